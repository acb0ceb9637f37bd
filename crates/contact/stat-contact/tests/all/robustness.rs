//! Finite input never yields NaN, whatever the scales.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use stat_contact::{AsperityLaw, Condition, ContactState, InterferenceLaw, Population, StatisticalContact};

/// Numbers between 10^low and 10^high, evenly in the exponent.
fn decades(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|exponent| 10f64.powf(exponent))
}

fn strength() -> impl Strategy<Value = NixGao> {
    (decades(3.0, 12.0), prop::option::of(decades(-15.0, 0.0)), prop::option::of(decades(0.0, 3.0))).prop_map(
        |(s0, length, cap)| {
            let mut strength = NixGao::constant(s0).unwrap();
            if let Some(length) = length {
                strength = strength.with_strain_gradient(length).unwrap();
            }
            if let Some(cap) = cap {
                strength = strength.with_cap(cap * s0).unwrap();
            }
            strength
        },
    )
}

/// Laws whose spheres hold their force from some contact radius on, or do not.
fn law(held_from: impl Strategy<Value = Option<f64>>) -> impl Strategy<Value = AsperityLaw> {
    prop_oneof![
        Just(AsperityLaw::Hertz),
        (strength(), prop_oneof![Just(Hardness::JacksonGreen2005), Just(Hardness::Cosine)], held_from)
            .prop_map(|(strength, hardness, held_from)| AsperityLaw::EpSphere {
                strength,
                hardness,
                held_from
            }),
        Just(AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson }),
        Just(AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem }),
        strength().prop_map(|strength| AsperityLaw::EpSine { strength }),
    ]
}

prop_compose! {
    fn contact(held_from: BoxedStrategy<Option<f64>>)(
        modulus in decades(3.0, 12.3),
        poisson in prop_oneof![-0.999..0.5f64, Just(0.5)],
        radius in decades(-12.0, 0.0),
        density in decades(0.0, 26.0),
        sigma in decades(-12.0, -2.0),
        law in law(held_from),
    ) -> (StatisticalContact, f64, String) {
        let pair = MaterialPair::against_rigid(ElasticBody::new(modulus, poisson).unwrap());
        let population = Population::new(radius, density, sigma).unwrap();
        (StatisticalContact::new(&pair, &population, &law), sigma, format!("{pair:?} {population:?} {law:?}"))
    }
}

fn held_or_not() -> BoxedStrategy<Option<f64>> {
    prop::option::of(0.02..1.0f64).boxed()
}

fn assert_sound(state: &ContactState) {
    assert!(state.evaluations < 5000, "{state:?}");
    assert!(state.pressure_pa >= 0.0, "{state:?}");
    assert!((0.0..=1.0).contains(&state.area_fraction), "{state:?}");
    assert!(!state.ln_pressure_pa.is_nan() && state.ln_area_fraction <= 0.0, "{state:?}");
    assert!(state.error_estimate >= 0.0, "{state:?}");
    assert!((0.0..=1.0).contains(&state.out_of_range_load_share), "{state:?}");
    assert!(state.separation_m.is_none_or(f64::is_finite), "{state:?}");
    assert_eq!(state.separation_m.is_none(), state.no_separation().is_some(), "{state:?}");
    assert!(state.flattened_share.is_none_or(|share| (0.0..=1.0).contains(&share)), "{state:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_separation_has_a_sound_state((contact, sigma, _what) in contact(held_or_not()), u in -60.0..60.0f64, digits in 4.0..12.0f64) {
        let state = contact.at_separation(u * sigma, 10f64.powf(-digits)).unwrap();
        assert_sound(&state);
        prop_assert!(state.ln_pressure_pa.is_finite() && state.ln_area_fraction.is_finite());
    }

    #[test]
    fn any_pressure_has_a_sound_state_that_carries_it((contact, sigma, _what) in contact(held_or_not()), pressure in decades(-6.0, 12.0)) {
        let state = contact.at_pressure(pressure, 1e-10, None).unwrap();
        assert_sound(&state);
        let Some(d) = state.separation_m else {
            prop_assert!(pressure >= contact.highest_pressure_pa() * (1.0 - 1e-9));
            return Ok(());
        };
        let back = contact.at_separation(d, 1e-10).unwrap();
        let u = (d / sigma).abs();
        // A unit in the last place of d shows in ln p like u^2, and like 1 far below the mean plane.
        let conditioned = 1e-9 + 1e-14 * if d > 0.0 { u * u } else { 1.0 };
        prop_assert!((back.ln_pressure_pa - pressure.ln()).abs() < conditioned, "{} {} at {u}", back.ln_pressure_pa, pressure.ln());
    }

    #[test]
    fn the_answer_does_not_depend_on_the_start((contact, sigma, _what) in contact(held_or_not()), pressure in decades(-6.0, 12.0), u in -50.0..50.0f64) {
        let alone = contact.at_pressure(pressure, 1e-10, None).unwrap();
        let start = contact.at_separation(u * sigma, 1e-4).unwrap();
        let led = contact.at_pressure(pressure, 1e-10, Some(&start)).unwrap();
        prop_assert_eq!(alone.separation_m.is_some(), led.separation_m.is_some());
        if let (Some(a), Some(b)) = (alone.separation_m, led.separation_m) {
            prop_assert!(((a - b) / sigma).abs() <= 1e-12 * (1.0 + (a / sigma).abs()), "{a:e} {b:e}");
        }
    }
}

#[test]
fn states_of_tables_are_within_their_errors() {
    const TABLES: usize = 2000;
    const STATES: u32 = 20;
    let asked = (contact(Just(None).boxed()), prop::array::uniform2(-60.0..60.0f64), 2.0..13.0f64);
    let mut runner = TestRunner::deterministic();
    let (mut ratios, mut beyond) = (Vec::new(), String::new());
    for _ in 0..TABLES {
        let ((contact, sigma, what), ends, digits) = asked.new_tree(&mut runner).unwrap().current();
        let ends = ends.map(|u| u * sigma);
        let table = contact.table(ends.map(Condition::Separation), 10f64.powf(-digits)).unwrap();
        for at in 0..STATES {
            let d = ends[0] + (ends[1] - ends[0]) * f64::from(at) / f64::from(STATES);
            let (state, single) = (table.at_separation(d).unwrap(), contact.at_separation(d, 1e-13).unwrap());
            let pressures = (state.ln_pressure_pa - single.ln_pressure_pa).abs();
            let areas = (state.ln_area_fraction - single.ln_area_fraction).abs();
            // The last place of the separation shows in ln p like u^2.
            let rounding = 1e-15 * (d / sigma).powi(2);
            ratios.push(pressures.max(areas) / (state.error_estimate + single.error_estimate + rounding));
            if ratios.last().is_some_and(|ratio| *ratio > 1.0) {
                beyond += &format!("{what} at {}: {state:?} {single:?}\n", d / sigma);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let exceeding = ratios.iter().filter(|ratio| **ratio > 1.0).count() as f64 / ratios.len() as f64;
    assert!(exceeding <= 5e-4 && ratios[ratios.len() - 1] < 3.0, "{exceeding:e} of all states: {beyond}");
    let median = ratios[ratios.len() / 2];
    assert!(median > 1e-4, "estimates are {:.0} times the errors", 1.0 / median);
}
