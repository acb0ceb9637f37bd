//! The models by name: one table that the command line, scenes, tables of populations and sensitivities go by.
//!
//! A law of its own crate becomes a model of the program by one entry here.

use std::sync::LazyLock;

use asperity::{AsperityError, Hardness, MaterialPair, NixGao};
use persson::corrections::Correction;
use persson::variance::Band;
use serde::{Deserialize, Deserializer};
use stacked_contact::StackedModel;
use stat_contact::{AsperityLaw, InterferenceLaw, NayakSummits, Population, StatisticalContact};
use units::UnknownName;

use crate::growth_law::GrowthLaw;
use crate::hardness_and_strength::HARDNESS_OVER_STRENGTH;
use crate::material::{Material, MaterialError};
pub use crate::model_options::{Choice, IgnoredOption, IgnoredReason, ModelOptions};
use crate::persson_law::{PerssonDeformation, PerssonLaw, PlasticLaw};

/// A model of a material: an entry of the table of models with its theory.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveModel {
    entry: &'static ModelEntry,
    theory: Theory,
}

/// A theory with its law and the bodies in contact.
#[derive(Debug, Clone, PartialEq)]
pub enum Theory {
    /// Scale upon scale.
    Stacked(StackedModel),
    /// Asperities of Gaussian heights.
    Statistical(Statistical),
    /// Persson's theory, without asperities.
    Persson(Persson),
}

/// A statistical theory of bodies in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistical {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The law of what is pressed.
    pub law: StatisticalLaw,
}

/// A surface as a statistical model presses it.
pub enum Pressable {
    /// Asperities, or the summits of a surface.
    Contact(StatisticalContact),
    /// A spectrum narrower than that of any surface, which has no summits.
    TooNarrow {
        /// m0 m4/m2^2 of the spectrum, below 1.5.
        alpha: f64,
    },
}

impl Statistical {
    /// Returns the contact of a roughness: of the radius \[m\], density \[1/m^2\] and rms height \[m\] of asperities, or of
    /// the moments m0 \[m^2\], m2 and m4 \[1/m^2\] for the law of the summits.
    ///
    /// # Errors
    /// [`AsperityError`] for numbers that the law does not take.
    pub fn press(&self, [first, second, third]: [f64; 3]) -> Result<Pressable, AsperityError> {
        match &self.law {
            StatisticalLaw::Asperities(law) => {
                let population = Population::new(first, second, third)?;
                Ok(Pressable::Contact(StatisticalContact::new(&self.pair, &population, law)))
            }
            StatisticalLaw::Summits => match NayakSummits::new(first, second, third) {
                Ok(summits) => Ok(Pressable::Contact(StatisticalContact::from_summits(&self.pair, &summits))),
                Err(error) if error.bound == NayakSummits::ALPHA => {
                    Ok(Pressable::TooNarrow { alpha: error.value })
                }
                Err(error) => Err(error),
            },
        }
    }
}

/// Persson's theory of bodies in contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Persson {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The law with its choices.
    pub law: PerssonLaw,
}

/// The law by which a statistical model turns the moments of a cutoff into contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StatisticalLaw {
    /// Asperities of one curvature, McCool's, under a law.
    Asperities(AsperityLaw),
    /// The summits of the surface, of every curvature, elastic (Bush, Gibson & Thomas).
    Summits,
}

/// The theory by which a model gets from the roughness to the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Framework {
    /// Scale upon scale.
    Stacked,
    /// A population of asperities.
    Statistical,
    /// The pressure spreads as roughness is taken in, without asperities.
    Persson,
}

impl std::fmt::Display for Framework {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Framework::Stacked => "stacked",
            Framework::Statistical => "statistical",
            Framework::Persson => "persson",
        })
    }
}

impl ModelOptions {
    /// Returns the options that were given and that a model ignores.
    #[must_use]
    pub fn ignored_by(&self, entry: &ModelEntry) -> Vec<IgnoredOption> {
        let ignored = |choice| Some(IgnoredOption { choice, reason: self.reason_to_ignore(choice, entry)? });
        self.given().filter_map(ignored).collect()
    }

    /// Returns why a model ignores a cap of the strength, or nothing if it heeds one. The cap belongs to the material,
    /// which is why it is no field here.
    #[must_use]
    pub fn reason_to_ignore_strength_cap(&self, entry: &ModelEntry) -> Option<IgnoredReason> {
        match entry.has(Choice::Strength) {
            false => Some(IgnoredReason::NeverYields),
            true if self.strain_gradient || self.hardness_law.is_some() => None,
            true => Some(IgnoredReason::NothingGrows),
        }
    }

