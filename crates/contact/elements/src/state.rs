//! State of one surface under one load.

use crate::half_space::{Contact, Ending, OpenPaths};

/// State of one surface under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PressedState {
    /// Nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Share of the points in contact, with a pressure above 1e-10 of the nominal one.
    pub area_fraction: f64,
    /// Area fraction less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017, Tribol. Int. 114:161).
    pub area_fraction_corrected: f64,
    /// Corrected area fraction on every second point of the grid; `None` without such a grid.
    pub area_fraction_coarser: Option<f64>,
    /// Share of the points at the saturation; 0 without one.
    pub plastic_area_fraction: f64,
    /// Plastic area fraction plus the staircase around each spot.
    pub plastic_area_fraction_corrected: f64,
    /// Mean over all points of the gap where it is open \[m\].
    pub mean_gap_m: f64,
    /// Mean over all points of the overlap left by plastic flow \[m\].
    pub mean_plastic_depth_m: f64,
    /// Largest pressure \[Pa\].
    pub largest_pressure_pa: f64,
    /// Pressure that would close the bodies by 1 m \[Pa/m\]; `None` if no gap is left, or if it was not computed.
    pub stiffness_pa_per_m: Option<f64>,
    /// Open paths across the surface; they may be as narrow as a point of the grid.
    pub open: OpenPaths,
    /// Steps of the solver.
    pub iterations: usize,
    /// Number of times that displacements were computed from pressures.
    pub operators: usize,
    /// Residual: sum of p|g| over the sum of p h_rms.
    pub residual: f64,
    /// True if rounding kept the residual above the tolerance.
    pub is_rounded: bool,
}

impl PressedState {
    /// Creates the state from a solved contact, its stiffness if computed, the open paths, and the contact on every
    /// second point if there is one.
    pub(crate) fn new(
        contact: &Contact,
        stiffness_pa_per_m: Option<f64>,
        open: OpenPaths,
        coarser: Option<&Contact>,
    ) -> Self {
        PressedState {
            nominal_pressure_pa: contact.nominal_pressure_pa,
            area_fraction: contact.area_fraction,
            area_fraction_corrected: contact.area_fraction_corrected,
            area_fraction_coarser: coarser.map(|coarser| coarser.area_fraction_corrected),
            plastic_area_fraction: contact.plastic_area_fraction_raw,
            plastic_area_fraction_corrected: contact.plastic_area_fraction,
            mean_gap_m: contact.mean_gap_m,
            mean_plastic_depth_m: contact.mean_plastic_depth_m,
            largest_pressure_pa: contact.largest_pressure_pa,
            stiffness_pa_per_m,
            open,
            iterations: contact.iterations,
            operators: contact.operators,
            residual: contact.residual,
            is_rounded: contact.ending == Ending::Rounding,
        }
    }
}
