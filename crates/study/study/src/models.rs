//! The models by name: one table that the command line, scenes, tables of populations and sensitivities go by.
//!
//! A law of its own crate becomes a model of the program by one entry here.

use std::sync::LazyLock;

use asperity::{Hardness, MaterialPair, NixGao};
use serde::{Deserialize, Deserializer};
use stacked_contact::StackedModel;
use stat_contact::{AsperityLaw, InterferenceLaw};
use units::UnknownName;

use crate::material::{Material, MaterialError, NeededFor};
use crate::persson_law::PerssonLaw;

/// One of the two frameworks, with its law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveModel {
    /// Scale upon scale.
    Stacked(StackedModel),
    /// Asperities of Gaussian heights.
    Statistical {
        /// The bodies in contact.
        pair: MaterialPair,
        /// What is pressed.
        law: StatisticalLaw,
    },
    /// Persson's theory, without asperities.
    Persson {
        /// The bodies in contact.
        pair: MaterialPair,
        /// How the surface deforms.
        law: PerssonLaw,
    },
}

/// What a statistical model makes of the moments of a cutoff.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StatisticalLaw {
    /// Asperities of one curvature, McCool's, under a law.
    Asperities(AsperityLaw),
    /// The summits of the surface, of every curvature, elastic (Bush, Gibson & Thomas).
    Summits,
}

/// How a model gets from the roughness to the contact.
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

/// What a model may leave to choose, besides the elastic constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Choice {
    /// A yield strength, which the model needs and whose cap it heeds.
    Strength,
    /// Whether that strength grows at small depths.
    StrainGradient,
    /// The form of the hardness of spheres.
    Hardness,
    /// What ties the pressure on an elastic sinusoid to its interference.
    Interference,
}

/// The choices made for a model; those that it does not have are not looked at.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ModelOptions {
    /// Let the strength grow at small depths.
    pub strain_gradient: bool,
    /// The form of the hardness of spheres.
    pub hardness: Hardness,
    /// The interference law of elastic sinusoids.
    pub interference: InterferenceLaw,
}

/// What there is to know of a model before it is built.
#[derive(Debug)]
pub struct ModelEntry {
    /// The name that people type, which is also that of its curves.
    pub name: &'static str,
    /// What it is called, with those who made it.
    pub full_name: &'static str,
    /// Where it was published.
    pub citation: &'static str,
    /// Its framework.
    pub framework: Framework,
    choices: &'static [Choice],
    build: fn(&Material, &ModelOptions) -> Result<CurveModel, MaterialError>,
    is: fn(&CurveModel) -> bool,
}

/// The name of the model of the summits of a surface.
const SUMMITS: &str = "bgt";

