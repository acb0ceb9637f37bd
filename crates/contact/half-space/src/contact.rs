//! What a pressed surface is asked.

use crate::sums;

/// How a solve ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// The residual is below the tolerance.
    Converged,
    /// Rounding keeps the residual above the tolerance, which is told beside it.
    Rounding,
}

/// A surface in equilibrium under a load.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contact {
    /// Share of the points in contact: their pressure is above 1e-10 of the nominal one.
    pub area_fraction: f64,
    /// The same without the staircase around each spot: less the perimeter's share (Yastrebov, Anciaux & Molinari 2017).
    pub area_fraction_corrected: f64,
    /// Share of the points at the saturation, with the staircase around them, since those below it are the ones counted too
    /// small; 0 without a saturation.
    pub plastic_area_fraction: f64,
    /// Share of the points at the saturation; 0 without one.
    pub plastic_area_fraction_raw: f64,
    /// Mean over all points of the gap where it is open, in m.
    pub mean_gap_m: f64,
    /// Mean over all points of the depth by which the surfaces overlap, in m: what has flowed.
    pub mean_plastic_depth_m: f64,
    /// The largest pressure in Pa.
    pub largest_pressure_pa: f64,
    /// Elastic energy over the nominal area, in J/m^2: half of the mean of pressure times displacement.
    pub energy_j_per_m2: f64,
    /// Height in m of the undeformed plane over which the gaps open: gap = displacement - height - offset. Where the boundary
    /// is free this is the approach of the two bodies; where it is periodic, displacements have a mean of 0 and the distance
    /// of the mean planes is its opposite.
    pub offset_m: f64,
    /// Steps of the solver.
    pub iterations: usize,
    /// How often displacements were computed from pressures.
    pub operators: usize,
    /// Sum of p|g| over the sum of p h_rms, over the points with 0 < p < saturation; or, where it is more, a tenth of the
    /// largest overlap at p = 0 or gap at the saturation, over h_rms.
    pub residual: f64,
    /// Whether the residual is below the tolerance.
    pub ending: Ending,
    /// Pressure in Pa at every point, row by row.
    pub pressures_pa: Vec<f64>,
    /// Gap in m at every point, row by row; negative where the surfaces overlap, by flow or within the tolerance.
    pub gaps_m: Vec<f64>,
}

/// Contact is where the pressure is above this share of the nominal one.
pub(crate) const TOUCHING: f64 = 1e-10;

impl Contact {
    /// Whether each point is in contact, row by row, as [`area_fraction`](Self::area_fraction) counts them.
    #[must_use]
    pub fn touching(&self) -> Vec<bool> {
        let points = self.pressures_pa.len();
        let [sum_pa] = sums::over(points, |point| [self.pressures_pa[point]]);
        let least_pa = TOUCHING * sum_pa / points as f64;
        self.pressures_pa.iter().map(|&pressure_pa| pressure_pa > least_pa).collect()
    }
}