    fn reason_to_ignore(&self, choice: Choice, entry: &ModelEntry) -> Option<IgnoredReason> {
        let yields = entry.has(Choice::Strength);
        let other_law = || self.hardness_law.as_ref().is_some_and(|law| *law != GrowthLaw::NixGao);
        match choice {
            Choice::StrainGradient if entry.has(Choice::HardnessLaw) && other_law() => {
                Some(IgnoredReason::OtherHardnessLaw)
            }
            choice if entry.has(choice) => None,
            Choice::StrainGradient if !yields => Some(IgnoredReason::NeverYields),
            Choice::HardnessLaw if !yields && entry.framework == Framework::Persson => {
                Some(IgnoredReason::NeverYields)
            }
            Choice::Correction if yields && entry.framework == Framework::Persson => {
                Some(IgnoredReason::CorrectionsAreElastic)
            }
            _ => Some(IgnoredReason::NoSuchOption),
        }
    }
}

/// The description of a model before it is built.
#[derive(Debug)]
pub struct ModelEntry {
    /// The name that people type, which is also that of its curves.
    pub name: &'static str,
    /// The full name, with the authors of the model.
    pub full_name: &'static str,
    /// The publication.
    pub citation: &'static str,
    /// Its framework.
    pub framework: Framework,
    choices: &'static [Choice],
    /// True if the model takes the moments of a surface, rather than the asperities that they make.
    takes_moments: bool,
    build: fn(&Material, &ModelOptions) -> Result<Theory, MaterialError>,
}

/// Every model, in the order of the documentation.
pub static MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "elastic",
        full_name: "Archard stack, elastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Stacked,
        choices: &[],
        takes_moments: false,
        build: |material, _| Ok(Theory::Stacked(StackedModel::Elastic { pair: material.pair })),
    },
    ModelEntry {
        name: "elastic-plastic",
        full_name: "Archard stack, elastic-plastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Krithivasan & Jackson (2007), Tribol. Lett. 27:31",
        framework: Framework::Stacked,
        choices: &[Choice::Strength, Choice::StrainGradient],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(Theory::Stacked(StackedModel::ElasticPlastic { pair: material.pair, strength }))
        },
    },
    ModelEntry {
        name: "hertz",
        full_name: "Greenwood-Williamson (Hertz)",
        citation: "Greenwood & Williamson (1966), Proc. R. Soc. A 295:300",
        framework: Framework::Statistical,
        choices: &[],
        takes_moments: false,
        build: |material, _| Ok(statistical(material, AsperityLaw::Hertz)),
    },
    ModelEntry {
        name: "ep-sphere",
        full_name: "GW, elastic-plastic spheres (Jackson-Green)",
        citation: "Jackson & Green (2005), J. Tribol. 127:343",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient, Choice::Hardness],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(
                material,
                AsperityLaw::EpSphere { strength, hardness: options.hardness.unwrap_or_default() },
            ))
        },
    },
    ModelEntry {
        name: "elastic-sine",
        full_name: "GW, elastic sinusoids (Rostami-Jackson)",
        citation: "Johnson, Greenwood & Higginson (1985), Int. J. Mech. Sci. 27:383; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Statistical,
        choices: &[Choice::Interference],
        takes_moments: false,
        build: |material, options| {
            let interference = options.interference_law.unwrap_or_default();
            Ok(statistical(material, AsperityLaw::ElasticSine { interference }))
        },
    },
    ModelEntry {
        name: "ep-sine",
        full_name: "GW, elastic-plastic sinusoids (Krithivasan-Jackson)",
        citation: "Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Rostami & Jackson (2013), Proc. IMechE J 227:1376",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(material, AsperityLaw::EpSine { strength }))
        },
    },
    ModelEntry {
        name: "bgt",
        full_name: "elastic summits of every curvature (Bush-Gibson-Thomas)",
        citation: "Bush, Gibson & Thomas (1975), Wear 35:87; Nayak (1971), J. Lubr. Technol. 93:398",
        framework: Framework::Statistical,
        choices: &[],
        takes_moments: true,
        build: |material, _| {
            Ok(Theory::Statistical(Statistical { pair: material.pair, law: StatisticalLaw::Summits }))
        },
    },
    ModelEntry {
        name: "persson",
        full_name: "Persson's theory, elastic",
        citation: "Persson (2001), J. Chem. Phys. 115:3840; Manners & Greenwood (2006), Wear 261:600",
        framework: Framework::Persson,
        choices: &[Choice::Correction, Choice::Band, Choice::Gamma],
        takes_moments: false,
        build: |material, options| {
            let deformation = PerssonDeformation::Elastic { correction: options.correction };
            Ok(Theory::Persson(Persson { pair: material.pair, law: PerssonLaw::new(deformation, options) }))
        },
    },
    ModelEntry {
        name: "persson-plastic",
        full_name: "Persson's theory, elastic-plastic",
        citation: "Persson (2001), Phys. Rev. Lett. 87:116101; Persson (2006), Surf. Sci. Rep. 61:201",
        framework: Framework::Persson,
        choices: &[
            Choice::Strength,
            Choice::StrainGradient,
            Choice::Band,
            Choice::Gamma,
            Choice::HardnessLaw,
        ],
        takes_moments: false,
        build: |material, options| {
            let plastic = PlasticLaw::new(material, options)?;
            let law = PerssonLaw::new(PerssonDeformation::ElasticPlastic(plastic), options);
            Ok(Theory::Persson(Persson { pair: material.pair, law }))
        },
    },
];

