//! Comparison of mean gap and stiffness with boundary elements: presses missing spectra, puts the theory of
//! today beside all, and rewrites the table of
//! `docs/guide/gap.md`.

use std::error::Error;
use std::path::Path;

use model_trials::elements;
use model_trials::gap_trials::{GapElements, GapRow, LOADS, beside_theory, rows_of, trials, written};
use model_trials::judge_spectra::JudgeTrial;
use tables::staging::write_file;

use crate::guide;

pub(crate) fn compare(anew: bool) -> Result<(), Box<dyn Error>> {
    let [csv, page] = ["gap/trials.csv", "gap.md"].map(guide);
    std::fs::create_dir_all(csv.with_file_name(""))?;
    let mut pressed: Vec<GapElements> = Vec::new();
    if !anew && csv.exists() {
        pressed = elements::read(&std::fs::read(&csv)?[..])?;
    }
    let trials = trials();
    let mut rows: Vec<GapRow> = Vec::new();
    let mut missing: Vec<&JudgeTrial> = Vec::new();
    for trial in &trials {
        let of_trial = pressed.iter().filter(|row| row.number == trial.number).copied();
        let of_trial: Vec<GapElements> = of_trial.collect();
        rows.extend(beside_theory(trial, &of_trial)?);
        missing.extend(of_trial.is_empty().then_some(trial));
    }
    for trial in missing {
        println!("pressing spectrum {}: {:?}", trial.number, trial.kind);
        rows.extend(rows_of(trial, &LOADS)?);
        store(&rows, &csv)?;
    }
    let place = |row: &GapRow| trials.iter().position(|trial| trial.number == row.number);
    rows.sort_by_key(place);
    store(&rows, &csv)?;
    write_file(&page, written(&std::fs::read_to_string(&page)?, &rows)?.into_bytes())?;
    println!("{} rows in docs/guide/gap, and the table of docs/guide/gap.md", rows.len());
    Ok(())
}

fn store(rows: &[GapRow], csv: &Path) -> Result<(), Box<dyn Error>> {
    let mut table = Vec::new();
    elements::write(rows, &mut table)?;
    Ok(write_file(csv, table)?)
}
