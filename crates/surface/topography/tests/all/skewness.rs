//! Traces whose heights are skewed are told from Gaussian ones.

use scans::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use topography::{Detrend, clear_skewness};

use crate::transform_support::{Random, periodic_profile_m};

const SPACING_M: f64 = 1e-8;
const POINTS: usize = 8192;

fn gaussian_m(seed: u64) -> Vec<f64> {
    periodic_profile_m(POINTS, SPACING_M, &mut Random(seed))
}

/// Heights with their peaks worn off at the median: plateaus over valleys.
fn worn_m(heights_m: &[f64]) -> Vec<f64> {
    let mut sorted = heights_m.to_vec();
    sorted.sort_by(f64::total_cmp);
    heights_m.iter().map(|height_m| height_m.min(sorted[POINTS / 2])).collect()
}

fn skewness(heights_m: Vec<f64>) -> Option<f64> {
    let line = UniformLineScan::new(SPACING_M, heights_m).expect("a line");
    clear_skewness(&Scan::UniformLine(line), Detrend::Plane)
}

#[test]
fn gaussian_traces_are_not_skewed_and_few_waves_prove_nothing() {
    assert_eq!((0..200).filter(|&seed| skewness(gaussian_m(seed)).is_some()).count(), 0);
    let one_valley = (0..POINTS).map(|i| -1e-8 * (-((i as f64 - 4000.0) / 500.0).powi(2)).exp());
    assert_eq!(skewness(one_valley.collect()), None);
}

#[test]
fn worn_traces_are_skewed_and_so_are_those_of_uneven_points() {
    let worn_m = worn_m(&gaussian_m(7));
    let tilted = |sign: f64| -> Vec<f64> {
        worn_m.iter().enumerate().map(|(i, height_m)| sign * height_m + 1e-11 * i as f64).collect()
    };
    // Half of a normal distribution, and a half in one point: -1.64.
    let valleys = skewness(tilted(1.0)).expect("valleys");
    assert!((-2.0..-1.3).contains(&valleys), "{valleys}");
    let peaks = skewness(tilted(-1.0)).expect("peaks");
    assert!((peaks + valleys).abs() < 1e-9, "{peaks}");

    // Every second point of one half only: each stands for its length.
    let kept = |i: &usize| *i < POINTS / 2 || i.is_multiple_of(2);
    let positions_m = (0..POINTS).filter(kept).map(|i| SPACING_M * i as f64).collect();
    let heights_m = (0..POINTS).filter(kept).map(|i| worn_m[i]).collect();
    let line = NonuniformLineScan::new(positions_m, heights_m).expect("a line");
    let uneven = clear_skewness(&Scan::NonuniformLine(line), Detrend::Plane).expect("valleys");
    assert!((uneven / valleys - 1.0).abs() < 0.02, "{uneven} {valleys}");
}

#[test]
fn maps_are_pressed_instead() {
    let map = HeightMap::new(128, SPACING_M, SPACING_M, worn_m(&gaussian_m(7))).expect("a map");
    assert_eq!(clear_skewness(&Scan::Map(map), Detrend::Plane), None);
}
