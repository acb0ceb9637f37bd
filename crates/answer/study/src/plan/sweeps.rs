//! Curves against load. Statistical sweeps of one model over one population share their states, among each other and with
//! the curves against cutoff; other models are computed at all cutoffs.

use std::collections::HashMap;

use numerics::parallel::Progress;
use ordered_float::OrderedFloat;
use stat_contact::{Condition, ContactState};

use super::distinct::Distinct;
use super::distinct_inputs::DistinctInputs;
use super::prepared_spectrum::{Cutoff, PreparedSpectrum, Roughness};
use super::work::counted;
use super::{CurveResult, Cutoffs, LoadSweep, Needs, Plan, PlanError, SweepResult, Work};
use crate::models::statistical::Asperities;
use crate::models::statistical::states::States;

/// The states of one model and population, by their pressures \[Pa\].
type KnownStates = HashMap<OrderedFloat<f64>, ContactState>;

/// The key of sweeps that share their states: the index of the model, and the asperities that the cutoff leaves.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Subject {
    model: usize,
    asperities: Option<Asperities>,
}

/// The areas of every sweep, and the states of statistical ones.
pub(super) fn results(
    plan: &Plan<'_>,
    inputs: &DistinctInputs,
    rows_of_models: &[CurveResult],
    prepared: &PreparedSpectrum,
    progress: &dyn Progress,
) -> Result<(Vec<SweepResult>, Work), PlanError> {
    let (needs, run) = (&plan.needs, plan.run(progress));
    let of_sweep = |(sweep, cutoff): (&LoadSweep, &Cutoff)| Subject {
        model: inputs.models.index_of[sweep.curve],
        asperities: cutoff.roughness.map(|roughness| Asperities::of(&roughness.asperities)),
    };
    let subjects = Distinct::of(needs.sweeps.iter().zip(&prepared.sweep_cutoffs).map(of_sweep));
    let places: Vec<usize> = (0..subjects.items.len()).collect();
    let computed = numerics::parallel::try_map(&places, |&place| {
        let subject = subjects.items[place];
        let sweeps = || {
            let of_all = needs.sweeps.iter().zip(&prepared.sweep_cutoffs).zip(&subjects.index_of);
            of_all.filter(|(_, index)| **index == place).map(|(sweep, _)| sweep)
        };
        let roughness = sweeps().find_map(|(_, cutoff)| cutoff.roughness);
        let (Some(model), Some(roughness)) = (inputs.models.items[subject.model].statistical(), roughness)
        else {
            return Ok((KnownStates::new(), Work::default()));
        };
        let wanted: Vec<f64> = sweeps().flat_map(|(sweep, _)| sweep.pressures_pa.iter().copied()).collect();
        let known = states_of_curve(&roughness, inputs, &rows_of_models[subject.model]);
        completed(known, &wanted, &roughness, &States { model, run })
    })?;
    let (states, mut work) = counted(computed);
    let sweeps: Vec<_> =
        needs.sweeps.iter().zip(&prepared.sweep_cutoffs).zip(subjects.index_of.iter().copied()).collect();
    let computed = numerics::parallel::try_map(&sweeps, |&((sweep, cutoff), subject)| {
        let cutoff_m = cutoff.wavelength_m;
        if needs.curves[sweep.curve].model.statistical().is_none() {
            let (area_fractions, work) = areas_of_rows(plan, sweep, cutoff_m, prepared, progress)?;
            return Ok((SweepResult { cutoff_m, area_fractions, states: Vec::new() }, work));
        }
        let state = |&pressure_pa: &f64| states[subject].get(&OrderedFloat(pressure_pa)).copied();
        let states: Vec<ContactState> = sweep.pressures_pa.iter().filter_map(state).collect();
        let area_fractions = states.iter().map(|state| state.area_fraction).collect();
        Ok::<_, PlanError>((SweepResult { cutoff_m, area_fractions, states }, Work::default()))
    })?;
    let (results, work_of_rows) = counted(computed);
    work += work_of_rows;
    Ok((results, work))
}

/// The areas of a model that has a row for every cutoff, with the waves down to a cutoff \[m\].
fn areas_of_rows(
    plan: &Plan<'_>,
    sweep: &LoadSweep,
    cutoff_m: f64,
    prepared: &PreparedSpectrum,
    progress: &dyn Progress,
) -> Result<(Vec<f64>, Work), PlanError> {
    let needs = Needs { areas_alone: true, ..plan.needs.clone() };
    let areas = Plan { psd: plan.psd, sampling: plan.sampling, needs };
    let model = &areas.needs.curves[sweep.curve].model;
    let conditions: Vec<Condition> = sweep.pressures_pa.iter().copied().map(Condition::Pressure).collect();
    let places = 0..model.rows_per_block(prepared, Cutoffs::Every);
    let (rows, work) = areas.blocks(model, Cutoffs::Every, prepared, progress, &conditions, places)?;
    let area = |block: usize| {
        let within = |(wavelength_m, _): &(f64, f64)| *wavelength_m >= cutoff_m * (1.0 - 1e-9);
        rows.area_fractions(block).into_iter().take_while(within).last().map_or(1.0, |(_, area)| area)
    };
    Ok(((0..conditions.len()).map(area).collect(), work))
}

/// Completes known states by those missing at the wanted pressures \[Pa\].
fn completed(
    mut states: KnownStates,
    wanted_pa: &[f64],
    roughness: &Roughness,
    model: &States<'_>,
) -> Result<(KnownStates, Work), PlanError> {
    let distinct = Distinct::of(wanted_pa.iter().copied().map(OrderedFloat));
    let missing: Vec<OrderedFloat<f64>> =
        distinct.items.into_iter().filter(|pressure_pa| !states.contains_key(pressure_pa)).collect();
    let missing_pa: Vec<f64> = missing.iter().map(|pressure_pa| pressure_pa.0).collect();
    let (found, mut work) = model.over_loads(roughness, &missing_pa)?;
    work.shared_states += wanted_pa.len() - missing.len();
    states.extend(missing.into_iter().zip(found));
    Ok((states, work))
}

/// The states that a curve against cutoff has of the asperities of a roughness.
fn states_of_curve(roughness: &Roughness, inputs: &DistinctInputs, curve: &CurveResult) -> KnownStates {
    let Some(blocks) = curve.statistical() else { return KnownStates::new() };
    let asperities = Asperities::of(&roughness.asperities);
    let known = |(condition, block): (&Condition, &Vec<super::CutoffState>)| {
        let Condition::Pressure(pressure_pa) = *condition else { return None };
        // The populations of sweeps are those of the shortest cutoffs, if of any.
        let of_population = block.iter().rev().filter_map(|row| row.contact);
        let state = of_population
            .filter(|(found, _)| Asperities::of(found) == asperities)
            .map(|(_, state)| state)
            .next()?;
        Some((OrderedFloat(pressure_pa), state))
    };
    inputs.conditions.items.iter().zip(blocks).filter_map(known).collect()
}
