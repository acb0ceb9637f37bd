//! One load on every surface, and what the surfaces say together.

use half_space::extrapolated_area;

use crate::state::PressedState;

/// One load on every surface.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PressedLoad {
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// What each surface answers, in the order of their numbers; one at least.
    pub states: Vec<PressedState>,
}

/// The mean of all surfaces under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mean {
    /// Mean share of the points in contact.
    pub area_fraction: f64,
    /// Mean of the corrected areas.
    pub area_fraction_corrected: f64,
    /// Mean of what a finer grid would show, see [`PressedLoad::extrapolated_area_fraction`]; `None` where the grid has no
    /// coarser one.
    pub area_fraction_extrapolated: Option<f64>,
    /// Standard error of that mean, or of the corrected one where there is none, s/sqrt(R); `None` for a single surface.
    pub standard_error: Option<f64>,
    /// Mean share of the points at the saturation.
    pub plastic_area_fraction: f64,
    /// Mean of the corrected plastic areas.
    pub plastic_area_fraction_corrected: f64,
    /// Mean gap \[m\].
    pub mean_gap_m: f64,
    /// Mean plastic depth \[m\].
    pub mean_plastic_depth_m: f64,
    /// The largest pressure on any surface \[Pa\].
    pub largest_pressure_pa: f64,
    /// Mean stiffness \[Pa/m\], where every surface has one.
    pub stiffness_pa_per_m: Option<f64>,
    /// Share of the surfaces that an open way crosses from the first column to the last.
    pub open_along_x: f64,
    /// Share of the surfaces that an open way crosses from the first row to the last.
    pub open_along_y: f64,
    /// The most steps that a surface took.
    pub iterations: usize,
    /// Displacements computed from pressures, on all surfaces.
    pub operators: usize,
    /// The largest residual.
    pub residual: f64,
}

impl PressedLoad {
    /// What the surfaces say together.
    #[must_use]
    pub fn mean(&self) -> Mean {
        let mean = |of: fn(&PressedState) -> f64| self.mean_of(of);
        let largest = |of: fn(&PressedState) -> f64| self.states.iter().map(of).fold(0.0, f64::max);
        let extrapolated = |state: &PressedState| self.extrapolated_area_fraction(state);
        Mean {
            area_fraction: mean(|state| state.area_fraction),
            area_fraction_corrected: mean(|state| state.area_fraction_corrected),
            area_fraction_extrapolated: self.mean_of_all(extrapolated),
            standard_error: self.standard_error(),
            plastic_area_fraction: mean(|state| state.plastic_area_fraction),
            plastic_area_fraction_corrected: mean(|state| state.plastic_area_fraction_corrected),
            mean_gap_m: mean(|state| state.mean_gap_m),
            mean_plastic_depth_m: mean(|state| state.mean_plastic_depth_m),
            largest_pressure_pa: largest(|state| state.largest_pressure_pa),
            stiffness_pa_per_m: self.mean_of_all(|state| state.stiffness_pa_per_m),
            open_along_x: mean(|state| share(state.open.along_x)),
            open_along_y: mean(|state| share(state.open.along_y)),
            iterations: self.states.iter().map(|state| state.iterations).max().unwrap_or_default(),
            operators: self.states.iter().map(|state| state.operators).sum(),
            residual: largest(|state| state.residual),
        }
    }

    /// Whether the grid is fine enough for the step to a finer one: where it shows the spots, what the correction leaves of
    /// the error is of first order in the spacing and makes areas too small, so that they grow with every finer grid. On a
    /// grid that does not show them the corrected area still falls, and a step from there would lead astray. All surfaces
    /// are asked together, as chance decides for a single one.
    #[must_use]
    pub fn shows_spots(&self) -> bool {
        let coarser = self.mean_of_all(|state| state.area_fraction_coarser);
        coarser.is_some_and(|coarser| coarser <= self.mean_of(|state| state.area_fraction_corrected))
    }

    /// The area of one of the surfaces that a finer grid would show: the step from the corrected area on every second point
    /// to that on all of them taken once more, and where the grid does not show the spots no step at all. `None` where there
    /// is no coarser grid.
    #[must_use]
    pub fn extrapolated_area_fraction(&self, state: &PressedState) -> Option<f64> {
        let coarser = state.area_fraction_coarser?;
        let corrected = state.area_fraction_corrected;
        Some(if self.shows_spots() { extrapolated_area(corrected, coarser) } else { corrected })
    }

    /// s/sqrt(R) of the best areas.
    fn standard_error(&self) -> Option<f64> {
        let best = |state: &PressedState| {
            self.extrapolated_area_fraction(state).unwrap_or(state.area_fraction_corrected)
        };
        let (count, mean) = (self.states.len() as f64, self.mean_of(best));
        let squares: f64 = self.states.iter().map(|state| (best(state) - mean).powi(2)).sum();
        (self.states.len() > 1).then(|| (squares / (count - 1.0) / count).sqrt())
    }

    fn mean_of(&self, of: impl Fn(&PressedState) -> f64) -> f64 {
        self.states.iter().map(of).sum::<f64>() / self.states.len() as f64
    }

    /// A mean where every surface has a value.
    fn mean_of_all(&self, of: impl Fn(&PressedState) -> Option<f64>) -> Option<f64> {
        let values: Vec<f64> = self.states.iter().map(of).collect::<Option<_>>()?;
        Some(values.iter().sum::<f64>() / values.len() as f64)
    }
}

/// What one surface adds to a share of surfaces.
pub(crate) fn share(is_so: bool) -> f64 {
    if is_so { 1.0 } else { 0.0 }
}

impl Mean {
    /// The best value of the area that there is: extrapolated, else corrected.
    #[must_use]
    pub fn best_area_fraction(&self) -> f64 {
        self.area_fraction_extrapolated.unwrap_or(self.area_fraction_corrected)
    }
}
