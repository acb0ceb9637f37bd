//! Heights written and read again.

use scans::{
    LengthUnit, MeasuredScan, NonuniformLineScan, Scan, ScanFile, ScanOptions, ScanSize, ScanWriteError,
    WrittenFormat, read_scans,
};

use crate::support::{self_affine_line, self_affine_map};

fn map() -> ScanFile {
    let size = ScanSize { x_m: 3e-6, y_m: Some(1.1e-6) };
    let missing = [2, 13].into_iter().collect();
    let mut file = ScanFile::of_map("a.spm".to_owned(), size, 6, self_affine_map(6, 4), missing).unwrap();
    file.channel = Some("Height (Trace)".to_owned());
    file
}

fn line() -> ScanFile {
    let size = ScanSize { x_m: 0.7e-3, y_m: None };
    ScanFile::of_line("a.txt".to_owned(), size, self_affine_line(12), [3].into_iter().collect()).unwrap()
}

/// Reads what was written; what the format does not hold is taken from the file.
fn again(format: WrittenFormat, file: &ScanFile) -> ScanFile {
    let bytes = format.write(file, "truearea 1, of a.spm:unit=um -- twice\nover").unwrap();
    read_scans(&bytes, "b", &ScanOptions::default()).unwrap().remove(0)
}

#[track_caller]
fn assert_same(found: &MeasuredScan, written: &MeasuredScan, stored: fn(f64) -> f64) {
    assert_eq!((found.points(), found.missing_points()), (written.points(), written.missing_points()));
    let close = |found: f64, written: f64| (found / written - 1.0).abs() < 1e-15;
    assert!(close(found.size_m().0, written.size_m().0));
    assert!(found.size_m().1.zip(written.size_m().1).is_none_or(|(found, written)| close(found, written)));
    for (found, written) in found.heights_m().zip(written.heights_m()) {
        assert_eq!(found.map(f64::to_bits), written.map(|height| stored(height).to_bits()));
    }
}

#[test]
fn maps_come_back_to_the_last_bit_with_their_gaps() {
    for &format in WrittenFormat::ALL {
        let found = again(format, &map());
        let stored = match format {
            WrittenFormat::Gsf => |height: f64| f64::from(height as f32),
            _ => |height| height,
        };
        assert_same(&found.scan, &map().scan, stored);
    }
    let gsf = again(WrittenFormat::Gsf, &map());
    assert_eq!(gsf.channel.as_deref(), Some("Height (Trace)"));
    assert_eq!(gsf.free_text, "truearea 1, of a.spm:unit:um -- twice over");
}

#[test]
fn profiles_come_back_even_and_uneven() {
    let mut uneven = line();
    let positions_m = vec![0.0, 1.1e-6, 5e-6, 9e-6];
    let heights_m = vec![1e-9, -2e-9, 3e-9, 0.0];
    uneven.scan = Scan::NonuniformLine(NonuniformLineScan::new(positions_m, heights_m).unwrap()).into();
    for &format in WrittenFormat::ALL {
        if format == WrittenFormat::Gsf {
            let refused = format.write(&line(), "").unwrap_err();
            assert_eq!(refused, ScanWriteError::Profile { format: ".gsf" });
            continue;
        }
        assert_same(&again(format, &line()).scan, &line().scan, |height| height);
        let found = again(format, &uneven);
        assert_same(&found.scan, &uneven.scan, |height| height);
        assert_eq!(found.scan.positions_m(), uneven.scan.positions_m());
    }
}

#[test]
fn units_and_periods_are_kept() {
    let mut file = map();
    file.is_periodic = true;
    assert!(again(WrittenFormat::NetCdf, &file).is_periodic);
    // Every format states metres: another unit is refused.
    for &format in WrittenFormat::ALL {
        let options = ScanOptions { unit: Some(LengthUnit::NANOMETRE), ..ScanOptions::default() };
        let bytes = format.write(&map(), "").unwrap();
        let found = read_scans(&bytes, "b", &options);
        assert!(found.is_err() || found.unwrap()[0].notes.iter().any(|note| note.contains("replaces")));
    }
}

#[test]
fn formats_are_told_by_the_ending() {
    assert_eq!(WrittenFormat::from_name("a/b.GSF"), Some(WrittenFormat::Gsf));
    assert_eq!(WrittenFormat::from_name("b.nc"), Some(WrittenFormat::NetCdf));
    assert_eq!(WrittenFormat::from_name("b.txt"), None);
}
