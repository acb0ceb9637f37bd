//! Both limits of flatness against elements, by the table that is kept.

use std::path::{Path, PathBuf};

use trials::elements;
use trials::flatness_trials::{FlatnessRow, trials, written};
use trials::judge_spectra::Set;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop").join(name)
}

fn rows() -> Vec<FlatnessRow> {
    elements::read(&std::fs::read(file("trials/flatness.csv")).unwrap()[..]).unwrap()
}

#[test]
fn the_page_has_the_table_of_the_rows() {
    let page = std::fs::read_to_string(file("trials.md")).unwrap();
    assert_eq!(written(&page, &rows()).unwrap(), page);
}

#[test]
fn elements_lie_in_the_range_on_nine_of_ten_surfaces_with_a_long_wave() {
    let rows = rows();
    let of_set = |set: Set| -> Vec<&FlatnessRow> {
        let trials = trials(set);
        assert_eq!(trials.len(), 12);
        rows.iter().filter(|row| trials.iter().any(|trial| row.is_of(trial))).collect()
    };
    assert_eq!(of_set(Set::Calibration).len() + of_set(Set::Report).len(), rows.len());
    let reported = of_set(Set::Report);
    let inside = reported.iter().filter(|row| row.is_inside()).count();
    assert!(10 * inside >= 9 * reported.len(), "{inside} of {}", reported.len());
}

#[test]
fn a_row_that_is_made_anew_has_the_limits_of_today() {
    let trial = trials(Set::Report)[0];
    let kept: Vec<FlatnessRow> = rows().into_iter().filter(|row| row.is_of(&trial)).collect();
    assert_eq!(trial.beside(&kept).unwrap(), kept);
}
