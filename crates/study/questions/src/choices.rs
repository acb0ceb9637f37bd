//! Choices that models leave open.

use asperity::Hardness;
use persson::corrections::Correction;
use persson::variance::Band;
use serde::{Deserialize, Serialize};
use stat_contact::InterferenceLaw;
use study::hardness_growth::GrowthLaw;
use study::material::Material;
use study::models::{self, Choice, Framework, ModelEntry, ModelOptions};

use crate::option::{OptionName, Reason, UnusedOption};

/// Choices that models leave open; each model uses some of them.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ModelChoices {
    /// True lets the strength grow at small depths; if absent, it grows if the model allows it and the material has the length.
    pub strain_gradient: Option<bool>,
    /// Form of the hardness of spheres.
    pub hardness: Option<Hardness>,
    /// Law of elastic sinusoids.
    pub interference_law: Option<InterferenceLaw>,
    /// Correction of Persson's elastic theory.
    pub correction: Option<Correction>,
    /// Waves that a cutoff lets through in Persson's theory.
    pub band: Option<Band>,
    /// Elastic energy factor of Persson's theory, in (0, 1\].
    pub gamma: Option<f64>,
    /// Growth of the hardness in Persson's theory.
    #[serde(with = "crate::text::growth")]
    pub hardness_law: Option<GrowthLaw>,
}

impl ModelChoices {
    /// The choices that are built into a model.
    #[must_use]
    pub fn options(&self, entry: &ModelEntry, material: &Material) -> ModelOptions {
        let by_length = entry.has(Choice::StrainGradient) && material.strain_gradient_length_m().is_some();
        ModelOptions {
            strain_gradient: self.strain_gradient.unwrap_or(by_length),
            hardness: self.hardness.unwrap_or_default(),
            interference: self.interference_law.unwrap_or_default(),
        }
    }
}

/// A shared set of checks: options that a model ignores, the most telling first.
pub(crate) fn check(
    choices: &ModelChoices,
    entry: &'static ModelEntry,
    has_strain_gradient_length: bool,
    has_strength_cap: bool,
) -> Result<(), UnusedOption> {
    let unused = |option, why| Err(UnusedOption { option, why });
    let is_persson = entry.framework == Framework::Persson;
    let yields = entry.has(Choice::Strength);
    let only_on = |option, choice| {
        let its_models = models::of_framework(entry.framework).filter(|entry| entry.has(choice));
        let models: Vec<&'static str> = its_models.map(|entry| entry.name).collect();
        let why = match models.is_empty() {
            true => Reason::Model(entry.name),
            false => Reason::OnlyOn { model: entry.name, models },
        };
        unused(option, why)
    };
    if choices.hardness.is_some() && !entry.has(Choice::Hardness) {
        return only_on(OptionName::Hardness, Choice::Hardness);
    }
    if choices.interference_law.is_some() && !entry.has(Choice::Interference) {
        return only_on(OptionName::InterferenceLaw, Choice::Interference);
    }
    let of_persson = [
        (OptionName::Gamma, choices.gamma.is_some()),
        (OptionName::Band, choices.band.is_some()),
        (OptionName::Correction, choices.correction.is_some()),
        (OptionName::HardnessLaw, choices.hardness_law.is_some()),
    ];
    if let Some((option, _)) = of_persson.into_iter().find(|(_, is_given)| *is_given && !is_persson) {
        return unused(option, Reason::Model(entry.name));
    }
    if choices.strain_gradient == Some(true) && !entry.has(Choice::StrainGradient) {
        return match is_persson {
            true => unused(OptionName::StrainGradient, Reason::DoesNotYield(entry.name)),
            false => only_on(OptionName::StrainGradient, Choice::StrainGradient),
        };
    }
    if choices.hardness_law.is_some() && !yields {
        return unused(OptionName::HardnessLaw, Reason::DoesNotYield(entry.name));
    }
    if choices.correction.is_some() && yields {
        return unused(OptionName::Correction, Reason::CorrectionsAreElastic(entry.name));
    }
    let grows = has_strain_gradient_length || (is_persson && choices.hardness_law.is_some());
    if has_strength_cap && !yields {
        return unused(OptionName::StrengthCap, Reason::DoesNotYield(entry.name));
    }
    if has_strength_cap && !grows {
        return match is_persson {
            true => unused(OptionName::StrengthCap, Reason::HardnessDoesNotGrow(entry.name)),
            false => unused(OptionName::StrengthCap, Reason::StrengthDoesNotGrow),
        };
    }
    let other_law = choices.hardness_law.as_ref().is_some_and(|law| *law != GrowthLaw::NixGao);
    if other_law && choices.strain_gradient == Some(true) {
        return unused(OptionName::StrainGradient, Reason::OtherHardnessLaw(entry.name));
    }
    if other_law && has_strain_gradient_length && choices.strain_gradient != Some(false) {
        return unused(OptionName::StrainGradientLength, Reason::OtherHardnessLaw(entry.name));
    }
    Ok(())
}
