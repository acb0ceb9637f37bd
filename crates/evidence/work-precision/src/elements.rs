//! Boundary elements beside Tamaas and `ContactMechanics`: the rows of `competitors/boundary_elements.py`.

use serde::Deserialize;
use tables::markdown::table;

use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::machine::own_program;
use crate::words::{mebibytes, time};

/// Answer of a program at a load; its numbers are missing where the program is.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Row {
    pressure_over_gradient: f64,
    engine: String,
    seconds: Option<f64>,
    peak_bytes: Option<u64>,
}

/// Presses the map with every engine.
///
/// # Errors
/// A message if the script fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    environment.output("boundary_elements.py", [own_program()?])
}

/// Table of time and memory, with a line for each load and a column for each program.
///
/// # Errors
/// A message if the rows cannot be parsed.
pub fn table_of(csv: &str) -> Result<String, String> {
    let rows: Vec<Row> = parse(csv)?;
    let lines: Vec<&[Row]> =
        rows.chunk_by(|one, next| one.pressure_over_gradient == next.pressure_over_gradient).collect();
    let cell = |row: &Row| match (row.seconds, row.peak_bytes) {
        (Some(seconds), Some(bytes)) => format!("{}, {}", time(seconds), mebibytes(bytes)),
        (Some(seconds), None) => time(seconds),
        _ => "missing".to_owned(),
    };
    let cells = |line: &&[Row]| {
        let load = line[0].pressure_over_gradient.to_string();
        std::iter::once(load).chain(line.iter().map(cell)).collect::<Vec<String>>()
    };
    let programs = lines.first().into_iter().flat_map(|line| line.iter()).map(|row| row.engine.as_str());
    let headings: Vec<&str> = std::iter::once("p/(E\\* h′)").chain(programs).collect();
    Ok(table(&headings, &lines.iter().map(cells).collect::<Vec<_>>()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_program_is_named() {
        let printed = "pressure_over_gradient,engine,seconds,peak_bytes\n\
            0.03,truearea,0.1,1048576\n\
            0.03,tamaas,1.9,\n\
            0.03,contactmechanics,,\n";
        let row = "| 0.03 | 100 ms, 1.00 MiB | 1.90 s | missing |";
        assert_eq!(table_of(printed).unwrap().lines().last(), Some(row));
    }
}
