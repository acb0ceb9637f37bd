//! Comparison of models with boundary elements: presses missing surfaces, and rewrites the tables and figures of
//! `docs/guide/which-model.md`.

use std::error::Error;
use std::path::PathBuf;

use model_trials::elements::{self, ElementsRow};
use model_trials::gluing::{self, GluingRow};
use model_trials::pictures::pictures;
use model_trials::programme::programme;
use model_trials::sections::{self, Findings};
use model_trials::{ratios, windows};
use serde::Serialize;
use tables::staging::{StagedFiles, write_file};

use crate::guide;

pub(crate) fn compare(anew: bool) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(beside("elements").with_file_name(""))?;
    let elements = pressed(anew)?;
    let gluing = glued(anew, &elements)?;
    let (ratios, windows) = (ratios::rows(&elements)?, windows::rows(&elements)?);
    let page = guide("which-model.md");
    let findings = Findings { elements: &elements, ratios: &ratios, windows: &windows, gluing: &gluing };
    let text = sections::written(&std::fs::read_to_string(&page)?, &findings)?;
    let mut files = StagedFiles::default();
    let mut stage = |path: PathBuf, content: Vec<u8>| files.stage(&path, |out| out.write_all(&content));
    stage(beside("ratios"), table(&ratios)?)?;
    stage(beside("windows"), table(&windows)?)?;
    for (name, svg) in pictures(&ratios) {
        stage(guide(&format!("which-model/{name}.svg")), svg.into_bytes())?;
    }
    stage(page, text.into_bytes())?;
    files.publish()?;
    println!(
        "{} ratios in docs/guide/which-model, and the tables and figures of docs/guide/which-model.md",
        ratios.len()
    );
    Ok(())
}

/// Areas of boundary elements: those of the table that are still in the programme, the others pressed now and kept.
fn pressed(anew: bool) -> Result<Vec<ElementsRow>, Box<dyn Error>> {
    let path = beside("elements");
    let old = if anew || !path.exists() { Vec::new() } else { elements::read(&std::fs::read(&path)?[..])? };
    let mut table_of_all: Vec<ElementsRow> = Vec::new();
    let trials = programme();
    for (at, trial) in trials.iter().enumerate() {
        if let Some(rows) = elements::known(&old, trial) {
            table_of_all.extend(rows);
            continue;
        }
        println!("pressing spectrum {} of {}: {:?}", at + 1, trials.len(), trial.band);
        table_of_all.extend(elements::rows_of(trial)?);
        let rest = trials[at + 1..].iter().filter_map(|trial| elements::known(&old, trial)).flatten();
        let kept: Vec<ElementsRow> = table_of_all.iter().chain(rest).copied().collect();
        write_file(&path, table(&kept)?)?;
    }
    write_file(&path, table(&table_of_all)?)?;
    Ok(table_of_all)
}

fn glued(anew: bool, elements: &[ElementsRow]) -> Result<Vec<GluingRow>, Box<dyn Error>> {
    let path = beside("gluing");
    if !anew && path.exists() {
        return Ok(elements::read(&std::fs::read(&path)?[..])?);
    }
    println!("gluing two decades");
    let rows = gluing::rows(elements)?;
    write_file(&path, table(&rows)?)?;
    Ok(rows)
}

fn table<R: Serialize>(rows: &[R]) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut bytes = Vec::new();
    elements::write(rows, &mut bytes)?;
    Ok(bytes)
}

fn beside(name: &str) -> PathBuf {
    guide(&format!("which-model/{name}.csv"))
}
