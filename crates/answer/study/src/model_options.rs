//! The options of models as one plain struct, in which an option that was not given is absent.

use asperity::Hardness;
use persson::Band;
use persson::EnergyFactor;
use persson::corrections::Correction;
use serde::de::MapAccess;
use serde::{Deserialize, Serialize};
use stacked_contact::YieldingAreaLaw;
use stat_contact::{Flattening, InterferenceLaw, SummitHeights};

use crate::choices_in_words;
use crate::growth_law::GrowthLaw;

/// A property or an option that some models take and others do not, besides the elastic constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Choice {
    /// A yield strength, which the model needs and whose cap it heeds.
    Strength,
    /// Growth of that strength at small depths.
    StrainGradient,
    /// The form of the hardness of spheres.
    Hardness,
    /// The quantities of flattened spheres that no longer grow.
    Flattening,
    /// The distribution of the heights of elastic spheres.
    SummitHeights,
    /// The area of a scale of a stack that yields.
    #[serde(rename = "elastic_plastic_area")]
    YieldingArea,
    /// The law between pressure and interference of an elastic sinusoid.
    #[serde(rename = "interference_law")]
    Interference,
    /// A corrected form of Persson's elastic theory.
    Correction,
    /// The spectrum that a cutoff ends, in Persson's theory.
    Band,
    /// The elastic energy factor of mean separations, in Persson's theory.
    Gamma,
    /// The growth of the hardness towards short wavelengths, in Persson's theory.
    HardnessLaw,
}

/// The choices made for a model. An option that is absent was not given, and the model takes its default.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ModelOptions {
    /// True if the strength grows at small depths.
    pub strain_gradient: bool,
    /// The form of the hardness of spheres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness: Option<Hardness>,
    /// The quantities of flattened spheres that no longer grow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flattening: Option<Flattening>,
    /// The distribution of the heights of elastic spheres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub summit_heights: Option<SummitHeights>,
    /// The area of scales of a stack that yield.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub elastic_plastic_area: Option<YieldingAreaLaw>,
    /// The interference law of elastic sinusoids.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interference_law: Option<InterferenceLaw>,
    /// The corrected form of Persson's elastic theory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correction: Option<Correction>,
    /// The spectrum that a cutoff ends, in Persson's theory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub band: Option<Band>,
    /// The elastic energy factor of Persson's theory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gamma: Option<EnergyFactor>,
    /// The growth of the hardness towards short wavelengths, in Persson's theory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness_law: Option<GrowthLaw>,
}

/// A setting of an option, for people.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// Its part of the name of a curve, e.g. `power-0.5`.
    pub name: String,
    /// The setting after the short name of a model, e.g. `hardening`.
    pub short: String,
    /// The setting in words.
    pub words: String,
}

impl Choice {
    /// The choices that a curve of a scene may make, in the order of its keys.
    pub const OF_CURVES: [Choice; 6] = [
        Choice::StrainGradient,
        Choice::Interference,
        Choice::Correction,
        Choice::Band,
        Choice::Gamma,
        Choice::HardnessLaw,
    ];

    /// The choices that a whole scene makes for all curves that have them.
    pub const OF_SCENES: [Choice; 3] = [Choice::Hardness, Choice::Flattening, Choice::YieldingArea];

    /// Returns the key of the choice in scenes and columns, e.g. `interference_law`.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Choice::Strength => "yield_strength",
            Choice::StrainGradient => "strain_gradient",
            Choice::Hardness => "hardness_formula",
            Choice::Flattening => "flattening",
            Choice::SummitHeights => "summit_heights",
            Choice::YieldingArea => "elastic_plastic_area",
            Choice::Interference => "interference_law",
            Choice::Correction => "correction",
            Choice::Band => "band",
            Choice::Gamma => "gamma",
            Choice::HardnessLaw => "hardness_law",
        }
    }
}

/// Returns a choice that differs from its default.
pub(crate) fn unless_default<T: Default + PartialEq>(choice: T) -> Option<T> {
    Some(choice).filter(|choice| *choice != T::default())
}

