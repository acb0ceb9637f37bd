//! Scans in short: size, height parameters, and heights few enough for a picture.

use roughness::HeightParameters;
use scans::{MissingPoints, NonuniformLineScan, Scan, ScanFile, ScanReadError, ScanSize};
use topography::without_form_m;

/// Largest number of points along a side of a thinned map.
const MAP_POINTS: usize = 160;

/// Largest number of points of a thinned line.
const LINE_POINTS: usize = 600;

/// A scan in short, for people.
#[derive(Debug, Clone)]
pub struct ScanSketch {
    /// Size along x and, of a map, along y \[m\].
    pub size_m: (f64, Option<f64>),
    /// Number of points along x and, of a map, along y.
    pub points: (usize, Option<usize>),
    /// Height parameters of all points; none if no point has a height.
    pub parameters: Option<HeightParameters>,
    /// Every few points, from which the least-squares plane or line is subtracted; none if too few are left.
    pub thinned: Option<ScanFile>,
}

impl ScanSketch {
    pub(crate) fn new(file: &ScanFile) -> Self {
        ScanSketch {
            size_m: file.scan.size_m(),
            points: file.scan.points(),
            parameters: HeightParameters::from_scan(&file.scan),
            thinned: thinned(file).and_then(|thinned| without_form(&thinned)).ok(),
        }
    }
}

/// Every few points of a scan.
fn thinned(file: &ScanFile) -> Result<ScanFile, ScanReadError> {
    let scan = &file.scan;
    let (columns, rows) = scan.points();
    let (dx_m, dy_m) = scan.spacing_m();
    let step = match rows {
        Some(rows) => columns.max(rows).div_ceil(MAP_POINTS),
        None => columns.div_ceil(LINE_POINTS),
    };
    let across = columns.div_ceil(step);
    let down = rows.map_or(1, |rows| rows.div_ceil(step));
    let indices = (0..down).flat_map(|row| (0..across).map(move |column| (row * columns + column) * step));
    let size = ScanSize {
        x_m: dx_m * (step * across) as f64,
        y_m: rows.map(|_| dy_m.unwrap_or(dx_m) * (step * down) as f64),
    };
    let heights: Vec<Option<f64>> = indices.clone().map(|index| scan.height_m(index)).collect();
    let mut thinned = of_heights(file.name.clone(), size, rows.map(|_| across), heights)?;
    if let Some(positions_m) = scan.positions_m() {
        let positions_m = indices.map(|index| positions_m[index]).collect();
        let heights_m = thinned.scan.heights_m().flatten().collect();
        let line = NonuniformLineScan::new(positions_m, heights_m).map_err(ScanReadError::Scan)?;
        thinned.scan = Scan::NonuniformLine(line).into();
    }
    Ok(thinned)
}

/// The scan without its least-squares plane or line; an unevenly spaced line stays as it is.
fn without_form(file: &ScanFile) -> Result<ScanFile, ScanReadError> {
    if file.scan.positions_m().is_some() {
        return Ok(file.clone());
    }
    let (columns, rows) = file.scan.points();
    let (x_m, y_m) = file.scan.size_m();
    let heights_m = without_form_m(&file.scan);
    of_heights(file.name.clone(), ScanSize { x_m, y_m }, rows.map(|_| columns), heights_m)
}

fn of_heights(
    name: String,
    size: ScanSize,
    columns: Option<usize>,
    heights: Vec<Option<f64>>,
) -> Result<ScanFile, ScanReadError> {
    let is_missing = |(index, height): (usize, &Option<f64>)| height.is_none().then_some(index);
    let missing: MissingPoints = heights.iter().enumerate().filter_map(is_missing).collect();
    let heights_m = heights.into_iter().map(Option::unwrap_or_default).collect();
    match columns {
        Some(columns) => ScanFile::of_map(name, size, columns, heights_m, missing),
        None => ScanFile::of_line(name, size, heights_m, missing),
    }
}
