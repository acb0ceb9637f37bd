//! The committed trials of gap and stiffness after yielding.

use std::path::Path;

use csv::Reader;
use trials::judge_spectra::Set;
use trials::yielding_trials::{YieldingRow, YieldingTrial, trials};

fn committed() -> Vec<YieldingRow> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop/trials/yielding.csv");
    Reader::from_path(path).unwrap().deserialize().collect::<Result<_, _>>().unwrap()
}

fn of(trial: &YieldingTrial, rows: &[YieldingRow]) -> Vec<YieldingRow> {
    rows.iter().filter(|row| row.spectrum() == trial.spectrum()).copied().collect()
}

#[test]
fn the_closed_form_stays_near_elements_that_flow_on_spectra_that_chose_nothing() {
    let rows = committed();
    let reported: Vec<YieldingRow> = trials(Set::Report)
        .iter()
        .flat_map(|trial| {
            let known = of(trial, &rows);
            let again = trial.beside(&known).unwrap();
            assert_eq!(known.len(), 12, "{trial:?}");
            for (known, again) in known.iter().zip(&again) {
                assert!((again.gap / known.gap - 1.0).abs() < 1e-3, "{known:?} {again:?}");
                assert!((again.stiffness / known.stiffness - 1.0).abs() < 1e-3, "{known:?} {again:?}");
            }
            again
        })
        .collect();
    for (value, rms, worst) in
        [((|row| row.stiffness) as fn(&YieldingRow) -> f64, 0.13, 0.30), (|row| row.gap, 0.07, 0.22)]
    {
        let logs: Vec<f64> = reported.iter().map(|row| value(row).ln()).collect();
        let root = (logs.iter().map(|ln| ln * ln).sum::<f64>() / logs.len() as f64).sqrt();
        let largest = logs.iter().fold(0.0f64, |largest, ln| largest.max(ln.abs()));
        assert!(root < rms && largest < worst, "{root} {largest}");
    }
}
