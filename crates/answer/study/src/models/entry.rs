//! The models by name: one table that the command line, scenes, tables of populations and sensitivities go by.

use std::sync::LazyLock;

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use units::{Remark, RemarkCode, UnknownName};

use super::{CurveModel, Framework, MODELS, Theory};
use crate::growth_law::GrowthLaw;
use crate::material::{Material, MaterialError};
use crate::model_options::{Choice, ModelOptions};

/// The description of a model before it is built.
#[derive(Debug, Clone, Copy)]
pub struct ModelEntry {
    /// The name that people type, which is also that of its curves.
    pub name: &'static str,
    /// The short name in print.
    pub short_name: &'static str,
    /// The full name, with the authors of the model.
    pub full_name: &'static str,
    /// The publication.
    pub citation: &'static str,
    /// Abbreviations and authors that people know it by, without case, blanks and hyphens.
    pub(super) aliases: &'static [&'static str],
    /// Its framework.
    pub framework: Framework,
    pub(super) choices: &'static [Choice],
    /// True if the model takes the moments of a surface, rather than the asperities that they make.
    pub takes_moments: bool,
    pub(super) build: fn(&Material, &ModelOptions) -> Result<Theory, MaterialError>,
}

impl Serialize for ModelEntry {
    /// Writes the name.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

/// The names of all models.
static NAMES: LazyLock<Vec<&'static str>> = LazyLock::new(|| MODELS.iter().map(|entry| entry.name).collect());

/// The models of a framework.
pub fn of_framework(framework: Framework) -> impl Iterator<Item = &'static ModelEntry> {
    MODELS.iter().filter(move |entry| entry.framework == framework)
}

/// The models that know a distance between the surfaces; the theory without asperities comes first.
pub fn with_gaps() -> impl Iterator<Item = &'static ModelEntry> {
    Framework::ALL.iter().rev().filter(|framework| framework.has_gaps()).flat_map(|of| of_framework(*of))
}

/// The model of a name in a framework.
///
/// # Errors
/// [`UnknownName`], which lists the names of that framework.
pub fn named(framework: Framework, name: &str) -> Result<&'static ModelEntry, UnknownName> {
    of_framework(framework).find(|entry| entry.answers_to(name)).ok_or_else(|| UnknownName {
        what: framework.noun(),
        given: name.to_owned(),
        accepted: of_framework(framework).map(|entry| entry.name).collect::<Vec<_>>().join(", "),
    })
}

impl ModelEntry {
    /// The model of a material, with the choices made.
    ///
    /// # Errors
    /// [`MaterialError`] where the model needs what the material lacks, or what it has is out of bounds, and where the rough body
    /// is a layer that the model does not know.
    pub fn build(
        &'static self,
        material: &Material,
        options: &ModelOptions,
    ) -> Result<CurveModel, MaterialError> {
        if material.pair.layer().is_some() && self.framework != Framework::Persson {
            return Err(MaterialError::LayerUnknown { model: self.name });
        }
        Ok(CurveModel { entry: self, theory: (self.build)(material, options)? })
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

    /// Returns the first model of its framework that yields, by name; `None` if this one does.
    #[must_use]
    pub fn yielding(&self) -> Option<&'static str> {
        let yielding = |entry: &&ModelEntry| entry.has(Choice::Strength);
        of_framework(self.framework).find(yielding).map(|entry| entry.name).filter(|_| !yielding(&self))
    }

    /// Returns the name of a curve that is given none: the model's, followed by the options that differ from its defaults.
    #[must_use]
    pub fn curve_name(&self, options: &ModelOptions) -> String {
        let settings = options.settings(|choice| self.has(choice));
        let parts = settings.iter().map(|setting| setting.name.as_str());
        std::iter::once(self.name).chain(parts).collect::<Vec<_>>().join("-")
    }

    /// Returns true if people call the model so: by its name, its short or full name in print, an abbreviation or its
    /// authors. Case, blanks and punctuation do not count.
    #[must_use]
    pub fn answers_to(&self, name: &str) -> bool {
        let plain = |text: &str| -> String {
            text.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
        };
        let wanted = plain(name);
        let names = [self.name, self.short_name, self.full_name];
        names.iter().chain(self.aliases).any(|known| plain(known) == wanted)
    }
}

