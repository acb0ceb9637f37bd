//! Identities that hold for all numbers.

use numerics::GaussLegendre;
use persson::growing_hardness::areas_of_squared_growth;
use persson::{ContactAreas, constant_hardness, elastic};
use proptest::prelude::*;

/// Fractions of a hardness: all of (0, 1), and both of its ends.
fn fraction() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.001..0.999f64,
        (-12.0..-3.0f64).prop_map(|x| 10f64.powf(x)),
        (-9.0..-3.0f64).prop_map(|x| 1.0 - 10f64.powf(x))
    ]
}

fn spread() -> impl Strategy<Value = f64> {
    (-2.0..1.3f64).prop_map(|x| 10f64.powf(x))
}

fn in_order(areas: &ContactAreas, tolerance: f64) -> bool {
    [areas.elastic, areas.plastic, areas.gap]
        .iter()
        .all(|share| (-tolerance..=1.0 + tolerance).contains(share))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn the_shares_make_up_the_area(pressure in fraction(), spread in spread()) {
        let areas = constant_hardness::areas(pressure, spread, 1.0);
        prop_assert!((areas.elastic + areas.plastic + areas.gap - 1.0).abs() < 1e-14, "{areas:?}");
        prop_assert!(in_order(&areas, 0.0));
    }

    #[test]
    fn elastic_stress_and_flow_carry_the_load(pressure in fraction(), spread in 0.05..9.0f64) {
        let rule = GaussLegendre::new(20);
        // Panels around the pressure that see the narrowest Gaussian.
        let mut edges: Vec<f64> = (0..=60).map(|i| f64::from(i) / 60.0).collect();
        edges.extend((-8..=8).map(|i| (pressure + 0.05 * f64::from(i)).clamp(0.0, 1.0)));
        edges.sort_by(f64::total_cmp);
        let moment = |k: i32| -> f64 {
            let nodes = edges.windows(2).flat_map(|pair| rule.over(pair[0], pair[1]));
            nodes.map(|(stress, weight)| {
                weight * stress.powi(k) * constant_hardness::stress_density_per_pa(stress, pressure, spread, 1.0)
            }).sum()
        };
        let areas = constant_hardness::areas(pressure, spread, 1.0);
        prop_assert!((moment(0) / areas.elastic - 1.0).abs() < 1e-10, "{} {areas:?}", moment(0));
        prop_assert!(((moment(1) + areas.plastic) / pressure - 1.0).abs() < 1e-12, "{} {areas:?}", moment(1));
    }

    #[test]
    fn the_two_sums_meet(pressure in fraction()) {
        let [early, late] = [0.5 - 1e-13, 0.5].map(|spread| constant_hardness::areas(pressure, spread, 1.0));
        for (a, b) in [(early.elastic, late.elastic), (early.plastic, late.plastic), (early.gap, late.gap)] {
            prop_assert!((a / b - 1.0).abs() < 1e-11, "{early:?} {late:?}");
        }
        let density = |spread| constant_hardness::stress_density_per_pa(0.7, pressure, spread, 1.0);
        prop_assert!((density(0.5 - 1e-13) / density(0.5) - 1.0).abs() < 1e-11);
    }

    #[test]
    fn the_area_is_that_of_the_elastic_theory_or_of_flow_or_somewhat_more(pressure in fraction(), spread in spread()) {
        let areas = constant_hardness::areas(pressure, spread, 1.0);
        let least = elastic::area_fraction(pressure, spread).max(pressure);
        prop_assert!(areas.contact() >= least * (1.0 - 1e-14));
        prop_assert!(areas.contact() <= least + 0.0551 && areas.contact() <= 1.0861 * least, "{areas:?} {least}");
    }

    #[test]
    fn a_hardness_that_is_never_reached_is_none(pressure in 1e-8..0.3f64, spread in 1e-3..0.015f64) {
        let pressure = pressure * spread;
        let areas = constant_hardness::areas(pressure, spread, 1.0);
        prop_assert!((areas.contact() / elastic::area_fraction(pressure, spread) - 1.0).abs() < 1e-15);
        prop_assert!(areas.plastic == 0.0);
    }

    #[test]
    fn from_the_hardness_on_everything_flows(spread in spread(), over in 1.0..1e6f64) {
        prop_assert_eq!(constant_hardness::areas(over, spread, 1.0).plastic, 1.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_hardness_that_hardly_grows_is_constant(pressure in fraction(), spread in 0.02..3.0f64) {
        let growing = areas_of_squared_growth(pressure, spread, 1.0, 1e-12);
        let constant = constant_hardness::areas(pressure, spread, 1.0);
        prop_assert!((growing.contact() / constant.contact() - 1.0).abs() < 1e-6, "{growing:?} {constant:?}");
        prop_assert!((growing.plastic - constant.plastic).abs() < 1e-6 * constant.contact(), "{growing:?} {constant:?}");
    }

    #[test]
    fn a_hardness_that_runs_away_is_never_reached(pressure in 1e-9..0.5f64, spread in 0.01..0.05f64) {
        let growing = areas_of_squared_growth(pressure, spread, 1.0, 100.0);
        prop_assert!((growing.contact() / elastic::area_fraction(pressure, spread) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_plastic_carries_no_more_than_the_load_and_less_as_hardness_grows(
        pressure in fraction(), spread in 0.05..3.0f64, growth in 0.01..100.0f64,
    ) {
        let constant = constant_hardness::areas(pressure, spread, 1.0);
        let growing = areas_of_squared_growth(pressure, spread, 1.0, growth);
        let now = (1.0 + growth * spread * spread).sqrt();
        prop_assert!(in_order(&growing, 0.0));
        prop_assert!(growing.plastic * now <= pressure * (1.0 + 1e-9), "{growing:?}");
        prop_assert!(growing.plastic <= constant.plastic + 1e-6 * constant.contact(), "{growing:?} {constant:?}");
        prop_assert!(growing.contact() >= elastic::area_fraction(pressure, spread) * (1.0 - 1e-12));
        prop_assert!(growing.contact() <= constant.contact() * (1.0 + 1e-6), "{growing:?} {constant:?}");
    }

    #[test]
    fn pressures_scale_together(pressure in fraction(), spread in 0.05..3.0f64, unit in 1e-3..1e12f64) {
        let one = areas_of_squared_growth(pressure, spread, 1.0, 2.0);
        let other = areas_of_squared_growth(pressure * unit, spread * unit, unit, 2.0);
        prop_assert!((one.contact() / other.contact() - 1.0).abs() < 1e-6);
    }
}
