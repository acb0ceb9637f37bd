//! The twenty statements, each with its measurement and its criterion.

mod area;
mod plasticity;
mod spectrum;
mod strength;

use findings::features::Point;
use units::display::{length, three_digits};

use crate::evidence::Evidence;
use crate::ledger::{Part, Row, Statement};

/// The statements in the order of the ledger.
const STATEMENTS: [Statement; 20] = [
    spectrum::LARGEST_ASPECT_RATIO,
    spectrum::COURSE_OF_ASPECT_RATIO,
    spectrum::MOMENTS,
    area::STACK_CONVERGES,
    plasticity::CONVERGED_PRESSURE,
    area::PROPORTIONAL_TO_LOAD,
    area::ELASTIC_DECADES,
    area::SPHERES_LEVEL_OFF,
    plasticity::PLASTIC_ABOVE_ELASTIC,
    area::NEVER_LEVEL,
    strength::STACK_RETURNS_TO_ELASTIC,
    strength::STATISTICAL_STAY_PLASTIC,
    strength::STRENGTH_AT_DEPTH,
    spectrum::SLOPE,
    plasticity::BEYOND_HARDNESS,
    strength::LOWERS_AREA,
    strength::STACK_CONVERGES,
    strength::SPHERES_LEVEL_OFF,
    area::STEEPEST_SCALE_DECIDES,
    area::LAST_FALL,
];

/// Returns the parts of all statements, with a mark for each spectrum and reading in `evidence`.
pub fn parts(evidence: &[Evidence]) -> Vec<Part> {
    STATEMENTS.into_iter().flat_map(|statement| Part::of(statement, evidence)).collect()
}

/// Returns a row per statement, with a finding for each of the spectra in `evidence`.
pub fn ledger(evidence: &[Evidence]) -> Vec<Row> {
    let row = |statement: Statement| {
        let finding = |scene: &Evidence| (scene.template.name(), (statement.check)(scene));
        Row { statement, findings: evidence.iter().map(finding).collect() }
    };
    STATEMENTS.into_iter().map(row).collect()
}

/// Smallest factor between values of a printed curve that the eye can distinguish.
const VISIBLE: f64 = 1.1;
/// Factor within which a curve counts as level: 10 % to either side.
const LEVEL: f64 = 1.2;

/// Formats the range of some values as `least–most`, or as one text if both are the same.
fn range(values: impl IntoIterator<Item = f64>, display: fn(f64) -> String) -> String {
    let (least, most) = extremes(values);
    if display(least) == display(most) {
        display(least)
    } else {
        format!("{}–{}", display(least), display(most))
    }
}

fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    range(values, three_digits)
}

fn lengths(values: impl IntoIterator<Item = f64>) -> String {
    range(values, length)
}

/// Smallest and largest value; NaN for no values or if one is NaN, so that no comparison with them holds.
fn extremes(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let values: Vec<f64> = values.into_iter().collect();
    if values.is_empty() || values.iter().any(|value| value.is_nan()) {
        return (f64::NAN, f64::NAN);
    }
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    (least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

fn lowest(values: impl IntoIterator<Item = f64>) -> f64 {
    extremes(values).0
}

fn highest(values: impl IntoIterator<Item = f64>) -> f64 {
    extremes(values).1
}

/// Value furthest from 1; NaN for no values.
fn furthest_from_one(values: &[f64]) -> f64 {
    let further = |a: &f64, b: &f64| (a - 1.0).abs().total_cmp(&(b - 1.0).abs());
    values.iter().copied().max_by(further).unwrap_or(f64::NAN)
}

/// Slopes d ln A/d ln(cutoff) over the last decade of every curve.
fn final_slopes(curves: &[Vec<Point>]) -> Vec<f64> {
    let slope = |curve: &Vec<Point>| {
        let (shortest_m, _) = *curve.last()?;
        findings::features::log_slope(findings::features::between(curve, 10.0 * shortest_m, shortest_m))
    };
    curves.iter().filter_map(slope).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_and_nan_prove_nothing() {
        assert!(lowest([]).is_nan() && highest([1.0, f64::NAN]).is_nan());
        assert_eq!((lowest([2.0, 1.0]), highest([2.0, 1.0])), (1.0, 2.0));
    }
}
