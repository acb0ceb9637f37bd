//! Statistical curves against load. Sweeps of one model over one population share their states, among each other and with
//! the curves against cutoff.

use std::collections::HashMap;

use ordered_float::OrderedFloat;
use stat_contact::{Condition, ContactState};

use super::distinct::Distinct;
use super::distinct_inputs::DistinctInputs;
use super::prepared_spectrum::{Cutoff, PreparedSpectrum, Roughness};
use super::run::Run;
use super::work::counted;
use super::{CurveResult, LoadSweep, Needs, PlanError, SweepResult, Work};
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

/// The states of every sweep.
pub(super) fn results(
    needs: &Needs,
    inputs: &DistinctInputs,
    rows_of_models: &[CurveResult],
    prepared: &PreparedSpectrum,
    run: Run<'_>,
) -> Result<(Vec<SweepResult>, Work), PlanError> {
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
    let (states, work) = counted(computed);
    let result = |((sweep, cutoff), &subject): ((&LoadSweep, &Cutoff), &usize)| {
        let state = |&pressure_pa: &f64| states[subject].get(&OrderedFloat(pressure_pa)).copied();
        SweepResult {
            cutoff_m: cutoff.wavelength_m,
            states: sweep.pressures_pa.iter().filter_map(state).collect(),
        }
    };
    let sweeps = needs.sweeps.iter().zip(&prepared.sweep_cutoffs).zip(&subjects.index_of);
    Ok((sweeps.map(result).collect(), work))
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
