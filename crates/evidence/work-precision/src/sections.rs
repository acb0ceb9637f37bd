//! Tables of `docs/develop/performance.md`, from the measurements.

use tables::markdown::table;

use crate::competitors::MissingPackage;
use crate::kernels::{Cost, KernelCost};
use crate::machine::Fact;
use crate::page::{error, mebibytes, met, three_digits, time};
use crate::point::{Engine, GivenQuantity, Point};
use crate::scaling::Scaling;
use crate::stack::{BARRED_LAW, StackCost};
use crate::verdicts::{FOUR_LAWS, mean_of_four, mean_seconds, standing, worst_error};

/// Tolerance at which the cost of a state is compared with scipy's.
const STATE_TOLERANCE: f64 = 1e-10;
/// Tolerance at which the Hertz pair is compared with `Fn`.
const PAIR_TOLERANCE: f64 = 1e-12;
/// Factor by which a fixed-load state must be cheaper than with scipy.
const STATE_BAR: f64 = 3000.0;
/// Factor by which the Hertz pair must be cheaper than with `Fn`.
const PAIR_BAR: f64 = 1000.0;
/// Factor by which a law must be cheaper than with numpy, both at a thousand interferences.
const KERNEL_BAR: f64 = 4.0;
/// Largest time per scale of the stack and load \[s\].
const STACK_BAR_S: f64 = 60e-9;
/// Tolerances shown, out of those measured.
const SHOWN_TOLERANCES: [f64; 6] = [1e-3, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13];

/// Measurements of statistical states and the stack.
#[derive(Debug)]
pub struct Measured {
    /// Machine and versions.
    pub facts: Vec<Fact>,
    /// Competitors that were missing.
    pub missing: Vec<MissingPackage>,
    /// Answers of all engines.
    pub points: Vec<Point>,
    /// Costs of scales of the stack.
    pub stack: Vec<StackCost>,
}

