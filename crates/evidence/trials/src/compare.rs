//! Comparisons with boundary elements: each presses what its table lacks, and rewrites the table and sections of its page.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;
use tables::staging::write_file;
use trials::TrialError;
use trials::elements::{self, ElementsRow};
use trials::flatness_trials::{self, FlatnessRow};
use trials::flattening_trials;
use trials::flow_trials::{self, FlowRow};
use trials::gap_trials::{self, GapRow};
use trials::judge_spectra::Set;
use trials::judge_trials::JudgedRow;
use trials::judge_truth::TruthRow;
use trials::layer_trials;
use trials::programme::{SpectrumTrial, programme};
use trials::scene_trials::{self, SceneRow};
use trials::yielding_trials::{self, YieldingRow};
use trials::{judge_spectra, judge_trials, pressing, ratios, sections};

use crate::Outcome;

/// Compares every model with boundary elements: `docs/guide/which-model.md`.
pub(crate) fn models(anew: bool) -> Outcome {
    let rows = pressed(&programme(), "docs/develop/trials/elements.csv", anew)?;
    let ratios = ratios::rows(&rows)?;
    store(&ratios, &checkout("docs/develop/trials/ratios.csv"))?;
    rewrite("docs/guide/which-model.md", |page| sections::written(page, &rows, &ratios))
}

/// Compares spheres that flatten with elements that flow: `docs/develop/trials.md`.
pub(crate) fn flattening(anew: bool) -> Outcome {
    let trials = [Set::Calibration, Set::Report].map(flattening_trials::trials).concat();
    let rows = pressed(&trials, "docs/develop/trials/flattening.csv", anew)?;
    rewrite("docs/develop/trials.md", |page| flattening_trials::written(page, &rows))
}

/// Returns the rows of trials, of which it presses those that a table lacks.
fn pressed(trials: &[SpectrumTrial], csv: &str, anew: bool) -> Result<Vec<ElementsRow>, Box<dyn Error>> {
    let csv = checkout(csv);
    let old: Vec<ElementsRow> = stored(&csv, anew)?;
    let mut rows: Vec<ElementsRow> = Vec::new();
    for (at, trial) in trials.iter().enumerate() {
        if let Some(known) = elements::known(&old, trial) {
            rows.extend(known);
            continue;
        }
        println!("pressing spectrum {} of {}: {:?}", at + 1, trials.len(), trial.band);
        rows.extend(pressing::rows_of(trial)?);
        let rest = trials[at + 1..].iter().filter_map(|trial| elements::known(&old, trial)).flatten();
        store(&rows.iter().chain(rest).copied().collect::<Vec<_>>(), &csv)?;
    }
    store(&rows, &csv)?;
    Ok(rows)
}

/// Compares mean gap and stiffness of Persson's theory with boundary elements: `docs/develop/trials.md`.
pub(crate) fn gaps(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/gap.csv");
    let pressed: Vec<GapRow> = stored(&csv, anew)?;
    let trials = gap_trials::trials();
    let mut rows: Vec<GapRow> = Vec::new();
    for trial in &trials {
        let of_trial = pressed.iter().filter(|row| row.number == trial.number).copied();
        rows.extend(gap_trials::completed(trial, of_trial.collect())?);
        let rest = pressed.iter().filter(|row| rows.iter().all(|done| done.number != row.number));
        store(&rows.iter().chain(rest).copied().collect::<Vec<_>>(), &csv)?;
    }
    store(&rows, &csv)?;
    rewrite("docs/develop/trials.md", |page| gap_trials::written(page, &rows))
}

/// Compares both limits of flatness with boundary elements: `docs/develop/trials.md`.
pub(crate) fn flatness(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/flatness.csv");
    let known: Vec<FlatnessRow> = stored(&csv, anew)?;
    let mut rows: Vec<FlatnessRow> = Vec::new();
    for trial in [Set::Calibration, Set::Report].map(flatness_trials::trials).concat() {
        let of_trial: Vec<FlatnessRow> = known.iter().filter(|row| row.is_of(&trial)).copied().collect();
        rows.extend(if of_trial.is_empty() { trial.rows()? } else { trial.beside(&of_trial)? });
        store(&rows, &csv)?;
    }
    rewrite("docs/develop/trials.md", |page| flatness_trials::written(page, &rows))
}

/// Compares leaks by the effective medium with flow through gaps of boundary elements: `docs/develop/trials.md`.
pub(crate) fn flow(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/flow.csv");
    let known: Vec<FlowRow> = stored(&csv, anew)?;
    let mut rows: Vec<FlowRow> = Vec::new();
    for trial in [Set::Calibration, Set::Report].map(flow_trials::trials).concat() {
        let of_trial: Vec<FlowRow> = known.iter().filter(|row| row.trial() == trial).copied().collect();
        rows.extend(if of_trial.is_empty() { trial.rows()? } else { trial.beside(&of_trial)? });
        let is_done = |row: &FlowRow| rows.iter().any(|done| done.trial() == row.trial());
        let rest = known.iter().filter(|row| !is_done(row));
        store(&rows.iter().chain(rest).copied().collect::<Vec<_>>(), &csv)?;
    }
    rewrite("docs/develop/trials.md", |page| flow_trials::written(page, &rows))
}

