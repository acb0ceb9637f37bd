//! Square maps that a script and a program of ours exchange: 64-bit numbers, row by row over a square of side 1 m.

use std::error::Error;
use std::process::ExitCode;

use elements::half_space::Grid;

/// Runs a program on its arguments, and says on standard error why it failed.
pub fn carry_out(run: impl FnOnce(&[String]) -> Result<(), Box<dyn Error>>) -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Reads a map, with its grid.
///
/// # Errors
/// Those of reading the file, and of a grid that cannot be.
pub fn read(path: &str) -> Result<(Grid, Vec<f64>), Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    let values: Vec<f64> = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let side = values.len().isqrt();
    Ok((Grid::new(side, side, 1.0, 1.0)?, values))
}

/// Writes a map.
///
/// # Errors
/// Those of writing the file.
pub fn write(path: &str, values: &[f64]) -> std::io::Result<()> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    std::fs::write(path, bytes)
}
