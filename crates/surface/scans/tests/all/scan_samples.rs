//! Real scans of the shared folder beside the checkout: sizes and heights as SurfaceTopography 1.27.1 reads them.
//!
//! "Demo UNCD data", L. Pastewka, CC BY 4.0 (`uncd_scans`), and test files of SurfaceTopography, MIT (`afm_tem_mit`).

use std::path::{Path, PathBuf};

use crate::support::{heights_m, in_unit, read_one, spacings_m};
use scans::{Scan, ScanFile, ScanOptions, read_metadata};

/// The samples lie beside the project, not in it.
fn sample(path: &str) -> Vec<u8> {
    let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../../shared/data");
    std::fs::read(folder.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn close(found: f64, expected: f64) -> bool {
    (found / expected - 1.0).abs() < 1e-12
}

/// The rms about the mean and the difference of the extremes.
fn rms_and_range_m(scan: &Scan) -> (f64, f64) {
    let heights_m = heights_m(scan);
    let count = heights_m.len() as f64;
    let mean = heights_m.iter().sum::<f64>() / count;
    let variance = heights_m.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / count;
    let range = heights_m.iter().copied().fold(f64::MIN, f64::max)
        - heights_m.iter().copied().fold(f64::MAX, f64::min);
    (variance.sqrt(), range)
}

struct Expected {
    size_m: f64,
    rms_m: f64,
    range_m: f64,
    /// First and last of the first row, first and last of the last.
    corners_m: [f64; 4],
}

fn assert_map(scan: &ScanFile<Scan>, expected: &Expected) {
    let Scan::Map(map) = &scan.scan else { panic!("a map") };
    assert_eq!((map.columns(), map.rows()), (512, 512));
    let (x_m, y_m) = spacings_m(&scan.scan);
    assert!(close(x_m * 512.0, expected.size_m) && close(y_m * 512.0, expected.size_m));
    let (rms_m, range_m) = rms_and_range_m(&scan.scan);
    assert!(close(rms_m, expected.rms_m), "{rms_m:e}");
    assert!(close(range_m, expected.range_m), "{range_m:e}");
    for (index, corner_m) in [0, 511, 511 * 512, 512 * 512 - 1].into_iter().zip(expected.corners_m) {
        assert!(close(map.heights_m()[index], corner_m));
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn images_of_an_atomic_force_microscope() {
    let retrace = ScanOptions { channel: Some("Height (Retrace)".to_owned()), ..ScanOptions::default() };
    let (uncd, di_1, di_6) =
        ("uncd_scans/gain_control_uncd_35_z03tr3R.001", "afm_tem_mit/di-1.di", "afm_tem_mit/di-6.di");
    for (path, options, expected) in [
        (
            uncd,
            ScanOptions::default(),
            Expected {
                size_m: 100e-9,
                rms_m: 2.7794175935431258e-08,
                range_m: 1.1330836972530649e-07,
                corners_m: [
                    -1.759922185753206e-06,
                    -1.7343689629071428e-06,
                    -1.6477345714158846e-06,
                    -1.6509847620410417e-06,
                ],
            },
        ),
        (
            di_1,
            ScanOptions::default(),
            Expected {
                size_m: 500e-9,
                rms_m: 9.945986800560388e-09,
                range_m: 5.9198569446927344e-08,
                corners_m: [
                    6.059980111183001e-09,
                    -9.740178655504912e-09,
                    2.843159166937812e-09,
                    -3.0306374893640624e-08,
                ],
            },
        ),
        (
            di_6,
            retrace,
            Expected {
                size_m: 10e-6,
                rms_m: 1.4325192156665013e-08,
                range_m: 1.0905934889628896e-07,
                corners_m: [
                    -2.220577009399275e-08,
                    -9.228051260561956e-09,
                    -3.745551582119259e-09,
                    -1.7604092435960515e-08,
                ],
            },
        ),
    ] {
        let bytes = sample(path);
        let scan = read_one(&bytes, &options).unwrap();
        assert_eq!(scan.channels, ["Height (Trace)", "Height (Retrace)"]);
        assert!(scan.notes.is_empty());
        assert_map(&scan, &expected);
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn traces_and_a_stylus_line() {
    for (path, unit, is_uniform, points, length_m, rms_m, range_m) in [
        (
            "uncd_scans/80_Scale10.472_FIXEDv2p1_D7eHXiT.asc",
            "nm",
            false,
            76,
            228.9070382e-9,
            3.884490199620412e-09,
            1.6616531e-08,
        ),
        (
            "uncd_scans/uncd_stylus_300um_5mar_3_k0HpKJt.txt",
            "mm",
            true,
            3001,
            0.29878356133333334e-3,
            3.2216820243188015e-07,
            1.146e-06,
        ),
        (
            "afm_tem_mit/nonuniform.asc",
            "nm",
            false,
            134,
            1684.600997e-9,
            1.4029186581854567e-08,
            6.140568e-08,
        ),
        ("afm_tem_mit/xy-1.txt", "nm", false, 132, 187.190431e-9, 3.1268353808541145e-09, 1.3305203e-08),
    ] {
        let bytes = sample(path);
        let scan = read_one(&bytes, &in_unit(unit)).unwrap().scan;
        let found_m = match &scan {
            Scan::UniformLine(line) if is_uniform => line.length_m(),
            Scan::NonuniformLine(line) if !is_uniform => line.length_m(),
            other => panic!("{path}: {other:?}"),
        };
        assert_eq!(heights_m(&scan).len(), points);
        let (rms, range) = rms_and_range_m(&scan);
        assert!(close(found_m, length_m) && close(rms, rms_m) && close(range, range_m), "{path}");
    }
}

#[test]
#[ignore = "needs the shared folder"]
#[cfg(feature = "container")]
fn the_metadata_beside_them() {
    let text = sample("uncd_scans/meta.yml");
    let entries = read_metadata(&String::from_utf8(text).unwrap(), "meta.yml").unwrap();
    assert_eq!(entries.len(), 3);
    for entry in entries {
        let path = format!("uncd_scans/{}", entry.original.as_deref().unwrap());
        let options = ScanOptions { metadata: Some(entry.clone()), ..ScanOptions::default() };
        let scan = read_one(&sample(&path), &options).unwrap();
        assert_eq!(scan.name, entry.name);
        if path.ends_with(".001") {
            // The factor from counts to nm, which the file has in its header: applied twice it would give 3 nm.
            assert!(close(rms_and_range_m(&scan.scan).0, 2.7794175935431258e-08));
            let note = "height_scale 0.112075538798523 of the metadata is not applied: the file carries its own scale";
            assert_eq!(scan.notes, [note]);
        } else {
            assert!(scan.notes.is_empty(), "{:?}", scan.notes);
        }
    }
}
