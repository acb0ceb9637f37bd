//! The bracket of the judge against its cost, on a scene that comes with the program.

use judge::{ElementArea, JudgePlan, JudgeSettings};
use numerics::parallel::Unobserved;
use scene::{Overrides, Scene, Template};
use study::NoFiles;
use study::plan::Results;
use tables::markdown::table;

use crate::bench::{Bench, Contents};
use crate::files::{self, scientific};
use crate::page::{percent, time};
use crate::seeds::{mean, standard_deviation, with_seeds};

/// Scene that is judged.
const SCENE: Template = Template::ContactChallenge;
/// Points along a side and surfaces in each window, beginning with the choice of the judge within its default budget. The last
/// has the means that brackets ought to hold.
const SETTINGS: [Option<(usize, usize)>; 8] = [
    None,
    Some((48, 4)),
    Some((48, 16)),
    Some((96, 4)),
    Some((96, 16)),
    Some((192, 4)),
    Some((192, 16)),
    Some((384, 4)),
];
/// Number of seeds.
const SEEDS: u64 = 8;

/// Area of boundary elements on the whole band with its bracket.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bracket {
    area_fraction: f64,
    standard_error: f64,
    low: f64,
    high: f64,
}

/// Brackets of one setting over all seeds, loads and bodies; means of shares of the area.
#[derive(Debug, Clone, PartialEq)]
struct BracketCost {
    /// Points along a side and surfaces in each window; `None` where the judge chooses.
    setting: Option<(usize, usize)>,
    /// Processor time \[s\] of a judgement.
    seconds: f64,
    half_width: f64,
    standard_error: f64,
    /// Standard deviation between seeds.
    scatter: f64,
    /// Share of the brackets that hold the mean of the finest setting.
    share_held: f64,
}

/// Judges the scene at every setting with every seed.
///
/// # Errors
/// A message if the scene cannot be judged.
pub fn measure(bench: &mut Bench) -> Result<Contents, String> {
    let scene = Scene::parse(SCENE.text(), &NoFiles, &Overrides::default());
    let scene = scene.map_err(|error| error.to_string())?;
    let results = scene.plan().compute().map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    for setting in SETTINGS {
        found.push(with_seeds(SEEDS, |seed| brackets(&scene, &results, &settings(setting, seed)))?);
    }
    let means = found.last().map(|(finest, _)| of_each(finest, |brackets| mean(&areas(brackets))));
    let means = means.unwrap_or_default();
    let costs = SETTINGS
        .iter()
        .zip(&found)
        .map(|(setting, (found, seconds))| cost(*setting, *seconds, found, &means));
    let costs: Vec<BracketCost> = costs.collect();
    Ok(Contents {
        sections: vec![("judge", costs_table(&costs))],
        files: vec![("judge.csv", files::comments(&bench.facts) + &csv(&costs))],
    })
}

/// JudgeSettings of the judge, without a budget where the setting is fixed.
fn settings(setting: Option<(usize, usize)>, seed: u64) -> JudgeSettings {
    let chosen = JudgeSettings { seed, ..JudgeSettings::default() };
    setting.map_or(chosen, |(grid, realisations)| JudgeSettings {
        grid: Some(grid),
        realisations: Some(realisations),
        budget: f64::INFINITY,
        ..chosen
    })
}

/// Judges a scene; a bracket for each load and body that was pressed.
fn brackets(scene: &Scene, results: &Results, settings: &JudgeSettings) -> Result<Vec<Bracket>, String> {
    let judgement = JudgePlan::new(scene, results, settings).run(&Unobserved);
    let judgement = judgement.map_err(|error| error.to_string())?;
    let found = judgement.references.iter().filter_map(|reference| reference.elements);
    let bracket = |area: ElementArea| Bracket {
        area_fraction: area.area_fraction,
        standard_error: area.standard_error,
        low: area.low(),
        high: area.high(),
    };
    Ok(found.map(bracket).collect())
}

/// Maps each bracket with its counterparts of all seeds.
fn of_each<T>(found: &[Vec<Bracket>], map: impl Fn(&[Bracket]) -> T) -> Vec<T> {
    let count = found.iter().map(Vec::len).min().unwrap_or(0);
    (0..count).map(|at| map(&found.iter().map(|brackets| brackets[at]).collect::<Vec<_>>())).collect()
}

