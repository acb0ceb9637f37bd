//! Surfaces that attract each other, under every load on both branches, and pulled apart.

use crate::half_space::{
    Adhesion, AdhesionError, AdhesiveContact, AdhesiveElements, AdhesiveNumbers, Control, HalfSpaceError,
    Start,
};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use tables::Table;
use thiserror::Error;
use units::display::pressure;
use units::named;

use crate::boundary::Boundary;
use crate::relief::Relief;
use crate::surfaces::Surfaces;
use spectrum::random_surfaces::RandomSurfaceError;

/// Steps from one load to the next, so that no state on the way is skipped.
const STEPS_TO_A_LOAD: usize = 4;
/// Step of the mean gap while surfaces are pulled apart, in rms heights.
const GAP_STEP: f64 = 0.01;
/// Share of the largest pull at which surfaces count as apart.
const APART: f64 = 0.2;
/// Most steps while surfaces are pulled apart.
const MOST_GAP_STEPS: usize = 4000;

/// History of an adhesive contact, which decides its state where there are several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Branch {
    /// The surfaces approach from first touch, and the load rises from zero, or falls if it is negative.
    Apart,
    /// The load falls from full contact.
    Contact,
}

named!(Branch, "branch", { Apart => "apart", Contact => "contact" });

/// Material, attraction, loads and branches.
#[derive(Clone, Debug, PartialEq)]
pub struct AdhesivePressing {
    /// Contact modulus E* \[Pa\].
    pub contact_modulus_pa: f64,
    /// Attraction.
    pub adhesion: Adhesion,
    /// Nominal pressures \[Pa\]; negative ones pull.
    pub pressures_pa: Vec<f64>,
    /// Branches that are followed.
    pub branches: Vec<Branch>,
    /// Largest residual, above 0 and at most 0.1.
    pub tolerance: f64,
}

/// State of one surface under one load on one branch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AdhesiveState {
    /// Surface, from 0.
    pub surface: usize,
    /// Branch on which it was reached.
    pub branch: Branch,
    /// Numbers of the contact.
    pub numbers: AdhesiveNumbers,
}

