//! Roughness of a row: asperities of one curvature, or the summits of a surface.

use study::models::ModelEntry;

/// The three numbers of a row's roughness, in the order of [`Roughness::columns`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness(pub [f64; 3]);

impl Roughness {
    /// McCool's parameters, which most models take.
    pub const ASPERITIES: [&'static str; 3] = ["radius_m", "density_per_m2", "sigma_s_m"];

    /// The moments of profiles, which a model of the summits takes instead.
    pub const MOMENTS: [&'static str; 3] = ["m0_m2", "m2", "m4_per_m2"];

    /// The roughness columns of a model.
    #[must_use]
    pub fn columns(entry: &ModelEntry) -> [&'static str; 3] {
        if entry.takes_moments() { Self::MOMENTS } else { Self::ASPERITIES }
    }
}