/// Every model, in the order of the documentation.
pub static MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "elastic",
        full_name: "Archard stack, elastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Stacked,
        choices: &[],
        build: |material, _| Ok(CurveModel::Stacked(StackedModel::Elastic { pair: material.pair })),
        is: |model| matches!(model, CurveModel::Stacked(StackedModel::Elastic { .. })),
    },
    ModelEntry {
        name: "elastic-plastic",
        full_name: "Archard stack, elastic-plastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Krithivasan & Jackson (2007), Tribol. Lett. 27:31",
        framework: Framework::Stacked,
        choices: &[Choice::Strength, Choice::StrainGradient],
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(CurveModel::Stacked(StackedModel::ElasticPlastic { pair: material.pair, strength }))
        },
        is: |model| matches!(model, CurveModel::Stacked(StackedModel::ElasticPlastic { .. })),
    },
    ModelEntry {
        name: "hertz",
        full_name: "Greenwood-Williamson (Hertz)",
        citation: "Greenwood & Williamson (1966), Proc. R. Soc. A 295:300",
        framework: Framework::Statistical,
        choices: &[],
        build: |material, _| Ok(statistical(material, AsperityLaw::Hertz)),
        is: |model| has_law(model, |law| matches!(law, AsperityLaw::Hertz)),
    },
    ModelEntry {
        name: "ep-sphere",
        full_name: "GW, elastic-plastic spheres (Jackson-Green)",
        citation: "Jackson & Green (2005), J. Tribol. 127:343",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient, Choice::Hardness],
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(material, AsperityLaw::EpSphere { strength, hardness: options.hardness }))
        },
        is: |model| has_law(model, |law| matches!(law, AsperityLaw::EpSphere { .. })),
    },
    ModelEntry {
        name: "elastic-sine",
        full_name: "GW, elastic sinusoids (Rostami-Jackson)",
        citation: "Johnson, Greenwood & Higginson (1985), Int. J. Mech. Sci. 27:383; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Statistical,
        choices: &[Choice::Interference],
        build: |material, options| {
            Ok(statistical(material, AsperityLaw::ElasticSine { interference: options.interference }))
        },
        is: |model| has_law(model, |law| matches!(law, AsperityLaw::ElasticSine { .. })),
    },
    ModelEntry {
        name: "ep-sine",
        full_name: "GW, elastic-plastic sinusoids (Krithivasan-Jackson)",
        citation: "Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Rostami & Jackson (2013), Proc. IMechE J 227:1376",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient],
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(material, AsperityLaw::EpSine { strength }))
        },
        is: |model| has_law(model, |law| matches!(law, AsperityLaw::EpSine { .. })),
    },
    ModelEntry {
        name: SUMMITS,
        full_name: "elastic summits of every curvature (Bush-Gibson-Thomas)",
        citation: "Bush, Gibson & Thomas (1975), Wear 35:87; Nayak (1971), J. Lubr. Technol. 93:398",
        framework: Framework::Statistical,
        choices: &[],
        build: |material, _| {
            Ok(CurveModel::Statistical { pair: material.pair, law: StatisticalLaw::Summits })
        },
        is: |model| matches!(model, CurveModel::Statistical { law: StatisticalLaw::Summits, .. }),
    },
    ModelEntry {
        name: "persson",
        full_name: "Persson's theory, elastic",
        citation: "Persson (2001), J. Chem. Phys. 115:3840; Manners & Greenwood (2006), Wear 261:600",
        framework: Framework::Persson,
        choices: &[],
        build: |material, _| Ok(CurveModel::Persson { pair: material.pair, law: PerssonLaw::Elastic }),
        is: |model| matches!(model, CurveModel::Persson { law: PerssonLaw::Elastic, .. }),
    },
    ModelEntry {
        name: "persson-plastic",
        full_name: "Persson's theory, elastic-plastic",
        citation: "Persson (2001), Phys. Rev. Lett. 87:116101; Persson (2006), Surf. Sci. Rep. 61:201",
        framework: Framework::Persson,
        choices: &[Choice::Strength, Choice::StrainGradient],
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            let hardness_pa = material.hardness_pa().ok_or(MaterialError::Missing(NeededFor::Yielding))?;
            let hardness_over_strength = hardness_pa / strength.macroscopic_strength_pa();
            let law = PerssonLaw::ElasticPlastic { strength, hardness_over_strength };
            Ok(CurveModel::Persson { pair: material.pair, law })
        },
        is: |model| matches!(model, CurveModel::Persson { law: PerssonLaw::ElasticPlastic { .. }, .. }),
    },
];

fn statistical(material: &Material, law: AsperityLaw) -> CurveModel {
    CurveModel::Statistical { pair: material.pair, law: StatisticalLaw::Asperities(law) }
}

