//! A sweep has the digits of single states, for less.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use proptest::prelude::*;
use stat_contact::{AsperityLaw, ContactState, InterferenceLaw, Population, StatisticalContact};

use crate::support::contacts_of_diamond;

const SIGMA_M: f64 = 5e-9;
const TOLERANCES: [f64; 4] = [1e-2, 1e-3, 1e-6, 1e-10];

/// All laws, and in the end spheres whose force steps down where they yield.
fn contacts() -> Vec<StatisticalContact> {
    let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.5).unwrap());
    let large = Population::new(1e-2, 1e8, SIGMA_M).unwrap();
    let strength = NixGao::constant(1e9).unwrap();
    let soft = AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None };
    let stepping = StatisticalContact::new(&pair, &large, &soft);
    contacts_of_diamond(SIGMA_M).into_iter().chain([stepping]).collect()
}

/// All but the evaluations.
fn without_cost(mut state: ContactState) -> ContactState {
    state.evaluations = 0;
    state
}

/// Every seventeenth, around and around: each once, far from the one before.
fn shuffled(sorted: &[f64]) -> Vec<f64> {
    const STRIDE: usize = 17;
    assert_ne!(sorted.len() % STRIDE, 0);
    (0..sorted.len()).map(|at| sorted[at * STRIDE % sorted.len()]).collect()
}

/// Separations \[m\], more than a cell holds.
fn separations_m() -> Vec<f64> {
    (0..300).map(|at| SIGMA_M * (-6.0 + 0.087 * f64::from(at))).collect()
}

/// The pressures \[Pa\] at them, and beyond them.
fn pressures_pa(contact: &StatisticalContact) -> Vec<f64> {
    let at = |&d: &f64| contact.at_separation(d, 1e-6).unwrap().pressure_pa;
    let highest_pa = contact.highest_pressure_pa().min(1e20);
    separations_m().iter().map(at).chain([0.999_999 * highest_pa, 1.001 * highest_pa]).collect()
}

#[test]
fn states_at_separations_have_the_digits_of_single_ones() {
    for contact in contacts() {
        for tolerance in TOLERANCES {
            for separations_m in [separations_m(), shuffled(&separations_m())] {
                let mut sweep = contact.sweep(tolerance);
                let (mut costs, mut single_costs) = (0, 0);
                for d in separations_m {
                    let single = contact.at_separation(d, tolerance).unwrap();
                    let state = sweep.at_separation(d).unwrap();
                    assert_eq!(without_cost(state), without_cost(single), "{contact:?} at {tolerance}");
                    (costs, single_costs) = (costs + state.evaluations, single_costs + single.evaluations);
                }
                assert!(costs <= single_costs, "{costs} in place of {single_costs}");
            }
        }
    }
}

#[test]
fn states_at_pressures_have_the_digits_of_single_ones() {
    for contact in contacts() {
        let sorted = pressures_pa(&contact);
        for tolerance in TOLERANCES {
            for pressures_pa in [sorted.clone(), shuffled(&sorted)] {
                let mut sweep = contact.sweep(tolerance);
                let (mut costs, mut single_costs) = (0, 0);
                for pressure_pa in pressures_pa {
                    let single = contact.at_pressure(pressure_pa, tolerance, None).unwrap();
                    let state = sweep.at_pressure(pressure_pa).unwrap();
                    assert_eq!(without_cost(state), without_cost(single), "{contact:?} at {tolerance}");
                    (costs, single_costs) = (costs + state.evaluations, single_costs + single.evaluations);
                }
                // Hertz's spheres are evaluated nowhere but far below the mean plane.
                assert!(
                    3 * costs < 2 * single_costs || single_costs < 10,
                    "{contact:?}: {costs} in place of {single_costs}"
                );
            }
        }
    }
}

#[test]
fn a_state_where_all_is_known_costs_nothing() {
    // The last contact is left out: its searches all begin anew, as several separations may carry the load.
    for (i, contact) in contacts()[..7].iter().enumerate() {
        let mut sweep = contact.sweep(1e-10);
        let [first, _, again] = [1e7, 1.1e7, 1e7].map(|pressure_pa| sweep.at_pressure(pressure_pa).unwrap());
        let is_hertz = i == 0;
        assert_eq!(first.evaluations == 0, is_hertz, "{contact:?}");
        assert_eq!(again, without_cost(first));
    }
}

#[test]
fn a_refused_question_leaves_the_sweep_as_it_was() {
    let contact = &contacts()[0];
    let mut sweep = contact.sweep(1e-10);
    let first = sweep.at_pressure(1e7).unwrap();
    assert_eq!(sweep.at_pressure(-1.0).unwrap_err(), contact.at_pressure(-1.0, 1e-10, None).unwrap_err());
    assert!(sweep.at_separation(f64::NAN).is_err());
    assert_eq!(without_cost(sweep.at_pressure(1e7).unwrap()), without_cost(first));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_is_asked_before_changes_no_digit(
        decades in (-12.0..0.0f64, 0.0..26.0f64, -12.0..-2.0f64, 6.0..11.0f64, -3.0..12.0f64),
        law in 0..5,
        asked in prop::collection::vec((prop::bool::ANY, -8.0..12.0f64), 2..20),
    ) {
        let [radius_m, density_per_m2, sigma_s_m, strength_pa, scale_pa] =
            <[f64; 5]>::from(decades).map(|decades| 10f64.powf(decades));
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap());
        let strength = NixGao::constant(strength_pa).unwrap();
        let law = match law {
            0 => AsperityLaw::Hertz,
            1 => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None },
            4 => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: Some(0.41) },
            2 => AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
            _ => AsperityLaw::EpSine { strength },
        };
        let population = Population::new(radius_m, density_per_m2, sigma_s_m).unwrap();
        let contact = StatisticalContact::new(&pair, &population, &law);
        for tolerance in TOLERANCES {
            let mut sweep = contact.sweep(tolerance);
            for &(is_separation, value) in &asked {
                let (single, state) = if is_separation {
                    let d = value * sigma_s_m;
                    (contact.at_separation(d, tolerance), sweep.at_separation(d))
                } else {
                    let pressure_pa = scale_pa * 10f64.powf(value / 4.0);
                    (contact.at_pressure(pressure_pa, tolerance, None), sweep.at_pressure(pressure_pa))
                };
                let same = without_cost(state.unwrap()) == without_cost(single.unwrap());
                prop_assert!(same, "{contact:?} at {tolerance}: {asked:?}");
            }
        }
    }
}
