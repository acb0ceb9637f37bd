//! The tables that the repository keeps are those that the programme makes.

use std::path::{Path, PathBuf};

use model_trials::elements::{self, ElementsRow};
use model_trials::programme::programme;
use model_trials::ratios;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/guide/which-model").join(name)
}

fn committed() -> Vec<ElementsRow> {
    elements::read(&std::fs::read(file("elements.csv")).unwrap()[..]).unwrap()
}

#[test]
fn every_trial_of_the_programme_has_been_pressed_and_no_other() {
    let table = committed();
    let rows: usize = programme()
        .iter()
        .map(|trial| elements::known(&table, trial).unwrap_or_else(|| panic!("{:?}", trial.band)).len())
        .sum();
    assert_eq!(rows, table.len());
}

#[test]
fn a_trial_pressed_again_gives_the_committed_areas() {
    // The quickest one.
    let trial = &programme()[0];
    let table = committed();
    let rows = elements::rows_of(trial).unwrap();
    for (committed, again) in elements::known(&table, trial).unwrap().into_iter().zip(&rows) {
        assert!((committed.area_fraction / again.area_fraction - 1.0).abs() < 1e-3, "{committed:?}");
    }
}

#[test]
fn the_committed_ratios_are_what_the_models_give() {
    let table = committed();
    let band = table[0].band();
    let of_band: Vec<ElementsRow> = table.into_iter().filter(|row| row.band() == band).collect();
    let rows = ratios::rows(&of_band).unwrap();
    let mut reader = csv::Reader::from_path(file("ratios.csv")).unwrap();
    let committed: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().unwrap();
    assert!(committed.len() > rows.len());
    for row in &rows {
        let ratio: f64 = committed
            .iter()
            .find(|record| {
                record[7] == row.model
                    && record[5].parse() == Ok(row.pressure_over_gradient)
                    && record[3].parse() == Ok(row.last_wave)
                    && record[1].parse() == Ok(row.first_wave)
            })
            .unwrap_or_else(|| panic!("{row:?}"))[10]
            .parse()
            .unwrap();
        assert!((ratio / row.ratio - 1.0).abs() < 1e-3, "{row:?}");
    }
}
