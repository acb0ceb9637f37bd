//! Workbooks of surface testers and of people.

use crate::instruments::{Sample, assert_holds, heights};
use crate::support::zip_file::zipped;
use scans::{Probe, ScanFormat, ScanOptions, ScanReadError, ScanSize, Unitless, read_scans};

const TYPES: &str = r#"<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"></Types>"#;
const ROOT: &str = r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#;
const LINKS: &str = r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/><Relationship Id="rId2" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet2.xml"/></Relationships>"#;

fn text(place: &str, text: &str) -> String {
    format!(r#"<c r="{place}" t="inlineStr"><is><t>{text}</t></is></c>"#)
}

fn sheet(rows: &[Vec<String>]) -> String {
    let rows: String = rows
        .iter()
        .enumerate()
        .map(|(index, cells)| format!(r#"<row r="{}">{}</row>"#, index + 1, cells.concat()))
        .collect();
    format!(
        r#"<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>{rows}</sheetData></worksheet>"#
    )
}

fn workbook(
    names: [&str; 2],
    conditions: &[Vec<String>],
    result: &str,
    points: &[(Option<f64>, Option<f64>)],
) -> Vec<u8> {
    let number = |column: &str, row: usize, value: Option<f64>| {
        value.map_or(String::new(), |value| number(&format!("{column}{row}"), value))
    };
    let data: Vec<Vec<String>> = points
        .iter()
        .enumerate()
        .map(|(index, &(position, height))| {
            let row = index + 1;
            let result = if index == 0 { text("A1", result) } else { String::new() };
            vec![result, number("E", row, position), number("F", row, height)]
        })
        .collect();
    packed(names, &sheet(conditions), &sheet(&data))
}

/// A workbook with two sheets.
fn packed(names: [&str; 2], first: &str, second: &str) -> Vec<u8> {
    let index = format!(
        r#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="{}" sheetId="1" r:id="rId1"/><sheet name="{}" sheetId="2" r:id="rId2"/></sheets></workbook>"#,
        names[0], names[1]
    );
    zipped(&[
        ("[Content_Types].xml", TYPES.as_bytes()),
        ("_rels/.rels", ROOT.as_bytes()),
        ("xl/workbook.xml", index.as_bytes()),
        ("xl/_rels/workbook.xml.rels", LINKS.as_bytes()),
        ("xl/worksheets/sheet1.xml", first.as_bytes()),
        ("xl/worksheets/sheet2.xml", second.as_bytes()),
    ])
}

fn conditions() -> Vec<Vec<String>> {
    vec![
        vec![text("B1", "Comment"), text("C1", "tip 2 µm")],
        vec![text("B2", "Profile"), text("C2", "R"), text("D2", "Cut-Off"), text("E2", "0.8mm")],
    ]
}

const NAMES: [&str; 2] = ["Certificate", "DATA"];
const POINTS: [(Option<f64>, Option<f64>); 4] =
    [(Some(0.0005), Some(0.25)), (Some(0.001), Some(0.5)), (Some(0.0015), None), (Some(0.002), Some(-1.0))];

pub fn samples() -> Vec<Sample> {
    let bytes = workbook(NAMES, &conditions(), "Ra     0.018  µm      ", &POINTS);
    vec![Sample { name: "even", bytes }]
}

#[test]
fn profiles_are_read_with_the_units_of_their_results() {
    let file = &heights(&samples()[0].bytes)[0];
    assert_holds(&file.scan, (2e-6, None), &[Some(0.25e-6), Some(0.5e-6), None, Some(-1e-6)], 1e-20);
    assert_eq!(
        (file.probe, file.free_text.as_str()),
        (Some(Probe::Tip), "Comment tip 2 µm\nProfile R Cut-Off 0.8mm")
    );
}

#[test]
fn positions_may_be_uneven_and_units_asked_for() {
    let points = [(Some(0.0), Some(1.0)), (None, Some(5.0)), (Some(1.0), Some(2.0)), (Some(3.0), Some(3.0))];
    let bytes = workbook(NAMES, &[], "Ra", &points);
    let refused = read_scans(&bytes, "scan", &ScanOptions::default()).unwrap_err();
    refused!(refused, NoUnit { what: Unitless::Lengths });
    let options = ScanOptions { unit: "um".parse().ok(), ..ScanOptions::default() };
    let file = read_scans(&bytes, "scan", &options).unwrap().remove(0);
    assert_eq!(file.scan.positions_m().unwrap(), [0.0, 1e-6, 3e-6]);
    let falling =
        workbook(NAMES, &conditions(), "Ra 1 µm", &[(Some(1.0), Some(0.0)), (Some(0.5), Some(1.0))]);
    let refused = read_scans(&falling, "scan", &ScanOptions::default()).unwrap_err();
    refused!(refused, BadField { field: "a position", value: "0.5" });
}

/// A workbook with these sheets, each of rows of cells.
fn of_sheets(sheets: [(&str, &[Vec<String>]); 2]) -> Vec<u8> {
    let [(first, first_rows), (second, second_rows)] = sheets;
    packed([first, second], &sheet(first_rows), &sheet(second_rows))
}

fn number(place: &str, value: f64) -> String {
    format!(r#"<c r="{place}"><v>{value}</v></c>"#)
}

#[test]
fn two_columns_of_any_sheet_are_a_profile() {
    // Sums of spacings, as a column of formulas holds them.
    let positions: Vec<f64> = (0..400).scan(0.0, |sum, _| Some(std::mem::replace(sum, *sum + 0.1))).collect();
    let mut rows = vec![vec![text("B2", "X (mm)"), text("C2", "Z (um)")]];
    rows.extend(positions.iter().enumerate().map(|(at, &position)| {
        vec![
            number(&format!("B{}", at + 3), position),
            number(&format!("C{}", at + 3), 0.25 * (at % 7) as f64),
        ]
    }));
    let rows: Vec<Vec<String>> = std::iter::once(Vec::new()).chain(rows).collect();
    let bytes = of_sheets([("Notes", &[vec![text("A1", "a flange")]]), ("Trace", &rows)]);
    let file = heights(&bytes).remove(0);
    assert_eq!((file.format, file.channel.as_deref()), (ScanFormat::Workbook, Some("Trace")));
    assert_eq!((file.scan.points(), file.scan.height_m(3)), ((400, None), Some(0.75e-6)));
    assert!((file.scan.spacing_m().0 / 1e-4 - 1.0).abs() < 1e-9 && file.scan.positions_m().is_none());
}

#[test]
fn more_columns_are_a_matrix_whose_unit_and_size_are_asked_for() {
    let rows: Vec<Vec<String>> = (1..=3)
        .map(|y| ["A", "B", "C", "D"].map(|x| number(&format!("{x}{y}"), f64::from(y))).to_vec())
        .collect();
    let bytes = of_sheets([("Map", &rows), ("Other", &[])]);
    let refused = read_scans(&bytes, "scan", &ScanOptions::default()).unwrap_err();
    assert!(matches!(refused, ScanReadError::NoUnit { format: ScanFormat::Workbook, .. }), "{refused}");
    let size = Some(ScanSize { x_m: 4e-6, y_m: None });
    let options =
        ScanOptions { fallback_unit: "nm".parse().ok(), fallback_size: size, ..ScanOptions::default() };
    let file = read_scans(&bytes, "scan", &options).unwrap().remove(0);
    assert_eq!((file.scan.points(), file.scan.height_m(11)), ((4, Some(3)), Some(3e-9)));
}

#[test]
fn a_workbook_without_numbers_and_one_that_swells_are_refused() {
    let words = of_sheets([("Notes", &[vec![text("A1", "a flange")]]), ("Other", &[])]);
    assert!(matches!(read_scans(&words, "scan", &ScanOptions::default()), Err(ScanReadError::NoRows)));
    let bounded = ScanOptions { max_unpacked_bytes: Some(100), ..ScanOptions::default() };
    let refused = read_scans(&samples()[0].bytes, "scan", &bounded).unwrap_err();
    refused!(refused, ArchiveTooLarge { what: "'_rels/.rels'", bound: 100 });
    let far = of_sheets([("Map", &[vec![number("A1", 1.0), number("XFD1000000", 2.0)]]), ("Other", &[])]);
    assert!(read_scans(&far, "scan", &ScanOptions::default()).is_err());
}
