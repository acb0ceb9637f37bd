//! One surface under one load.

use half_space::{Contact, Ending, OpenPaths};

/// What one surface answers to one load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PressedState {
    /// Share of the points in contact: their pressure is above 1e-10 of the nominal one.
    pub area_fraction: f64,
    /// The same less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017, Tribol. Int. 114:161).
    pub area_fraction_corrected: f64,
    /// The corrected area on every second point of the grid; `None` without such a grid.
    pub area_fraction_coarser: Option<f64>,
    /// Share of the points at the saturation; 0 without one.
    pub plastic_area_fraction: f64,
    /// The same with the staircase around each spot.
    pub plastic_area_fraction_corrected: f64,
    /// Mean over all points of the gap where it is open \[m\].
    pub mean_gap_m: f64,
    /// Mean over all points of the overlap that flow has left \[m\].
    pub mean_plastic_depth_m: f64,
    /// The largest pressure \[Pa\].
    pub largest_pressure_pa: f64,
    /// How much more pressure it takes to press the bodies nearer \[Pa/m\]; `None` where no gap is left, or nobody asked.
    pub stiffness_pa_per_m: Option<f64>,
    /// Where what is not in contact crosses the surface; ways are as narrow as a point of the grid.
    pub open: OpenPaths,
    /// Steps of the solver.
    pub iterations: usize,
    /// How often displacements were computed from pressures.
    pub operators: usize,
    /// How far from equilibrium it is: sum of p|g| over the sum of p h_rms.
    pub residual: f64,
    /// Whether rounding kept the residual above the tolerance.
    pub is_rounded: bool,
}

impl PressedState {
    /// A solved contact, its stiffness where asked for, the ways across, and the contact on every second point where there
    /// is one.
    pub(crate) fn of(
        contact: &Contact,
        stiffness_pa_per_m: Option<f64>,
        open: OpenPaths,
        coarser: Option<&Contact>,
    ) -> Self {
        PressedState {
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
