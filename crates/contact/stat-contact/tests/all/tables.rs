//! States of a table are single states within their error estimates, for less.

use asperity::{ElasticBody, MaterialPair};
use stat_contact::{
    AsperityLaw, Condition, ContactState, InterferenceLaw, NayakSummits, Population, StatisticalContact,
};

use crate::support::contacts_of_diamond;

const SIGMA_M: f64 = 5e-9;
const TOLERANCES: [f64; 5] = [1e-2, 1e-4, 1e-7, 1e-10, 1e-13];

/// All laws that have no closed form, and the summits of a surface.
fn contacts() -> Vec<StatisticalContact> {
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
    let summits = NayakSummits::new(SIGMA_M * SIGMA_M, 0.05, 5e14).unwrap();
    let summits = StatisticalContact::from_summits(&pair, &summits);
    contacts_of_diamond(SIGMA_M).into_iter().skip(1).chain([summits]).collect()
}

/// Larger of the relative differences of pressure and area.
fn difference(a: &ContactState, b: &ContactState) -> f64 {
    let pressures = (a.ln_pressure_pa - b.ln_pressure_pa).abs();
    pressures.max((a.ln_area_fraction - b.ln_area_fraction).abs())
}

fn separations_m(range: [f64; 2]) -> impl Iterator<Item = f64> {
    const STATES: u32 = 101;
    (0..STATES)
        .map(move |at| SIGMA_M * (range[0] + (range[1] - range[0]) * f64::from(at) / f64::from(STATES - 1)))
}

#[test]
fn states_at_separations_are_within_their_error_estimates() {
    for contact in contacts() {
        for range in [[-3.5, 20.5], [2.0, 2.5], [-30.0, 60.0]] {
            for tolerance in TOLERANCES {
                let table =
                    contact.table(range.map(|u| Condition::Separation(u * SIGMA_M)), tolerance).unwrap();
                for d in separations_m(range) {
                    let state = table.at_separation(d).unwrap();
                    let single = contact.at_separation(d, 1e-13).unwrap();
                    let bound = state.error_estimate + single.error_estimate;
                    let place =
                        format!("{contact:?} at {tolerance:e}, {} sigma: {state:?} {single:?}", d / SIGMA_M);
                    assert!(difference(&state, &single) <= bound, "{place}");
                    assert_eq!(state.separation_m, Some(d));
                    assert_eq!(state.clamped, single.clamped, "{place}");
                    let shares = state.out_of_range_load_share - single.out_of_range_load_share;
                    assert!(shares.abs() < 1e-3 + bound, "{place}");
                    if single.pressure_pa < f64::MIN_POSITIVE {
                        continue;
                    }
                    let stiffnesses = [&state, &single].map(|state| state.stiffness_pa_per_m().unwrap());
                    let mean_height = stiffnesses[1] / single.pressure_pa * SIGMA_M;
                    let off = (stiffnesses[0] / stiffnesses[1] - 1.0).abs() * mean_height;
                    assert!(off <= 10.0 * (bound + tolerance) * mean_height.max(1.0), "{off:e} {place}");
                }
            }
        }
    }
}

#[test]
fn states_at_pressures_are_within_their_error_estimates() {
    for contact in contacts() {
        for tolerance in TOLERANCES {
            let range = [-3.5, 20.5];
            let at = |u: f64| contact.at_separation(u * SIGMA_M, 1e-13).unwrap().pressure_pa;
            let ends = range.map(|u| Condition::Pressure(at(u)));
            let table = contact.table(ends, tolerance).unwrap();
            for d in separations_m(range) {
                let pressure_pa = contact.at_separation(d, 1e-13).unwrap().pressure_pa;
                let state = table.at_pressure(pressure_pa).unwrap();
                let single = contact.at_pressure(pressure_pa, 1e-13, None).unwrap();
                assert_eq!((state.pressure_pa, state.ln_pressure_pa), (pressure_pa, pressure_pa.ln()));
                let bound = state.error_estimate + single.error_estimate;
                let place =
                    format!("{contact:?} at {tolerance:e}, {} sigma: {state:?} {single:?}", d / SIGMA_M);
                // An error of the pressure moves the separation by as much over the slope of ln p, and the area with it.
                let slope = SIGMA_M * single.stiffness_pa_per_m().unwrap() / pressure_pa;
                let off = (state.separation_m.unwrap() - single.separation_m.unwrap()).abs() / SIGMA_M;
                assert!(off * slope <= bound, "{off:e} {place}");
                assert!((state.ln_area_fraction - single.ln_area_fraction).abs() <= 3.0 * bound, "{place}");
            }
        }
    }
}

