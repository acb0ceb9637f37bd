//! Calls of the Python package beside numpy and scipy code of the same length: the rows of `competitors/python_calls.py`.

use std::path::PathBuf;

use serde::Deserialize;
use tables::markdown::table;

use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::reference::repository;
use crate::words::{error, three_digits, time};

/// Folder of the wheel that `cargo xtask python` builds.
const WHEELS: &str = "target/python/wheels";

/// Task that both carry out; times in seconds of the processor.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Row {
    task: String,
    lines: usize,
    their_lines: usize,
    seconds: f64,
    their_seconds: f64,
    /// Largest relative difference of the results.
    differ: f64,
}

/// Installs the wheel beside the competitors, and carries out every task with both.
///
/// # Errors
/// A message if there is no wheel, or if the script fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    environment.install_wheel(&wheel()?)?;
    environment.output("python_calls.py", [""; 0])
}

fn wheel() -> Result<PathBuf, String> {
    let files = std::fs::read_dir(repository(WHEELS)).into_iter().flatten().flatten();
    let mut wheels =
        files.map(|file| file.path()).filter(|path| path.extension().is_some_and(|it| it == "whl"));
    wheels.next().ok_or_else(|| {
        "the wheel of the Python package is missing; build it with cargo xtask python".to_owned()
    })
}

/// Table of time, length and difference by task.
///
/// # Errors
/// A message if the rows cannot be parsed.
pub fn table_of(csv: &str) -> Result<String, String> {
    let rows: Vec<Row> = parse(csv)?;
    let columns = ["task", "truearea", "lines", "numpy and scipy", "lines", "ratio", "differ by"];
    let cells = |row: &Row| {
        vec![
            row.task.clone(),
            time(row.seconds),
            row.lines.to_string(),
            time(row.their_seconds),
            row.their_lines.to_string(),
            three_digits(row.their_seconds / row.seconds),
            error(row.differ),
        ]
    };
    Ok(table(&columns, &rows.iter().map(cells).collect::<Vec<_>>()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_the_ratio_of_times() {
        let printed = "task,lines,their_lines,seconds,their_seconds,differ\n100 loads,5,7,1e-5,2e-2,1e-12\n";
        let row = "| 100 loads | 10.0 µs | 5 | 20.0 ms | 7 | 2000 | 1.0e-12 |";
        assert_eq!(table_of(printed).unwrap().lines().last(), Some(row));
    }
}