impl ModelOptions {
    /// Returns the options that were given and that a model ignores.
    #[must_use]
    pub fn ignored_by(&self, entry: &ModelEntry) -> Vec<Remark> {
        let ignored = |choice| Some(remark_on_ignored(choice, self.reason_to_ignore(choice, entry)?, entry));
        self.given().filter_map(ignored).collect()
    }

    /// Returns a remark if a model ignores a cap of the strength. The cap is a property of the material, not a field here.
    #[must_use]
    pub fn ignored_strength_cap(&self, entry: &ModelEntry) -> Option<Remark> {
        let code = match entry.has(Choice::Strength) {
            false => RemarkCode::NeverYields,
            true if self.strain_gradient || self.hardness_law.is_some() => return None,
            true if entry.framework.takes_hardness() => RemarkCode::HardnessDoesNotGrow,
            true => RemarkCode::StrengthDoesNotGrow,
        };
        Some(Remark::new(code).with("model", entry.name).on("strength_cap"))
    }

    fn reason_to_ignore(&self, choice: Choice, entry: &ModelEntry) -> Option<RemarkCode> {
        let yields = entry.has(Choice::Strength);
        let is_of_framework = || of_framework(entry.framework).any(|other| other.has(choice));
        let law = self.hardness_law.as_ref().filter(|_| entry.has(Choice::HardnessLaw));
        match (choice, law) {
            (Choice::StrainGradient, Some(GrowthLaw::NixGao)) => Some(RemarkCode::Replaced),
            (Choice::StrainGradient, Some(_)) => Some(RemarkCode::OtherHardnessLaw),
            (choice, _) if entry.has(choice) => None,
            (Choice::StrainGradient, _) if !yields => Some(RemarkCode::NeverYields),
            (Choice::HardnessLaw, _) if !yields && is_of_framework() => Some(RemarkCode::NeverYields),
            (Choice::Correction, _) if yields && is_of_framework() => Some(RemarkCode::CorrectionsAreElastic),
            _ => Some(RemarkCode::NoSuchOption),
        }
    }
}