fn statistical(material: &Material, law: AsperityLaw) -> Theory {
    Theory::Statistical(Statistical { pair: material.pair, law: StatisticalLaw::Asperities(law) })
}

/// The names of all models.
static NAMES: LazyLock<Vec<&'static str>> = LazyLock::new(|| MODELS.iter().map(|entry| entry.name).collect());

/// The models of a framework.
pub fn of_framework(framework: Framework) -> impl Iterator<Item = &'static ModelEntry> {
    MODELS.iter().filter(move |entry| entry.framework == framework)
}

/// The models that know a distance between the surfaces.
pub fn with_gaps() -> impl Iterator<Item = &'static ModelEntry> {
    of_framework(Framework::Persson).chain(of_framework(Framework::Statistical))
}

/// The model of a name in a framework.
///
/// # Errors
/// [`UnknownName`], which lists the names of that framework.
pub fn named(framework: Framework, name: &str) -> Result<&'static ModelEntry, UnknownName> {
    of_framework(framework).find(|entry| entry.answers_to(name)).ok_or_else(|| UnknownName {
        what: match framework {
            Framework::Stacked => "stacked model",
            Framework::Statistical => "statistical model",
            Framework::Persson => "model of Persson's theory",
        },
        given: name.to_owned(),
        accepted: of_framework(framework).map(|entry| entry.name).collect::<Vec<_>>().join(", "),
    })
}

impl ModelEntry {
    /// The model of a material, with the choices made.
    ///
    /// # Errors
    /// [`MaterialError`] where the model needs what the material lacks, or what it has is out of bounds.
    pub fn build(
        &'static self,
        material: &Material,
        options: &ModelOptions,
    ) -> Result<CurveModel, MaterialError> {
        Ok(CurveModel { entry: self, theory: (self.build)(material, options)? })
    }

    /// Returns true if it takes the moments of a surface, rather than the asperities that they make.
    #[must_use]
    pub fn takes_moments(&self) -> bool {
        self.takes_moments
    }

    /// Returns true if it takes asperities of one curvature, McCool's.
    #[must_use]
    pub fn takes_asperities(&self) -> bool {
        self.framework == Framework::Statistical && !self.takes_moments
    }

    /// Returns true if the model has this choice.
    #[must_use]
    pub fn has(&self, choice: Choice) -> bool {
        self.choices.contains(&choice)
    }

