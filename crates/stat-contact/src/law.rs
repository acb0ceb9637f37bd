//! The choice of contact law, and the names by which users choose it.

use asperity::{Hardness, NixGao};
use units::named;

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
    #[must_use]
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

named!(Model, "statistical model", {
    Hertz => "hertz",
    EpSphere => "ep-sphere",
    ElasticSine => "elastic-sine",
    EpSine => "ep-sine",
});

impl Model {
    /// Whether the model needs a yield strength.
    #[must_use]
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

named!(InterferenceLaw, "interference law", {
    RostamiJackson => "rostami-jackson",
    Bem => "bem",
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_as_they_are_written() {
        for model in Model::ALL {
            assert_eq!(model.to_string().parse::<Model>().as_ref(), Ok(model));
        }
        for law in InterferenceLaw::ALL {
            assert_eq!(law.to_string().parse::<InterferenceLaw>().as_ref(), Ok(law));
        }
        assert_eq!(
            "gauss".parse::<Model>().unwrap_err().to_string(),
            "reading the statistical model: 'gauss' is none of hertz, ep-sphere, elastic-sine, ep-sine"
        );
    }
}
