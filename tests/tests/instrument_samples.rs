//! Real files of instruments in the shared folder beside the checkout, held against what SurfaceTopography 1.27.1
//! reads of them (MIT licence; its test files are not committed).

use std::collections::BTreeMap;

use measurements::{Files, ScanRequest, read_channels};
use tables::{Cells, Table};
use tests::shared_file;
use topography::{HeightParameters, ParameterValue};

/// The files of the folder of samples, by their names.
struct Samples;

impl Files for Samples {
    fn read(&self, name: &str) -> std::io::Result<Vec<u8>> {
        std::fs::read(shared_file("data/instruments").join(name))
    }

    fn read_beside(&self, _: &str, _: &str) -> std::io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// Facts that the peer knows and the file lacks: a unit, a size.
const TOLD: [(&str, &str); 2] = [("xyz-1.txt", ":unit=um"), ("xy-3.txt", ":unit=um")];

/// The cells of a column, as text.
fn cells(table: &Table, column: &str) -> Vec<String> {
    match table.column(column) {
        Some(Cells::Typed(cells)) => cells.iter().map(|cell| cell.text().into_owned()).collect(),
        Some(Cells::Numbers(numbers)) => {
            numbers.iter().map(|number| number.map_or(String::new(), |number| number.to_string())).collect()
        }
        _ => panic!("there is no column {column}"),
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn every_expected_row_is_read_as_the_peer_reads_it() {
    let expected = std::fs::read(shared_file("data/instruments/expected.csv")).unwrap();
    let mut reader = csv::Reader::from_reader(&expected[..]);
    let rows: Vec<BTreeMap<String, String>> = reader.deserialize().map(Result::unwrap).collect();
    let mut wrong = Vec::new();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for row in &rows {
        let file = &row["file"];
        // The rows of a file stand in the order of its channels.
        let nth = *seen.entry(file.clone()).and_modify(|nth| *nth += 1).or_insert(0);
        let told = TOLD.iter().find(|(name, _)| name == file).map_or("", |(_, told)| told);
        let request: ScanRequest = format!("{file}{told}").parse().unwrap();
        let all_channels = file.ends_with(".ibw");
        let found = read_channels::<()>(&[request], &Samples, all_channels, |_, _| Ok(())).unwrap();
        if let Some(error) = found.unreadable.first() {
            wrong.push(format!("{file}: {error}"));
            continue;
        }
        let table = found.table();
        if nth >= table.rows() {
            wrong.push(format!("{file}: {} channels, and a further one is expected", table.rows()));
            continue;
        }
        for (column, tolerance) in [
            ("points_x", 0.0),
            ("points_y", 0.0),
            ("gaps", 0.0),
            ("size_x_m", 1e-6),
            ("size_y_m", 1e-6),
            ("rms_height_m", 1e-6),
            ("peak_to_valley_m", 1e-6),
        ] {
            let [found, expected] = [&cells(&table, column)[nth], &row[column]];
            let agrees = match (found.parse::<f64>(), expected.parse::<f64>()) {
                (Ok(found), Ok(expected)) => (found - expected).abs() <= tolerance * expected.abs(),
                _ => found == expected,
            };
            if !agrees {
                wrong.push(format!("{file}, channel {}, {column}: {found}, expected {expected}", nth + 1));
            }
        }
    }
    assert_eq!(rows.len(), 29);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "needs the shared folder"]
fn height_parameters_equal_those_of_an_independent_program() {
    let reference = std::fs::read(shared_file("reference/roughness.csv")).unwrap();
    let mut compared = 0;
    for row in csv::Reader::from_reader(&reference[..]).deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        if row["treatment"] != "plane" {
            continue;
        }
        let bytes = Samples.read(&row["file"]).unwrap();
        let mut files = scans::read_scans(&bytes, &row["file"], &scans::ScanOptions::default()).unwrap();
        let found = HeightParameters::from_scan(&files.swap_remove(0).scan).unwrap();
        let Some(parameter) = found.parameters().into_iter().find(|found| found.symbol == row["parameter"])
        else {
            continue;
        };
        let (ParameterValue::LengthM(value) | ParameterValue::Number(value)) = parameter.value;
        let scale = if row["unit"] == "um" { 1e6 } else { 1.0 };
        let [expected, tolerance] = ["own", "tolerance"].map(|column| row[column].parse::<f64>().unwrap());
        // The reference fits its plane to heights of a micrometre on an offset of 76 mm in this file, which costs it two
        // digits. Ssk is the small rest of cubes of both signs, so that its rounding is relative to a skewness of one.
        let tolerance = if row["file"] == "al3d-1.al3d" { 5e-9 } else { tolerance };
        let size = if row["parameter"] == "Ssk" { 1.0 } else { expected };
        approx::assert_abs_diff_eq!(value * scale, expected, epsilon = tolerance * size);
        compared += 1;
    }
    assert_eq!(compared, 14);
}
