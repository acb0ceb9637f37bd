//! Small files after public bug reports, with what another program reads in them; `tests/files/README.md` says whence
//! they come.

use scans::{
    MeasuredScan, Mend, ScanFile, ScanOption, ScanOptions, ScanReadError, Statistics, read_scans,
    visit_channels,
};

/// A file as it was made, with its name for messages.
macro_rules! file {
    ($name:literal) => {
        ($name, include_bytes!(concat!("../files/", $name)).as_slice())
    };
}

fn read(file: (&str, &[u8])) -> ScanFile {
    read_with(file, &ScanOptions::default())
}

fn read_with((name, bytes): (&str, &[u8]), options: &ScanOptions) -> ScanFile {
    read_scans(bytes, name, options).unwrap_or_else(|error| panic!("{name}: {error}")).remove(0)
}

/// Points, size in m, rms height and peak to valley in m, missing points.
type Expected = ([usize; 2], [f64; 2], [f64; 2], usize);

#[track_caller]
fn assert_reads(scan: &MeasuredScan, (points, size_m, heights_m, gaps): Expected) {
    let (columns, rows) = scan.points();
    let (x_m, y_m) = scan.size_m();
    assert_eq!([columns, rows.unwrap_or(1)], points);
    assert_eq!(scan.missing_points().count(), gaps);
    let found = Statistics::from_scan(scan).unwrap();
    let numbers = [x_m, y_m.unwrap_or_default(), found.rms_height_m, found.peak_to_valley_m];
    for (found, expected) in numbers.into_iter().zip([size_m, heights_m].concat()) {
        assert!((found - expected).abs() <= 1e-5 * expected, "{found} is not {expected}");
    }
}

#[test]
fn files_hold_what_other_programs_find() {
    for (file, expected) in [
        (file!("nms_real_layout.nms"), ([10, 8], [3.125e-6, 2.5e-6], [8.46861e-7, 3.0e-6], 0)),
        (file!("jpk_thumbnail_with_slots.jpk"), ([16, 12], [2e-6, 1.5e-6], [1.23941e-8, 3.98038e-8], 0)),
        (file!("small.gsf"), ([20, 12], [2e-6, 1.2e-6], [1.79543e-9, 9.52303e-9], 0)),
        (file!("nanoscope_aspect_0.512.spm"), ([20, 14], [3e-7, 2.1e-7], [2.29402e-7, 7.84851e-7], 0)),
    ] {
        assert_reads(&read(file).scan, expected);
    }
}

#[cfg(feature = "x3p")]
#[test]
fn archives_within_a_folder_are_read() {
    for (file, expected) in [
        (file!("x3p_in_folder.x3p"), ([9, 6], [2.25e-5, 1.5e-5], [7.95884e-7, 3.34551e-6], 1)),
        (
            file!("x3ptools_csafe-logo.x3p"),
            ([741, 419], [4.77945e-4, 2.70255e-4], [6.57530e-8, 6.19608e-7], 0),
        ),
    ] {
        assert_reads(&read(file).scan, expected);
    }
    // Its increment of 1e-6 is not applied, and said so.
    assert_eq!(read(file!("x3ptools_csafe-logo.x3p")).notes.len(), 1);
}

#[test]
fn a_thumbnail_is_no_channel() {
    let file = read(file!("jpk_thumbnail_with_slots.jpk"));
    assert_eq!(file.channel.as_deref(), Some("Height (Trace)"));
    assert_eq!(file.channels, ["Height (Trace)"]);
}

#[test]
fn a_file_without_heights_names_its_channels() {
    let (name, bytes) = file!("no_heights.gwy");
    let visit = |all: bool| {
        let mut found = Vec::new();
        visit_channels(bytes, name, &ScanOptions::default(), all, |file| found.push(file.unwrap()))
            .map(|()| found.len())
    };
    refused!(visit(false).unwrap_err(), NoHeightChannel { channels: vec!["Amplitude".to_owned()] });
    assert_eq!(visit(true).unwrap(), 1);
}

