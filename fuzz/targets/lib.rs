//! What the targets share: the options of a run and what must hold of every scan that is read.

use std::io::{Cursor, Write};

use scans::{Scan, ScanOptions, ScanSize, read_scans};
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
    for options in [bare, told, in_unit, sized] {
        match read_scans(bytes, "fuzz", &options) {
            Ok(scans) => scans.iter().for_each(|file| check(&file.scan)),
            Err(error) => assert!(error.to_string().len() < 10_000 + 4 * bytes.len(), "{error}"),
        }
    }
}

fn check(scan: &Scan) {
    let heights_m = match scan {
        Scan::UniformLine(line) => {
            assert!(line.spacing_m() > 0.0);
            line.heights_m()
        }
        Scan::NonuniformLine(line) => {
            assert!(line.positions_m().is_sorted());
            line.heights_m()
        }
        Scan::Map(map) => {
            assert_eq!(map.columns() * map.rows(), map.heights_m().len());
            map.heights_m()
        }
    };
    assert!(heights_m.len() >= 2 && heights_m.iter().all(|height_m| height_m.is_finite()));
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
