//! Solves the adhesive contact of a square map for `competitors/adhesion.py`, which measures it from outside.
//!
//! `adhesive_elements HEIGHTS GAPS WORK RANGE CONTROL VALUE TOLERANCE TIMES`: heights in m as 64-bit numbers, row by row
//! over a square of side 1 m and modulus 1 Pa; work of adhesion in J/m^2 and its range in m; CONTROL is `gap` or
//! `pressure`, and VALUE the mean gap in m or the nominal pressure in Pa. The contact is solved TIMES times from the
//! surface that just touches, and the gaps are written in the format of the heights.

use std::process::ExitCode;

use elements::half_space::{Adhesion, AdhesiveElements, Control, Start};
use numerics::parallel::Unobserved;
use work_precision::square_map::{carry_out, read, write};

fn main() -> ExitCode {
    carry_out(run)
}

fn run(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [heights, gaps, work, range, control, value, tolerance, times] = arguments else {
        return Err("HEIGHTS GAPS WORK RANGE CONTROL VALUE TOLERANCE TIMES".into());
    };
    let (grid, heights_m) = read(heights)?;
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
        write(gaps, &contact.gaps_m)?;
        println!("{} {} {:e}", contact.iterations, contact.operators, contact.nominal_pressure_pa);
    }
    Ok(())
}
