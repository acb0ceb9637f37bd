//! Comparison of mean gap and stiffness with boundary elements: presses missing spectra, and rewrites the table of
//! `docs/guide/gap.md`.

use std::error::Error;

use model_trials::elements;
use model_trials::gap_trials::{GapRow, LOADS, rows_of, trials, written};
use staging::write_file;

use crate::guide;

pub(crate) fn compare(anew: bool) -> Result<(), Box<dyn Error>> {
    let [csv, page] = ["gap/trials.csv", "gap.md"].map(guide);
    std::fs::create_dir_all(csv.with_file_name(""))?;
    let mut rows: Vec<GapRow> = Vec::new();
    if !anew && csv.exists() {
        rows = elements::read(&std::fs::read(&csv)?[..])?;
    }
    for trial in trials() {
        if !rows.iter().any(|row| row.number == trial.number) {
            println!("pressing spectrum {}: {:?}", trial.number, trial.kind);
            rows.extend(rows_of(&trial, &LOADS)?);
            let mut table = Vec::new();
            elements::write(&rows, &mut table)?;
            write_file(&csv, table)?;
        }
    }
    write_file(&page, written(&std::fs::read_to_string(&page)?, &rows)?.into_bytes())?;
    println!("{} rows in docs/guide/gap, and the table of docs/guide/gap.md", rows.len());
    Ok(())
}