    /// Returns the name of a curve that is given none: the model's, followed by the options that differ from its defaults.
    #[must_use]
    pub fn curve_name(&self, options: &ModelOptions) -> String {
        let mut name = self.name.to_owned();
        let mut add = |part: String| name.push_str(&format!("-{part}"));
        let growth = options.hardness_law.as_ref().filter(|_| self.has(Choice::HardnessLaw));
        let has_gradient = growth.map_or(options.strain_gradient, |law| *law == GrowthLaw::NixGao);
        if has_gradient && self.has(Choice::StrainGradient) {
            add("strain-gradient".to_owned());
        }
        match growth {
            Some(GrowthLaw::Power(exponent)) => add(format!("power-{exponent}")),
            Some(GrowthLaw::Table(_)) => add("hardness-table".to_owned()),
            Some(GrowthLaw::NixGao) | None => {}
        }
        let law = options.interference_law.filter(|law| *law != InterferenceLaw::default());
        if let Some(law) = law.filter(|_| self.has(Choice::Interference)) {
            add(law.to_string());
        }
        if let Some(correction) = options.correction.filter(|_| self.has(Choice::Correction)) {
            add(correction.to_string());
        }
        let band = options.band.filter(|band| *band != Band::default());
        if let Some(band) = band.filter(|_| self.has(Choice::Band)) {
            add(band.to_string());
        }
        let gamma = options.gamma.filter(|gamma| *gamma != PerssonLaw::ENERGY_FACTOR);
        if let Some(gamma) = gamma.filter(|_| self.has(Choice::Gamma)) {
            add(format!("gamma-{gamma}"));
        }
        name
    }
}

impl PartialEq for ModelEntry {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl std::fmt::Display for ModelEntry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name)
    }
}

impl<'de> Deserialize<'de> for &'static ModelEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        let found = MODELS.iter().find(|entry| entry.answers_to(&name));
        found.ok_or_else(|| serde::de::Error::unknown_variant(&name, &NAMES))
    }
}

