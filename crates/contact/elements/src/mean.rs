//! One load on every surface, and the mean over the surfaces.

use crate::half_space::extrapolated_area;

use crate::state::PressedState;

/// One load on every surface.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PressedLoad {
    /// Nominal pressure \[Pa\]; the mean over the surfaces where each has its own.
    pub nominal_pressure_pa: f64,
    /// State of each surface, in the order of their numbers; at least one.
    pub states: Vec<PressedState>,
}

/// Mean of all surfaces under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mean {
    /// Mean share of the points in contact.
    pub area_fraction: f64,
    /// Mean of the corrected areas.
    pub area_fraction_corrected: f64,
    /// Mean of the areas extrapolated to a finer grid, see [`PressedLoad::extrapolated_area_fraction`]; `None` if the
    /// grid has no coarser one.
    pub area_fraction_extrapolated: Option<f64>,
    /// Standard error s/sqrt(R) of the extrapolated mean or, without one, of the corrected mean; `None` for a single
    /// surface.
    pub standard_error: Option<f64>,
    /// Mean share of the points at the saturation.
    pub plastic_area_fraction: f64,
    /// Mean of the corrected plastic areas.
    pub plastic_area_fraction_corrected: f64,
    /// Mean gap \[m\].
    pub mean_gap_m: f64,
    /// Mean plastic depth \[m\].
    pub mean_plastic_depth_m: f64,
    /// Largest pressure on any surface \[Pa\].
    pub largest_pressure_pa: f64,
    /// Mean stiffness \[Pa/m\]; `None` unless every surface has one.
    pub stiffness_pa_per_m: Option<f64>,
    /// Share of the surfaces with an open path from the first column to the last.
    pub open_along_x: f64,
    /// Share of the surfaces with an open path from the first row to the last.
    pub open_along_y: f64,
    /// Largest number of steps for a surface.
    pub iterations: usize,
    /// Number of times that displacements were computed from pressures, on all surfaces.
    pub operators: usize,
    /// Largest residual.
    pub residual: f64,
}

impl PressedLoad {
    /// Computes the mean over the surfaces.
    #[must_use]
    pub fn mean(&self) -> Mean {
        let mean = |of: fn(&PressedState) -> f64| self.mean_of(of);
        let largest = |of: fn(&PressedState) -> f64| self.states.iter().map(of).fold(0.0, f64::max);
        let extrapolated = |state: &PressedState| self.extrapolated_area_fraction(state);
        Mean {
            area_fraction: mean(|state| state.numbers.area_fraction),
            area_fraction_corrected: mean(|state| state.numbers.area_fraction_corrected),
            area_fraction_extrapolated: self.mean_of_all(extrapolated),
            standard_error: self.standard_error(),
            plastic_area_fraction: mean(|state| state.numbers.plastic_area_fraction),
            plastic_area_fraction_corrected: mean(|state| state.numbers.plastic_area_fraction_corrected),
            mean_gap_m: mean(|state| state.numbers.mean_gap_m),
            mean_plastic_depth_m: mean(|state| state.numbers.mean_plastic_depth_m),
            largest_pressure_pa: largest(|state| state.numbers.largest_pressure_pa),
            stiffness_pa_per_m: self.mean_of_all(|state| state.stiffness_pa_per_m),
            open_along_x: mean(|state| share(state.open.along_x)),
            open_along_y: mean(|state| share(state.open.along_y)),
            iterations: self.states.iter().map(|state| state.numbers.iterations).max().unwrap_or_default(),
            operators: self.states.iter().map(|state| state.numbers.operators).sum(),
            residual: largest(|state| state.numbers.residual),
        }
    }

    /// Best available area of surfaces that flow at a hardness \[Pa\], if any: contact carries the hardness at most, and so p/H touches at
    /// least, though corrected areas may be less.
    #[must_use]
    pub fn area_fraction(&self, hardness_pa: Option<f64>) -> f64 {
        let least = hardness_pa.map_or(0.0, |hardness_pa| self.nominal_pressure_pa / hardness_pa);
        self.mean().best_area_fraction().max(least)
    }

    /// Returns true if the grid is fine enough for an extrapolation. A grid that resolves the spots leaves a
    /// corrected error of first order in the spacing that makes areas too small, so that they grow with every finer
    /// grid. On a coarser grid the corrected area still falls, and an extrapolation would mislead. The mean over all
    /// surfaces decides, because single ones scatter.
    #[must_use]
    pub fn shows_spots(&self) -> bool {
        let coarser = self.mean_of_all(|state| state.area_fraction_coarser);
        coarser.is_some_and(|coarser| coarser <= self.mean_of(|state| state.numbers.area_fraction_corrected))
    }

    /// Area of one of the surfaces, extrapolated to a finer grid: adds the step from the corrected area on every
    /// second point to that on all of them once more, or nothing if the grid does not resolve the spots. `None` if
    /// there is no coarser grid.
    #[must_use]
    pub fn extrapolated_area_fraction(&self, state: &PressedState) -> Option<f64> {
        let coarser = state.area_fraction_coarser?;
        let corrected = state.numbers.area_fraction_corrected;
        Some(if self.shows_spots() { extrapolated_area(corrected, coarser) } else { corrected })
    }

    /// Standard error s/sqrt(R) of the best areas.
    fn standard_error(&self) -> Option<f64> {
        let best = |state: &PressedState| {
            self.extrapolated_area_fraction(state).unwrap_or(state.numbers.area_fraction_corrected)
        };
        let (count, mean) = (self.states.len() as f64, self.mean_of(best));
        let squares: f64 = self.states.iter().map(|state| (best(state) - mean).powi(2)).sum();
        (self.states.len() > 1).then(|| (squares / (count - 1.0) / count).sqrt())
    }

    fn mean_of(&self, of: impl Fn(&PressedState) -> f64) -> f64 {
        self.states.iter().map(of).sum::<f64>() / self.states.len() as f64
    }

    /// Mean over the surfaces; `None` unless every surface has a value.
    fn mean_of_all(&self, of: impl Fn(&PressedState) -> Option<f64>) -> Option<f64> {
        let values: Vec<f64> = self.states.iter().map(of).collect::<Option<_>>()?;
        Some(values.iter().sum::<f64>() / values.len() as f64)
    }
}

/// Contribution of one surface to a share of surfaces: 1 or 0.
pub(crate) fn share(is_so: bool) -> f64 {
    if is_so { 1.0 } else { 0.0 }
}

impl Mean {
    /// Best available area: extrapolated, else corrected.
    #[must_use]
    pub fn best_area_fraction(&self) -> f64 {
        self.area_fraction_extrapolated.unwrap_or(self.area_fraction_corrected)
    }
}
