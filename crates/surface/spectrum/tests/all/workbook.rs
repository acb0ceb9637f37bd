//! Workbooks of Excel, made here cell by cell.
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::io::{Cursor, Write};

use spectrum::{Convention, ReadError, ReadOptions, SeriesName, read_psd, series_names};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A sheet: its name, and cells with their address.
type Sheet<'s> = (&'s str, Vec<(String, &'s str)>);

/// A workbook with text and numbers in its cells.
fn workbook(sheets: &[Sheet<'_>]) -> Vec<u8> {
    let types = "http://schemas.openxmlformats.org/package/2006/relationships";
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let mut entries = String::new();
    let mut relations = String::new();
    let mut files = Vec::new();
    for (i, (name, cells)) in sheets.iter().enumerate() {
        write!(entries, "<sheet name=\"{name}\" sheetId=\"{0}\" r:id=\"rId{0}\"/>", i + 1).unwrap();
        write!(
            relations,
            "<Relationship Id=\"rId{0}\" Type=\"{office}/worksheet\" Target=\"worksheets/sheet{0}.xml\"/>",
            i + 1
        )
        .unwrap();
        let mut data = String::new();
        for (address, text) in cells {
            let row = address.trim_start_matches(|letter: char| letter.is_ascii_alphabetic());
            let cell = match text.parse::<f64>() {
                Ok(_) => format!("<c r=\"{address}\"><v>{text}</v></c>"),
                Err(_) => format!("<c r=\"{address}\" t=\"inlineStr\"><is><t>{text}</t></is></c>"),
            };
            write!(data, "<row r=\"{row}\">{cell}</row>").unwrap();
        }
        let sheet = format!("<worksheet xmlns=\"{main}\"><sheetData>{data}</sheetData></worksheet>");
        files.push((format!("xl/worksheets/sheet{}.xml", i + 1), sheet));
    }
    let book =
        format!("<workbook xmlns=\"{main}\" xmlns:r=\"{office}\"><sheets>{entries}</sheets></workbook>");
    files.push(("xl/workbook.xml".to_owned(), book));
    let relationships = |inner: &str| format!("<Relationships xmlns=\"{types}\">{inner}</Relationships>");
    files.push(("xl/_rels/workbook.xml.rels".to_owned(), relationships(&relations)));
    let root =
        format!("<Relationship Id=\"rId1\" Type=\"{office}/officeDocument\" Target=\"xl/workbook.xml\"/>");
    files.push(("_rels/.rels".to_owned(), relationships(&root)));
    archive(files.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))
}

fn archive<'f>(files: impl Iterator<Item = (&'f str, &'f [u8])>) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, bytes) in files {
        archive.start_file(name, options).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// A sheet as contact.engineering writes it, with its header in any row.
fn sheet<'s>(
    name: &'s str,
    about: &[(&'s str, &'s str)],
    header_row: usize,
    table: &[[&'s str; 3]],
) -> Sheet<'s> {
    let mut cells = Vec::new();
    for (row, (key, value)) in about.iter().enumerate() {
        cells.push((format!("A{}", row + 1), *key));
        cells.push((format!("B{}", row + 1), *value));
    }
    for (row, fields) in table.iter().enumerate() {
        for (column, text) in ["B", "C", "D"].iter().zip(fields).filter(|(_, text)| !text.is_empty()) {
            cells.push((format!("{column}{}", header_row + row), *text));
        }
        if row > 0 {
            cells.push((format!("A{}", header_row + row), "0"));
        }
    }
    (name, cells)
}

const MICRO: [&str; 3] = ["Wavevector (µm⁻¹)", "PSD (µm³)", ""];
const SI: [&str; 3] = ["Wavevector (1/m)", "PSD (m³)", "standard error of PSD (m³)"];

fn of<'s>(subject_type: &'s str, subject: &'s str, series: &'s str) -> [(&'s str, &'s str); 4] {
    [("Function name", "PSD"), ("Subject", subject), ("Subject type", subject_type), ("Data series", series)]
}

fn refusal(bytes: &[u8]) -> String {
    read_psd(bytes, &ReadOptions::default()).unwrap_err().to_string()
}

#[test]
fn the_header_stands_in_any_row_and_its_units_count() {
    let about = of("measurement", "scan 1", "1D PSD along x");
    let table = [MICRO, ["1", "0.005", ""], ["2", "1.3014851047376978e-35", ""], ["4", "", ""]];
    for header_row in [6, 10] {
        let bytes = workbook(&[sheet("analysis-0-series-0", &about, header_row, &table)]);
        let file = read_psd(&bytes[..], &ReadOptions::default()).unwrap();
        assert_eq!(file.psd.wavelengths_m(), [TAU / 1e6, TAU / 2e6]);
        assert_eq!(file.psd.values(), [5e-21, 1.301485104737698e-53]);
        assert_eq!(file.psd.convention(), Convention::C1D);
        assert_eq!(file.comments[1..3], ["Subject: scan 1", "Subject type: measurement"]);
        assert_eq!(file.notes[1], "1 row without a value is left out");
    }
}

