//! Comparison of the judge of scenes with whole bands that are solved at once: presses missing truths, and rewrites the
//! tables of `docs/guide/judge.md`.

use std::error::Error;

use model_trials::elements;
use model_trials::judge_spectra::{Set, trials};
use model_trials::judge_trials::{JudgedRow, written};
use model_trials::judge_truth::TruthRow;
use tables::staging::write_file;

use crate::guide;

pub(crate) fn compare(anew: bool) -> Result<(), Box<dyn Error>> {
    let [truth_csv, trials_csv, page] = ["judge/truth.csv", "judge/trials.csv", "judge.md"].map(guide);
    std::fs::create_dir_all(truth_csv.with_file_name(""))?;
    let mut truth: Vec<TruthRow> = Vec::new();
    if !anew && truth_csv.exists() {
        truth = elements::read(&std::fs::read(&truth_csv)?[..])?;
    }
    let mut judged: Vec<JudgedRow> = Vec::new();
    for trial in [Set::Calibration, Set::Report].into_iter().flat_map(trials) {
        if !truth.iter().any(|row| row.number == trial.number) {
            println!("pressing spectrum {}: {:?}", trial.number, trial.kind);
            truth.extend(trial.truth()?);
            let mut table = Vec::new();
            elements::write(&truth, &mut table)?;
            write_file(&truth_csv, table)?;
        }
        judged.extend(trial.judged(&truth)?);
    }
    let mut table = Vec::new();
    elements::write(&judged, &mut table)?;
    write_file(&trials_csv, table)?;
    write_file(&page, written(&std::fs::read_to_string(&page)?, &judged)?.into_bytes())?;
    println!("{} rows in docs/guide/judge, and the tables of docs/guide/judge.md", judged.len());
    Ok(())
}
