//! Reads a map and its spectrum for `competitors/scans.py`, which measures it from outside.
//!
//! `scan_spectrum FILE HEIGHTS SPECTRUM`: the first channel of FILE less its least-squares plane, without a window, line by
//! line. Heights in m and spectrum in m^3 are written as 64-bit numbers, heights row by row.

use std::path::Path;
use std::process::ExitCode;

use scans::{Scan, ScanOptions, read_scans};
use topography::{Detrend, Preparation, Window, map_line_spectrum};
use work_precision::square_map::{carry_out, write};

fn main() -> ExitCode {
    carry_out(run)
}

fn run(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [file, heights, spectrum] = arguments else { return Err("FILE HEIGHTS SPECTRUM".into()) };
    let name = Path::new(file).file_name().unwrap_or_default().to_string_lossy();
    let read = read_scans(&std::fs::read(file)?, &name, &ScanOptions::default())?;
    let first = read.into_iter().next().ok_or("no channel of heights")?;
    let Scan::Map(map) = first.scan.complete()? else { return Err("not a map".into()) };
    let preparation = Preparation { detrend: Detrend::Plane, window: Window::None };
    write(heights, map.heights_m())?;
    write(spectrum, map_line_spectrum(&map, preparation).c1d_m3())?;
    println!("{} {}", map.columns(), map.rows());
    Ok(())
}