#[test]
fn every_sheet_with_a_table_is_a_series() {
    let information = ("INFORMATION", vec![("A1".to_owned(), "Property"), ("B1".to_owned(), "Value")]);
    let one = of("measurement", "scan 1", "1D PSD along x");
    let other = of("measurement", "scan 1", "1D PSD along y");
    let average = of("surface", "the dataset", "1D PSD along x");
    let table = |value| [SI, ["1e6", value, "1e-22"], ["2e6", "1e-21", ""]];
    let bytes = workbook(&[
        information,
        sheet("analysis-0-series-0", &one, 10, &table("2e-21")),
        sheet("analysis-0-series-1", &other, 10, &table("3e-21")),
        sheet("analysis-1-series-0", &average, 10, &table("4e-21")),
    ]);
    let names = series_names(&bytes[..]).unwrap();
    assert_eq!(
        names.iter().map(SeriesName::to_string).collect::<Vec<_>>(),
        ["scan 1 - 1D PSD along x", "scan 1 - 1D PSD along y", "the dataset - 1D PSD along x"]
    );
    let file = read_psd(&bytes[..], &ReadOptions::default()).unwrap();
    assert_eq!(file.psd.values(), [4e-21, 1e-21]);
    assert_eq!(file.psd.standard_errors(), Some(&[Some(1e-22), None][..]));
    let y = ReadOptions { series: Some("1D PSD along y".into()), ..ReadOptions::default() };
    assert_eq!(read_psd(&bytes[..], &y).unwrap().psd.values(), [3e-21, 1e-21]);
}

#[test]
fn what_is_wrong_in_a_sheet_is_told_with_sheet_and_row() {
    let about = of("measurement", "scan 1", "1D PSD along x");
    let table = [SI, ["1e6", "0", ""], ["2e6", "1e-21", ""]];
    let error =
        read_psd(&workbook(&[sheet("mine", &about, 7, &table)])[..], &ReadOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "sheet 'mine', line 8: column 'PSD (m³)' is '0'; it must be finite and above 0: correct it or remove the row"
    );
    assert_eq!(error.line(), Some(8));
    let own = [["Wavevector (1/m)", "PSD (m³)", ""], ["1e6", "", ""], ["2e6", "1e-21", ""]];
    assert_eq!(
        refusal(&workbook(&[sheet("mine", &[], 1, &own)])),
        "sheet 'mine', line 2: column 'PSD (m³)' is empty; enter a number above 0 or remove the row"
    );
}

#[test]
fn archives_that_are_no_workbook_are_refused() {
    let bytes = workbook(&[("notes", vec![("A1".to_owned(), "nothing")]), ("more", vec![])]);
    assert_eq!(
        refusal(&bytes),
        "reading the workbook: no sheet has a row that names an abscissa (wavelength, wavevector or frequency) and a \
         spectrum (c1d, psd or ciso); the sheets are 'notes', 'more'"
    );
    for length in [30, bytes.len() / 2, bytes.len() - 30] {
        let error = read_psd(&bytes[..length], &ReadOptions::default()).unwrap_err();
        assert!(matches!(error, ReadError::Workbook(_)));
        assert!(error.to_string().starts_with("reading the workbook: "), "{error}");
        assert!(error.to_string().ends_with("; save or export it again, or as CSV"), "{error}");
        assert_eq!(error.line(), None);
    }
    assert_eq!(
        refusal(&archive([("meta.yml", &b"a: 1"[..])].into_iter())),
        "reading the workbook: the file is a ZIP archive without a workbook; unpack it and give one of \
         its files"
    );
}

#[test]
fn a_workbook_that_swells_is_refused_before_it_is_parsed() {
    let zeros = vec![b' '; 129 << 20];
    let bytes =
        archive([("xl/workbook.xml", &b"<workbook/>"[..]), ("xl/sharedStrings.xml", &zeros)].into_iter());
    assert!(bytes.len() < 1 << 20);
    assert_eq!(
        refusal(&bytes),
        "reading the workbook: unpacked, it exceeds 128 MiB; export the series as CSV, which has no limit"
    );
}

#[test]
fn a_lone_cell_far_away_takes_no_memory() {
    let about = of("measurement", "scan 1", "1D PSD along x");
    let table = [SI, ["1e6", "2e-21", ""], ["2e6", "1e-21", ""]];
    let (name, mut cells) = sheet("mine", &about, 7, &table);
    cells.push(("XFD1048576".to_owned(), "1"));
    let file = read_psd(&workbook(&[(name, cells)])[..], &ReadOptions::default()).unwrap();
    assert_eq!(file.psd.len(), 2);
}
