//! Calls of the Python package beside numpy and scipy code of the same length: the rows of `competitors/python_calls.py`.

use std::path::PathBuf;

use serde::Deserialize;
use tables::markdown::table;

use crate::bench::{Bench, Contents};
use crate::files;
use crate::page::{error, three_digits, time};
use crate::reference::repository;

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
pub fn measure(bench: &mut Bench) -> Result<Contents, String> {
    bench.environment.install_wheel(&wheel()?)?;
    let printed = bench.environment.output("python_calls.py", [""; 0])?;
    Ok(Contents {
        sections: vec![("python", costs(&files::parse(&printed)?))],
        files: vec![("python.csv", files::comments(&bench.facts) + &printed)],
    })
}

fn wheel() -> Result<PathBuf, String> {
    let files = std::fs::read_dir(repository(WHEELS)).into_iter().flatten().flatten();
    let mut wheels =
        files.map(|file| file.path()).filter(|path| path.extension().is_some_and(|it| it == "whl"));
    wheels.next().ok_or_else(|| "no wheel of the Python package; build one: cargo xtask python".to_owned())
}

/// Table of time, length and difference by task.
fn costs(rows: &[Row]) -> String {
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
    table(&columns, &rows.iter().map(cells).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_the_ratio_of_times() {
        let printed = "task,lines,their_lines,seconds,their_seconds,differ\n100 loads,5,7,1e-5,2e-2,1e-12\n";
        let row = "| 100 loads | 10.0 µs | 5 | 20.0 ms | 7 | 2000 | 1.0e-12 |";
        assert_eq!(costs(&files::parse(printed).unwrap()).lines().last(), Some(row));
    }
}
