//! Synthetic scans and writers of every format that scans are read from.

#[macro_use]
pub mod refused;

pub mod corpus;
pub mod nanoscope;
pub mod netcdf;
pub mod x3p;
pub mod zip_file;

use std::f64::consts::TAU;

use scans::{Scan, ScanFile, ScanOptions, ScanReadError, read_scans};

/// Hurst exponent of the synthetic surfaces.
const HURST: f64 = 0.8;

/// Heights in m of a self-affine line: cosines of amplitude 10 nm / k^(H + 1/2) with fixed phases, about their mean.
pub fn self_affine_line(points: usize) -> Vec<f64> {
    (0..points).map(|point| cosines(point as f64 / points as f64, 0.0)).collect()
}

/// Heights in m of a self-affine map, row after row, different along x and y.
pub fn self_affine_map(columns: usize, rows: usize) -> Vec<f64> {
    let at = |row: usize, column: usize| cosines(column as f64 / columns as f64, row as f64 / rows as f64);
    (0..rows).flat_map(|row| (0..columns).map(move |column| at(row, column))).collect()
}

fn cosines(x: f64, y: f64) -> f64 {
    let mode = |k: u32| {
        let wave = f64::from(k);
        let phase = TAU * (wave * 0.618_033_988_749_894_9).fract();
        10e-9 * wave.powf(-HURST - 0.5) * (TAU * wave * (x + 2.0 * y) + phase).cos()
    };
    (1..=7).map(mode).sum()
}

/// Reads the one scan in a file, which must have no missing points.
pub fn read_one(bytes: &[u8], options: &ScanOptions) -> Result<ScanFile<Scan>, ScanReadError> {
    measured(bytes, options)?.complete()
}

/// Reads the one scan in a file as it was measured.
pub fn measured(bytes: &[u8], options: &ScanOptions) -> Result<ScanFile, ScanReadError> {
    let mut scans = read_scans(bytes, "scan", options)?;
    assert_eq!(scans.len(), 1);
    Ok(scans.remove(0))
}

/// The points without a height of the one scan in a file, counted from 0, row after row.
pub fn missing_points(bytes: &[u8], options: &ScanOptions) -> Vec<usize> {
    measured(bytes, options).unwrap().scan.missing_points().indices().collect()
}

/// The error of a file that cannot be read.
pub fn refusal(bytes: &[u8], options: &ScanOptions) -> ScanReadError {
    match read_scans(bytes, "scan", options) {
        Ok(scans) => panic!("it should be refused, but holds {} scans", scans.len()),
        Err(error) => error,
    }
}

/// Options with a unit alone.
pub fn in_unit(unit: &str) -> ScanOptions {
    ScanOptions { unit: Some(unit.parse().unwrap()), ..ScanOptions::default() }
}

/// The heights of any scan, in m.
pub fn heights_m(scan: &Scan) -> &[f64] {
    match scan {
        Scan::UniformLine(line) => line.heights_m(),
        Scan::NonuniformLine(line) => line.heights_m(),
        Scan::Map(map) => map.heights_m(),
        Scan::Lines(_) => panic!("no file holds parallel lines"),
    }
}

/// The spacings of a map or a uniform line along x and y, in m.
pub fn spacings_m(scan: &Scan) -> (f64, f64) {
    match scan {
        Scan::UniformLine(line) => (line.spacing_m(), 0.0),
        Scan::NonuniformLine(line) => (line.mean_spacing_m(), 0.0),
        Scan::Map(map) => (map.spacing_x_m(), map.spacing_y_m()),
        Scan::Lines(_) => panic!("no file holds parallel lines"),
    }
}

/// Asserts that values agree within the resolution of a format, in m.
pub fn assert_close(found: &[f64], expected: &[f64], resolution_m: f64) {
    assert_eq!(found.len(), expected.len());
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).abs() <= resolution_m, "value {index}: {found:e} is not {expected:e}");
    }
}

/// Lines of numbers with blanks between them.
pub fn text_rows<const N: usize>(rows: impl Iterator<Item = [f64; N]>) -> String {
    let line = |row: [f64; N]| row.map(|value| format!("{value:.9e}")).join(" ") + "\n";
    rows.map(line).collect()
}

/// A matrix in nm below a header in the words of Gwyddion.
pub fn gwyddion_matrix(columns: usize, size_um: [f64; 2], heights_m: &[f64]) -> String {
    let [width, height] = size_um;
    let header =
        format!("# Channel: Topography\n# Width: {width} µm\n# Height: {height} µm\n# Value units: m\n");
    let row =
        |row: &[f64]| row.iter().map(|height| format!("{height:.9e}")).collect::<Vec<_>>().join("\t") + "\n";
    header + &heights_m.chunks(columns).map(row).collect::<String>()
}
