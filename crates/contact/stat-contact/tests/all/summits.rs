//! The summits of Gaussian surfaces: reference values, limits, the way back from a pressure, scalings and costs.

use std::path::Path;

use asperity::{ElasticBody, MaterialPair};
use stat_contact::{ContactState, LinearLaw, NayakSummits, StatisticalContact};

const TOLERANCE: f64 = 1e-10;

/// Summits of unit height and slope under a unit modulus: pressures are p/(E* sqrt(m2)), separations d/sqrt(m0).
fn contact(alpha: f64) -> StatisticalContact {
    StatisticalContact::from_summits(&unit(), &NayakSummits::new(1.0, 1.0, alpha).unwrap())
}

fn unit() -> MaterialPair {
    MaterialPair::against_rigid(ElasticBody::new(1.0, 0.0).unwrap())
}

struct Row {
    alpha: f64,
    u: f64,
    area_fraction: f64,
    pressure: f64,
}

/// A committed table whose first columns are alpha, the separation, the area (not limited to 1) and the pressure.
fn rows(name: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/reference").join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let [alpha, u, area_fraction, pressure] = [0, 1, 2, 3].map(|i| cells[i].parse().unwrap());
            Row { alpha, u, area_fraction, pressure }
        })
        .collect()
}

/// Computes the larger relative deviation of area and pressure from a row; areas above 1 count as 1.
fn deviation(state: &ContactState, row: &Row) -> f64 {
    let area = if row.area_fraction > 1.0 { 1.0 } else { row.area_fraction };
    assert_eq!(state.clamped, row.area_fraction > 1.0, "alpha = {}, u = {}", row.alpha, row.u);
    (state.area_fraction / area - 1.0).abs().max((state.pressure_pa / row.pressure - 1.0).abs())
}

#[test]
fn states_agree_with_twenty_digits_within_their_estimates() {
    let rows = rows("summits.csv");
    assert!(rows.len() > 50);
    for row in rows.iter().filter(|row| row.pressure.is_normal() && row.area_fraction.is_normal()) {
        let state = contact(row.alpha).at_separation(row.u, TOLERANCE).unwrap();
        let off = deviation(&state, row);
        // Half a unit in the last place of the separation shows u^2 times.
        let rounding = 1e-16 * row.u * row.u;
        let what =
            format!("alpha = {}, u = {}: {off:e}, estimated {:e}", row.alpha, row.u, state.error_estimate);
        assert!(off < 1e-12 + rounding, "{what}");
        assert!(off <= state.error_estimate + rounding && state.error_estimate < 1e-11, "{what}");
    }
}

#[test]
fn states_below_the_smallest_double_agree_in_logarithms() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/reference/summits.csv");
    let text = std::fs::read_to_string(path).unwrap();
    // ln of a decimal that no double holds.
    let ln = |cell: &str| {
        let (digits, exponent) = cell.split_once('e').unwrap();
        digits.parse::<f64>().unwrap().ln() + exponent.parse::<f64>().unwrap() * std::f64::consts::LN_10
    };
    let mut seen = 0;
    for line in text.lines().filter(|line| line.contains("e-")) {
        let cells: Vec<&str> = line.split(',').collect();
        if !cells.get(3).is_some_and(|cell| cell.parse() == Ok(0.0)) {
            continue;
        }
        let [alpha, u] = [0, 1].map(|i| cells[i].parse::<f64>().unwrap());
        let state = contact(alpha).at_separation(u, TOLERANCE).unwrap();
        assert!((state.ln_area_fraction - ln(cells[2])).abs() < 2e-12, "{line}");
        assert!((state.ln_pressure_pa - ln(cells[3])).abs() < 2e-12, "{line}");
        seen += 1;
    }
    assert!(seen >= 4, "{seen}");
}

#[test]
fn states_agree_with_the_given_table() {
    let rows = rows("bgt.csv");
    assert_eq!(rows.len(), 36);
    for row in rows {
        // The table prints eleven digits.
        let off = deviation(&contact(row.alpha).at_separation(row.u, TOLERANCE).unwrap(), &row);
        assert!(off < 6e-11, "alpha = {}, u = {}: {off:e}", row.alpha, row.u);
    }
}

#[test]
fn there_and_back_again_from_any_start() {
    for alpha in [1.5, 1.5 + 1e-9, 1.53, 2.0, 17.0, 400.0, 1e5, 1e9, 1e30] {
        let contact = contact(alpha);
        for u in [-1e7, -999_999.0, -300.0, -8.0, -1.0, -1e-3, 0.0, 1e-3, 0.7, 3.3, 9.0, 37.0] {
            let there = contact.at_separation(u, TOLERANCE).unwrap();
            for start in [None, Some(-40.0), Some(0.5), Some(25.0)] {
                let start = start.map(|u| contact.at_separation(u, TOLERANCE).unwrap());
                let back = contact.at_pressure(there.pressure_pa, TOLERANCE, start.as_ref()).unwrap();
                let off = (back.separation_m.unwrap() - u).abs();
                assert!(off < 2e-14 * u.abs().max(10.0), "alpha = {alpha}, u = {u}: {off:e}");
                let area_off = (back.ln_area_fraction - there.ln_area_fraction).abs();
                assert!(area_off < 1e-12 * (1.0 + u * u), "alpha = {alpha}, u = {u}: {area_off:e}");
            }
        }
    }
}

