//! The judge gives the areas of the committed trials, close to those of whole bands solved at once.

use std::path::Path;

use serde::de::DeserializeOwned;
use trials::elements;
use trials::judge_spectra::{Set, trials};
use trials::judge_trials::JudgedRow;
use trials::judge_truth::TruthRow;

fn committed<R: DeserializeOwned>(name: &str) -> Vec<R> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop/trials");
    elements::read(&std::fs::read(folder.join(name)).unwrap()[..]).unwrap()
}

#[test]
fn one_trial_of_every_kind_gives_the_committed_areas() {
    let truth: Vec<TruthRow> = committed("judge-truth.csv");
    let rows: Vec<JudgedRow> = committed("judge.csv");
    for trial in trials(Set::Report).iter().step_by(5) {
        let judged = trial.judged(&truth).unwrap();
        let known: Vec<&JudgedRow> = rows.iter().filter(|row| row.number == trial.number).collect();
        assert_eq!((judged.len(), judged.is_empty()), (known.len(), false), "{trial:?}");
        for (again, row) in judged.iter().zip(known) {
            assert!((again.judge / row.judge - 1.0).abs() < 1e-3, "{row:?}");
            assert_eq!((again.agrees, again.holds), (row.agrees, row.holds), "{row:?}");
            assert!(again.judge.ln().abs() < 0.12 + 3.0 * row.truth_error, "{row:?}");
        }
    }
}

#[test]
fn every_trial_has_a_truth() {
    let truth: Vec<TruthRow> = committed("judge-truth.csv");
    for trial in [Set::Calibration, Set::Report].into_iter().flat_map(trials) {
        assert_eq!(truth.iter().filter(|row| row.number == trial.number).count(), 3, "{trial:?}");
    }
}
