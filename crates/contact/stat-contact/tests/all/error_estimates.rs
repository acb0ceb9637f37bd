//! Error estimates against references: they bound the true errors of the reference states at least 999 times in a thousand,
//! and half of them are within a factor of a hundred of them.

use std::path::Path;

use crate::support::Row;

const TOLERANCES: [f64; 11] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];

fn committed() -> Vec<Row> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/reference");
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    // The one has a column more, for laws other than the usual ones.
    let usual = data(&text("statistical_extra.csv"), |model, rest| {
        rest.strip_prefix(',').map(|usual| format!("{model},{usual}"))
    });
    let many = data(&text("statistical_many.csv"), |model, rest| Some(format!("{model},{rest}")));
    let rows =
        [usual, many].map(|table| crate::support::rows(&table).collect::<Vec<_>>()).into_iter().flatten();
    rows.filter(|row| row.pressure_pa.is_normal() && row.area_fraction.is_normal()).collect()
}

/// The rows of a table without comments and header, taken apart after the model and put together again.
fn data(text: &str, row: impl Fn(&str, &str) -> Option<String>) -> String {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .filter_map(|line| line.split_once(',').and_then(|(model, rest)| row(model, rest)))
        .collect::<Vec<_>>()
        .join("\n")
}

/// The larger relative error of a row's pressure and area at a tolerance, and its estimate.
fn error_and_estimate(row: &Row, tolerance: f64) -> (f64, f64) {
    let state = row.contact.at_separation(row.separation_m, tolerance).unwrap();
    let off = |computed: f64, exact: f64| (computed / exact - 1.0).abs();
    let error = off(state.pressure_pa, row.pressure_pa).max(off(state.area_fraction, row.area_fraction));
    (error, state.error_estimate)
}

/// Error of a row by the rounding of its inputs alone: half a unit of the separation shows in ln p up to u^2 times.
fn rounding(row: &Row) -> f64 {
    let u = row.separation_m / row.sigma_s_m;
    1e-16 * (1.0 + u * u)
}

#[test]
fn estimates_bound_the_errors_of_the_reference_states() {
    let rows = committed();
    assert!(rows.len() > 500, "{} rows", rows.len());
    let mut exceeded = Vec::new();
    for row in &rows {
        for tolerance in TOLERANCES {
            let (error, estimate) = error_and_estimate(row, tolerance);
            if error > estimate + rounding(row) {
                exceeded
                    .push(format!("{} at {tolerance:e}: {error:.1e}, estimated {estimate:.1e}", row.what));
            }
        }
    }
    let share = exceeded.len() as f64 / (rows.len() * TOLERANCES.len()) as f64;
    assert!(share <= 1e-3, "{share:.1e}\n{}", exceeded.join("\n"));
}

#[test]
fn half_of_the_estimates_are_within_a_hundred_times_the_error() {
    let rows = committed();
    for tolerance in TOLERANCES {
        let mut ratios: Vec<f64> = rows
            .iter()
            .map(|row| {
                let (error, estimate) = error_and_estimate(row, tolerance);
                estimate / error.max(rounding(row))
            })
            .collect();
        ratios.sort_by(f64::total_cmp);
        let median = ratios[ratios.len() / 2];
        assert!(median <= 100.0, "{tolerance:e}: {median}");
    }
}
