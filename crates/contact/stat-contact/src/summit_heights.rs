//! Distributions of the heights of asperities.

use units::named;

/// Distribution of the heights of asperities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SummitHeights {
    /// Gaussian.
    #[default]
    Gaussian,
    /// Exponential, exp(-z/sigma_s)/sigma_s above z = 0: the simplification of Greenwood & Williamson for elastic spheres, whose real
    /// pressure E* sqrt(sigma_s/(pi R)) is that of every load. Separations are measured from z = 0.
    Exponential,
}

named!(SummitHeights, "distribution of heights", { Gaussian => "gaussian", Exponential => "exponential" });
