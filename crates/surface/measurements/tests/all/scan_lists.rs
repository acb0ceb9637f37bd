//! Lists of scans.

use std::io::Cursor;

use tables::TableSource;

use measurements::{ScanRequest, requests_of_list};

fn read(text: &'static str) -> Result<Vec<ScanRequest>, String> {
    let list = TableSource::new("scans.csv", Cursor::new(text)).unwrap().whole().unwrap();
    requests_of_list("scans.csv", &list).map_err(|error| error.to_string())
}

#[test]
fn a_row_says_what_options_after_a_file_say() {
    let requests = read("file,unit,tip_radius,shortest\na.txt,nm,20 nm,\nb.001,,,46nm\n").unwrap();
    let typed = ["a.txt:unit=nm,tip-radius=20 nm", "b.001:shortest=46nm"];
    assert_eq!(requests, typed.map(|text| text.parse::<ScanRequest>().unwrap()));
}

#[test]
fn a_row_says_what_is_known_of_an_instrument() {
    let requests =
        read("file,instrument,z_calibration,slope_uncertainty\na.txt,AFM,3 %,0.05\nb.txt,AFM,,\n").unwrap();
    let typed = ["a.txt:instrument=AFM,z-calibration=3%,slope-uncertainty=0.05", "b.txt:instrument=AFM"];
    assert_eq!(requests, typed.map(|text| text.parse::<ScanRequest>().unwrap()));
    let bad = read("file,z_calibration\na.txt,3\n").unwrap_err();
    assert!(bad.starts_with("scans.csv, line 2, column z_calibration: the standard uncertainty"), "{bad}");
}

#[test]
fn bad_lists_are_refused_with_their_place() {
    assert_eq!(
        read("file,width\na.txt,3nm\n").unwrap_err(),
        "scans.csv: column width is not an option of a scan; use file, unit, height_unit, channel, size, tip_radius, shortest, \
         gaps, direction, detrend, instrument, z_calibration or slope_uncertainty"
    );
    let bad = read("file,size\na.txt,3\n").unwrap_err();
    assert!(bad.starts_with("scans.csv, line 2, column size: '3' has no unit"), "{bad}");
    assert_eq!(read("file\n").unwrap_err(), "scans.csv: the list has no rows; give a row for each scan");
}
