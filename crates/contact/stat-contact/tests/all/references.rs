//! States against the project's high-precision table, which lies beside a development checkout.

use std::path::Path;

use crate::support::Row;

fn rows() -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../../shared/reference/statistical.csv");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    crate::support::rows(text.split_once('\n').expect("a header").1).collect()
}

fn deviation(computed: f64, reference: f64) -> f64 {
    (computed / reference - 1.0).abs()
}

#[test]
#[ignore = "needs the shared folder"]
fn estimated_errors_bound_the_true_ones_at_every_tolerance() {
    for row in rows() {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let state = row.contact.at_separation(row.separation_m, tolerance).unwrap();
            let made = deviation(state.pressure_pa, row.pressure_pa)
                .max(deviation(state.area_fraction, row.area_fraction));
            let estimate = state.error_estimate;
            assert!(made <= estimate, "{} at {tolerance:e}: {made:e}, estimated {estimate:e}", row.what);
            assert!(estimate < 10.0 * tolerance, "{} at {tolerance:e}: {estimate:e}", row.what);
        }
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn separation_and_area_are_found_from_the_pressure_from_any_start() {
    for row in rows() {
        let starts = [None, Some(-40.0), Some(-1.0), Some(0.5), Some(6.0), Some(55.0)];
        let mut found = Vec::new();
        for start in starts {
            let start = start.map(|u| row.contact.at_separation(u * row.sigma_s_m, 1e-4).unwrap());
            let state = row.contact.at_pressure(row.pressure_pa, 1e-12, start.as_ref()).unwrap();
            let separation_m = state.separation_m.expect("the table's pressures are carried");
            let off = (separation_m - row.separation_m).abs() / row.sigma_s_m;
            let area_off = deviation(state.area_fraction, row.area_fraction);
            assert!(off < 1e-10 && area_off < 1e-10, "{}: {off:e} {area_off:e}", row.what);
            found.push(separation_m / row.sigma_s_m);
        }
        let spread = found.iter().fold(0.0, |spread: f64, u| spread.max((u - found[0]).abs()));
        assert!(spread <= 2e-14 * found[0].abs().max(1.0), "{}: {found:?}", row.what);
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn a_looser_tolerance_costs_less() {
    let rows = rows();
    let cost = |tolerance: f64| -> usize {
        rows.iter()
            .map(|row| row.contact.at_separation(row.separation_m, tolerance).unwrap().evaluations)
            .sum()
    };
    let costs = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12].map(cost);
    assert!(rows.is_empty() || costs.is_sorted_by(|a, b| a < b), "{costs:?}");
}
