//! Solves the adhesive contact of a square map for `competitors/adhesion.py`, which measures it from outside.
//!
//! `adhesive_elements HEIGHTS GAPS WORK RANGE CONTROL VALUE TOLERANCE TIMES`: heights in m as 64-bit numbers, row by row
//! over a square of side 1 m and modulus 1 Pa; work of adhesion in J/m^2 and its range in m; CONTROL is `gap` or
//! `pressure`, and VALUE the mean gap in m or the nominal pressure in Pa. The contact is solved TIMES times from the
//! surface that just touches, and the gaps are written in the format of the heights.

use std::process::ExitCode;

use half_space::{Adhesion, AdhesiveElements, Control, Grid, Start};
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
    let [heights, gaps, work, range, control, value, tolerance, times] = arguments else {
        return Err("HEIGHTS GAPS WORK RANGE CONTROL VALUE TOLERANCE TIMES".into());
    };
    let bytes = std::fs::read(heights)?;
    let heights_m: Vec<f64> = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let side = heights_m.len().isqrt();
    let grid = Grid::new(side, side, 1.0, 1.0)?;
    let adhesion = Adhesion { work_j_per_m2: work.parse()?, range_m: range.parse()? };
    let control = match control.as_str() {
        "gap" => Control::MeanGapM(value.parse()?),
        "pressure" => Control::PressurePa(value.parse()?),
        other => return Err(format!("'{other}' is neither gap nor pressure").into()),
    };
    for _ in 0..times.parse::<usize>()? {
        // Laid out anew each time, as for a user with one map and one state.
        let contact = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion)?.solve(
            control,
            Start::Apart,
            tolerance.parse()?,
            &Unobserved,
        )?;
        let bytes: Vec<u8> = contact.gaps_m.iter().flat_map(|gap| gap.to_le_bytes()).collect();
        std::fs::write(gaps, bytes)?;
        println!("{} {} {:e}", contact.iterations, contact.operators, contact.nominal_pressure_pa);
    }
    Ok(())
}
