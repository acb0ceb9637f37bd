//! `cargo xtask coverage`: runs synthetic studies and prints the tables of `docs/guide/uncertainty.md`.

use std::process::ExitCode;
use std::time::Instant;

use coverage::{
    CELLS, INSTRUMENTS, Laboratory, Moves, Shape, StudyError, TAILS_HEADER, bias_table, biases,
    coverage_table, coverages, shrinkage_table, shrinkages, tails, tails_rows, trials,
};
use lexopt::prelude::*;
use topography::Average;
use uncertainty::Settings;

const HELP: &str = "\
cargo xtask coverage [--studies N] [--scans N] [--draws N] [--hurst H] [--seed S] [--only bias|coverage|advice|forms|seeds]
                     [--cell N]... [--first N]

N synthetic studies (400) of surfaces of each Hurst exponent (0.5, 0.8 and 0.95), with so many scans by each of two
instruments (5) and so many draws (1000): the bias of averages of scans decade by decade, how often intervals hold the
truth and how wide they are, and how they shrink when 1, 3 and 10 scans are added (a quarter of the studies).

--only forms draws the spectra at random, in nine cells, states the time it takes first, and judges coverage and both
tails. --only seeds runs the same studies with five seeds of the draws. --cell N runs one cell (again for more), --first N begins with that study, so that parts can run apart.
";

/// Factor on the number of lines where biases are measured: they cost little, and single lines scatter much.
const LINES: u32 = 20;

/// Seeds of the draws that are compared.
const SEEDS: u64 = 5;

const ADDED: [u32; 3] = [1, 3, 10];

const AVERAGES: [Average; 3] = [Average::Log, Average::LogUnbiased, Average::Arithmetic];

#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Bias,
    Coverage,
    Advice,
    Forms,
    Seeds,
}

struct Arguments {
    first: u32,
    cells: Vec<usize>,
    studies: u32,
    scans: u32,
    hurst_exponents: Vec<f64>,
    seed: u64,
    draws: usize,
    only: Option<Part>,
}

fn main() -> ExitCode {
    match parse() {
        Ok(Some(arguments)) => match run(&arguments) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::FAILURE
            }
        },
        Ok(None) => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprint!("error: {error}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn parse() -> Result<Option<Arguments>, lexopt::Error> {
    let mut arguments = Arguments {
        first: 0,
        cells: Vec::new(),
        studies: 400,
        scans: 5,
        hurst_exponents: Vec::new(),
        seed: 1,
        draws: 1000,
        only: None,
    };
    let mut parser = lexopt::Parser::from_env();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("studies") => arguments.studies = parser.value()?.parse()?,
            Long("first") => arguments.first = parser.value()?.parse()?,
            Long("cell") => arguments.cells.push(parser.value()?.parse()?),
            Long("scans") => arguments.scans = parser.value()?.parse()?,
            Long("draws") => arguments.draws = parser.value()?.parse()?,
            Long("hurst") => arguments.hurst_exponents.push(parser.value()?.parse()?),
            Long("seed") => arguments.seed = parser.value()?.parse()?,
            Long("only") => arguments.only = Some(parser.value()?.parse_with(part)?),
            Long("help") | Short('h') => return Ok(None),
            other => return Err(other.unexpected()),
        }
    }
    if arguments.hurst_exponents.is_empty() {
        arguments.hurst_exponents = vec![0.5, 0.8, 0.95];
    }
    Ok(Some(arguments))
}

fn part(name: &str) -> Result<Part, &'static str> {
    match name {
        "bias" => Ok(Part::Bias),
        "coverage" => Ok(Part::Coverage),
        "advice" => Ok(Part::Advice),
        "forms" => Ok(Part::Forms),
        "seeds" => Ok(Part::Seeds),
        _ => Err("there are bias, coverage, advice, forms and seeds"),
    }
}

fn run(arguments: &Arguments) -> Result<(), StudyError> {
    let Arguments { studies, scans, seed, draws, .. } = *arguments;
    let settings = Settings { draws, ..Settings::default() };
    if arguments.only == Some(Part::Forms) {
        return forms(arguments, &settings);
    }
    if arguments.only == Some(Part::Seeds) {
        return seeds(arguments, &settings);
    }
    let wanted = |part| arguments.only.is_none_or(|only| only == part);
    for &hurst_exponent in &arguments.hurst_exponents {
        let laboratory = Laboratory::new(hurst_exponent, seed)?;
        if wanted(Part::Bias) {
            let mut rows = Vec::new();
            for (place, instrument) in INSTRUMENTS.iter().enumerate() {
                let studies = studies.saturating_mul(if instrument.shape == Shape::Line { LINES } else { 1 });
                rows.extend(biases(&laboratory, studies, place, scans, &AVERAGES)?);
            }
            println!("{}", bias_table(hurst_exponent, &rows));
        }
        if wanted(Part::Coverage) {
            let trials = trials(&laboratory, studies, &[scans; 2], &settings)?;
            println!("{}", coverage_table(hurst_exponent, scans, &coverages(&trials)));
        }
        if wanted(Part::Advice) {
            let rows = shrinkages(&laboratory, studies.div_ceil(4), scans, &ADDED, &settings)?;
            println!("{}", shrinkage_table(hurst_exponent, &rows));
        }
    }
    Ok(())
}

/// Numbers of the cells that are asked for, from 1.
fn cells(arguments: &Arguments) -> Vec<usize> {
    let wanted = |number: &usize| arguments.cells.is_empty() || arguments.cells.contains(number);
    (1..=CELLS.len()).filter(wanted).collect()
}

/// Compares intervals of the same studies with other seeds of the draws.
fn seeds(arguments: &Arguments, settings: &Settings) -> Result<(), StudyError> {
    println!(
        "| cell | spectra | scans | ends | beyond a twentieth | 95 % within | largest |\n| ---: | --- | --- | ---: | ---: | ---: | ---: |"
    );
    let row = |number: &str, form: &str, scans: &str, moves: &Moves| {
        println!(
            "| {number} | {form} | {scans} | {} | {:.1} % | {:.3} | {:.3} |",
            moves.count(),
            100.0 * moves.share_beyond(),
            moves.quantile(0.95),
            moves.quantile(1.0)
        );
    };
    let mut all = Vec::new();
    for number in cells(arguments) {
        let cell = &CELLS[number - 1];
        let moves = Moves::of_cell(cell, arguments.studies, SEEDS, arguments.seed, settings)?;
        row(&number.to_string(), cell.form.name(), &cell.scans_in_words(), &moves);
        all.push(moves);
    }
    row("all", "", "", &Moves::joined(&all));
    Ok(())
}

/// Runs the cells one after the other and prints each as soon as it is there.
fn forms(arguments: &Arguments, settings: &Settings) -> Result<(), StudyError> {
    let Arguments { studies, first, seed, .. } = *arguments;
    let cells = cells(arguments);
    let start = Instant::now();
    let trial_run =
        cells.iter().try_for_each(|&number| CELLS[number - 1].trials(first, 2, seed, settings).map(|_| ()));
    trial_run?;
    let seconds = start.elapsed().as_secs_f64() / 2.0 * f64::from(studies);
    eprintln!("{} cells of {studies} studies take about {seconds:.0} s", cells.len());
    println!("{TAILS_HEADER}");
    for number in cells {
        let cell = &CELLS[number - 1];
        print!("{}", tails_rows(number, cell, &tails(&cell.trials(first, studies, seed, settings)?)));
    }
    Ok(())
}
