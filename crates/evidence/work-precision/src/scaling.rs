//! Scaling of the program's cost with its input: scales, cutoffs, loads, rows of a table, points of maps, scans, draws, threads.
//!
//! The program is measured from outside, with everything that a user waits for: start-up, reading, computing,
//! writing. Time is processor time, user and system, which a busy machine disturbs less than wall time; only threads
//! are measured by wall time.

use std::path::PathBuf;

use crate::inputs::Inputs;
use crate::processes::{peak_bytes, processor_s, program, wall_s};
use crate::uncertain_scene::SceneFiles;

const MATERIAL: [&str; 6] =
    ["--youngs-modulus", "463 GPa", "--poisson-ratio", "0.2", "--yield-strength", "1.8 GPa"];
/// Material of the Contact-Mechanics Challenge, and a band of its spectrum that the coarsest grid holds.
const BAND: [&str; 10] = [
    "--youngs-modulus",
    "18.75 MPa",
    "--poisson-ratio",
    "0.5",
    "--longest",
    "50 um",
    "--shortest",
    "2 um",
    "--box",
    "100 um",
];
const SPECTRUM: &str = "builtin:uncd-reconstructed";
const DECADES: f64 = 7.3;

/// Growth of the time with one kind of input.
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// Input that grows, and model.
    pub what: &'static str,
    /// Runs, the smallest first.
    pub runs: Vec<Run>,
    /// Least-squares slope of ln(time) over ln(size), both beyond those of the smallest run; `None` if fewer than two
    /// runs take longer than that one.
    pub exponent: Option<f64>,
}

/// Run of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// Number of scales, cutoffs, loads, rows, points, scans or draws.
    pub size: f64,
    /// Processor time \[s\] of a run, start-up included.
    pub processor_s: f64,
    /// Largest memory held \[bytes\]; `None` if the system does not report it.
    pub peak_bytes: Option<u64>,
}

/// Wall time by number of threads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threads {
    /// Number of threads allowed.
    pub threads: usize,
    /// Shortest wall time of some runs \[s\].
    pub wall_s: f64,
}

/// Scaling of the program.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    /// Processor time \[s\] of a run that computes nothing.
    pub start_up_s: f64,
    /// Growth of the time with each kind of input.
    pub growths: Vec<Growth>,
    /// Wall times of the same work on more threads.
    pub threads: Vec<Threads>,
}

/// Measures the program beside this one, as built by cargo; its input is kept in `folder` meanwhile.
///
/// # Errors
/// A message if the program is missing or fails.
pub fn measure(folder: PathBuf) -> Result<Scaling, String> {
    let program = program("truearea", "truearea-cli")?;
    let start_up_s = processor_s(&program, &["--version".to_owned()])?;
    let inputs = Inputs::new(folder);
    let growth = |what, sizes: &[f64], arguments: &dyn Fn(f64) -> Vec<String>| -> Result<Growth, String> {
        let run = |&size: &f64| {
            let (arguments, size) = (arguments(size), size.round());
            let processor_s = processor_s(&program, &arguments)?;
            Ok(Run { size, processor_s, peak_bytes: peak_bytes(&program, &arguments)? })
        };
        let runs = sizes.iter().map(run).collect::<Result<Vec<Run>, String>>()?;
        Ok(Growth { what, exponent: exponent(&runs), runs })
    };
    let per_decade = |sizes: &[f64]| sizes.iter().map(|size| size * DECADES).collect::<Vec<f64>>();
    let loads = [1.0, 10.0, 100.0, 1000.0];
    let rows = [1e3, 1e4, 1e5, 1e6];
    let points = [256.0, 512.0, 1024.0, 2048.0].map(|side: f64| side * side);
    let draws = [1e2, 1e3, 1e4];
    let scene = SceneFiles::new()?;
    let growths = vec![
        growth("scales, stacked", &per_decade(&[1e2, 1e3, 1e4, 1e5]), &|scales| {
            resampled("stacked", "elastic-plastic", scales, 1)
        })?,
        growth("loads, stacked", &loads, &|loads| {
            resampled("stacked", "elastic-plastic", 100.0 * DECADES, loads as usize)
        })?,
        growth("cutoffs, statistical", &per_decade(&[1e1, 1e2, 1e3, 1e4]), &|cutoffs| {
            resampled("statistical", "ep-sphere", cutoffs, 1)
        })?,
        growth("loads, statistical", &loads, &|loads| {
            resampled("statistical", "ep-sphere", 10.0 * DECADES, loads as usize)
        })?,
        growth("rows of a table, statistical", &rows, &|rows| {
            vec!["statistical".to_owned(), "--input".to_owned(), inputs.states(rows as usize)]
        })?,
        growth("points of a map, spectrum", &points, &|points| inputs.map(points))?,
        growth("points of a map, elements", &points, &elements)?,
        growth("scans of 4096 points, spectrum", &loads, &|lines| inputs.lines(lines as usize))?,
        growth("draws of an interval", &draws, &|draws| inputs.draws(&scene, draws as usize))?,
    ];
    let available = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = (1..=available).map(|threads| {
        let wall_s = wall_s(&program, &resampled("statistical", "ep-sphere", 1e3 * DECADES, 4), threads)?;
        Ok(Threads { threads, wall_s })
    });
    let threads = threads.collect::<Result<Vec<Threads>, String>>()?;
    inputs.remove();
    Ok(Scaling { start_up_s, growths, threads })
}

