//! States of surfaces under a load, with their mean gaps.

use asperity::AsperityError;
use persson::Band;
use persson::EnergyFactor;
use persson::hardness_laws::HardnessError;

use super::tolerance::Tolerance;

/// A surface under a nominal pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapState {
    /// Nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Real over nominal area of contact.
    pub area_fraction: f64,
    /// Mean of the open gap \[m\]; none where the model has none: where more than 3 % of the contact flows at a hardness that grows in
    /// Persson's theory, and beyond complete contact or what all flattened spheres carry.
    pub mean_gap_m: Option<f64>,
    /// Distance of the mean planes of the undeformed faces \[m\]: less than the mean gap by the mean depth that has flowed.
    pub mean_plane_distance_m: Option<f64>,
    /// K = -dp/du \[Pa/m\], of unloading where the contact has flowed; none where there is no gap.
    pub stiffness_pa_per_m: Option<f64>,
}

/// Choices beside the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapChoices {
    /// Elastic energy factor of Persson's theory.
    pub energy_factor: EnergyFactor,
    /// The band that a cutoff lets through in Persson's theory.
    pub band: Band,
    /// Relative tolerance of statistical states.
    pub tolerance: Tolerance,
}

/// Why a model has no gaps.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GapError {
    /// A model that knows no distance between the surfaces.
    #[error("the model {0} knows areas and no distances; take a statistical one, or one of Persson's theory")]
    NoDistances(&'static str),
    /// One sample, or moments that make no asperities.
    #[error(
        "the spectrum has no gap: its moments need two samples at least, and numbers within the range of doubles"
    )]
    NoRoughness,
    /// A spectrum that no isotropic surface has.
    #[error(
        "the spectrum is narrower than that of any isotropic surface (alpha = {alpha}, at least 1.5): it has no summits"
    )]
    TooNarrow {
        /// m0 m4/m2^2.
        alpha: f64,
    },
    /// A hardness that cannot be used with this spectrum, or cannot carry a load.
    #[error(transparent)]
    Hardness(#[from] HardnessError),
    /// A value that no model takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
    /// The work was cancelled.
    #[error("ended before all was computed")]
    Cancelled,
}
