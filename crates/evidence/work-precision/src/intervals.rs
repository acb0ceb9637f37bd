//! Movement of the ends of an interval between seeds against the cost of its draws, with and without the polynomial that
//! fills up the space between draws.

use numerics::parallel::Unobserved;
use scene::Scene;
use study::plan::Results;
use tables::markdown::table;
use uncertainty::{AreaInterval, Settings, UncertaintyPlan};

use crate::bench::{Bench, Contents};
use crate::files::{self, scientific};
use crate::page::{percent, time};
use crate::seeds::{mean, root_mean_square, standard_deviation, with_seeds};
use crate::uncertain_scene::SceneFiles;

/// Numbers of computed draws.
const DRAWS: [usize; 4] = [100, 300, 1000, 3000];
/// Number of seeds.
const SEEDS: u64 = 12;
/// Function of a plan that computes its intervals.
type Intervals = fn(&UncertaintyPlan<'_>) -> Result<Vec<AreaInterval>, study::plan::PlanError>;

/// Ways to an interval, by name.
const WAYS: [(&str, Intervals); 2] = [
    ("draws alone", |plan| plan.intervals_unfilled(&Unobserved)),
    ("filled up by the polynomial", |plan| plan.intervals(&Unobserved)),
];

/// Cost and steadiness of the intervals of one way.
#[derive(Debug, Clone, PartialEq)]
struct IntervalCost {
    way: &'static str,
    draws: usize,
    /// Processor time \[s\] of all intervals of the scene.
    seconds: f64,
    /// Standard deviation of an end between seeds over the width, root mean square over all ends.
    movement: f64,
    /// The largest of these.
    largest_movement: f64,
}

/// Computes the intervals of the scene with every number of draws, way and seed.
///
/// # Errors
/// A message if the scene cannot be computed.
pub fn measure(bench: &mut Bench) -> Result<Contents, String> {
    let scene = SceneFiles::new()?.parsed()?;
    let results = scene.plan().compute().map_err(|error| error.to_string())?;
    let mut costs = Vec::new();
    for (way, intervals) in WAYS {
        for draws in DRAWS {
            let (found, seconds) = with_seeds(SEEDS, |seed| {
                let settings = Settings { draws, seed, ..Settings::default() };
                ends(&scene, &results, &settings, intervals)
            })?;
            let movements = movements(&found);
            costs.push(IntervalCost {
                way,
                draws,
                seconds,
                movement: root_mean_square(&movements),
                largest_movement: movements.into_iter().fold(0.0, f64::max),
            });
        }
    }
    Ok(Contents {
        sections: vec![("intervals", costs_table(&costs))],
        files: vec![("intervals.csv", files::comments(&bench.facts) + &csv(&costs))],
    })
}

/// Logarithms of the ends of every interval.
fn ends(
    scene: &Scene,
    results: &Results,
    settings: &Settings,
    intervals: Intervals,
) -> Result<Vec<[f64; 2]>, String> {
    let plan = UncertaintyPlan::new(scene, results, settings).ok_or("nothing is uncertain")?;
    let found = intervals(&plan).map_err(|error| error.to_string())?;
    Ok(found.iter().map(|interval| [interval.low.ln(), interval.high.ln()]).collect())
}

/// Standard deviation of every end between seeds, over the mean width of its interval.
fn movements(found: &[Vec<[f64; 2]>]) -> Vec<f64> {
    let count = found.iter().map(Vec::len).min().unwrap_or(0);
    let of_interval = |at: usize| {
        let [low, high] = [0, 1].map(|end| found.iter().map(|ends| ends[at][end]).collect::<Vec<f64>>());
        let width = mean(&high) - mean(&low);
        [low, high].map(|ends| standard_deviation(&ends) / width)
    };
    (0..count).flat_map(of_interval).collect()
}

/// Table of cost and movement by way and number of draws.
fn costs_table(costs: &[IntervalCost]) -> String {
    let cells = |cost: &IntervalCost| {
        let movements = [cost.movement, cost.largest_movement].map(percent);
        let mut cells = vec![cost.way.to_owned(), cost.draws.to_string(), time(cost.seconds)];
        cells.extend(movements);
        cells
    };
    let columns = ["way", "draws", "processor time", "movement of an end", "largest"];
    table(&columns, &costs.iter().map(cells).collect::<Vec<_>>())
}

fn csv(costs: &[IntervalCost]) -> String {
    let row = |cost: &IntervalCost| {
        let numbers = [cost.seconds, cost.movement, cost.largest_movement].map(scientific);
        format!("{},{},{}\n", cost.way, cost.draws, numbers.join(","))
    };
    let header = "way,draws,processor_seconds,movement,largest_movement\n";
    header.to_owned() + &costs.iter().map(row).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_move_in_units_of_the_width() {
        let found = [vec![[0.0, 2.0]], vec![[0.2, 2.2]]];
        let moved = movements(&found);
        assert!(
            moved.iter().all(|movement| (movement - 0.2 * 0.5f64.sqrt() / 2.0).abs() < 1e-12),
            "{moved:?}"
        );
    }

    #[test]
    fn every_curve_of_the_scene_has_intervals() {
        let scene = SceneFiles::new().unwrap().parsed().unwrap();
        let results = scene.plan().compute().unwrap();
        for (way, intervals) in WAYS {
            let settings = Settings { draws: 100, ..Settings::default() };
            let ends = ends(&scene, &results, &settings, intervals).unwrap();
            assert_eq!(ends.len(), 6, "{way}");
            assert!(ends.iter().all(|[low, high]| low < high), "{way}");
        }
    }
}