impl ModelOptions {
    /// Returns the settings that differ from the defaults of a model which has some of the choices. Those of a whole
    /// scene are left out.
    #[must_use]
    pub fn settings(&self, has: impl Fn(Choice) -> bool) -> Vec<Setting> {
        let growth = self.hardness_law.as_ref().filter(|_| has(Choice::HardnessLaw));
        let has_gradient = growth.map_or(self.strain_gradient, |law| *law == GrowthLaw::NixGao);
        let growth_name = |law: &GrowthLaw| match law {
            GrowthLaw::Power(exponent) => Some(format!("power-{exponent}")),
            GrowthLaw::Table(_) => Some("hardness-table".to_owned()),
            GrowthLaw::NixGao => None,
        };
        let growth = growth.and_then(|law| {
            let name = growth_name(law)?;
            Some(Setting {
                short: format!("hardness {}", name.trim_start_matches("hardness-").replace('-', " ")),
                name,
                words: choices_in_words::hardness_law(law),
            })
        });
        let interference = self.interference_law.filter(|law| *law != InterferenceLaw::default());
        let band = self.band.filter(|band| *band != Band::default());
        let gamma = self.gamma.filter(|gamma| *gamma != EnergyFactor::default());
        let gradient = has_gradient.then(|| Setting {
            name: "strain-gradient".to_owned(),
            short: "hardening".to_owned(),
            words: "strain gradient".to_owned(),
        });
        let named =
            |name: String, words: &str| Setting { short: name.clone(), name, words: words.to_owned() };
        let settings = [
            (Choice::StrainGradient, gradient),
            (Choice::HardnessLaw, growth),
            (
                Choice::Interference,
                interference.map(|law| named(law.to_string(), choices_in_words::interference(law))),
            ),
            (
                Choice::Correction,
                self.correction.map(|form| named(form.to_string(), choices_in_words::correction(form))),
            ),
            (
                Choice::Band,
                band.map(|band| Setting {
                    name: band.to_string(),
                    short: format!("{band} band"),
                    words: choices_in_words::band(band).to_owned(),
                }),
            ),
            (
                Choice::Gamma,
                gamma.map(|gamma| Setting {
                    name: format!("gamma-{gamma}"),
                    short: format!("energy factor {gamma}"),
                    words: format!("energy factor {gamma}"),
                }),
            ),
        ];
        let of_model = settings.into_iter().filter(|(choice, _)| has(*choice));
        of_model.filter_map(|(_, setting)| setting).collect()
    }

    /// Reads the value of an option, which comes next; a strength is none.
    ///
    /// # Errors
    /// The errors of the reader.
    pub fn read<'de, A: MapAccess<'de>>(&mut self, choice: Choice, values: &mut A) -> Result<(), A::Error> {
        match choice {
            Choice::Strength => {}
            Choice::StrainGradient => self.strain_gradient = values.next_value()?,
            Choice::Hardness => self.hardness = values.next_value()?,
            Choice::Flattening => self.flattening = values.next_value()?,
            Choice::SummitHeights => self.summit_heights = values.next_value()?,
            Choice::YieldingArea => self.elastic_plastic_area = values.next_value()?,
            Choice::Interference => self.interference_law = values.next_value()?,
            Choice::Correction => self.correction = values.next_value()?,
            Choice::Band => self.band = values.next_value()?,
            Choice::Gamma => self.gamma = values.next_value()?,
            Choice::HardnessLaw => self.hardness_law = values.next_value()?,
        }
        Ok(())
    }

    /// Returns the options that were given, in the order of the fields.
    pub fn given(&self) -> impl Iterator<Item = Choice> {
        let given = [
            (self.strain_gradient, Choice::StrainGradient),
            (self.hardness.is_some(), Choice::Hardness),
            (self.flattening.is_some(), Choice::Flattening),
            (self.summit_heights.is_some(), Choice::SummitHeights),
            (self.elastic_plastic_area.is_some(), Choice::YieldingArea),
            (self.interference_law.is_some(), Choice::Interference),
            (self.correction.is_some(), Choice::Correction),
            (self.band.is_some(), Choice::Band),
            (self.gamma.is_some(), Choice::Gamma),
            (self.hardness_law.is_some(), Choice::HardnessLaw),
        ];
        given.into_iter().filter_map(|(is_given, choice)| is_given.then_some(choice))
    }
}