fn has_law(model: &CurveModel, is: impl FnOnce(&AsperityLaw) -> bool) -> bool {
    matches!(model, CurveModel::Statistical { law: StatisticalLaw::Asperities(law), .. } if is(law))
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
    of_framework(framework).find(|entry| entry.name == name).ok_or_else(|| UnknownName {
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
    pub fn build(&self, material: &Material, options: &ModelOptions) -> Result<CurveModel, MaterialError> {
        (self.build)(material, options)
    }

    /// Whether it takes the moments of a surface, rather than the asperities that they make.
    #[must_use]
    pub fn takes_moments(&self) -> bool {
        self.name == SUMMITS
    }

    /// Whether a choice is one of this model's.
    #[must_use]
    pub fn has(&self, choice: Choice) -> bool {
        self.choices.contains(&choice)
    }

    /// The name of a curve that is given none: the model's, and what sets the curve apart from a plain one. An
    /// `interference` is one that was chosen for this curve alone.
    #[must_use]
    pub fn curve_name(&self, strain_gradient: bool, interference: Option<InterferenceLaw>) -> String {
        let chosen =
            interference.filter(|law| self.has(Choice::Interference) && *law != InterferenceLaw::default());
        match chosen {
            _ if strain_gradient && self.has(Choice::StrainGradient) => {
                format!("{}-strain-gradient", self.name)
            }
            Some(law) => format!("{}-{law}", self.name),
            None => self.name.to_owned(),
        }
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
        let found = MODELS.iter().find(|entry| entry.name == name);
        found.ok_or_else(|| serde::de::Error::unknown_variant(&name, &NAMES))
    }
}

impl CurveModel {
    /// What there is to know of the model.
    #[must_use]
    pub fn entry(&self) -> &'static ModelEntry {
        let Some(entry) = MODELS.iter().find(|entry| (entry.is)(self)) else {
            unreachable!("every law has its entry, which a test goes through");
        };
        entry
    }

    /// The strength of the rough body, where it yields.
    #[must_use]
    pub fn strength(&self) -> Option<NixGao> {
        match self {
            CurveModel::Stacked(model) => model.strength(),
            CurveModel::Statistical { law: StatisticalLaw::Asperities(law), .. } => law.strength(),
            CurveModel::Statistical { law: StatisticalLaw::Summits, .. } => None,
            CurveModel::Persson { law, .. } => law.strength(),
        }
    }

    /// Whether it stands on the amplitudes of scales.
    #[must_use]
    pub fn needs_amplitudes(&self) -> bool {
        match self {
            CurveModel::Stacked(_) => true,
            CurveModel::Statistical { .. } => false,
            CurveModel::Persson { .. } => self.strength_grows(),
        }
    }

    /// Whether it stands on spectral moments.
    #[must_use]
    pub fn needs_moments(&self) -> bool {
        !matches!(self, CurveModel::Stacked(_))
    }

    /// Whether its strength grows at small depths.
    #[must_use]
    pub fn strength_grows(&self) -> bool {
        self.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some())
    }

    /// The bodies in contact.
    #[must_use]
    pub fn pair(&self) -> MaterialPair {
        match *self {
            CurveModel::Stacked(
                StackedModel::Elastic { pair } | StackedModel::ElasticPlastic { pair, .. },
            )
            | CurveModel::Statistical { pair, .. }
            | CurveModel::Persson { pair, .. } => pair,
        }
    }

    /// The same model of other bodies in contact; what yields keeps its strength.
    #[must_use]
    pub fn with_pair(self, pair: MaterialPair) -> Self {
        match self {
            CurveModel::Stacked(StackedModel::Elastic { .. }) => {
                CurveModel::Stacked(StackedModel::Elastic { pair })
            }
            CurveModel::Stacked(StackedModel::ElasticPlastic { strength, .. }) => {
                CurveModel::Stacked(StackedModel::ElasticPlastic { pair, strength })
            }
            CurveModel::Statistical { law, .. } => CurveModel::Statistical { pair, law },
            CurveModel::Persson { law, .. } => CurveModel::Persson { pair, law },
        }
    }

    /// The same model of another strength; `None` where it never yields.
    #[must_use]
    pub fn with_strength(self, strength: NixGao) -> Option<Self> {
        match self {
            CurveModel::Stacked(model) => model.with_strength(strength).map(CurveModel::Stacked),
            CurveModel::Statistical { .. } => self.with_law(|law| law.with_strength(strength)),
            CurveModel::Persson { pair, law } => {
                Some(CurveModel::Persson { pair, law: law.with_strength(strength)? })
            }
        }
    }

    /// The same model with the hardness in another form; `None` where it has none.
    #[must_use]
    pub fn with_hardness(self, hardness: Hardness) -> Option<Self> {
        self.with_law(|law| law.with_hardness(hardness))
    }

    /// The form of the hardness of its spheres; `None` where it has none.
    #[must_use]
    pub fn hardness(&self) -> Option<Hardness> {
        Hardness::ALL.into_iter().find(|hardness| self.with_hardness(*hardness) == Some(*self))
    }

    /// Its interference law; `None` where it has none.
    #[must_use]
    pub fn interference(&self) -> Option<InterferenceLaw> {
        InterferenceLaw::ALL.iter().copied().find(|law| self.with_interference(*law) == Some(*self))
    }

    /// The same model with another interference law; `None` where it has none.
    #[must_use]
    pub fn with_interference(self, interference: InterferenceLaw) -> Option<Self> {
        self.with_law(|law| law.with_interference(interference))
    }

    fn with_law(self, change: impl FnOnce(AsperityLaw) -> Option<AsperityLaw>) -> Option<Self> {
        match self {
            CurveModel::Stacked(_)
            | CurveModel::Persson { .. }
            | CurveModel::Statistical { law: StatisticalLaw::Summits, .. } => None,
            CurveModel::Statistical { pair, law: StatisticalLaw::Asperities(law) } => {
                Some(CurveModel::Statistical { pair, law: StatisticalLaw::Asperities(change(law)?) })
            }
        }
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
    fn a_name_of_the_other_framework_is_none() {
        assert_eq!(
            named(Framework::Statistical, "elastic").unwrap_err().to_string(),
            "reading the statistical model: 'elastic' is none of hertz, ep-sphere, elastic-sine, ep-sine, bgt"
        );
    }
}