#[test]
fn loads_over_hundreds_of_decades_are_found() {
    for alpha in [1.5, 6.0, 1e4] {
        let contact = contact(alpha);
        let mut last = f64::INFINITY;
        for decades in (-300..=36).step_by(6) {
            let pressure_pa = 10f64.powi(decades);
            let state = contact.at_pressure(pressure_pa, TOLERANCE, None).unwrap();
            let separation_m = state.separation_m.unwrap();
            let there = contact.at_separation(separation_m, TOLERANCE).unwrap();
            let off = (there.ln_pressure_pa - pressure_pa.ln()).abs();
            assert!(off < 1e-11, "alpha = {alpha}, 1e{decades}: {off:e}");
            assert!(separation_m < last && state.evaluations < 5000, "alpha = {alpha}: {state:?}");
            last = separation_m;
        }
    }
}

#[test]
fn the_states_far_below_follow_those_that_are_integrated() {
    for alpha in [1.5, 10.0, 1e6] {
        let states = [-1e6 * (1.0 - 1e-9), -1e6 * (1.0 + 1e-9)]
            .map(|u| contact(alpha).at_separation(u, TOLERANCE).unwrap().ln_pressure_pa);
        assert!((states[1] - states[0] - 3e-9).abs() < 1e-12, "alpha = {alpha}: {states:?}");
    }
}

#[test]
fn as_the_load_vanishes_the_area_is_that_of_the_linear_law() {
    // sqrt(2 pi) is reached slowly, and the more so the broader the spectrum: the loss goes like alpha/d^2.
    for alpha in [1.5, 2.0, 10.0, 100.0] {
        let losses = [1e2, 3e2].map(|u| {
            let state = contact(alpha).at_separation(u, TOLERANCE).unwrap();
            let ln_linear = LinearLaw::BushGibsonThomas.area_fraction(1.0, 1.0, 2f64.sqrt()).ln();
            ln_linear + state.ln_pressure_pa - state.ln_area_fraction
        });
        assert!(0.0 < losses[0] && losses[0] < alpha * 1e-4, "alpha = {alpha}: {losses:?}");
        assert!((losses[0] / losses[1] / 9.0 - 1.0).abs() < 0.05, "alpha = {alpha}: {losses:?}");
    }
}

#[test]
fn lengths_and_moduli_may_be_scaled() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
    let modulus_pa = pair.composite_modulus_pa();
    let (m0_m2, m2, m4_per_m2) = (2.5e-17, 0.04, 6.4e15);
    let summits = NayakSummits::new(m0_m2, m2, m4_per_m2).unwrap();
    assert!((summits.alpha() - 100.0).abs() < 1e-12);
    let there = StatisticalContact::from_summits(&pair, &summits);
    let here = contact(summits.alpha());
    for u in [-4.0, 0.3, 7.0] {
        let there = there.at_separation(u * m0_m2.sqrt(), TOLERANCE).unwrap();
        let here = here.at_separation(u, TOLERANCE).unwrap();
        let expected_pa = here.pressure_pa * modulus_pa * m2.sqrt();
        assert!((there.pressure_pa / expected_pa - 1.0).abs() < 1e-13 * (1.0 + u * u));
        assert!((there.area_fraction / here.area_fraction - 1.0).abs() < 1e-13 * (1.0 + u * u));
    }
}

/// All but the evaluations.
fn without_cost(mut state: ContactState) -> ContactState {
    state.evaluations = 0;
    state
}

#[test]
fn a_sweep_has_the_digits_of_single_states() {
    for alpha in [1.5, 40.0] {
        let contact = contact(alpha);
        let mut sweep = contact.sweep(TOLERANCE);
        for step in 0..40 {
            let u = -6.0 + f64::from(step * 17 % 40);
            let single = contact.at_separation(u, TOLERANCE).unwrap();
            let swept = sweep.at_separation(u).unwrap();
            assert_eq!(without_cost(swept), without_cost(single));
            let single = contact.at_pressure(single.pressure_pa, TOLERANCE, None).unwrap();
            let swept = sweep.at_pressure(single.pressure_pa).unwrap();
            assert_eq!(without_cost(swept), without_cost(single));
        }
    }
}

#[test]
fn a_state_costs_what_it_did() {
    let costs = |u: f64| {
        ALPHAS.map(|alpha| {
            let there = contact(alpha).at_separation(u, TOLERANCE).unwrap();
            let back = contact(alpha).at_pressure(there.pressure_pa, TOLERANCE, None).unwrap();
            (there.evaluations, back.evaluations)
        })
    };
    assert_eq!([-1.0, 0.5, 3.0, 9.0].map(costs), COSTS);
}

const ALPHAS: [f64; 5] = [1.5, 1.6, 5.0, 140.0, 1e5];

/// Curvatures at which summits were looked at: to find a state at a separation, and that at its pressure; at -1, 1/2, 3 and 9.
const COSTS: [[(usize, usize); 5]; 4] = [
    [(68, 748), (68, 408), (68, 272), (68, 204), (68, 204)],
    [(442, 1326), (136, 408), (102, 272), (68, 204), (68, 204)],
    [(442, 884), (136, 408), (102, 272), (68, 204), (68, 136)],
    [(408, 1258), (170, 476), (102, 272), (68, 204), (68, 204)],
];
