//! Files of instruments, every byte of them made here: each reader finds what was written, and refuses what is damaged.
//!
//! A module a format has `fn samples() -> Vec<Sample>`: small files that the reader of the format reads. From them also
//! start the fuzzer and the test that cuts and flips bytes.

mod alicona;
mod bcr;
mod bounds;
mod bytes;
mod digital_surf;
mod frt;
mod gsf;
mod gwyddion;
mod hdf5;
mod igor;
mod jpk;
mod keyence;
mod marwin;
mod matlab;
mod metropro;
mod molecular_imaging;
mod mountains_map;
mod nanofocus;
mod nanonis;
mod nanosurf;
mod nt_mdt;
mod numpy;
mod omni_surf;
#[cfg(feature = "archives")]
mod packed;
mod park;
mod sdf;
mod sensofar;
mod sensofar_plux;
mod text;
mod tiff_file;
mod truemap;
mod vision64;
mod workbook;
mod wsxm;
mod wyko;
mod wyko_ascii;
mod x3p;
mod zeta;
mod zygo_xyz;

use std::io::{Cursor, Read};

use scans::{
    FormatCheck, MeasuredScan, ScanFile, ScanFormat, ScanOptions, ScanReadError, ScanSize, read_scans,
    visit_channels,
};

/// A file with what it holds.
pub struct Sample {
    /// A name of its own among those of the format.
    pub name: &'static str,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// The samples of every format.
fn samples() -> Vec<(ScanFormat, Vec<Sample>)> {
    vec![
        (ScanFormat::Alicona, alicona::samples()),
        (ScanFormat::Bcr, bcr::samples()),
        (ScanFormat::DigitalSurf, digital_surf::samples()),
        (ScanFormat::Frt, frt::samples()),
        (ScanFormat::Gsf, gsf::samples()),
        (ScanFormat::Gwyddion, gwyddion::samples()),
        (ScanFormat::Hdf5, hdf5::samples()),
        (ScanFormat::Igor, igor::samples()),
        (ScanFormat::Jpk, jpk::samples()),
        (ScanFormat::Keyence, keyence::samples()),
        (ScanFormat::MarWin, marwin::samples()),
        (ScanFormat::Matlab, matlab::samples()),
        (ScanFormat::MetroPro, metropro::samples()),
        (ScanFormat::MolecularImaging, molecular_imaging::samples()),
        (ScanFormat::MountainsMap, mountains_map::samples()),
        (ScanFormat::NanoFocus, nanofocus::samples()),
        (ScanFormat::Nanonis, nanonis::samples()),
        (ScanFormat::Nanosurf, nanosurf::samples()),
        (ScanFormat::NtMdt, nt_mdt::samples()),
        (ScanFormat::Numpy, numpy::samples()),
        (ScanFormat::OmniSurf, omni_surf::samples()),
        (ScanFormat::ParkTiff, park::samples()),
        (ScanFormat::Sdf, sdf::samples()),
        (ScanFormat::Sensofar, sensofar::samples()),
        (ScanFormat::SensofarPlux, sensofar_plux::samples()),
        (ScanFormat::Text, text::samples()),
        (ScanFormat::TrueMap, truemap::samples()),
        (ScanFormat::Vision64, vision64::samples()),
        (ScanFormat::Workbook, workbook::samples()),
        (ScanFormat::Wsxm, wsxm::samples()),
        (ScanFormat::Wyko, wyko::samples().into_iter().chain(wyko_ascii::samples()).collect()),
        (ScanFormat::X3p, x3p::samples()),
        (ScanFormat::Zeta, zeta::samples()),
        (ScanFormat::ZygoXyz, zygo_xyz::samples()),
    ]
}

/// The channels of heights of a file; each must be readable.
pub fn heights(bytes: &[u8]) -> Vec<ScanFile> {
    channels(bytes, false).into_iter().map(|channel| channel.unwrap()).collect()
}

/// The error of a file that cannot be read.
pub fn refusal(bytes: &[u8]) -> ScanReadError {
    read_scans(bytes, "scan", &ScanOptions::default()).unwrap_err()
}

/// The channels of a file: all, or those of heights, of which there may be none.
pub fn channels(bytes: &[u8], all: bool) -> Vec<Result<ScanFile, ScanReadError>> {
    let mut found = Vec::new();
    match visit_channels(bytes, "scan", &ScanOptions::default(), all, |channel| found.push(channel)) {
        Err(ScanReadError::NoHeightChannel { .. }) if !all => Vec::new(),
        visited => {
            visited.unwrap();
            found
        }
    }
}

/// Asserts points, size in m to 1e-12, heights in m (nothing at missing points) within a resolution.
#[track_caller]
pub fn assert_holds(
    scan: &MeasuredScan,
    size_m: (f64, Option<f64>),
    heights_m: &[Option<f64>],
    resolution_m: f64,
) {
    let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-12;
    let (x_m, y_m) = scan.size_m();
    assert!(close(x_m, size_m.0), "{x_m} is not {}", size_m.0);
    match (y_m, size_m.1) {
        (None, None) => {}
        (Some(found), Some(expected)) => assert!(close(found, expected), "{found} is not {expected}"),
        other => panic!("sizes along y: {other:?}"),
    }
    assert_eq!(scan.heights_m().len(), heights_m.len());
    for (index, (found, expected)) in scan.heights_m().zip(heights_m).enumerate() {
        match (found, expected) {
            (None, None) => {}
            (Some(found), Some(expected)) if (found - expected).abs() <= resolution_m => {}
            other => panic!("point {index}: {other:?}"),
        }
    }
}

#[test]
fn every_sample_is_told_by_its_content_and_read() {
    for (format, samples) in samples() {
        for Sample { name, bytes } in samples {
            if format != ScanFormat::Text {
                assert_eq!(ScanFormat::recognise(&bytes), Some(format), "{name}");
            }
            assert!(
                !heights_if_told(&bytes)
                    .unwrap_or_else(|error| panic!("{format} {name}: {error}"))
                    .is_empty()
            );
        }
    }
}

#[test]
fn formats_that_no_real_file_has_checked_say_so() {
    let notes = |bytes: &[u8]| heights_if_told(bytes).unwrap().remove(0).notes;
    let is_noted = |bytes: &[u8]| notes(bytes).iter().any(|note| note.contains("not checked"));
    for (format, samples) in samples() {
        for Sample { name, bytes } in samples {
            let is_unchecked = matches!(format.check(), FormatCheck::MadeFiles(_)) || name == "zygo";
            assert_eq!(is_noted(&bytes), is_unchecked, "{format} {name}");
        }
    }
}

/// Fuzzing starts from the samples: a folder a format in `fuzz/corpus`.
#[test]
fn samples_are_kept_for_fuzzing() {
    for (format, samples) in samples() {
        // The inputs of `x3p` are unpacked ones.
        let folder = match format {
            ScanFormat::X3p => "archive".to_owned(),
            _ => format.to_string().to_lowercase().replace(' ', "-"),
        };
        samples.iter().for_each(|sample| {
            crate::support::corpus::keep(&folder, &sample.name.replace(' ', "-"), &sample.bytes)
        });
    }
}

#[test]
fn no_sample_is_claimed_by_two_readers() {
    for (format, samples) in samples() {
        for Sample { name, bytes } in samples {
            let expected = if format == ScanFormat::Text { vec![] } else { vec![format] };
            assert_eq!(ScanFormat::candidates(&bytes), expected, "{format} {name}");
        }
    }
}

#[test]
fn what_is_cut_or_damaged_is_read_or_refused_and_never_worse() {
    for (_, samples) in samples() {
        for Sample { bytes, .. } in samples {
            damage(&bytes, <[u8]>::to_vec);
        }
    }
}

/// Check sums keep damage to an archive from what is packed in it.
#[test]
fn what_is_damaged_before_it_is_packed_is_no_worse() {
    for (_, samples) in samples() {
        for Sample { bytes, .. } in samples {
            let files = unzipped(&bytes);
            for (path, content) in &files {
                let with = |damaged: &[u8]| {
                    let file = |(other, whole): &(String, Vec<u8>)| {
                        (other.clone(), if other == path { damaged.to_vec() } else { whole.clone() })
                    };
                    let files: Vec<(String, Vec<u8>)> = files.iter().map(file).collect();
                    let files = files.iter().map(|(path, content)| (path.as_str(), content.as_slice()));
                    crate::support::zip_file::stored(&files.collect::<Vec<_>>())
                };
                damage(content, with);
            }
        }
    }
}

/// Reads a file cut off at many places, and with bits flipped and numbers made large at many.
fn damage(bytes: &[u8], packed: impl Fn(&[u8]) -> Vec<u8>) {
    let step = (bytes.len() / 500).max(1);
    for at in (0..bytes.len()).step_by(step) {
        let _ = heights_if_told(&packed(&bytes[..at]));
        for flip in [0x01, 0x80, 0xff] {
            let mut damaged = bytes.to_vec();
            damaged[at] ^= flip;
            let _ = heights_if_told(&packed(&damaged));
        }
        for large in [0x7fff_ffffu32.to_le_bytes(), 0x7fff_ffffu32.to_be_bytes(), [0xff; 4]] {
            let mut damaged = bytes.to_vec();
            damaged[at..].iter_mut().zip(large).for_each(|(byte, large)| *byte = large);
            let _ = heights_if_told(&packed(&damaged));
        }
    }
}

/// The files in a ZIP file; none of any other.
fn unzipped(bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let Ok(mut archive) = zip::ZipArchive::new(Cursor::new(bytes)) else { return Vec::new() };
    let count = archive.len();
    let file = |index: usize| {
        let mut file = archive.by_index(index).unwrap();
        let mut content = Vec::new();
        file.read_to_end(&mut content).unwrap();
        (file.name().unwrap().into_owned(), content)
    };
    (0..count).map(file).collect()
}

/// With unit and size to fall back on, for formats that have none.
fn heights_if_told(bytes: &[u8]) -> Result<Vec<ScanFile>, ScanReadError> {
    let options = ScanOptions {
        fallback_unit: "nm".parse().ok(),
        fallback_size: Some(ScanSize { x_m: 1e-6, y_m: None }),
        max_unpacked_bytes: Some(1 << 20),
        ..ScanOptions::default()
    };
    read_scans(bytes, "scan", &options)
}
