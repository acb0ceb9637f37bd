//! Presses what is not known yet and writes the page anew: `cargo xtask judge`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use model_trials::elements;
use model_trials::programme::programme;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let path = repository("docs/which-model/elements.csv");
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let mut table = match std::fs::read(&path) {
        Ok(bytes) => elements::read(&bytes[..]).map_err(|e| text(&e))?,
        Err(_) => Vec::new(),
    };
    for trial in programme() {
        if elements::known(&table, &trial).is_some() { continue; }
        let start = std::time::Instant::now();
        table.retain(|row| row.band() != trial.band);
        table.extend(elements::rows_of(&trial).map_err(|e| text(&e))?);
        let mut out = Vec::new();
        elements::write(&table, &mut out).map_err(|e| text(&e))?;
        std::fs::create_dir_all(path.parent().unwrap_or(Path::new("."))).map_err(|e| text(&e))?;
        std::fs::write(&path, out).map_err(|e| text(&e))?;
        println!("{:?} {:.1} s", trial.band, start.elapsed().as_secs_f64());
    }
    Ok(())
}

fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}
