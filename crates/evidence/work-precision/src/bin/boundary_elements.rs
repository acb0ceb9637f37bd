//! Presses a square map for `competitors/boundary_elements.py`, which measures it from outside.
//!
//! `boundary_elements HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES`: heights in m as 64-bit numbers, row by row over a
//! square of side 1 m and modulus 1 Pa; they are pressed TIMES times, and the pressures are written in the same
//! format.

use std::process::ExitCode;

use half_space::{Elements, Grid, Loading};
use parallel::Unobserved;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [heights, pressures, pressure, tolerance, times] = arguments else {
        return Err("HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES".into());
    };
    let bytes = std::fs::read(heights)?;
    let heights_m: Vec<f64> = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let side = heights_m.len().isqrt();
    let grid = Grid::new(side, side, 1.0, 1.0)?;
    let loading = Loading {
        contact_modulus_pa: 1.0,
        nominal_pressure_pa: pressure.parse()?,
        saturation_pa: None,
        tolerance: tolerance.parse()?,
    };
    for _ in 0..times.parse::<usize>()? {
        // Laid out anew each time, as for a user with one map and one load.
        let contact = Elements::periodic(grid, &heights_m)?.press(&loading, &Unobserved)?;
        let bytes: Vec<u8> =
            contact.pressures_pa.iter().flat_map(|pressure| pressure.to_le_bytes()).collect();
        std::fs::write(pressures, bytes)?;
        println!("{} {}", contact.iterations, contact.operators);
    }
    Ok(())
}