/// Compares closed forms of gap and stiffness after yielding with boundary elements: `docs/develop/trials.md`.
pub(crate) fn yielding(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/yielding.csv");
    let known: Vec<YieldingRow> = stored(&csv, anew)?;
    let mut rows: Vec<YieldingRow> = Vec::new();
    for trial in [Set::Calibration, Set::Report].map(yielding_trials::trials).concat() {
        let of_trial: Vec<YieldingRow> =
            known.iter().filter(|row| row.spectrum() == trial.spectrum()).copied().collect();
        rows.extend(if of_trial.is_empty() { trial.rows()? } else { trial.beside(&of_trial)? });
        let is_left = |row: &&YieldingRow| !rows.iter().any(|done| done.spectrum() == row.spectrum());
        let rest = known.iter().filter(is_left);
        store(&rows.iter().chain(rest).copied().collect::<Vec<_>>(), &csv)?;
    }
    rewrite("docs/develop/trials.md", |page| yielding_trials::written(page, &rows))
}

/// Compares the judge of scenes with whole bands solved at once: `docs/develop/trials.md`.
pub(crate) fn judge(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/judge-truth.csv");
    let mut truth: Vec<TruthRow> = stored(&csv, anew)?;
    let mut judged = Vec::new();
    for trial in [Set::Calibration, Set::Report].into_iter().flat_map(judge_spectra::trials) {
        if !truth.iter().any(|row| row.number == trial.number) {
            println!("pressing spectrum {}: {:?}", trial.number, trial.kind);
            truth.extend(trial.truth()?);
            store(&truth, &csv)?;
        }
        judged.extend(trial.judged(&truth)?);
    }
    store(&judged, &checkout("docs/develop/trials/judge.csv"))?;
    rewrite("docs/develop/trials.md", |page| judge_trials::written(page, &judged))
}

/// Compares the judge on layers with whole bands solved at once: `docs/develop/trials.md`.
pub(crate) fn layers(anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/layers.csv");
    let mut truth: Vec<JudgedRow> = stored(&csv, anew)?;
    let mut rows: Vec<JudgedRow> = Vec::new();
    let (known, missing): (Vec<_>, Vec<_>) =
        layer_trials::trials().into_iter().partition(|trial| truth.iter().any(|row| trial.is_of(row)));
    for trial in &known {
        rows.extend(trial.judged(&truth)?);
    }
    for trial in &missing {
        println!("pressing spectrum {} on {:?}", trial.spectrum.number, trial.layer);
        truth.extend(trial.truth()?);
        rows.extend(trial.judged(&truth)?);
        store(&rows, &csv)?;
    }
    store(&rows, &csv)?;
    rewrite("docs/develop/trials.md", |page| layer_trials::written(page, &rows))
}

/// Compares reports on the files of a folder by a program with whole bands solved at once: `docs/develop/trials.md`.
pub(crate) fn scenes(folder: &Path, program: &Path, anew: bool) -> Outcome {
    let csv = checkout("docs/develop/trials/scenes.csv");
    let old: Vec<SceneRow> = stored(&csv, anew)?;
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        files.insert(name, std::fs::read(&path)?);
    }
    let mut rows: Vec<SceneRow> = Vec::new();
    for scene in scene_trials::scenes() {
        let known = old.iter().find(|row| row.scene == scene.scene).cloned();
        let row = known.map_or_else(|| scene.with_truth(&files), Ok)?;
        rows.push(row.with_answer(program, folder)?);
        println!("{:?}", rows.last());
        let rest = old.iter().filter(|row| rows.iter().all(|done| done.scene != row.scene));
        store(&rows.iter().chain(rest).cloned().collect::<Vec<_>>(), &csv)?;
    }
    rewrite("docs/develop/trials.md", |page| scene_trials::written(page, &rows))
}

/// Reads a table; empty if it is missing or to be made anew.
fn stored<R: DeserializeOwned>(csv: &Path, anew: bool) -> Result<Vec<R>, Box<dyn Error>> {
    if anew || !csv.exists() { Ok(Vec::new()) } else { Ok(elements::read(&std::fs::read(csv)?[..])?) }
}

fn store<R: Serialize>(rows: &[R], csv: &Path) -> Outcome {
    let mut table = Vec::new();
    elements::write(rows, &mut table)?;
    Ok(write_file(csv, table)?)
}

/// Rewrites the tables of a page.
fn rewrite(page: &str, tables: impl FnOnce(&str) -> Result<String, TrialError>) -> Outcome {
    let path = checkout(page);
    write_file(&path, tables(&std::fs::read_to_string(&path)?)?.into_bytes())?;
    println!("rewrote the tables of {page}");
    Ok(())
}

/// Path of a file of this repository.
fn checkout(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(path)
}