#[test]
fn texts_hold_what_their_headers_and_columns_say() {
    for (file, expected) in [
        (file!("columns_z_then_x.csv"), ([4, 1], [4e-6, 0.0], [4.43706e-7, 1.1e-6], 0)),
        (file!("quoted_profile.csv"), ([4, 1], [2e-6, 0.0], [3.391165e-10, 9e-10], 0)),
        (file!("dabam-010.dat"), ([435, 1], [0.4437, 0.0], [8.77485e-9, 3.395e-8], 0)),
        (file!("wsxm_xyz.txt"), ([4, 3], [8e-9, 9e-9], [8.57159e-10, 2.3e-9], 0)),
        (file!("wyko_nm.asc"), ([5, 6], [8e-6, 1.2e-5], [4.20745e-8, 2.0026e-7], 1)),
        (file!("wyko_two_blocks.asc"), ([5, 6], [8e-6, 1.2e-5], [4.20745e-8, 2.0026e-7], 1)),
        (file!("zygo_format1.xyz"), ([4, 3], [2e-5, 1.5e-5], [8.90816e-7, 2.3e-6], 1)),
    ] {
        assert_reads(&read(file).scan, expected);
    }
    let residual = ScanOptions { channel: Some("Residual Heigth".to_owned()), ..ScanOptions::default() };
    let found = read_with(file!("dabam-010.dat"), &residual);
    let rms_m = Statistics::from_scan(&found.scan).unwrap().rms_height_m;
    assert!((rms_m / 3.04479e-9 - 1.0).abs() < 1e-5, "{rms_m}");
    assert_eq!(found.channels, ["Measured heigth", "Residual Heigth"]);
}

#[test]
fn texts_of_testers_need_a_unit() {
    let expected = ([400, 1], [4e-3, 0.0], [5.53000e-7, 1.7576e-6], 0);
    let um = ScanOptions { fallback_unit: "um".parse().ok(), ..ScanOptions::default() };
    let tester = read_with(file!("tx1_length_count_heights.tx1"), &um);
    assert_reads(&tester.scan, expected);
    assert_eq!(tester.notes.len(), 1, "{:?}", tester.notes);
    let (name, bytes) = file!("stylus_mm_um_no_header.txt");
    let error = read_scans(bytes, name, &ScanOptions::default()).unwrap_err();
    assert_eq!(error.mend(), Some(Mend::Give(ScanOption::Units)));
    let options =
        ScanOptions { fallback_unit: "mm".parse().ok(), fallback_height_unit: "um".parse().ok(), ..um };
    let stylus = read_with((name, bytes), &options);
    assert_reads(&stylus.scan, ([400, 1], [4e-4, 0.0], [5.53002e-7, 1.75769e-6], 0));
    let slope = Statistics::from_scan(&stylus.scan).unwrap().rms_slope_x.unwrap();
    assert!((slope / 0.0748644 - 1.0).abs() < 1e-5, "{slope}");
}

#[test]
fn slopes_are_no_heights() {
    let (name, bytes) = file!("dabam-001.dat");
    for unit in [None, "um".parse().ok()] {
        let options = ScanOptions { fallback_unit: unit, ..ScanOptions::default() };
        let error = read_scans(bytes, name, &options).unwrap_err();
        let is_told =
            matches!(&error, ScanReadError::NoLength { line: 4, column: 2, unit } if unit == "urad");
        assert!(is_told, "{error}");
    }
}

#[cfg(feature = "archives")]
#[test]
fn archives_of_instruments_without_an_image_are_named() {
    use crate::support::zip_file::stored;
    use scans::ForeignFile;
    let force = [
        ("header.properties", b"type=force".as_slice()),
        ("segments/0/segment-header.properties", b"1 2\n3 4\n"),
    ];
    let plux = [("index.xml", b"<xml/>".as_slice()), ("recipe.txt", b"1 2\n3 4\n")];
    for files in [force, plux] {
        let error = read_scans(&stored(&files), "scan", &ScanOptions::default()).unwrap_err();
        assert!(matches!(error, ScanReadError::Foreign(ForeignFile::Instrument(_))), "{error}");
    }
}
