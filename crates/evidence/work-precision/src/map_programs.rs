//! Programs that the scripts of the competitors measure from outside. They exchange square maps as 64-bit numbers, row by row.

use std::error::Error;
use std::path::Path;

use elements::half_space::{Elements, Grid, Loading};
use numerics::parallel::Unobserved;
use scans::{Scan, ScanOptions, read_scans};
use topography::{Detrend, Preparation, Window, map_line_spectrum};

/// Presses a map: `press HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES`.
///
/// Heights in m lie over a square of side 1 m and modulus 1 Pa. They are pressed TIMES times, and the pressures are written in
/// the same format. Prints iterations, operators and the largest memory in bytes.
///
/// # Errors
/// The errors of arguments, files, and the solver.
pub fn press(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let [heights, pressures, pressure, tolerance, times] = arguments else {
        return Err("usage: press HEIGHTS PRESSURES PRESSURE TOLERANCE TIMES".into());
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
        write(pressures, &contact.pressures_pa)?;
        println!(
            "{} {} {}",
            contact.numbers.iterations,
            contact.numbers.operators,
            peak_bytes().unwrap_or_default()
        );
    }
    Ok(())
}

/// Reads a map and its spectrum: `scan FILE HEIGHTS SPECTRUM`.
///
/// Writes the first channel of FILE less its least-squares plane, in m, and its spectrum line by line without a window, in m³.
///
/// # Errors
/// The errors of arguments and files.
pub fn scan(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let [file, heights, spectrum] = arguments else { return Err("usage: scan FILE HEIGHTS SPECTRUM".into()) };
    let name = Path::new(file).file_name().unwrap_or_default().to_string_lossy();
    let read = read_scans(&std::fs::read(file)?, &name, &ScanOptions::default())?;
    let first = read.into_iter().next().ok_or("the file has no heights")?;
    let Scan::Map(map) = first.scan.complete()? else { return Err("the file is not a map".into()) };
    let preparation = Preparation { detrend: Detrend::Plane, window: Window::None };
    write(heights, map.heights_m())?;
    write(spectrum, &map_line_spectrum(&map, preparation).c1d_m3)?;
    println!("{} {}", map.columns(), map.rows());
    Ok(())
}

fn write(path: &str, values: &[f64]) -> std::io::Result<()> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    std::fs::write(path, bytes)
}

/// Largest memory that this process has held; `None` if the system does not report it.
fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? * 1024)
}