/// Arguments of a model over the spectrum of diamond, resampled to about `scales` scales, under loads from 10⁻⁶ to 1
/// GPa.
fn resampled(model: &str, law: &str, scales: f64, loads: usize) -> Vec<String> {
    let mut arguments = vec![model.to_owned(), SPECTRUM.to_owned()];
    arguments.extend(["--model", law, "--scales-per-decade"].map(str::to_owned));
    arguments.push(format!("{}", (scales / DECADES).round()));
    arguments.extend(MATERIAL.map(str::to_owned));
    for load in 0..loads {
        let decades = if loads == 1 { 2.0 } else { 6.0 * load as f64 / (loads - 1) as f64 };
        arguments.extend(["--pressure".to_owned(), format!("{} kPa", 10f64.powf(decades))]);
    }
    arguments
}

/// Arguments of boundary elements on a surface of this many points, whose band stays the same.
fn elements(points: f64) -> Vec<String> {
    let mut arguments = vec!["bem".to_owned(), "builtin:contact-challenge".to_owned()];
    arguments.extend(BAND.map(str::to_owned));
    arguments.extend(["--realisations", "1", "--pressure", "1 MPa", "--grid"].map(str::to_owned));
    arguments.push(points.sqrt().round().to_string());
    arguments
}

/// Slope beyond the smallest run, which stands for all that does not grow.
fn exponent(runs: &[Run]) -> Option<f64> {
    let (least, others) = runs.split_first()?;
    let points: Vec<(f64, f64)> = others
        .iter()
        .filter(|run| run.processor_s > least.processor_s)
        .map(|run| ((run.size - least.size).ln(), (run.processor_s - least.processor_s).ln()))
        .collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|point| (point.0 - x).powi(2)).sum();
    let slope = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum::<f64>() / spread;
    (points.len() > 1).then_some(slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponent_is_that_of_the_cost_beyond_start_up() {
        let run = |size: f64, power: f64| Run {
            size,
            processor_s: 0.01 + 1e-6 * size.powf(power),
            peak_bytes: None,
        };
        for power in [1.0, 2.0] {
            let runs = [10.0, 1e3, 1e5, 1e7].map(|size| run(size, power));
            assert!((exponent(&runs).unwrap() - power).abs() < 0.01);
        }
        assert_eq!(exponent(&[run(10.0, 1.0), run(1e6, 1.0)]), None, "a point has no slope");
    }
}
