//! Comparison of the judge on layers with whole bands that are solved at once: presses missing truths, and rewrites the table of
//! `docs/guide/judge.md`.

use std::error::Error;
use std::path::Path;

use model_trials::elements;
use model_trials::layer_trials::{LayerRow, LayerTruth, trials, written};
use tables::staging::write_file;

use crate::guide;

pub(crate) fn compare(anew: bool) -> Result<(), Box<dyn Error>> {
    let [csv, page] = ["judge/layers.csv", "judge.md"].map(guide);
    let mut truth: Vec<LayerTruth> = Vec::new();
    if !anew && csv.exists() {
        truth = elements::read(&std::fs::read(&csv)?[..])?;
    }
    let mut rows: Vec<LayerRow> = Vec::new();
    let (known, missing): (Vec<_>, Vec<_>) =
        trials().into_iter().partition(|trial| truth.iter().any(|row| trial.is_of(row)));
    for trial in &known {
        rows.extend(trial.judged(&truth)?);
    }
    store(&rows, &csv)?;
    for trial in &missing {
        println!("pressing spectrum {} on {:?}", trial.spectrum.number, trial.layer);
        truth.extend(trial.truth()?);
        rows.extend(trial.judged(&truth)?);
        store(&rows, &csv)?;
    }
    write_file(&page, written(&std::fs::read_to_string(&page)?, &rows)?.into_bytes())?;
    println!("{} rows in docs/guide/judge/layers.csv, and a table of docs/guide/judge.md", rows.len());
    Ok(())
}

fn store(rows: &[LayerRow], csv: &Path) -> Result<(), Box<dyn Error>> {
    let mut table = Vec::new();
    elements::write(rows, &mut table)?;
    Ok(write_file(csv, table)?)
}