fn areas(brackets: &[Bracket]) -> Vec<f64> {
    brackets.iter().map(|bracket| bracket.area_fraction).collect()
}

/// Summarises the brackets of a setting, with the means that they ought to hold.
fn cost(setting: Option<(usize, usize)>, seconds: f64, found: &[Vec<Bracket>], means: &[f64]) -> BracketCost {
    let of_all = |value: fn(&Bracket) -> f64| {
        mean(
            &found.iter().flatten().map(|bracket| value(bracket) / bracket.area_fraction).collect::<Vec<_>>(),
        )
    };
    let scatter = |brackets: &[Bracket]| standard_deviation(&areas(brackets)) / mean(&areas(brackets));
    // The mean of equal areas, as of full flow, may be off by its rounding.
    const ROUNDING: f64 = 1e-14;
    let is_held = |(bracket, mean): (&Bracket, &f64)| {
        f64::from(bracket.low <= mean * (1.0 + ROUNDING) && mean * (1.0 - ROUNDING) <= bracket.high)
    };
    let held: Vec<f64> = found.iter().flat_map(|brackets| brackets.iter().zip(means).map(is_held)).collect();
    BracketCost {
        setting,
        seconds,
        half_width: of_all(|bracket| 0.5 * (bracket.high - bracket.low)),
        standard_error: of_all(|bracket| bracket.standard_error),
        scatter: mean(&of_each(found, scatter)),
        share_held: mean(&held),
    }
}

/// Table of cost and width by setting.
fn costs_table(costs: &[BracketCost]) -> String {
    let columns = [
        "points along a side",
        "surfaces a window",
        "processor time",
        "half width",
        "standard error",
        "between seeds",
        "hold the mean",
    ];
    let cells = |cost: &BracketCost| {
        let shares = [cost.half_width, cost.standard_error, cost.scatter, cost.share_held];
        let mut cells = setting_cells(cost, "chosen").to_vec();
        cells.push(time(cost.seconds));
        cells.extend(shares.map(percent));
        cells
    };
    table(&columns, &costs.iter().map(cells).collect::<Vec<_>>())
}

/// Cells of grid and surfaces.
fn setting_cells(cost: &BracketCost, where_chosen: &str) -> [String; 2] {
    let chosen = || [where_chosen.to_owned(), where_chosen.to_owned()];
    cost.setting
        .map_or_else(chosen, |(grid, realisations)| [grid, realisations].map(|count| count.to_string()))
}

fn csv(costs: &[BracketCost]) -> String {
    let header = "grid,realisations,processor_seconds,half_width,standard_error,scatter,share_held\n";
    let row = |cost: &BracketCost| {
        let numbers = [cost.seconds, cost.half_width, cost.standard_error, cost.scatter, cost.share_held];
        format!("{},{}\n", setting_cells(cost, "").join(","), numbers.map(scientific).join(","))
    };
    header.to_owned() + &costs.iter().map(row).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_are_held_against_the_means_and_measured_in_areas() {
        let bracket = |area_fraction: f64| Bracket {
            area_fraction,
            standard_error: 0.05 * area_fraction,
            low: 0.9 * area_fraction,
            high: 1.1 * area_fraction,
        };
        let found = [vec![bracket(0.1), bracket(0.3)], vec![bracket(0.12), bracket(0.3)]];
        let means = of_each(&found, |brackets| mean(&areas(brackets)));
        let cost = cost(Some((48, 2)), 0.5, &found, &means);
        assert!((cost.half_width - 0.1).abs() < 1e-12 && (cost.standard_error - 0.05).abs() < 1e-12);
        assert!((cost.scatter - 0.5 * 0.02 * 0.5f64.sqrt() / 0.11).abs() < 1e-12, "{}", cost.scatter);
        assert_eq!(cost.share_held, 1.0);
        assert_eq!(super::cost(Some((48, 2)), 0.5, &found, &[0.2, 0.3]).share_held, 0.5);
        let flat = Bracket { low: 0.1, ..bracket(0.1) };
        assert_eq!(super::cost(None, 0.5, &[vec![flat]], &[0.1f64.next_down()]).share_held, 1.0);
        let row = costs_table(&[cost]).lines().last().unwrap().to_owned();
        assert_eq!(row, "| 48 | 2 | 500 ms | 10.0 % | 5.00 % | 6.43 % | 100 % |");
    }
}
