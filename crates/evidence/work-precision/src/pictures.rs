//! Work-precision plots: the error of a state over its time.

use report::plot;
use study::figure::{Axis, FigureData, Series, Shows};

use crate::files::stem;
use crate::machine::Fact;
use crate::point::{Engine, GivenQuantity, Point};
use crate::scaling::Scaling;

/// Error at which smaller ones are drawn: logarithmic axes have no zero, and doubles no more digits.
const LEAST_ERROR: f64 = 1e-16;

const X_LABEL: &str = "error of the state";

/// Plots one law and question of a population: a line per engine and separation, which joins its settings.
pub fn work_precision(
    points: &[&Point],
    population: &str,
    law: &str,
    given: GivenQuantity,
    facts: &[Fact],
) -> String {
    let mut series = Vec::new();
    // scipy with laws in numpy is a decade or more above the tuned one, and has a row in the tables.
    let drawn = Engine::ALL.into_iter().filter(|engine| *engine != Engine::QuadNumpy);
    for (index, engine) in drawn.enumerate() {
        let of_engine =
            || points.iter().filter(|point| point.engine == engine && point.population == population);
        let mut separations: Vec<f64> = of_engine().map(|point| point.separation_over_sigma).collect();
        separations.sort_by(f64::total_cmp);
        separations.dedup();
        series.extend(separations.into_iter().map(|separation| {
            let here = of_engine().filter(|point| point.separation_over_sigma == separation);
            let right = here.filter_map(|point| Some((point.error()?.max(LEAST_ERROR), point.seconds)));
            Series::under(engine.name(), index, without_repetitions(right.collect()))
        }));
    }
    let lines = series.into_iter().filter(|line| !line.points.is_empty()).collect();
    let error = Axis { column: "error", label: X_LABEL };
    let figure = FigureData {
        title: format!("{law}, {}", given.question()),
        ..FigureData::new(&stem(law, given), Shows::Response, error, "time per state (s)", lines)
    };
    plot::svg(&figure, &format!("{population}, a line for each of d/σ = −3, 0, 3, 6, 20"), &provenance(facts))
}

/// Merges settings with the same error to one point, which is drawn as a dot if it is the only one.
fn without_repetitions(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for (error, seconds) in points {
        match kept.iter_mut().find(|(known, _)| *known == error) {
            Some((_, shortest)) => *shortest = shortest.min(seconds),
            None => kept.push((error, seconds)),
        }
    }
    kept
}

/// Plots the program's processor time over the size of its input.
pub fn scaling(scaling: &Scaling, facts: &[Fact]) -> String {
    let series = scaling.growths.iter().enumerate().map(|(index, growth)| {
        Series::under(growth.what, index, growth.runs.iter().map(|run| (run.size, run.processor_s)).collect())
    });
    let size =
        Axis { column: "size", label: "number of scales, cutoffs, loads, rows, points, scans or draws" };
    let figure = FigureData {
        title: "Cost of a run of the program".to_owned(),
        ..FigureData::new("scaling", Shows::Response, size, "processor time (s)", series.collect())
    };
    plot::svg(&figure, "one thread, start-up and writing included", &provenance(facts))
}

fn provenance(facts: &[Fact]) -> Vec<String> {
    let measured = "measured by `cargo xtask work-precision`; do not edit".to_owned();
    std::iter::once(measured).chain(facts.iter().map(|(name, value)| format!("{name}: {value}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::without_repetitions;

    #[test]
    fn settings_of_one_error_are_one_point_of_the_shortest_time() {
        let points = vec![(1e-16, 3.0), (1e-16, 2.0), (1e-9, 1.0)];
        assert_eq!(without_repetitions(points), [(1e-16, 2.0), (1e-9, 1.0)]);
    }
}