/// Sections of the machine, of states and of the stack, by name.
pub fn all(measured: &Measured) -> [(&'static str, String); 8] {
    let Measured { facts, missing, points, stack } = measured;
    [
        ("machine", machine_table(facts, missing)),
        ("verdicts", verdicts(points, stack)),
        ("standings", standings(points)),
        ("where-ahead", where_ahead(points)),
        ("ratios", ratios(points)),
        ("states-by-separation", state_costs(points, GivenQuantity::Separation)),
        ("states-by-pressure", state_costs(points, GivenQuantity::Pressure)),
        ("stack", stack_costs(stack)),
    ]
}

/// All laws of the points, in their order.
pub fn laws(points: &[Point]) -> Vec<&str> {
    let mut laws: Vec<&str> = Vec::new();
    for point in points {
        if !laws.contains(&point.law.as_str()) {
            laws.push(&point.law);
        }
    }
    laws
}

/// Table of the machine, and of missing competitors.
fn machine_table(facts: &[Fact], missing: &[MissingPackage]) -> String {
    let mut rows: Vec<Vec<String>> =
        facts.iter().map(|(name, value)| vec![name.clone(), value.clone()]).collect();
    rows.extend(missing.iter().map(|m| vec![m.package.clone(), format!("**missing**: {}", m.reason)]));
    table(&["what", "which"], &rows).replace("---:", "---")
}

/// Table of the bars of the study, and our results.
pub fn verdicts(points: &[Point], stack: &[StackCost]) -> String {
    let mut rows =
        vec![state_bar(points, Engine::QuadNumpy), state_bar(points, Engine::Quad), pair_bar(points)];
    rows.extend(stack.iter().filter(|cost| cost.law == BARRED_LAW).map(|cost| {
        let seconds = cost.seconds_per_scale;
        vec![
            "stacked, elastic-plastic, a scale and load".to_owned(),
            format!("at most {}", time(STACK_BAR_S)),
            time(seconds),
            met(seconds <= STACK_BAR_S),
        ]
    }));
    let plotted: Vec<Point> =
        points.iter().filter(|point| FOUR_LAWS.contains(&point.law.as_str())).cloned().collect();
    let standings = Engine::COMPETITORS.map(|engine| standing(&plotted, engine, engine.counterpart()));
    let ahead: usize = standings.iter().map(|standing| standing.ahead.len()).sum();
    let right: usize = standings.iter().map(|standing| standing.right).sum();
    rows.push(vec![
        "competitors' points both faster and more accurate than one of ours, four laws".to_owned(),
        "0".to_owned(),
        format!("{ahead} of {right}"),
        met(ahead == 0),
    ]);
    table(&["what", "bar", "measured", "met"], &rows)
}

/// Table of the bars of single asperities, and our results.
pub fn kernel_verdicts(costs: &[KernelCost]) -> String {
    let rows = costs.iter().filter(|cost| cost.batch.is_some()).map(|cost| {
        let what = format!("{}, each of 1000, against numpy", cost.kernel);
        let seconds = |cost: Option<Cost>| cost.map(|cost| cost.seconds);
        ratio_row(&what, KERNEL_BAR, seconds(cost.batch), seconds(cost.array), "numpy")
    });
    table(&["what", "bar", "measured", "met"], &rows.collect::<Vec<_>>())
}

/// Row for one of ours that must be cheaper by a factor, or with the missing measurement.
fn ratio_row(what: &str, bar: f64, ours: Option<f64>, theirs: Option<f64>, name: &str) -> Vec<String> {
    let (measured, met) = match (ours, theirs) {
        (Some(ours), Some(theirs)) => (
            format!("{} times ({} against {})", three_digits(theirs / ours), time(ours), time(theirs)),
            met(theirs / ours >= bar),
        ),
        _ => (format!("{name} is missing"), "unknown".to_owned()),
    };
    vec![what.to_owned(), format!("{} times cheaper", three_digits(bar)), measured, met]
}

fn state_bar(points: &[Point], scipy: Engine) -> Vec<String> {
    let mean = |engine| mean_of_four(points, engine, STATE_TOLERANCE, GivenQuantity::Pressure);
    let what = format!("a state at a given load, 10⁻¹⁰, mean of four laws, against {}", scipy.name());
    ratio_row(&what, STATE_BAR, mean(Engine::Ours), mean(scipy), scipy.name())
}

fn pair_bar(points: &[Point]) -> Vec<String> {
    let mean = |engine, setting| mean_seconds(points, engine, setting, "hertz", GivenQuantity::Separation);
    let ours = mean(Engine::Ours, PAIR_TOLERANCE);
    let theirs = mean(Engine::Fn, Engine::Fn.settings()[0]);
    let what = "Hertz, area and load at a separation, 10⁻¹², against ContactMechanics' Fn";
    ratio_row(what, PAIR_BAR, ours, theirs, "ContactMechanics")
}

/// Table of how often competitors are ahead, and how often they are on the front.
fn standings(points: &[Point]) -> String {
    let mut rows = Vec::new();
    let like_for_like = Engine::COMPETITORS.map(|engine| (engine, engine.counterpart()));
    for (engine, against) in like_for_like.into_iter().chain([(Engine::GridBatch, Engine::Ours)]) {
        let standing = standing(points, engine, against);
        rows.push(vec![
            engine.name().to_owned(),
            against.name().to_owned(),
            standing.right.to_string(),
            standing.wrong.to_string(),
            standing.failed.to_string(),
            standing.ahead.len().to_string(),
            standing.unmatched.len().to_string(),
        ]);
    }
    let columns = [
        "engine",
        "against",
        "right",
        "wrong by over 1 %",
        "no answer",
        "faster and more accurate",
        "unmatched",
    ];
    table(&columns, &rows)
}

/// Table of the points at which a competitor is ahead.
fn where_ahead(points: &[Point]) -> String {
    let mut rows: Vec<(Vec<String>, usize)> = Vec::new();
    for engine in Engine::COMPETITORS {
        for point in standing(points, engine, engine.counterpart()).ahead {
            let key = vec![
                engine.name().to_owned(),
                format!("{}", point.setting),
                point.law.clone(),
                point.given.question().to_owned(),
            ];
            match rows.iter_mut().find(|(known, _)| *known == key) {
                Some((_, count)) => *count += 1,
                None => rows.push((key, 1)),
            }
        }
    }
    if rows.is_empty() {
        return "No point.".to_owned();
    }
    let rows: Vec<Vec<String>> = rows
        .into_iter()
        .map(|(mut key, count)| {
            key.push(count.to_string());
            key
        })
        .collect();
    table(&["engine", "nodes or tolerance", "law", "question", "points"], &rows)
}

/// Table of the cost of a state by law and tolerance, with the worst error.
fn state_costs(points: &[Point], given: GivenQuantity) -> String {
    let columns: Vec<String> =
        std::iter::once("law".to_owned()).chain(SHOWN_TOLERANCES.iter().map(|t| format!("{t:e}"))).collect();
    let rows = laws(points).into_iter().map(|law| {
        let cell = |tolerance: &f64| {
            let seconds = mean_seconds(points, Engine::Ours, *tolerance, law, given);
            let worst = worst_error(points, Engine::Ours, *tolerance, law, given);
            match (seconds, worst) {
                (Some(seconds), Some(worst)) => format!("{}, {}", time(seconds), error(worst)),
                _ => String::new(),
            }
        };
        std::iter::once(law.to_owned()).chain(SHOWN_TOLERANCES.iter().map(cell)).collect()
    });
    table(&columns.iter().map(String::as_str).collect::<Vec<_>>(), &rows.collect::<Vec<_>>())
}

/// Table of our cost over each engine's at its best setting for a comparable error, law by law.
fn ratios(points: &[Point]) -> String {
    let mut rows = Vec::new();
    for law in laws(points) {
        for given in GivenQuantity::ALL {
            let ours = mean_seconds(points, Engine::Ours, STATE_TOLERANCE, law, given);
            let scipy = mean_seconds(points, Engine::Quad, STATE_TOLERANCE, law, given);
            let contact_mechanics = mean_seconds(points, Engine::Fn, Engine::Fn.settings()[0], law, given);
            let cells = [scipy, contact_mechanics].map(|theirs| match (ours, theirs) {
                (Some(ours), Some(theirs)) => [time(theirs), three_digits(theirs / ours)],
                _ => [String::new(), String::new()],
            });
            let [scipy, contact_mechanics] = cells;
            let mut row =
                vec![law.to_owned(), given.question().to_owned(), ours.map_or_else(String::new, time)];
            row.extend(scipy);
            row.extend(contact_mechanics);
            rows.push(row);
        }
    }
    table(&["law", "question", "truearea, 1e-10", "scipy, 1e-10", "ratio", "Fn", "ratio"], &rows)
}

/// Table of the cost of a scale of the stack.
fn stack_costs(costs: &[StackCost]) -> String {
    let rows = costs.iter().map(|cost| {
        let off = cost.off_limit.map_or_else(|| "unknown".to_owned(), error);
        vec![cost.law.to_owned(), time(cost.seconds_per_scale), off]
    });
    table(&["law", "per scale and load", "off the dense limit"], &rows.collect::<Vec<_>>())
}

/// Table of the cost of one asperity.
pub fn kernel_costs(costs: &[KernelCost]) -> String {
    let cells = |cost: &Option<Cost>| match cost {
        Some(cost) => format!("{}, {}", time(cost.seconds), error(cost.median_error)),
        None => String::new(),
    };
    let rows = costs.iter().map(|cost| {
        vec![
            cost.kernel.to_owned(),
            cells(&Some(cost.ours)),
            cells(&cost.scalar),
            cells(&cost.batch),
            cells(&cost.array),
        ]
    });
    let columns = ["one evaluation", "truearea", "Python", "truearea, each of 1000", "numpy, each of 1000"];
    table(&columns, &rows.collect::<Vec<_>>())
}

/// Formats a whole number to three digits.
fn count(number: f64) -> String {
    if number < 1000.0 { format!("{number}") } else { three_digits(number) }
}

/// Table of the scaling of the program, also with the number of threads.
pub fn growths(scaling: &Scaling) -> String {
    let memory = |bytes: Option<u64>| bytes.map_or_else(|| "unknown".to_owned(), mebibytes);
    let rows = scaling.growths.iter().filter_map(|growth| {
        let (first, last) = (growth.runs.first()?, growth.runs.last()?);
        Some(vec![
            growth.what.to_owned(),
            format!("{} to {}", count(first.size), count(last.size)),
            time(last.processor_s),
            time((last.processor_s - scaling.start_up_s) / last.size),
            growth.exponent.map_or_else(|| "unknown".to_owned(), |exponent| format!("{exponent:.2}")),
            memory(first.peak_bytes),
            memory(last.peak_bytes),
        ])
    });
    let columns = [
        "what grows",
        "from, to",
        "last run",
        "each of the last",
        "exponent",
        "memory of the first",
        "of the last",
    ];
    let threads = scaling.threads.iter().map(|run| format!("{} on {}", time(run.wall_s), run.threads));
    format!(
        "{}\nStart-up is {}. Four loads at 7300 cutoffs each, by the clock on the wall and the number of threads: {}.\n",
        table(&columns, &rows.collect::<Vec<_>>()),
        time(scaling.start_up_s),
        threads.collect::<Vec<_>>().join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::Outcome;

    fn point(engine: Engine, law: &str, setting: f64, seconds: f64) -> Point {
        Point {
            population: "steel".to_owned(),
            law: law.to_owned(),
            given: GivenQuantity::Pressure,
            separation_over_sigma: 0.0,
            engine,
            setting,
            seconds,
            outcome: Outcome::Right(1e-11),
        }
    }

    #[test]
    fn a_bar_is_met_missed_or_unknown() {
        let of = |engine, seconds| FOUR_LAWS.iter().map(move |law| point(engine, law, 1e-10, seconds));
        let verdict = |theirs: f64| {
            let points: Vec<Point> = of(Engine::Ours, 1e-5).chain(of(Engine::Quad, theirs)).collect();
            state_bar(&points, Engine::Quad)[3].clone()
        };
        assert_eq!((verdict(0.04).as_str(), verdict(0.02).as_str()), ("yes", "**no**"));
        let alone: Vec<Point> = of(Engine::Ours, 1e-5).collect();
        assert_eq!(state_bar(&alone, Engine::Quad)[3], "unknown");
    }

    #[test]
    fn a_law_must_be_four_times_as_fast_as_numpy_at_many_interferences() {
        let cost = |seconds| Some(Cost { seconds, median_error: 0.0 });
        let of = |batch, array| KernelCost {
            kernel: "Hertz",
            ours: cost(1e-8).unwrap(),
            batch,
            scalar: None,
            array,
        };
        let costs = [
            of(cost(1e-9), cost(4e-9)),
            of(cost(1e-9), cost(3.9e-9)),
            of(cost(1e-9), None),
            of(None, cost(1e-9)),
        ];
        let text = kernel_verdicts(&costs);
        let met: Vec<&str> = text.lines().skip(2).map(|row| row.rsplit('|').nth(1).unwrap().trim()).collect();
        assert_eq!(met, ["yes", "**no**", "unknown"], "{text}");
    }

    #[test]
    fn the_page_has_every_section_of_states() {
        let (facts, missing, points, stack) = Default::default();
        let path = crate::reference::repository("docs/develop/performance.md");
        let page = std::fs::read_to_string(path).unwrap();
        for (name, contents) in all(&Measured { facts, missing, points, stack }) {
            assert!(tables::markdown::with_section(&page, name, &contents).is_ok(), "{name}");
        }
    }

    #[test]
    fn points_at_which_a_competitor_is_ahead_are_listed() {
        let ours = Point { outcome: Outcome::Right(1e-5), ..point(Engine::OursBatch, "hertz", 1e-4, 1e-6) };
        let theirs = Point { seconds: 1e-7, ..point(Engine::GridBatch, "hertz", 100.0, 0.0) };
        let text = where_ahead(&[ours.clone(), theirs]);
        assert!(text.ends_with("| grid, batch | 100 | hertz | d(p) | 1 |\n"), "{text}");
        assert_eq!(where_ahead(&[ours]), "No point.");
    }
}
