//! Support of the targets: the options of a run, and the promises of every scan that is read.

use std::io::{Cursor, Write};

use scans::{MeasuredScan, ScanOptions, ScanSize, Statistics, read_scans, visit_channels};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Reads the bytes as they are, and again with unit and size given, which takes text further.
pub fn read(bytes: &[u8]) {
    let bare = ScanOptions { max_unpacked_bytes: Some(1 << 20), ..ScanOptions::default() };
    let told = ScanOptions {
        unit: "nm".parse().ok(),
        size: Some(ScanSize { x_m: 1e-6, y_m: None }),
        ..bare.clone()
    };
    let in_unit = ScanOptions { size: None, ..told.clone() };
    let sized = ScanOptions { unit: None, ..told.clone() };
    let _ = visit_channels(bytes, "fuzz", &bare, true, |channel| {
        if let Ok(file) = channel {
            check(&file.scan);
            let _ = Statistics::from_scan(&file.scan);
        }
    });
    for options in [bare, told, in_unit, sized] {
        match read_scans(bytes, "fuzz", &options) {
            Ok(scans) => scans.iter().for_each(|file| check(&file.scan)),
            Err(error) => check_message(&error.to_string(), bytes),
        }
    }
}

/// Checks that a message has a length that a terminal takes.
pub fn check_message(message: &str, bytes: &[u8]) {
    assert!(!message.is_empty() && message.len() < 10_000 + 4 * bytes.len(), "{message}");
}

fn check(scan: &MeasuredScan) {
    let (columns, rows) = scan.points();
    let points = columns * rows.unwrap_or(1);
    assert_eq!(scan.heights_m().len(), points);
    assert!(points >= 2 && scan.missing_points().count() <= points);
    assert!(scan.missing_points().indices().all(|index| index < points));
    assert!(scan.heights_m().flatten().all(f64::is_finite));
    let (spacing_x_m, spacing_y_m) = scan.spacing_m();
    assert!(spacing_x_m > 0.0 && spacing_y_m.is_none_or(|spacing_y_m| spacing_y_m > 0.0));
    assert!(scan.positions_m().is_none_or(|positions_m| positions_m.is_sorted()));
}

/// The bytes before and after the first zero byte: a text and data, which a target packs into an archive, since no
/// fuzzer finds its way past checksums.
pub fn text_and_data(bytes: &[u8]) -> (&[u8], &[u8]) {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    (&bytes[..end], bytes.get(end + 1..).unwrap_or_default())
}

/// An uncompressed archive of these files.
pub fn packed(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for (path, bytes) in files {
        zip.start_file(*path, stored).expect("a new path");
        zip.write_all(bytes).expect("memory");
    }
    zip.finish().expect("memory").into_inner()
}
