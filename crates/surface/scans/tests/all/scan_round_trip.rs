//! A self-affine surface written in every format reads back within the resolution of that format.

use crate::support::nanoscope::{Image, NanoscopeFile};
use crate::support::netcdf::{Kind, NetCdf};
use crate::support::x3p::{SPACING_M, X3p};
use crate::support::zip_file::zipped;
use crate::support::{
    assert_close, gwyddion_matrix, heights_m, in_unit, read_one, self_affine_line, self_affine_map,
    spacings_m, text_rows,
};
use scans::{Scan, ScanFormat, ScanOptions};

const COLUMNS: usize = 24;
const ROWS: usize = 15;
/// Rounding of ten digits of heights near 10 nm.
const TEXT_RESOLUTION_M: f64 = 1e-17;
const SINGLE_RESOLUTION_M: f64 = 20e-9 * f32::EPSILON as f64;

#[test]
fn text_profiles() {
    let line = self_affine_line(64);
    let rows = line.iter().enumerate().map(|(index, height)| [index as f64 * 0.3, height * 1e9]);
    let scan = read_one(text_rows(rows).as_bytes(), &in_unit("nm")).unwrap();
    assert_eq!(scan.format, ScanFormat::Text);
    assert!(matches!(scan.scan, Scan::UniformLine(_)));
    assert_close(heights_m(&scan.scan), &line, TEXT_RESOLUTION_M);
    assert_close(&[spacings_m(&scan.scan).0], &[0.3e-9], 1e-20);

    let uneven = |index: usize| index as f64 + 0.3 * (index as f64).sin();
    let rows = line.iter().enumerate().map(|(index, height)| [uneven(index), height * 1e9]);
    let scan = read_one(text_rows(rows).as_bytes(), &in_unit("nm")).unwrap();
    let Scan::NonuniformLine(read) = &scan.scan else { panic!("unevenly spaced") };
    assert_close(read.heights_m(), &line, TEXT_RESOLUTION_M);
    assert_close(read.positions_m(), &(0..64).map(|i| uneven(i) * 1e-9).collect::<Vec<_>>(), 1e-17);
}

#[test]
fn text_maps() {
    let map = self_affine_map(COLUMNS, ROWS);
    let matrix =
        read_one(gwyddion_matrix(COLUMNS, [2.4, 1.2], &map).as_bytes(), &ScanOptions::default()).unwrap();
    assert_eq!(matrix.channel.as_deref(), Some("Topography"));
    assert_close(heights_m(&matrix.scan), &map, TEXT_RESOLUTION_M);
    assert_close(&[spacings_m(&matrix.scan).0, spacings_m(&matrix.scan).1], &[0.1e-6, 0.08e-6], 1e-21);

    // Points in any order: here every seventh.
    let point = |index: usize| {
        let at = index * 7 % map.len();
        [0.1 * (at % COLUMNS) as f64 - 1.0, 0.3 * (at / COLUMNS) as f64, map[at] * 1e6]
    };
    assert_ne!(map.len() % 7, 0);
    let points = read_one(text_rows((0..map.len()).map(point)).as_bytes(), &in_unit("um")).unwrap();
    assert_close(heights_m(&points.scan), &map, TEXT_RESOLUTION_M);
    assert_close(&[spacings_m(&points.scan).0, spacings_m(&points.scan).1], &[0.1e-6, 0.3e-6], 1e-15);
}

#[test]
fn formats_are_told_without_reading() {
    let map = self_affine_map(COLUMNS, ROWS);
    for (bytes, format) in [
        (NanoscopeFile::new(COLUMNS, ROWS, &map).to_bytes(), Some(ScanFormat::Nanoscope)),
        (NetCdf::map(2, Kind::F64, COLUMNS, &map).to_bytes(), Some(ScanFormat::NetCdf)),
        (X3p::surface('D', COLUMNS, &map).to_bytes(), Some(ScanFormat::X3p)),
        (zipped(&[("folder/meta.yml", b"surfaces: []")]), Some(ScanFormat::Container)),
        (zipped(&[("xl/workbook.xml", b"")]), Some(ScanFormat::Workbook)),
        (b"0 1\n1 2\n".to_vec(), None),
        (b"\x89PNG\r\n\x1a\n".to_vec(), None),
        (Vec::new(), None),
    ] {
        assert_eq!(ScanFormat::recognise(&bytes), format);
    }
}

