//! Files of instruments that hold whatever scan a test wants.

use scans::{
    HeightMap, LengthUnit, MeasuredScan, MissingPoints, Scan, ScanFile, ScanOptions, ScanSize, read_scans,
};

/// A file with this scan in it.
pub fn file_of(scan: MeasuredScan) -> ScanFile {
    let options = ScanOptions {
        unit: Some(LengthUnit::NANOMETRE),
        size: Some(ScanSize { x_m: 1e-9, y_m: Some(1e-9) }),
        ..ScanOptions::default()
    };
    let mut read = read_scans(b"1 2\n3 4\n", "map.txt", &options).expect("a sound text");
    let mut file = read.pop().expect("one scan");
    file.scan = scan;
    file.notes.clear();
    file
}

pub fn map_with_gaps(
    columns: usize,
    rows: usize,
    spacings_m: [f64; 2],
    height_m: impl Fn(usize, usize) -> f64,
    is_gap: impl Fn(usize, usize) -> bool,
) -> MeasuredScan {
    let places = || (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    // The heights at missing points must not matter.
    let heights_m =
        places().map(|(row, column)| if is_gap(row, column) { 777.0 } else { height_m(row, column) });
    let map =
        HeightMap::new(columns, spacings_m[0], spacings_m[1], heights_m.collect()).expect("a sound map");
    let gaps: MissingPoints =
        places().enumerate().filter(|&(_, (row, column))| is_gap(row, column)).map(|(at, _)| at).collect();
    MeasuredScan::with_missing_points(Scan::Map(map), gaps)
}