impl CurveModel {
    /// Returns the entry of the model in the table of models.
    #[must_use]
    pub fn entry(&self) -> &'static ModelEntry {
        self.entry
    }

    /// Returns the theory with its law.
    #[must_use]
    pub fn theory(&self) -> &Theory {
        &self.theory
    }

    /// Returns the stack, or nothing for another theory.
    #[must_use]
    pub fn stacked(&self) -> Option<&StackedModel> {
        match &self.theory {
            Theory::Stacked(model) => Some(model),
            _ => None,
        }
    }

    /// Returns the statistical theory, or nothing for another one.
    #[must_use]
    pub fn statistical(&self) -> Option<&Statistical> {
        match &self.theory {
            Theory::Statistical(model) => Some(model),
            _ => None,
        }
    }

    /// Returns the options in which the model differs from the defaults of its entry.
    #[must_use]
    pub fn options(&self) -> ModelOptions {
        let persson = self.persson();
        ModelOptions {
            strain_gradient: self.has_strain_gradient(),
            hardness: self.hardness().filter(|form| *form != Hardness::default()),
            interference_law: self.interference().filter(|law| *law != InterferenceLaw::default()),
            correction: persson.and_then(PerssonLaw::correction).flatten(),
            band: persson.map(|law| law.band).filter(|band| *band != Band::default()),
            gamma: persson.map(|law| law.energy_factor).filter(|gamma| *gamma != PerssonLaw::ENERGY_FACTOR),
            hardness_law: persson.and_then(PerssonLaw::plastic).and_then(PlasticLaw::growth).cloned(),
        }
    }

    /// Returns the law of Persson's theory, or nothing for another theory.
    #[must_use]
    pub fn persson(&self) -> Option<&PerssonLaw> {
        match &self.theory {
            Theory::Persson(model) => Some(&model.law),
            _ => None,
        }
    }

    /// Returns the strength of the body that yields, or nothing for an elastic model.
    #[must_use]
    pub fn strength(&self) -> Option<NixGao> {
        match &self.theory {
            Theory::Stacked(model) => model.strength(),
            Theory::Statistical(model) => match model.law {
                StatisticalLaw::Asperities(law) => law.strength(),
                StatisticalLaw::Summits => None,
            },
            Theory::Persson(model) => model.law.plastic().map(PlasticLaw::strength),
        }
    }

    fn has_strain_gradient(&self) -> bool {
        self.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some())
    }

    /// Returns true if it stands on the amplitudes of scales.
    #[must_use]
    pub fn needs_amplitudes(&self) -> bool {
        self.stacked().is_some() || self.persson().is_some() && self.has_strain_gradient()
    }

    /// Returns true if it stands on spectral moments.
    #[must_use]
    pub fn needs_moments(&self) -> bool {
        self.stacked().is_none()
    }

    /// Returns true if its strength or its hardness grows at small scales.
    #[must_use]
    pub fn strength_grows(&self) -> bool {
        let with_depth =
            self.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some());
        with_depth || self.persson().and_then(PerssonLaw::plastic).is_some_and(PlasticLaw::grows)
    }

    /// Returns the hardness \[Pa\] at which the model flows at long wavelengths, or nothing for an elastic one. The laws of
    /// asperities flow at three times their strength, Persson's theory at the hardness of the material.
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        let of_strength = |strength: NixGao| HARDNESS_OVER_STRENGTH * strength.macroscopic_strength_pa();
        let plastic = self.persson().and_then(PerssonLaw::plastic);
        plastic.map(PlasticLaw::hardness_pa).or_else(|| self.strength().map(of_strength))
    }

    /// Returns the bodies in contact.
    #[must_use]
    pub fn pair(&self) -> MaterialPair {
        match &self.theory {
            Theory::Stacked(StackedModel::Elastic { pair } | StackedModel::ElasticPlastic { pair, .. })
            | Theory::Statistical(Statistical { pair, .. })
            | Theory::Persson(Persson { pair, .. }) => *pair,
        }
    }

    /// Returns the same model of other bodies in contact, with its strength and its options.
    #[must_use]
    pub fn with_pair(&self, pair: MaterialPair) -> Self {
        let mut moved = self.clone();
        match &mut moved.theory {
            Theory::Stacked(
                StackedModel::Elastic { pair: own } | StackedModel::ElasticPlastic { pair: own, .. },
            )
            | Theory::Statistical(Statistical { pair: own, .. })
            | Theory::Persson(Persson { pair: own, .. }) => *own = pair,
        }
        moved
    }

    fn with_theory(&self, theory: Theory) -> Self {
        CurveModel { entry: self.entry, theory }
    }

    fn with_persson(&self, law: PerssonLaw) -> Self {
        self.with_theory(Theory::Persson(Persson { pair: self.pair(), law }))
    }

    /// Returns the same model with another strength, or nothing for one that never yields.
    #[must_use]
    pub fn with_strength(&self, strength: NixGao) -> Option<Self> {
        match &self.theory {
            Theory::Stacked(model) => Some(self.with_theory(Theory::Stacked(model.with_strength(strength)?))),
            Theory::Statistical(_) => self.with_law(|law| law.with_strength(strength)),
            Theory::Persson(model) => Some(self.with_persson(model.law.with_strength(strength)?)),
        }
    }

    /// Returns the same model with another correction of Persson's elastic theory, or nothing for one that has none.
    #[must_use]
    pub fn with_correction(&self, correction: Option<Correction>) -> Option<Self> {
        Some(self.with_persson(self.persson()?.with_correction(correction)?))
    }

    /// Returns the same model with a cutoff of another spectrum, or nothing for a theory other than Persson's.
    #[must_use]
    pub fn with_band(&self, band: Band) -> Option<Self> {
        Some(self.with_persson(PerssonLaw { band, ..self.persson()?.clone() }))
    }

    /// Returns the same model with the hardness of its spheres in another form, or nothing for one that has none.
    #[must_use]
    pub fn with_hardness(&self, hardness: Hardness) -> Option<Self> {
        self.with_law(|law| law.with_hardness(hardness))
    }

    /// Returns the form of the hardness of its spheres, or nothing for a model that has none.
    #[must_use]
    pub fn hardness(&self) -> Option<Hardness> {
        Hardness::ALL.into_iter().find(|hardness| self.with_hardness(*hardness).as_ref() == Some(self))
    }

    /// Returns the interference law, or nothing for a model that has none.
    #[must_use]
    pub fn interference(&self) -> Option<InterferenceLaw> {
        InterferenceLaw::ALL.iter().copied().find(|law| self.with_interference(*law).as_ref() == Some(self))
    }

    /// Returns the same model with another interference law, or nothing for one that has none.
    #[must_use]
    pub fn with_interference(&self, interference: InterferenceLaw) -> Option<Self> {
        self.with_law(|law| law.with_interference(interference))
    }

    fn with_law(&self, change: impl FnOnce(AsperityLaw) -> Option<AsperityLaw>) -> Option<Self> {
        let Statistical { pair, law: StatisticalLaw::Asperities(law) } = *self.statistical()? else {
            return None;
        };
        let law = StatisticalLaw::Asperities(change(law)?);
        Some(self.with_theory(Theory::Statistical(Statistical { pair, law })))
    }
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;
    use units::Pressure;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::{GivenMaterial, NeededFor};

    fn material(yield_strength: Option<Pressure>) -> Material {
        Material::new(GivenMaterial {
            body: ElasticBody::new(463e9, 0.2).unwrap(),
            counterface: None,
            flows: crate::bodies::Body::Rough,
            hardness_and_strength: HardnessAndStrength::new(None, yield_strength).unwrap(),
            strength_cap: None,
            strain_gradient_length_m: Some(5e-6),
        })
    }

    #[test]
    fn every_model_is_built_known_again_and_has_the_choices_that_its_law_has() {
        let strong = material(Some("1.8 GPa".parse().unwrap()));
        for entry in MODELS {
            let model = entry.build(&strong, &ModelOptions::default()).unwrap();
            assert_eq!(model.entry(), entry);
            let built = entry.build(&material(None), &ModelOptions::default());
            assert_eq!(built.is_err(), entry.has(Choice::Strength), "{entry}");
            assert!(built.err().is_none_or(|error| error == MaterialError::Missing(NeededFor::Yielding)));
            let strength = NixGao::constant(2e9).unwrap();
            assert_eq!(model.with_strength(strength).is_some(), entry.has(Choice::Strength), "{entry}");
            assert_eq!(
                model.with_hardness(Hardness::Cosine).is_some(),
                entry.has(Choice::Hardness),
                "{entry}"
            );
            let bem = model.with_interference(InterferenceLaw::Bem);
            assert_eq!(bem.is_some(), entry.has(Choice::Interference), "{entry}");
            let growing = ModelOptions { strain_gradient: true, ..ModelOptions::default() };
            let grows = entry.build(&strong, &growing).unwrap() != model;
            assert_eq!(grows, entry.has(Choice::StrainGradient), "{entry}");
            assert_eq!(named(entry.framework, entry.name).unwrap(), entry);
            let other = MaterialPair::against_rigid(ElasticBody::new(70e9, 0.33).unwrap());
            let moved = model.with_pair(other);
            assert_eq!((moved.pair(), moved.strength(), moved.entry()), (other, model.strength(), entry));
            assert_eq!(moved.with_pair(model.pair()), model);
        }
    }

    #[test]
    fn an_option_is_ignored_by_the_models_that_do_not_have_it_with_the_reason() {
        use IgnoredReason::{
            CorrectionsAreElastic, NeverYields, NoSuchOption, NothingGrows, OtherHardnessLaw,
        };
        let all = ModelOptions {
            strain_gradient: true,
            hardness: Some(Hardness::default()),
            interference_law: Some(InterferenceLaw::Bem),
            correction: Some(Correction::AlgebraicNayak),
            band: Some(Band::Surface),
            gamma: Some(0.5),
            hardness_law: Some(GrowthLaw::Power(0.5)),
        };
        assert_eq!(ModelOptions::default().given().count(), 0);
        assert_eq!(all.given().count(), 7);
        let entry = |name: &str| MODELS.iter().find(|entry| entry.name == name).unwrap();
        for entry in MODELS {
            let reasons = all.ignored_by(entry);
            for choice in all.given() {
                let ignored = reasons.iter().find(|ignored| ignored.choice == choice);
                let reason = match choice {
                    Choice::StrainGradient if entry.name == "persson-plastic" => Some(OtherHardnessLaw),
                    choice if entry.has(choice) => None,
                    Choice::StrainGradient => Some(NeverYields),
                    Choice::HardnessLaw if entry.name == "persson" => Some(NeverYields),
                    Choice::Correction if entry.name == "persson-plastic" => Some(CorrectionsAreElastic),
                    _ => Some(NoSuchOption),
                };
                assert_eq!(ignored.map(|ignored| ignored.reason), reason, "{choice:?} of {entry}");
            }
        }
        let nix_gao = ModelOptions { hardness_law: Some(GrowthLaw::NixGao), ..all.clone() };
        let ignored = nix_gao.ignored_by(entry("persson-plastic"));
        assert!(ignored.iter().all(|ignored| ignored.choice != Choice::StrainGradient));
        let cap = |options: &ModelOptions, name: &str| options.reason_to_ignore_strength_cap(entry(name));
        assert_eq!(cap(&all, "persson"), Some(NeverYields));
        assert_eq!(cap(&ModelOptions::default(), "persson-plastic"), Some(NothingGrows));
        assert_eq!(cap(&nix_gao, "persson-plastic"), None);
    }

    #[test]
    fn a_name_of_the_other_framework_is_none() {
        assert_eq!(
            named(Framework::Statistical, "elastic").unwrap_err().to_string(),
            "reading the statistical model: 'elastic' is none of hertz, ep-sphere, elastic-sine, ep-sine, bgt"
        );
    }
}