#[test]
fn nanoscope_images() {
    let map = self_affine_map(COLUMNS, ROWS);
    let reversed: Vec<f64> = map.iter().map(|height| -height).collect();
    let mut file = NanoscopeFile::new(COLUMNS, ROWS, &map);
    file.images.push(Image { name: "Height", direction: "Retrace", heights_m: &reversed });
    file.images.push(Image { name: "Phase", direction: "Trace", heights_m: &map });
    let scan = read_one(&file.to_bytes(), &ScanOptions::default()).unwrap();
    assert_eq!(scan.format, ScanFormat::Nanoscope);
    assert_eq!(scan.channel.as_deref(), Some("Height (Trace)"));
    assert_eq!(scan.channels, ["Height (Trace)", "Height (Retrace)"]);
    assert_close(heights_m(&scan.scan), &map, 0.5001 * file.resolution_m());
    assert_close(
        &[spacings_m(&scan.scan).0 * 24.0, spacings_m(&scan.scan).1 * 15.0],
        &[500e-9, 250e-9],
        1e-21,
    );

    let retrace = ScanOptions { channel: Some("Height (Retrace)".to_owned()), ..ScanOptions::default() };
    let scan = read_one(&file.to_bytes(), &retrace).unwrap();
    assert_close(heights_m(&scan.scan), &reversed, 0.5001 * file.resolution_m());
}

#[test]
fn nanoscope_counts_of_four_bytes() {
    let map = self_affine_map(COLUMNS, ROWS);
    let old =
        NanoscopeFile { bytes_per_pixel: 4, bytes_per_count: 4, ..NanoscopeFile::new(COLUMNS, ROWS, &map) };
    let scan = read_one(&old.to_bytes(), &ScanOptions::default()).unwrap();
    assert_close(heights_m(&scan.scan), &map, 0.5001 * old.resolution_m());
    // From version 9.2 on counts take four bytes even where their scale is that of two.
    let new =
        NanoscopeFile { version: 0x0920_0000, bytes_per_count: 4, ..NanoscopeFile::new(COLUMNS, ROWS, &map) };
    let scan = read_one(&new.to_bytes(), &ScanOptions::default()).unwrap();
    assert_close(heights_m(&scan.scan), &map, 0.5001 * new.resolution_m());
}

#[test]
fn netcdf_maps_and_lines() {
    let map = self_affine_map(COLUMNS, ROWS);
    for version in [1, 2, 5] {
        for (kind, resolution_m) in [(Kind::F64, 1e-23), (Kind::F32, SINGLE_RESOLUTION_M)] {
            let file = NetCdf::map(version, kind, COLUMNS, &map);
            let scan = read_one(&file.to_bytes(), &ScanOptions::default()).unwrap();
            assert_eq!((scan.format, scan.is_periodic), (ScanFormat::NetCdf, true));
            assert_close(heights_m(&scan.scan), &map, resolution_m);
            assert_close(
                &[spacings_m(&scan.scan).0 * 24.0, spacings_m(&scan.scan).1 * 15.0],
                &[2.5e-6, 1.5e-6],
                1e-20,
            );
        }
    }
    let line = self_affine_line(50);
    let positions: Vec<f64> = (0..50).map(|index| f64::from(index * index) * 1e-3).collect();
    let scan =
        read_one(&NetCdf::line("x", positions.clone(), &line).to_bytes(), &ScanOptions::default()).unwrap();
    assert_close(heights_m(&scan.scan), &line, 1e-23);
    assert_close(&[spacings_m(&scan.scan).0], &[0.05e-6], 1e-21);
    let scan =
        read_one(&NetCdf::line("n", positions.clone(), &line).to_bytes(), &ScanOptions::default()).unwrap();
    let Scan::NonuniformLine(read) = &scan.scan else { panic!("unevenly spaced") };
    assert_close(read.positions_m(), &positions.iter().map(|x| x * 1e-6).collect::<Vec<_>>(), 1e-21);
}

#[test]
#[cfg(feature = "x3p")]
fn x3p_surfaces_and_profiles() {
    let map = self_affine_map(COLUMNS, ROWS);
    for (data_type, resolution_m) in [('I', 0.5e-12), ('L', 0.5e-12), ('F', SINGLE_RESOLUTION_M), ('D', 0.0)]
    {
        let file = X3p::surface(data_type, COLUMNS, &map);
        let scan = read_one(&file.to_bytes(), &ScanOptions::default()).unwrap();
        assert_eq!(scan.format, ScanFormat::X3p);
        assert_close(heights_m(&scan.scan), &map, resolution_m * 1.0001);
        assert_close(&[spacings_m(&scan.scan).0, spacings_m(&scan.scan).1], &SPACING_M, 1e-21);
    }
    let line = self_affine_line(50);
    let profile = X3p { feature: "PRF", ..X3p::surface('D', 50, &line) };
    let scan = read_one(&profile.to_bytes(), &ScanOptions::default()).unwrap();
    assert!(matches!(scan.scan, Scan::UniformLine(_)));
    assert_eq!(heights_m(&scan.scan), line);
    let positions: Vec<f64> = (0..50).map(|index| f64::from(index * index) * 1e-9).collect();
    let uneven = X3p { feature: "PRF", positions_m: Some(&positions), ..X3p::surface('L', 50, &line) };
    let scan = read_one(&uneven.to_bytes(), &ScanOptions::default()).unwrap();
    let Scan::NonuniformLine(read) = &scan.scan else { panic!("unevenly spaced") };
    assert_eq!(read.positions_m(), positions);
    assert_close(read.heights_m(), &line, 0.5001e-12);
}