#[test]
fn a_table_costs_as_much_as_some_states() {
    for contact in contacts() {
        let ends = [-3.5, 20.5].map(|u| Condition::Separation(u * SIGMA_M));
        let single = |tolerance| {
            let states =
                separations_m([-3.5, 20.5]).map(|d| contact.at_separation(d, tolerance).unwrap().evaluations);
            states.sum::<usize>() as f64 / 101.0
        };
        for (tolerance, states) in [(1e-3, 25.0), (1e-6, 50.0), (1e-10, 125.0)] {
            let table = contact.table(ends, tolerance).unwrap();
            let cost = table.evaluations as f64 / single(tolerance);
            assert!(cost < states, "{contact:?} at {tolerance}: as much as {cost} states");
            let state = table.at_separation(0.3 * SIGMA_M).unwrap();
            assert_eq!(state.evaluations, 0);
        }
    }
}

#[test]
fn conditions_outside_are_single_states() {
    for contact in contacts() {
        let table = contact.table([0.0, 2.0].map(|u| Condition::Separation(u * SIGMA_M)), 1e-6).unwrap();
        for u in [-2e6, -5.0, 2.1, 30.0] {
            let d = u * SIGMA_M;
            assert_eq!(table.at_separation(d).unwrap(), contact.at_separation(d, 1e-6).unwrap());
        }
        for pressure_pa in [1e-3, 1e30] {
            let single = contact.at_pressure(pressure_pa, 1e-6, None).unwrap();
            assert_eq!(table.at(Condition::Pressure(pressure_pa)).unwrap(), single);
        }
        assert_eq!(table.at_pressure(-1.0), contact.at_pressure(-1.0, 1e-6, None));
        assert!(table.at_separation(f64::NAN).is_err());
    }
}

#[test]
fn pressures_that_a_table_cannot_tell_apart_are_single_states() {
    // Sinusoids so soft that all are flattened, and the pressure no longer depends on the separation.
    let pair = MaterialPair::against_rigid(ElasticBody::new(700.0, 0.04).unwrap());
    let population = Population::new(1.8e-3, 9.8e23, 0.23).unwrap();
    let law = AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson };
    let contact = StatisticalContact::new(&pair, &population, &law);
    let table = contact.table([-1.715, -1.71].map(Condition::Separation), 1e-12).unwrap();
    let pressure_pa = contact.at_separation(-1.712, 1e-12).unwrap().pressure_pa;
    let single = contact.at_pressure(pressure_pa, 1e-12, None).unwrap();
    assert_eq!(table.at_pressure(pressure_pa).unwrap(), single);
}

#[test]
fn a_table_between_bad_ends_is_refused() {
    let contact = &contacts()[2];
    assert!(contact.table([Condition::Pressure(-1.0), Condition::Pressure(1.0)], 1e-6).is_err());
    assert!(contact.table([Condition::Separation(f64::NAN), Condition::Separation(1.0)], 1e-6).is_err());
    // More than full contact has no separation, and so no table.
    let table = contact.table([Condition::Pressure(1e3), Condition::Pressure(1e30)], 1e-6).unwrap();
    assert_eq!(table.at_pressure(2e30), contact.at_pressure(2e30, 1e-6, None));
}