/// The remark on an option that a model ignores, with the models that take it.
fn remark_on_ignored(choice: Choice, code: RemarkCode, entry: &ModelEntry) -> Remark {
    let remark = Remark::new(code).with("model", entry.name).on(choice.key());
    let others = of_framework(entry.framework).filter(|other| other.has(choice));
    let others: Vec<&str> = others.map(|other| other.name).collect();
    // A law of the hardness is an option of one theory, whose models a front end may call otherwise.
    match code {
        RemarkCode::Replaced => remark.with("other", Choice::HardnessLaw.key()),
        _ if others.is_empty() || choice == Choice::HardnessLaw => remark,
        _ => remark.with("models", others.join(", ")),
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

#[cfg(test)]
mod tests {
    use ::persson::Band;
    use ::persson::EnergyFactor;
    use ::persson::corrections::Correction;
    use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
    use stacked_contact::YieldingAreaLaw;
    use stat_contact::{Flattening, InterferenceLaw, SummitHeights};
    use units::Pressure;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::{GivenMaterial, NeededFor};

    fn material(yield_strength: Option<Pressure>) -> Material {
        Material::new(GivenMaterial {
            hardness_and_strength: HardnessAndStrength::new(None, yield_strength).unwrap(),
            strain_gradient_length_m: Some(5e-6),
            ..GivenMaterial::new(ElasticBody::new(463e9, 0.2).unwrap())
        })
    }

    #[test]
    fn every_model_is_built_known_again_and_has_the_choices_that_its_law_has() {
        let strong = material(Some("1.8 GPa".parse().unwrap()));
        for entry in MODELS.iter() {
            let model = entry.build(&strong, &ModelOptions::default()).unwrap();
            assert_eq!(model.entry, entry);
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
            let [mut flattened, mut shaped, mut heights] = [(); 3].map(|()| ModelOptions::default());
            heights.summit_heights = Some(SummitHeights::Exponential);
            flattened.flattening = Some(Flattening::Area);
            shaped.elastic_plastic_area = Some(YieldingAreaLaw::ElasticShape);
            let given = [
                (flattened, Choice::Flattening),
                (shaped, Choice::YieldingArea),
                (heights, Choice::SummitHeights),
            ];
            for (options, choice) in given {
                let other = entry.build(&strong, &options).unwrap();
                assert_eq!(other != model, entry.has(choice), "{entry}");
                assert_eq!(other.options() == options, entry.has(choice), "{entry}");
            }
            let growing = ModelOptions { strain_gradient: true, ..ModelOptions::default() };
            let grows = entry.build(&strong, &growing).unwrap() != model;
            assert_eq!(grows, entry.has(Choice::StrainGradient), "{entry}");
            assert_eq!(named(entry.framework, entry.name).unwrap(), entry);
            let other = MaterialPair::against_rigid(ElasticBody::new(70e9, 0.33).unwrap());
            let moved = model.with_pair(other);
            assert_eq!((moved.pair(), moved.strength(), moved.entry), (other, model.strength(), entry));
            assert_eq!(moved.with_pair(model.pair()), model);
        }
    }

    #[test]
    fn an_option_is_ignored_by_the_models_that_do_not_have_it_with_the_reason() {
        use RemarkCode::{
            CorrectionsAreElastic, HardnessDoesNotGrow, NeverYields, NoSuchOption, OtherHardnessLaw,
        };
        let all = ModelOptions {
            strain_gradient: true,
            hardness: Some(Hardness::default()),
            flattening: Some(Flattening::Area),
            summit_heights: Some(SummitHeights::Exponential),
            elastic_plastic_area: Some(YieldingAreaLaw::ElasticShape),
            interference_law: Some(InterferenceLaw::Bem),
            correction: Some(Correction::AlgebraicNayak),
            band: Some(Band::Profile),
            gamma: EnergyFactor::new(0.5).ok(),
            hardness_law: Some(GrowthLaw::Power(0.5)),
        };
        assert_eq!(ModelOptions::default().given().count(), 0);
        assert_eq!(all.given().count(), 10);
        let entry = |name: &str| MODELS.iter().find(|entry| entry.name == name).unwrap();
        for entry in MODELS.iter() {
            let reasons = all.ignored_by(entry);
            for choice in all.given() {
                let is_on = |ignored: &&Remark| ignored.place.option.as_deref() == Some(choice.key());
                let ignored = reasons.iter().find(is_on);
                let reason = match choice {
                    Choice::StrainGradient if entry.name == "persson-plastic" => Some(OtherHardnessLaw),
                    choice if entry.has(choice) => None,
                    Choice::StrainGradient => Some(NeverYields),
                    Choice::HardnessLaw if entry.name == "persson" => Some(NeverYields),
                    Choice::Correction if entry.name == "persson-plastic" => Some(CorrectionsAreElastic),
                    _ => Some(NoSuchOption),
                };
                assert_eq!(ignored.map(|ignored| ignored.code), reason, "{choice:?} of {entry}");
            }
        }
        let nix_gao = ModelOptions { hardness_law: Some(GrowthLaw::NixGao), ..all.clone() };
        let ignored = nix_gao.ignored_by(entry("persson-plastic"));
        let of_growth = ignored.iter().find(|one| one.place.option.as_deref() == Some("strain_gradient"));
        assert_eq!(of_growth.map(|one| one.code), Some(RemarkCode::Replaced));
        let cap = |options: &ModelOptions, name: &str| {
            options.ignored_strength_cap(entry(name)).map(|cap| cap.code)
        };
        assert_eq!(cap(&all, "persson"), Some(NeverYields));
        assert_eq!(cap(&ModelOptions::default(), "persson-plastic"), Some(HardnessDoesNotGrow));
        assert_eq!(cap(&nix_gao, "persson-plastic"), None);
    }

    #[test]
    fn a_name_of_the_other_framework_is_unknown_and_those_of_its_own_are_listed() {
        let error = named(Framework::Statistical, "elastic").unwrap_err();
        assert_eq!((error.what, error.given.as_str()), ("statistical model", "elastic"));
        let names: Vec<&str> = of_framework(Framework::Statistical).map(|entry| entry.name).collect();
        assert_eq!(error.accepted.split(", ").collect::<Vec<_>>(), names);
    }

    #[test]
    fn every_name_belongs_to_one_model() {
        let answering = |name: &str| -> Vec<&str> {
            MODELS.iter().filter(|entry| entry.answers_to(name)).map(|entry| entry.name).collect()
        };
        for entry in MODELS.iter() {
            for name in [entry.name, entry.short_name, entry.full_name].iter().chain(entry.aliases) {
                assert_eq!(answering(name), [entry.name], "{name}");
            }
        }
        assert_eq!((answering("GW"), answering("EP sine")), (vec!["hertz"], vec!["ep-sine"]));
        assert_eq!(answering("Greenwood-Williamson (Hertz)"), ["hertz"]);
        assert!(answering("rigid").is_empty());
    }
}
