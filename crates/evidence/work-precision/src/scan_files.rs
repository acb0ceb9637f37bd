//! Opening instrument files and their spectra beside `SurfaceTopography`: the rows of `competitors/scans.py`.

use std::path::PathBuf;

use serde::Deserialize;
use tables::markdown::table;

use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::machine::own_program;
use crate::reference::repository;
use crate::words::{error, three_digits, time};

/// Variable that names the folder of the files.
const FOLDER: &str = "WORK_PRECISION_SCANS";
/// Folder without the variable: samples beside the checkout. They are other people's, hence not committed.
const BESIDE: &str = "../shared/data/instruments";

/// File of one format; times in seconds of the processor.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Row {
    format: String,
    points_x: usize,
    points_y: usize,
    /// Our whole process.
    seconds: f64,
    /// Their whole process.
    their_seconds: f64,
    /// Their calls alone.
    their_call_seconds: f64,
    /// Largest difference of heights over their range.
    heights_differ: f64,
    /// Largest relative difference of a value of the spectrum.
    spectra_differ: f64,
}

/// Reads every file with both programs.
///
/// # Errors
/// A message if the files are missing or the script fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    let folder = std::env::var_os(FOLDER).map_or_else(|| repository(BESIDE), PathBuf::from);
    if !folder.is_dir() {
        return Err(format!("the folder of scans is missing; name one with the variable {FOLDER}"));
    }
    environment.output("scans.py", [own_program()?, folder])
}

/// Table of time and difference by format.
///
/// # Errors
/// A message if the rows cannot be parsed.
pub fn table_of(csv: &str) -> Result<String, String> {
    let rows: Vec<Row> = parse(csv)?;
    let columns = [
        "format",
        "points",
        "truearea",
        "SurfaceTopography",
        "ratio",
        "its calls alone",
        "ratio",
        "heights differ by",
        "spectra by",
    ];
    let cells = |row: &Row| {
        vec![
            row.format.clone(),
            format!("{} × {}", row.points_x, row.points_y),
            time(row.seconds),
            time(row.their_seconds),
            three_digits(row.their_seconds / row.seconds),
            time(row.their_call_seconds),
            three_digits(row.their_call_seconds / row.seconds),
            error(row.heights_differ),
            error(row.spectra_differ),
        ]
    };
    Ok(table(&columns, &rows.iter().map(cells).collect::<Vec<_>>()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_both_ratios() {
        let printed = "format,points_x,points_y,seconds,their_seconds,their_call_seconds,heights_differ,spectra_differ\n\
            MetroPro,640,480,1e-2,1,5e-2,1e-16,2e-12\n";
        let text = table_of(printed).unwrap();
        let row = "| MetroPro | 640 × 480 | 10.0 ms | 1.00 s | 100 | 50.0 ms | 5.00 | 1.0e-16 | 2.0e-12 |";
        assert_eq!(text.lines().last(), Some(row));
    }
}
