//! States of statistical models, in runs: one after the other from its neighbour, run beside run.

use stat_contact::{Condition, ContactState, StatisticalContact};

use super::{Asperities, CutoffState, Pressable, Statistical};
use crate::plan::error::PlanError;
use crate::plan::prepared_spectrum::{Cutoff, Roughness};
use crate::plan::run::Run;
use crate::plan::work::{Work, counted};

/// The largest number of consecutive states. Each starts from its neighbour's solution. The first starts without one,
/// which costs some evaluations and changes no digit.
const STATES_PER_BLOCK: usize = 256;

/// The states of a model.
pub(crate) struct States<'r> {
    pub model: &'r Statistical,
    pub run: Run<'r>,
}

impl States<'_> {
    /// A block of rows for every condition, a row for every cutoff.
    pub fn over_cutoffs(
        &self,
        cutoffs: &[Cutoff],
        conditions: &[Condition],
    ) -> Result<(Vec<Vec<CutoffState>>, Work), PlanError> {
        if let [Cutoff { wavelength_m, roughness: Some(roughness) }] = cutoffs {
            return self.at_one_cutoff(*wavelength_m, roughness, conditions);
        }
        let pieces: Vec<&[Cutoff]> = cutoffs.chunks(STATES_PER_BLOCK).collect();
        let blocks = numerics::parallel::try_map(conditions, |&condition| {
            numerics::parallel::try_map(&pieces, |cutoffs| self.rows(cutoffs, condition)).map(joined)
        })?;
        Ok(counted(blocks))
    }

    /// Computes the states of one population, one for each of the distinct pressures \[Pa\]; empty if the model has
    /// nothing to press.
    pub fn over_loads(
        &self,
        roughness: &Roughness,
        pressures_pa: &[f64],
    ) -> Result<(Vec<ContactState>, Work), PlanError> {
        let Pressable::Contact(contact) = self.model.press_roughness(roughness)? else {
            return Ok(Default::default());
        };
        let conditions: Vec<Condition> = pressures_pa.iter().copied().map(Condition::Pressure).collect();
        self.states(&contact, &conditions)
    }

    /// Computes a block of one row for every condition. Evaluations for one condition are reused for those after it.
    fn at_one_cutoff(
        &self,
        wavelength_m: f64,
        roughness: &Roughness,
        conditions: &[Condition],
    ) -> Result<(Vec<Vec<CutoffState>>, Work), PlanError> {
        let nothing = CutoffState { wavelength_m, contact: None, too_narrow_alpha: None };
        match self.model.press_roughness(roughness)? {
            Pressable::Contact(contact) => {
                let (states, work) = self.states(&contact, conditions)?;
                let row =
                    |state| vec![CutoffState { contact: Some((roughness.asperities, state)), ..nothing }];
                Ok((states.into_iter().map(row).collect(), work))
            }
            Pressable::TooNarrow { alpha } => {
                conditions.iter().for_each(|_| self.run.state_is_known());
                let row = vec![CutoffState { too_narrow_alpha: Some(alpha), ..nothing }];
                Ok((vec![row; conditions.len()], Work::default()))
            }
        }
    }

    /// The states of a contact, one for every condition.
    fn states(
        &self,
        contact: &StatisticalContact,
        conditions: &[Condition],
    ) -> Result<(Vec<ContactState>, Work), PlanError> {
        let piece = |conditions: &[Condition]| {
            let mut sweep = contact.sweep(self.run.tolerance.value());
            let mut work = Work::default();
            let state = |condition: &Condition| {
                self.run.go_on()?;
                let state = sweep.at(*condition)?;
                self.count(&state, &mut work);
                Ok(state)
            };
            let states = conditions.iter().map(state).collect::<Result<Vec<_>, PlanError>>()?;
            Ok((states, work))
        };
        let pieces: Vec<&[Condition]> = conditions.chunks(STATES_PER_BLOCK).collect();
        numerics::parallel::try_map(&pieces, |conditions| piece(conditions)).map(joined)
    }

    /// The rows of neighbouring cutoffs under one condition, each found from the one before it, which saves work. Where a
    /// cutoff has left the asperities as they were, so is the state.
    fn rows(&self, cutoffs: &[Cutoff], condition: Condition) -> Result<(Vec<CutoffState>, Work), PlanError> {
        let mut work = Work::default();
        let mut before: Option<(Asperities, ContactState)> = None;
        let mut row = |cutoff: &Cutoff| {
            let nothing =
                CutoffState { wavelength_m: cutoff.wavelength_m, contact: None, too_narrow_alpha: None };
            let Some(roughness) = cutoff.roughness else { return Ok(nothing) };
            let asperities = Asperities::of(&roughness.asperities);
            let state = match before {
                Some((same, state)) if same == asperities => {
                    work.shared_states += 1;
                    state
                }
                neighbour => {
                    self.run.go_on()?;
                    let contact = match self.model.press_roughness(&roughness)? {
                        Pressable::Contact(contact) => contact,
                        Pressable::TooNarrow { alpha } => {
                            self.run.state_is_known();
                            return Ok(CutoffState { too_narrow_alpha: Some(alpha), ..nothing });
                        }
                    };
                    let neighbour = neighbour.map(|(_, state)| state);
                    let tolerance = self.run.tolerance.value();
                    // The neighbour saves work and changes no digit.
                    let state = contact.at(condition, tolerance, neighbour.as_ref())?;
                    self.count(&state, &mut work);
                    state
                }
            };
            before = Some((asperities, state));
            Ok(CutoffState { contact: Some((roughness.asperities, state)), ..nothing })
        };
        let rows = cutoffs.iter().map(&mut row).collect::<Result<Vec<_>, PlanError>>()?;
        Ok((rows, work))
    }

    /// Reports a computed state to the observer, and counts it.
    fn count(&self, state: &ContactState, work: &mut Work) {
        self.run.state_is_known();
        work.statistical_states += 1;
        work.law_evaluations += state.evaluations;
    }
}

/// Pieces of rows one after the other, and the work of all.
fn joined<T>(pieces: Vec<(Vec<T>, Work)>) -> (Vec<T>, Work) {
    let (pieces, work) = counted(pieces);
    (pieces.into_iter().flatten().collect(), work)
}