/// Reason why adhesive surfaces were not pressed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum AdhesiveError {
    /// The edges of a map are free.
    #[error(
        "adhesion: the edges of the map are free, and only a periodic surface is solved; make its boundary periodic"
    )]
    FreeEdges,
    /// There is no load.
    #[error("adhesion: there is no load")]
    NoLoad,
    /// A load pulls the surfaces apart.
    #[error(
        "adhesion: {} pulls the surfaces apart; the last load that held was {}; pull less",
        pressure(*.nominal_pressure_pa), pressure(*.held_pa)
    )]
    PulledOff {
        /// The load \[Pa\].
        nominal_pressure_pa: f64,
        /// The last load that held \[Pa\].
        held_pa: f64,
    },
    /// The surface cannot be made.
    #[error(transparent)]
    Surface(#[from] RandomSurfaceError),
    /// The surface cannot be pressed.
    #[error(transparent)]
    Adhesion(#[from] AdhesionError),
}

impl From<HalfSpaceError> for AdhesiveError {
    fn from(error: HalfSpaceError) -> Self {
        AdhesionError::from(error).into()
    }
}

impl AdhesivePressing {
    /// Checks that the grid of a surface resolves the process zone E* rho^2/w; returns points of the grid in it.
    ///
    /// # Errors
    /// [`AdhesionError::Unresolved`] with the points that would do, and numbers out of their bounds.
    pub fn resolution(&self, relief: &Relief) -> Result<f64, AdhesiveError> {
        if relief.boundary == Boundary::Free {
            return Err(AdhesiveError::FreeEdges);
        }
        relief.check_whole()?;
        Ok(self.adhesion.resolution(&relief.grid()?, self.contact_modulus_pa)?)
    }

    /// Presses every surface under every load on every branch: on as many threads as there are, and with the same digits on any
    /// number of them. The states come surface by surface, branch by branch, in the order of the loads.
    ///
    /// # Errors
    /// [`AdhesiveError`]; the first surface that fails.
    pub fn press(
        &self,
        surfaces: &Surfaces,
        progress: &dyn Progress,
    ) -> Result<Vec<AdhesiveState>, AdhesiveError> {
        if self.pressures_pa.is_empty() {
            return Err(AdhesiveError::NoLoad);
        }
        let branches = self.branches.len();
        let of_pairs = numerics::parallel::map_indices(surfaces.count() * branches, |pair| {
            let (surface, branch) = (pair / branches, self.branches[pair % branches]);
            let relief = surfaces.relief(surface)?;
            self.resolution(&relief)?;
            let mut elements = self.elements(&relief)?;
            let found = self.along(branch, &mut elements, progress)?;
            Ok(found
                .iter()
                .map(|contact| AdhesiveState { surface, branch, numbers: contact.numbers })
                .collect::<Vec<_>>())
        });
        let states = of_pairs.into_iter().collect::<Result<Vec<_>, AdhesiveError>>()?;
        Ok(states.into_iter().flatten().collect())
    }

    fn elements(&self, relief: &Relief) -> Result<AdhesiveElements, AdhesiveError> {
        let (modulus_pa, adhesion) = (self.contact_modulus_pa, self.adhesion);
        Ok(AdhesiveElements::new(relief.grid()?, &relief.heights_m, modulus_pa, adhesion)?)
    }

    /// Follows a branch; the states are in the order of the loads.
    fn along(
        &self,
        branch: Branch,
        elements: &mut AdhesiveElements,
        progress: &dyn Progress,
    ) -> Result<Vec<AdhesiveContact>, AdhesiveError> {
        let mut found: Vec<Option<AdhesiveContact>> = vec![None; self.pressures_pa.len()];
        let mut order: Vec<usize> = (0..self.pressures_pa.len()).collect();
        order.sort_by(|a, b| self.pressures_pa[*a].total_cmp(&self.pressures_pa[*b]));
        let mut follow = |loads: &mut dyn Iterator<Item = usize>, mut last_pa: f64, start: Start| {
            let mut held = self.solve(elements, last_pa, start, last_pa, progress)?;
            for load in loads {
                let pressure_pa = self.pressures_pa[load];
                let from_pa = last_pa;
                for step in 1..=STEPS_TO_A_LOAD {
                    if pressure_pa == from_pa {
                        break;
                    }
                    let share = step as f64 / STEPS_TO_A_LOAD as f64;
                    // The last step ends on the load itself, to the last digit.
                    let next_pa = if step == STEPS_TO_A_LOAD {
                        pressure_pa
                    } else {
                        from_pa + share * (pressure_pa - from_pa)
                    };
                    held = self.solve(elements, next_pa, Start::Last, last_pa, progress)?;
                    last_pa = next_pa;
                }
                found[load] = Some(held.clone());
            }
            Ok::<(), AdhesiveError>(())
        };
        match branch {
            Branch::Apart => {
                let (pulling, pressing): (Vec<usize>, Vec<usize>) =
                    order.iter().partition(|load| self.pressures_pa[**load] < 0.0);
                if !pulling.is_empty() {
                    follow(&mut pulling.into_iter().rev(), 0.0, Start::Apart)?;
                }
                if !pressing.is_empty() {
                    follow(&mut pressing.into_iter(), 0.0, Start::Apart)?;
                }
            }
            Branch::Contact => {
                let largest_pa = order.last().map_or(0.0, |load| self.pressures_pa[*load]);
                follow(&mut order.into_iter().rev(), largest_pa, Start::Contact)?;
            }
        }
        Ok(found.into_iter().flatten().collect())
    }

    /// Solves one load; `held_pa` is the last one that held.
    fn solve(
        &self,
        elements: &mut AdhesiveElements,
        nominal_pressure_pa: f64,
        start: Start,
        held_pa: f64,
        progress: &dyn Progress,
    ) -> Result<AdhesiveContact, AdhesiveError> {
        let control = Control::PressurePa(nominal_pressure_pa);
        let found = elements.solve(control, start, self.tolerance, progress);
        progress.advance(1);
        found.map_err(|error| match error {
            AdhesionError::PulledOff { nominal_pressure_pa } => {
                AdhesiveError::PulledOff { nominal_pressure_pa, held_pa }
            }
            error => error.into(),
        })
    }

    /// Pulls every surface apart from the state without a load on the branch `apart`, by a mean gap that rises in steps of a
    /// hundredth of the rms height. The states end where the pull has fallen to a fifth of its largest value.
    ///
    /// # Errors
    /// [`AdhesiveError`]; the first surface that fails.
    pub fn pull_apart(
        &self,
        surfaces: &Surfaces,
        progress: &dyn Progress,
    ) -> Result<Vec<AdhesiveState>, AdhesiveError> {
        let of_surfaces = numerics::parallel::map_indices(surfaces.count(), |surface| {
            let relief = surfaces.relief(surface)?;
            self.resolution(&relief)?;
            let mut elements = self.elements(&relief)?;
            let free = self.solve(&mut elements, 0.0, Start::Apart, 0.0, progress)?;
            let step_m = GAP_STEP * relief.rms_height_m();
            let state = |contact: &AdhesiveContact| AdhesiveState {
                surface,
                branch: Branch::Apart,
                numbers: contact.numbers,
            };
            let mut states = vec![state(&free)];
            let mut largest_pull_pa = 0.0f64;
            for step in 1..=MOST_GAP_STEPS {
                let control = Control::MeanGapM(free.numbers.mean_gap_m + step as f64 * step_m);
                let contact = elements.solve(control, Start::Last, self.tolerance, progress)?;
                progress.advance(1);
                states.push(state(&contact));
                let pull_pa = -contact.numbers.nominal_pressure_pa;
                largest_pull_pa = largest_pull_pa.max(pull_pa);
                if largest_pull_pa > 0.0 && pull_pa < APART * largest_pull_pa {
                    break;
                }
            }
            Ok(states)
        });
        let states = of_surfaces.into_iter().collect::<Result<Vec<_>, AdhesiveError>>()?;
        Ok(states.into_iter().flatten().collect())
    }
}

/// Means over the surfaces, for each branch and load in the order in which they were pressed.
#[must_use]
pub fn adhesive_means(states: &[AdhesiveState]) -> Vec<AdhesiveState> {
    let first = states.first().map_or(0, |state| state.surface);
    let of_first: Vec<&AdhesiveState> = states.iter().filter(|state| state.surface == first).collect();
    let mean = |at: usize| {
        let same: Vec<&AdhesiveState> = states.iter().skip(at).step_by(of_first.len()).collect();
        let mean = |of: fn(&AdhesiveNumbers) -> f64| {
            same.iter().map(|state| of(&state.numbers)).sum::<f64>() / same.len() as f64
        };
        let largest =
            |of: fn(&AdhesiveNumbers) -> f64| same.iter().map(|state| of(&state.numbers)).fold(0.0, f64::max);
        let numbers = AdhesiveNumbers {
            area_fraction: mean(|numbers| numbers.area_fraction),
            area_fraction_corrected: mean(|numbers| numbers.area_fraction_corrected),
            repulsive_area_fraction: mean(|numbers| numbers.repulsive_area_fraction),
            mean_gap_m: mean(|numbers| numbers.mean_gap_m),
            mean_attraction_pa: mean(|numbers| numbers.mean_attraction_pa),
            largest_contact_pressure_pa: largest(|numbers| numbers.largest_contact_pressure_pa),
            residual: largest(|numbers| numbers.residual),
            ..of_first[at].numbers
        };
        AdhesiveState { numbers, ..*of_first[at] }
    };
    (0..of_first.len()).map(mean).collect()
}

/// Table with a row per state: `nominal_pressure_pa, branch, area_fraction, area_fraction_corrected, repulsive_area_fraction,
/// mean_gap_m, mean_attraction_pa, largest_contact_pressure_pa, residual`; begun by `realisation` if `numbered`.
#[must_use]
pub fn adhesive_table(states: &[AdhesiveState], numbered: bool) -> Table {
    let column = |of: fn(&AdhesiveNumbers) -> f64| states.iter().map(move |state| of(&state.numbers));
    let table = if numbered {
        Table::default().with_numbers("realisation", states.iter().map(|state| (state.surface + 1) as f64))
    } else {
        Table::default()
    };
    table
        .with_numbers("nominal_pressure_pa", column(|numbers| numbers.nominal_pressure_pa))
        .with_words("branch", states.iter().map(|state| state.branch.name()))
        .with_numbers("area_fraction", column(|numbers| numbers.area_fraction))
        .with_numbers("area_fraction_corrected", column(|numbers| numbers.area_fraction_corrected))
        .with_numbers("repulsive_area_fraction", column(|numbers| numbers.repulsive_area_fraction))
        .with_numbers("mean_gap_m", column(|numbers| numbers.mean_gap_m))
        .with_numbers("mean_attraction_pa", column(|numbers| numbers.mean_attraction_pa))
        .with_numbers("largest_contact_pressure_pa", column(|numbers| numbers.largest_contact_pressure_pa))
        .with_numbers("residual", column(|numbers| numbers.residual))
}
