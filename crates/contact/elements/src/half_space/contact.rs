//! Solution of a contact problem.

/// End of a solve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// The residual is below the tolerance.
    Converged,
    /// Rounding keeps the residual above the tolerance; see [`ContactNumbers::residual`].
    Rounding,
}

/// Numbers of a surface in equilibrium under a load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactNumbers {
    /// Load over the nominal area \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Share of the nominal points in contact, with a pressure above 1e-10 of the nominal one.
    pub area_fraction: f64,
    /// Area fraction less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017, Tribol. Int. 114:161).
    pub area_fraction_corrected: f64,
    /// Share of the nominal points at the saturation; 0 without one.
    pub plastic_area_fraction: f64,
    /// Plastic area fraction plus the staircase around each spot, because here the points below the saturation are overcounted.
    pub plastic_area_fraction_corrected: f64,
    /// Mean over all points with a height of the gap where it is open \[m\].
    pub mean_gap_m: f64,
    /// Mean over all points with a height of the depth by which the surfaces overlap \[m\]: the plastic deformation.
    pub mean_plastic_depth_m: f64,
    /// Largest pressure \[Pa\].
    pub largest_pressure_pa: f64,
    /// Steps of the solver.
    pub iterations: usize,
    /// Number of times that displacements were computed from pressures.
    pub operators: usize,
    /// Residual: sum of p|g| over the sum of p h_rms, over the points with 0 < p < saturation; or, if larger, a tenth
    /// of the largest overlap at p = 0 or gap at the saturation, over h_rms.
    pub residual: f64,
    /// End of the solve.
    pub ending: Ending,
}

/// Surface in equilibrium under a load.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contact {
    /// Its numbers.
    pub numbers: ContactNumbers,
    /// Elastic energy over the nominal area \[J/m^2\]: half of the mean of pressure times displacement.
    pub energy_j_per_m2: f64,
    /// Height \[m\] of the undeformed plane over which the gaps open: gap = displacement - height - offset. With a
    /// free boundary this is the approach of the two bodies; with a periodic one, displacements have a mean of 0 and
    /// the distance of the mean planes is its opposite.
    pub offset_m: f64,
    /// Pressure \[Pa\] at every point, row by row.
    pub pressures_pa: Vec<f64>,
    /// Gap \[m\] at every point, row by row; negative where the surfaces overlap, by plastic flow or within the
    /// tolerance, infinite at missing points.
    pub gaps_m: Vec<f64>,
}

/// Share of the nominal pressure above which a point is in contact.
pub(crate) const TOUCHING: f64 = 1e-10;

impl Contact {
    /// Returns for each point, row by row, true if it is in contact, as counted by
    /// [`area_fraction`](ContactNumbers::area_fraction).
    #[must_use]
    pub fn touching(&self) -> Vec<bool> {
        let least_pa = TOUCHING * self.numbers.nominal_pressure_pa;
        self.pressures_pa.iter().map(|&pressure_pa| pressure_pa > least_pa).collect()
    }
}
