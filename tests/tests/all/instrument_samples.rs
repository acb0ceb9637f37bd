//! Real files of instruments in the shared folder beside the checkout, held against what SurfaceTopography 1.27.1
//! reads of them (MIT licence; its test files are not committed).

use std::collections::BTreeMap;

use measurements::{Conventions, Files, RoughnessOfFiles, RoughnessSettings, ScanRequest, read_channels};
use roughness::Evaluation;
use tables::{Cells, Table};
use tests::shared_file;

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
fn roughness_parameters_equal_those_of_an_independent_program() {
    let reference = std::fs::read(shared_file("reference/roughness.csv")).unwrap();
    let mut found: BTreeMap<(String, String), Table> = BTreeMap::new();
    let (mut compared, mut wrong) = (0, Vec::new());
    for row in csv::Reader::from_reader(&reference[..]).deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let (file, treatment) = (row["file"].clone(), row["treatment"].clone());
        let cutoff = [("18 um", 18e-6), (" 4 um", 4e-6), ("800 um", 800e-6)];
        let cutoff = cutoff.into_iter().find(|(words, _)| treatment.contains(words));
        let table = found.entry((file.clone(), treatment)).or_insert_with(|| {
            let settings = RoughnessSettings {
                evaluation: Evaluation {
                    longest_m: cutoff.map(|(_, cutoff_m)| cutoff_m),
                    ..Evaluation::default()
                },
                conventions: Conventions::All,
                ..RoughnessSettings::default()
            };
            let found = RoughnessOfFiles::read(&[file.parse().unwrap()], &Samples, &settings);
            assert!(found.unreadable.is_empty(), "{:?}", found.unreadable);
            found.table()
        });
        let [symbols, conventions, units, values] =
            ["parameter", "convention", "unit", "value"].map(|of| cells(table, of));
        let convention = row["convention"].split(';').next().unwrap();
        let is_that = |at: &usize| {
            symbols[*at] == row["parameter"]
                && (conventions[*at] == convention || ["", "5 sections"].contains(&convention))
        };
        let at = (0..symbols.len()).find(is_that).unwrap_or_else(|| panic!("{row:?} is missing"));
        assert_eq!(units[at], row["unit"], "{row:?}");
        let [value, own] = [&values[at], &row["own"]].map(|text| text.parse::<f64>().unwrap());
        // The reference fits its plane to heights of a micrometre on an offset of 76 mm in one file, which costs it two
        // digits, takes 10,000 points of the material ratio, and splines through the autocorrelation. Ssk is the small
        // rest of cubes of both signs, so that its rounding is relative to a skewness of one.
        let tolerance = match row["parameter"].as_str() {
            "Sal" | "Str" => 0.004,
            "Sk" | "Spk" | "Svk" | "Smr1" | "Smr2" | "Vmp" | "Vmc" | "Vvc" | "Vvv" => 1e-5,
            "Rk" | "Rpk" | "Rvk" | "Rmr1" | "Rmr2" => 1e-5,
            _ if file == "al3d-1.al3d" => 5e-9,
            _ => 1e-9,
        };
        let size = if row["parameter"].ends_with("sk") { own.abs().max(1.0) } else { own.abs() };
        if (value - own).abs() > tolerance * size {
            wrong.push(format!("{row:?}: {value}"));
        }
        compared += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(compared, 113);
}
