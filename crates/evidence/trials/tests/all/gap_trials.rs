//! Gap and stiffness of the committed trials: those of elements pressed again, and near to the theory.

use std::path::Path;

use persson::separation::{LIGHT_CONTACT, STIFFNESS_WITHIN};
use trials::elements;
use trials::gap_trials::{GapRow, LIGHT_LOADS, rows_under, trials};
use trials::judge_spectra::{JudgeTrial, Set};

fn committed() -> Vec<GapRow> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop/trials/gap.csv");
    elements::read(&std::fs::read(file).unwrap()[..]).unwrap()
}

#[test]
fn a_spectrum_pressed_again_gives_the_committed_rows() {
    let rows = committed();
    let trial = trials()[6];
    let again = rows_under(&trial, &LIGHT_LOADS[3..4]).unwrap();
    let is_same = |row: &&GapRow| {
        row.number == trial.number && row.pressure_over_gradient == again[0].pressure_over_gradient
    };
    let (again, known) = (again[0], rows.iter().find(is_same).unwrap());
    assert_eq!((again.kind, again.number), (known.kind, known.number));
    for (value, expected) in [
        (again.area_fraction, known.area_fraction),
        (again.gap_over_rms_height, known.gap_over_rms_height),
        (again.relative_stiffness, known.relative_stiffness),
        (again.gap_2d, known.gap_2d),
        (again.stiffness_2d, known.stiffness_2d),
        (again.gap_1d, known.gap_1d),
        (again.stiffness_1d, known.stiffness_1d),
        (again.gap_fitted, known.gap_fitted),
        (again.stiffness_fitted, known.stiffness_fitted),
    ] {
        assert!((value / expected - 1.0).abs() < 1e-3, "{again:?} {known:?}");
    }
}

#[test]
fn stiffness_and_gap_by_the_waves_of_the_surface_are_near_to_the_elements() {
    let rows = committed();
    let moderate: Vec<&GapRow> = rows.iter().filter(|row| row.area_fraction > LIGHT_CONTACT).collect();
    let rms = |ratio: fn(&GapRow) -> f64| {
        let squares: f64 = moderate.iter().map(|row| ratio(row).ln().powi(2)).sum();
        (squares / moderate.len() as f64).sqrt()
    };
    assert!(rms(|row| row.stiffness_2d) < 0.095 && rms(|row| row.gap_2d) < 0.06);
    assert!(rms(|row| row.stiffness_1d) > 0.25 && rms(|row| row.gap_1d) > 0.25);
    assert!(moderate.iter().all(|row| (0.78..1.16).contains(&row.stiffness_2d)));
    // The lowest, 0.869, lies near half of the area. The fitted energy brings it in.
    assert!(moderate.iter().all(|row| (0.86..1.15).contains(&row.gap_2d)));
    assert!(moderate.iter().all(|row| (0.78..1.16).contains(&row.stiffness_fitted)));
    assert!(moderate.iter().all(|row| (0.87..1.15).contains(&row.gap_fitted)));
    assert!(rms(|row| row.stiffness_fitted) < 0.08 && rms(|row| row.gap_fitted) < 0.051);
    // One of 54 is known to 3.2 %, by 24 surfaces.
    assert!(moderate.iter().all(|row| row.gap_error <= 0.03 && row.stiffness_error <= 0.032));
}

/// Below a thousandth a few summits of a finite surface carry the load.
#[test]
fn the_stated_range_of_the_stiffness_under_light_loads_holds_elements_of_nine_in_ten_spectra() {
    let rows = committed();
    let light = |row: &&GapRow| (1e-3..0.01).contains(&row.area_fraction);
    let range = 1.0 / STIFFNESS_WITHIN..=STIFFNESS_WITHIN;
    assert!(range.end() / range.start() <= 1.6);
    let held = |trial: &&JudgeTrial| {
        let mut of_trial = rows.iter().filter(light).filter(|row| row.number == trial.number);
        of_trial.all(|row| range.contains(&row.stiffness_2d))
    };
    for set in [Set::Calibration, Set::Report] {
        let all: Vec<JudgeTrial> = trials().into_iter().filter(|trial| trial.set == set).collect();
        assert_eq!(all.len(), 24);
        assert!(all.iter().filter(held).count() >= 22, "{set:?}");
    }
    assert!(rows.iter().filter(light).all(|row| (0.8..1.15).contains(&row.gap_2d)));
}
