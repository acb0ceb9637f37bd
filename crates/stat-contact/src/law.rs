//! The choice of contact law, and the names by which users choose it.

use std::fmt;
use std::str::FromStr;

use asperity::{Hardness, NixGao};

/// How one asperity answers to the flat that presses on it (`docs/models.md`, sections 2 and 3.1).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub enum AsperityLaw {
    /// An elastic sphere (Greenwood & Williamson 1966).
    Hertz,
    /// The elastic-plastic sphere of Jackson & Green (2005; section 2.2); the area of one never exceeds pi R^2.
    EpSphere {
        /// Yield strength, at the depth of the interference.
        strength: NixGao,
        /// How the hardness falls as the contact grows.
        hardness: Hardness,
    },
    /// The elastic sinusoid of Johnson, Greenwood & Higginson (1985; section 2.3), with the density and the curvature
    /// of the population (Jackson & Jacobs, Eqs. 6 and 7).
    ElasticSine {
        /// What ties its pressure to its interference.
        interference: InterferenceLaw,
    },
    /// The elastic-plastic sinusoid of Krithivasan & Jackson (2007; section 2.4), pressed by the mean gap of Rostami &
    /// Jackson (2013; section 2.6).
    EpSine {
        /// Yield strength, at the depth of the interference.
        strength: NixGao,
    },
}

impl AsperityLaw {
    /// The model that this law belongs to.
    pub fn model(&self) -> Model {
        match self {
            AsperityLaw::Hertz => Model::Hertz,
            AsperityLaw::EpSphere { .. } => Model::EpSphere,
            AsperityLaw::ElasticSine { .. } => Model::ElasticSine,
            AsperityLaw::EpSine { .. } => Model::EpSine,
        }
    }
}

/// The four statistical models by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// Elastic spheres.
    Hertz,
    /// Elastic-plastic spheres.
    EpSphere,
    /// Elastic sinusoids.
    ElasticSine,
    /// Elastic-plastic sinusoids.
    EpSine,
}

impl Model {
    /// Every model, in the order of the documentation.
    pub const ALL: [Model; 4] = [Model::Hertz, Model::EpSphere, Model::ElasticSine, Model::EpSine];

    /// The name users type.
    pub fn name(self) -> &'static str {
        match self {
            Model::Hertz => "hertz",
            Model::EpSphere => "ep-sphere",
            Model::ElasticSine => "elastic-sine",
            Model::EpSine => "ep-sine",
        }
    }

    /// Whether the model needs a yield strength.
    pub fn is_plastic(self) -> bool {
        matches!(self, Model::EpSphere | Model::EpSine)
    }
}

/// The mean gap of the elastic sinusoid against its mean pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InterferenceLaw {
    /// The fit of Rostami & Jackson (2013), not Hertzian at light pressure.
    #[default]
    RostamiJackson,
    /// Boundary-element solutions, Hertzian at light pressure (section 3.3).
    Bem,
}

impl InterferenceLaw {
    /// Both laws.
    pub const ALL: [InterferenceLaw; 2] = [InterferenceLaw::RostamiJackson, InterferenceLaw::Bem];

    /// The name users type.
    pub fn name(self) -> &'static str {
        match self {
            InterferenceLaw::RostamiJackson => "rostami-jackson",
            InterferenceLaw::Bem => "bem",
        }
    }
}

/// A name that stands for nothing here; its message lists those that do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{given:?} is no {what}; there are {known}")]
pub struct UnknownName {
    given: String,
    what: &'static str,
    known: String,
}

fn find<T: Copy>(
    all: &[T],
    name: fn(T) -> &'static str,
    what: &'static str,
    given: &str,
) -> Result<T, UnknownName> {
    all.iter().copied().find(|&item| name(item) == given).ok_or_else(|| UnknownName {
        given: given.to_owned(),
        what,
        known: all.iter().map(|&item| name(item)).collect::<Vec<_>>().join(", "),
    })
}

impl FromStr for Model {
    type Err = UnknownName;

    fn from_str(given: &str) -> Result<Self, UnknownName> {
        find(&Model::ALL, Model::name, "statistical model", given)
    }
}

impl FromStr for InterferenceLaw {
    type Err = UnknownName;

    fn from_str(given: &str) -> Result<Self, UnknownName> {
        find(&InterferenceLaw::ALL, InterferenceLaw::name, "interference law", given)
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl fmt::Display for InterferenceLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_as_they_are_written() {
        for model in Model::ALL {
            assert_eq!(model.to_string().parse::<Model>().unwrap(), model);
        }
        for law in InterferenceLaw::ALL {
            assert_eq!(law.to_string().parse::<InterferenceLaw>().unwrap(), law);
        }
        assert_eq!(
            "gauss".parse::<Model>().unwrap_err().to_string(),
            "\"gauss\" is no statistical model; there are hertz, ep-sphere, elastic-sine, ep-sine"
        );
    }
}
