//! Text as instruments and spreadsheets write it: encodings, flags, counters, empty fields, missing points.

use scans::{Probe, ScanFile, ScanOptions, read_scans};

use crate::instruments::{Sample, assert_holds};

fn utf16(text: &str, order: fn(u16) -> [u8; 2]) -> Vec<u8> {
    std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(order).collect()
}

const COUNTED: &str = "index,x in µm,y in µm\r\n0,-1.5,2.5\r\n1,-1.0,3.5\r\n2,-0.5,4.5\r\n";
const FLAGGED: &str = "X;Y;valid\r\n[mm];[um];[1/0]\r\n0,5;106,5;1\r\n1,0;99;0\r\n1,5;107,5;1\r\n";
const STYLUS: &str = "Scan Parameters\r\r\nScan Type,Standard Scan\r\nStylus,Radius: 2.5 µm\r\nLocation,0.0 um, 0.0 um\r\n\r\r\n\
                      Analytical Results\r\r\nRa,468.0 um,0.0 um,733.0 um,0.0 um,0.00525 um\r\n\r\r\nScan Data\r\r\n\
                      Lateral um,Raw Micrometer,\r\n0.0,-0.25,,\r\n0.2,,,\r\n0.4,0.5,,\r\n";

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("utf16-little", utf16(COUNTED, u16::to_le_bytes)),
        sample("utf16-big", utf16(COUNTED, u16::to_be_bytes)),
        sample("flagged", FLAGGED.into()),
        sample("stylus", latin1(STYLUS)),
        sample("points", b"0 0 1\n0 1 2\n1 0 nan\n1 1 4\n2 1 6\n".to_vec()),
        sample("tabs", b"1\t2\t\t4\t\n\t\t\t\t\n5\t6\t7\t\t\n".to_vec()),
    ]
}

fn latin1(text: &str) -> Vec<u8> {
    text.chars().map(|character| u8::try_from(character).unwrap()).collect()
}

fn read_with(bytes: &[u8], unit: &str) -> ScanFile {
    let options = ScanOptions { fallback_unit: unit.parse().ok(), ..ScanOptions::default() };
    read_scans(bytes, "scan", &options).unwrap().remove(0)
}

#[test]
fn utf16_is_text() {
    for order in [u16::to_le_bytes, u16::to_be_bytes] {
        let file = read_with(&utf16(COUNTED, order), "m");
        assert_holds(&file.scan, (1.5e-6, None), &[Some(2.5e-6), Some(3.5e-6), Some(4.5e-6)], 1e-20);
    }
}

#[test]
fn a_flag_tells_which_points_count() {
    let file = read_with(FLAGGED.as_bytes(), "m");
    assert_holds(&file.scan, (1.5e-3, None), &[Some(106.5e-6), None, Some(107.5e-6)], 1e-18);
}

#[test]
fn a_counter_without_a_name_is_told_by_rising_positions() {
    let file = read_with(b"1 0.5 7\n2 1.0 8\n3 2.5 9\n", "um");
    assert_eq!(file.scan.positions_m().unwrap(), [0.5e-6, 1e-6, 2.5e-6]);
    // Columns of a map are none.
    let map = read_with(b"0 0 1\n1 0 2\n0 1 3\n1 1 4\n", "nm");
    assert_eq!(map.scan.points(), (2, Some(2)));
}

#[test]
fn exports_of_a_stylus_tell_its_radius() {
    let file = read_with(&latin1(STYLUS), "m");
    assert_holds(&file.scan, (0.6e-6, None), &[Some(-0.25e-6), None, Some(0.5e-6)], 1e-20);
    assert_eq!((file.probe, file.tip_radius_m), (Some(Probe::Tip), Some(2.5e-6)));
    assert!(file.free_text.contains("Stylus,Radius: 2.5 µm"), "{}", file.free_text);
}

#[test]
fn points_without_a_height_in_a_grid_are_missing() {
    let file = read_with(b"0 0 1\n2 1 6\n0 1 2\n1 0 nan\n1 1 4\n", "nm");
    let heights = [Some(1e-9), None, None, Some(2e-9), Some(4e-9), Some(6e-9)];
    assert_holds(&file.scan, (3e-9, Some(2e-9)), &heights, 1e-22);
}

#[test]
fn empty_fields_are_missing_points() {
    let size = scans::ScanSize { x_m: 4e-9, y_m: Some(3e-9) };
    let options = ScanOptions { unit: "nm".parse().ok(), size: Some(size), ..ScanOptions::default() };
    let missing = None;
    for text in [
        "1\t2\t\t4\t\n\t\t\t\t\n5\t6\t7\t\t\n",
        "1;2;;4\n;;;\n5;6;7;\n",
        ";1;2;-;4;;\n;;;;;;\n;5;6;7;BAD;;\n",
    ] {
        let file = read_scans(text.as_bytes(), "scan", &options).unwrap().remove(0);
        let heights = [1.0, 2.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 5.0, 6.0, 7.0, 0.0]
            .map(|height| if height == 0.0 { missing } else { Some(height * 1e-9) });
        assert_holds(&file.scan, (4e-9, Some(3e-9)), &heights, 1e-22);
    }
}

#[test]
fn lines_without_position_and_height_stay_in_their_place() {
    // The missing one of an even line is known; of an uneven one it says nothing.
    let even = read_with(b"0 1\n1 2\nNaN NaN\n3 1\n", "nm");
    assert_holds(&even.scan, (4e-9, None), &[Some(1e-9), Some(2e-9), None, Some(1e-9)], 1e-22);
    let uneven = read_with(b"0;1\n1;2\n;\n8;1\n;\n", "nm");
    assert_eq!(uneven.scan.positions_m().unwrap(), [0.0, 1e-9, 8e-9]);
    let end = read_with(b"0;1\n1;2\n2;1\n;\n;\n", "nm");
    assert_holds(&end.scan, (3e-9, None), &[Some(1e-9), Some(2e-9), Some(1e-9)], 1e-22);
    let message = read_scans(
        b"0;1\n;2\n3;1\n",
        "scan",
        &ScanOptions { unit: "nm".parse().ok(), ..ScanOptions::default() },
    );
    refused!(message.unwrap_err(), NotANumber { line: 2, column: 1, text: "no position" });
}

#[test]
fn maps_of_other_programs_tell_factors() {
    let map =
        |text: &str| read_scans(text.as_bytes(), "scan", &ScanOptions::default()).unwrap().remove(0).scan;
    let rows = "1 2 3 4\n5 6 7 bad\n";
    let heights = |factor: f64| [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|height| Some(height * factor));
    let expected = |factor: f64| [&heights(factor)[..], &[None]].concat();
    let spip = "# File Format = ASCII\n# x-pixels = 4\n# y-pixels = 2\n# x-length = 400\n# y-length = 100\n";
    let scaled = map(&format!("{spip}# Bit2nm = 0.5\n{rows}"));
    assert_holds(&scaled, (400e-9, Some(100e-9)), &expected(0.5e-9), 1e-22);
    // A unit leaves nothing to scale.
    let in_unit = map(&format!("{spip}# Bit2nm = 0.5\n# z-unit = um\n{rows}"));
    assert_holds(&in_unit, (400e-9, Some(100e-9)), &expected(1e-6), 1e-20);
    let attocube = "# pixel size = 0.25 um\n# height conversion factor (-> m) = 2.5e-7\n";
    assert_holds(&map(&format!("{attocube}{rows}")), (1e-6, Some(0.5e-6)), &expected(2.5e-7), 1e-20);
}
