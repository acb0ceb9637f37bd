//! Presses a square map for `competitors/boundary_elements.py`, which measures it from outside.
//!
//! `boundary_elements HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES`: heights in m as 64-bit numbers, row by row over a
//! square of side 1 m and modulus 1 Pa; they are pressed TIMES times, and the pressures are written in the same
//! format. It prints iterations, operators and the largest memory in bytes.

use std::process::ExitCode;

use elements::half_space::{Elements, Loading};
use numerics::parallel::Unobserved;
use work_precision::processes::own_peak_bytes;
use work_precision::square_map::{carry_out, read, write};

fn main() -> ExitCode {
    carry_out(run)
}

fn run(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [heights, pressures, pressure, tolerance, times] = arguments else {
        return Err("HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES".into());
    };
    let (grid, heights_m) = read(heights)?;
    let loading = Loading {
        contact_modulus_pa: 1.0,
        nominal_pressure_pa: pressure.parse()?,
        saturation_pa: None,
        tolerance: tolerance.parse()?,
    };
    for _ in 0..times.parse::<usize>()? {
        // Laid out anew each time, as for a user with one map and one load.
        let contact = Elements::periodic(grid, &heights_m)?.press(&loading, &Unobserved)?;
        write(pressures, &contact.pressures_pa)?;
        let peak_bytes = own_peak_bytes().unwrap_or_default();
        println!("{} {} {peak_bytes}", contact.iterations, contact.operators);
    }
    Ok(())
}
