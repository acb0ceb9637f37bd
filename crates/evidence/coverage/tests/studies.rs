//! Few studies, in seconds; `cargo xtask coverage` carries out many.

use coverage::{
    AFM, INSTRUMENTS, KnownSurface, Laboratory, STYLUS, biases, coverages, known_composite, shrinkages,
    trials,
};
use study::Unobserved;
use topography::Average;
use uncertainty::{Guess, Settings, UncertaintyPlan};

const FEW: Settings = Settings { draws: 100, level: 0.95, seed: 1, shares_draws: None };

#[test]
fn intervals_hold_the_truth() {
    let laboratory = Laboratory::new(0.8, 7).unwrap();
    let trials = trials(&laboratory, 24, &[5, 5], &FEW).unwrap();
    let found = coverages(&trials);
    assert_eq!(found.len(), 16);
    for area in &found {
        // Of 24 intervals of 95 %, fewer than 19 hold the truth once in a thousand times.
        assert!(area.held >= 19, "{area:?}");
        // The deviations of 24 studies know their root mean square to a sixth.
        assert!((0.5..2.5).contains(&area.relative_width()), "{area:?}");
    }
}

#[test]
fn means_of_logarithms_without_bias_have_none() {
    let laboratory = Laboratory::new(0.8, 7).unwrap();
    let averages = [Average::Log, Average::LogUnbiased];
    let rows = biases(&laboratory, 400, 0, 5, &averages).unwrap();
    assert_eq!(rows.len(), 6);
    for row in rows {
        let bound = 0.02 + 3.0 * row.standard_error;
        match row.average {
            Average::LogUnbiased => assert!(row.of_expected.abs() < bound, "{row:?}"),
            // Half of it is missing at the long end, where a bin holds a wave or two.
            _ => assert!(row.decade < -3 || row.of_expected < -0.4, "{row:?}"),
        }
    }
}

#[test]
fn scans_show_the_spectrum_that_they_are_made_with() {
    let laboratory = Laboratory::new(0.5, 3).unwrap();
    for (place, instrument) in INSTRUMENTS.into_iter().enumerate() {
        let rows = biases(&laboratory, 40, place, 3, &[Average::Arithmetic]).unwrap();
        // Windows and trends lift the first bins of a steep spectrum; the last decade is free of them.
        let last = rows.last().unwrap();
        assert_eq!(last.instrument, instrument);
        assert!(last.of_known.abs() < 0.03 + 3.0 * last.standard_error, "{last:?}");
    }
}

#[test]
fn studies_are_the_same_again_and_grow_by_scans() {
    let laboratory = Laboratory::new(0.8, 1).unwrap();
    let (few, more) = (laboratory.study(3, &[2, 2]).unwrap(), laboratory.study(3, &[2, 3]).unwrap());
    assert_eq!((few.scans.len(), more.scans.len()), (4, 5));
    assert!(few.files.iter().all(|(name, bytes)| more.files[name] == *bytes));
    assert_ne!(laboratory.study(4, &[1, 1]).unwrap().files["AFM-1.npy"], few.files["AFM-1.npy"]);
}

#[test]
fn the_known_composite_has_the_bins_of_the_measured_one() {
    let laboratory = Laboratory::new(0.95, 1).unwrap();
    let measured = laboratory.study(0, &[2, 2]).unwrap().composite().unwrap();
    let known = known_composite(&laboratory.surface, &measured).unwrap();
    let wavelengths_m: Vec<f64> = measured.composite.bins().iter().map(|bin| bin.wavelength_m).collect();
    assert_eq!(known.wavelengths_m(), wavelengths_m);
}

#[test]
fn more_scans_are_predicted_to_shrink_intervals_and_do() {
    let laboratory = Laboratory::new(0.8, 1).unwrap();
    let rows = shrinkages(&laboratory, 2, 4, &[10], &FEW).unwrap();
    let of_lines: Vec<_> =
        rows.iter().filter(|row| row.instrument == STYLUS.name && row.curve == "hertz").collect();
    assert!(!of_lines.is_empty());
    for row in of_lines {
        assert!(row.predicted < 1.0 && row.real < 1.05, "{row:?}");
    }
}

#[test]
fn two_scans_of_an_instrument_are_a_guess_and_three_are_not() {
    for (instrument, hurst_exponent) in [(STYLUS, 0.3), (STYLUS, 0.8), (AFM, 0.8)] {
        let surface = KnownSurface::new(hurst_exponent, 2.0 * AFM.spacing_m()).unwrap();
        let laboratory = Laboratory::of_surface(surface, &[instrument], 3).unwrap();
        for scans in [2, 3] {
            let scene = laboratory.study(0, &[scans]).unwrap().scene().unwrap();
            let results = scene.plan().compute().unwrap();
            let settings = Settings { draws: 20, ..Settings::default() };
            let found = UncertaintyPlan::new(&scene, &results, &settings).unwrap().run(&Unobserved).unwrap();
            let is_guess = found.guesses.iter().any(|guess| matches!(guess, Guess::FewScans { .. }));
            assert_eq!(is_guess, scans == 2, "{} {scans}", instrument.name);
        }
    }
}
