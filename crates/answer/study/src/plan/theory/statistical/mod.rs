//! Populations of asperities that cutoffs leave, under loads and at separations.

pub(in crate::plan) mod states;

use std::num::NonZeroU32;
use std::ops::Range;

use serde::Serialize;
use spectrum::AsperityParameters;
use stat_contact::{Condition, ContactState, StatisticalContact};
use tables::Table;

use self::states::States;
use super::{CurveResult, CurveTheory, Job, Rows};
use crate::models::{Pressable, Statistical, StatisticalLaw};
use crate::plan::condition::contact_of;
use crate::plan::gap::{GapChoices, GapError, GapState, LoadedSurface};
use crate::plan::prepared_spectrum::{Cutoff, Roughness};
use crate::plan::{Cutoffs, Plan, PlanError, PreparedSpectrum, Work};

/// The contact of the asperities that a spectrum has up to a cutoff.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CutoffState {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The asperities and their contact; `None` at the longest wavelength, where there are no moments yet.
    pub contact: Option<(AsperityParameters, ContactState)>,
    /// Alpha of a spectrum too narrow for any surface, for a model of summits: there is no contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub too_narrow_alpha: Option<f64>,
}

/// One column of a state.
type StateColumn = (&'static str, fn(&ContactState) -> Option<f64>);

/// Columns of a statistical state on how it was found, and its logarithms.
pub const STATE_DETAILS: [StateColumn; 5] = [
    ("error_estimate", |state| Some(state.error_estimate)),
    ("evaluations", |state| Some(state.evaluations as f64)),
    ("out_of_range_load_share", |state| Some(state.out_of_range_load_share)),
    ("ln_pressure_pa", |state| Some(state.ln_pressure_pa)),
    ("ln_area_fraction", |state| Some(state.ln_area_fraction)),
];

impl CurveTheory for Statistical {
    fn most_states(&self, cutoffs: usize) -> usize {
        cutoffs
    }

    fn rows_per_block(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> usize {
        prepared.cutoff_count(cutoffs)
    }

    fn splits_blocks(&self) -> bool {
        true
    }

    fn check(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> Result<(), PlanError> {
        for cutoff in prepared.cutoffs(cutoffs, 0..prepared.cutoff_count(cutoffs)) {
            cutoff.roughness.map(|roughness| contact_of(self, &roughness)).transpose()?;
        }
        Ok(())
    }

    fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        places: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let cutoffs = job.prepared.cutoffs(job.cutoffs, places);
        let cutoffs = match job.plan.needs.states_per_decade {
            Some(per_decade) => thinned(cutoffs, per_decade),
            None => cutoffs,
        };
        let states = States { model: self, run: job.run };
        let (blocks, work) = states.over_cutoffs(&cutoffs, conditions)?;
        Ok((CurveResult::Statistical(blocks), work))
    }

    fn surface(
        &self,
        _: &Plan<'_>,
        prepared: &PreparedSpectrum,
        choices: &GapChoices,
    ) -> Result<Option<Box<dyn LoadedSurface>>, GapError> {
        let (moments, _) = prepared.moments.last().ok_or(GapError::NoRoughness)?;
        let asperities = AsperityParameters::from_moments(moments).ok_or(GapError::NoRoughness)?;
        let contact = match contact_of(self, &Roughness { moments: *moments, asperities })? {
            Pressable::Contact(contact) => contact,
            Pressable::TooNarrow { alpha } => return Err(GapError::TooNarrow { alpha }),
        };
        let mean_height_m = match self.law {
            StatisticalLaw::Asperities(_) => asperities.offset_m,
            StatisticalLaw::Summits => 0.0,
        };
        Ok(Some(Box::new(PressedAsperities { contact, mean_height_m, tolerance: choices.tolerance.value() })))
    }
}

/// All asperities of a spectrum, the mean of their heights above the mean plane of the surface.
#[derive(Debug)]
struct PressedAsperities {
    contact: StatisticalContact,
    mean_height_m: f64,
    tolerance: f64,
}

impl LoadedSurface for PressedAsperities {
    fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        let state = self.contact.at_pressure(pressure_pa, self.tolerance, None)?;
        Ok(GapState {
            nominal_pressure_pa: pressure_pa,
            area_fraction: state.area_fraction,
            mean_gap_m: state.separation_m.map(|separation_m| separation_m + self.mean_height_m),
            stiffness_pa_per_m: state.stiffness_pa_per_m(),
        })
    }
}

/// Returns of neighbouring cutoffs, from long to short, at most so many per decade: the last of each part of a decade, so
/// that the shortest is always there.
fn thinned(cutoffs: Vec<Cutoff>, per_decade: NonZeroU32) -> Vec<Cutoff> {
    let part = |cutoff: &Cutoff| (cutoff.wavelength_m.log10() * f64::from(per_decade.get())).ceil();
    cutoffs.chunk_by(|a, b| part(a) == part(b)).filter_map(|part| part.last().copied()).collect()
}

impl Rows for Vec<Vec<CutoffState>> {
    fn count(&self) -> usize {
        self.len()
    }

    fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        let area = |row: &CutoffState| row.contact.map(|(_, state)| (row.wavelength_m, state.area_fraction));
        self[block].iter().filter_map(area).collect()
    }

    fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        let states = self[block].iter().filter_map(|row| row.contact);
        states.map(|(_, state)| (state.ln_pressure_pa - state.ln_area_fraction).exp()).fold(0.0, f64::max)
    }

    fn table(&self, _: &[f64], _: bool, details: bool) -> Table {
        let rows = || self.iter().flatten();
        let parameter =
            |of: fn(&AsperityParameters) -> f64| rows().map(move |row| row.contact.map(|(p, _)| of(&p)));
        let state = |of: fn(&ContactState) -> Option<f64>| {
            rows().map(move |row| row.contact.and_then(|(_, s)| of(&s)))
        };
        let table = Table::default()
            .with_numbers("wavelength_m", rows().map(|row| row.wavelength_m))
            .with_numbers("radius_m", parameter(|p| p.radius_m))
            .with_numbers("density_per_m2", parameter(|p| p.density_per_m2))
            .with_numbers("sigma_s_m", parameter(|p| p.sigma_s_m))
            .with_numbers("separation_m", state(|s| s.separation_m))
            .with_numbers("pressure_pa", state(|s| Some(s.pressure_pa)))
            .with_numbers("area_fraction", state(|s| Some(s.area_fraction)));
        if !details {
            return table;
        }
        STATE_DETAILS.iter().fold(table, |table, (name, of)| table.with_numbers(name, state(*of)))
    }

    fn states(&self) -> usize {
        self.iter().flatten().filter(|row| row.contact.is_some()).count()
    }
}
