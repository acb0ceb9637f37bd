//! The tables that the repository keeps are those that the programme makes.

use std::path::{Path, PathBuf};

use trials::elements::{self, ElementsRow};
use trials::pressing;
use trials::programme::programme;
use trials::ratios::{self, RatioRow};
use trials::sections;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop/trials").join(name)
}

fn committed() -> Vec<ElementsRow> {
    elements::read(&std::fs::read(file("elements.csv")).unwrap()[..]).unwrap()
}

fn committed_ratios() -> Vec<RatioRow> {
    elements::read(&std::fs::read(file("ratios.csv")).unwrap()[..]).unwrap()
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
    let rows = pressing::rows_of(trial).unwrap();
    for (committed, again) in elements::known(&table, trial).unwrap().into_iter().zip(&rows) {
        assert!((committed.area_fraction / again.area_fraction - 1.0).abs() < 1e-3, "{committed:?}");
    }
}

#[test]
fn the_committed_ratios_are_what_the_models_give() {
    let table = committed();
    let band = table[0].band();
    let of_band: Vec<ElementsRow> = table.into_iter().filter(|row| row.band() == band).collect();
    let again = ratios::rows(&of_band).unwrap();
    let rows = committed_ratios();
    assert!(rows.len() > again.len());
    for (row, again) in rows.iter().zip(&again) {
        let place = |row: &RatioRow| {
            (row.model.clone(), row.first_wave, row.pressure_over_gradient, row.spread_over_hardness)
        };
        assert_eq!(place(row), place(again));
        assert!((row.ratio / again.ratio - 1.0).abs() < 1e-3, "{row:?}");
    }
}

#[test]
fn the_tables_of_the_page_are_those_of_the_committed_ratios() {
    let page = std::fs::read_to_string(file("../../guide/which-model.md")).unwrap();
    assert_eq!(sections::written(&page, &committed(), &committed_ratios()).unwrap(), page);
}
