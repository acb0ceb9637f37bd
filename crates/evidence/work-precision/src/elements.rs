//! Boundary elements beside Tamaas and `ContactMechanics`: the rows of `competitors/boundary_elements.py`.

use serde::Deserialize;
use tables::markdown::table;

use crate::bench::{Bench, Contents};
use crate::files;
use crate::page::{error, mebibytes, met, three_digits, time};
use crate::processes::program;

/// Factors by which ours must be cheaper than Tamaas, by p/(E* h').
const BARS: [(f64, f64); 4] = [(0.01, 15.0), (0.03, 20.0), (0.1, 30.0), (0.5, 60.0)];
/// Competitor that the bars are about.
const BARRED: &str = "tamaas";
const OURS: &str = "truearea";

/// Answer of an engine at a load; its numbers are missing where the engine is.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Row {
    pressure_over_gradient: f64,
    engine: String,
    seconds: Option<f64>,
    ratio: Option<f64>,
    residual: Option<f64>,
    peak_bytes: Option<u64>,
}

/// Presses the map with every engine.
///
/// # Errors
/// A message if our program is not built, or if the script fails.
pub fn measure(bench: &mut Bench) -> Result<Contents, String> {
    let program = program("boundary_elements", "truearea-work-precision")?;
    let printed = bench.environment.output("boundary_elements.py", [program])?;
    let rows: Vec<Row> = files::parse(&printed)?;
    Ok(Contents {
        sections: vec![("elements", costs(&rows))],
        files: vec![("elements.csv", files::comments(&bench.facts) + &printed)],
    })
}

/// Table of time, residual and memory by load and engine.
fn costs(rows: &[Row]) -> String {
    let columns = ["p/(E\\* h′)", "engine", "time", "over ours", "bar", "met", "residual", "memory"];
    let cells = |row: &Row| {
        let bar = BARS.iter().find(|(load, _)| *load == row.pressure_over_gradient && row.engine == BARRED);
        let ratio = row.ratio.filter(|_| row.engine != OURS);
        vec![
            row.pressure_over_gradient.to_string(),
            row.engine.clone(),
            row.seconds.map_or_else(|| "missing".to_owned(), time),
            ratio.map(three_digits).unwrap_or_default(),
            bar.map(|(_, bar)| bar.to_string()).unwrap_or_default(),
            bar.zip(ratio).map(|((_, bar), ratio)| met(ratio >= *bar)).unwrap_or_default(),
            row.residual.map(error).unwrap_or_default(),
            row.peak_bytes.map(mebibytes).unwrap_or_default(),
        ]
    };
    table(&columns, &rows.iter().map(cells).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_about_tamaas_and_a_missing_engine_is_named() {
        let printed = "pressure_over_gradient,engine,seconds,ratio,residual,peak_bytes\n\
            0.03,truearea,0.1,1.00,1e-8,1048576\n\
            0.03,tamaas,1.9,19.00,9e-9,\n\
            0.03,contactmechanics,,,,\n";
        let text = costs(&files::parse(printed).unwrap());
        let rows: Vec<&str> = text.lines().skip(2).collect();
        assert_eq!(
            rows,
            [
                "| 0.03 | truearea | 100 ms |  |  |  | 1.0e-8 | 1.00 MiB |",
                "| 0.03 | tamaas | 1.90 s | 19.0 | 20 | **no** | 9.0e-9 |  |",
                "| 0.03 | contactmechanics | missing |  |  |  |  |  |",
            ]
        );
    }
}
