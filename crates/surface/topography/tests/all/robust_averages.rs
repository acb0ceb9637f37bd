//! Medians over lines and removed spikes give the known spectrum of a surface that errors of an instrument spoil.

use std::f64::consts::TAU;

use crate::transform_support::files::file_of;
use crate::transform_support::{Random, self_affine_c1d_m3};
use scans::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use topography::{BandLimits, GapTreatment, LineAverage, Recipe, ScanSpectrum, without_gaps, without_spikes};

const SPACING_M: f64 = 10e-9;
const COLUMNS: usize = 512;
const ROWS: usize = 120;

/// Independent Gaussian lines of the known spectrum, cut from longer ones.
fn lines_m() -> Vec<f64> {
    let mut random = Random(1);
    let mut line = || {
        let mut values = vec![numerics::transforms::Complex::default(); 4 * COLUMNS];
        let length_m = 4.0 * COLUMNS as f64 * SPACING_M;
        for (n, value) in values.iter_mut().enumerate().take(2 * COLUMNS).skip(1) {
            let rms_m = 2.0 * (self_affine_c1d_m3(TAU * n as f64 / length_m) / length_m).sqrt();
            let amplitude_m = rms_m * (-(1.0 - random.next()).ln()).sqrt();
            *value = numerics::transforms::Complex::from_polar(amplitude_m, TAU * random.next());
        }
        numerics::transforms::inverse(4 * COLUMNS).process(&mut values);
        values[..COLUMNS].iter().map(|value| value.re).collect::<Vec<f64>>()
    };
    (0..ROWS).flat_map(|_| line()).collect()
}

/// Mean over the bins of ln(C/C_known), and the standard error that a mean over all lines has by itself.
fn off(heights_m: Vec<f64>, line_average: LineAverage, remove_spikes: bool) -> (f64, f64) {
    let file = file_of(Scan::Map(HeightMap::new(COLUMNS, SPACING_M, SPACING_M, heights_m).unwrap()).into());
    let file = if remove_spikes { without_spikes(file).unwrap() } else { file };
    let file = without_gaps(file, GapTreatment::Harmonic).unwrap();
    let recipe = Recipe { line_average, remove_spikes, ..Recipe::default() };
    let found = ScanSpectrum::new(file, BandLimits::default(), &recipe).unwrap();
    // From the third wave on, where the window lifts nothing, to five points.
    let values = found.spectrum.wavelengths_m().zip(&found.spectrum.c1d_m3);
    let ratios = values.skip(3).filter(|(wavelength_m, _)| *wavelength_m > 5.0 * SPACING_M);
    let ln: Vec<f64> = ratios.map(|(l, c1d_m3)| (c1d_m3 / self_affine_c1d_m3(TAU / l)).ln()).collect();
    let mean = ln.iter().sum::<f64>() / ln.len() as f64;
    // Of 35/18 neighbouring bins under a window one is independent.
    (mean, (35.0 / 18.0 / (ROWS * ln.len()) as f64).sqrt())
}

#[test]
fn a_median_over_lines_is_not_moved_by_outlying_ones() {
    let clean_m = lines_m();
    let (mean, error) = off(clean_m.clone(), LineAverage::Mean, false);
    assert!(mean.abs() < 4.0 * error, "{mean} {error}");
    let (median, _) = off(clean_m.clone(), LineAverage::Median, false);
    // The median of exponential numbers scatters by 1.44 of their mean; it is taken bin by bin.
    assert!(median.abs() < 4.0 * 1.44 * error + 0.01, "{median} {error}");
    let mut spoiled_m = clean_m;
    let mut random = Random(9);
    for row in [11, 53, 54, 99] {
        let line = &mut spoiled_m[row * COLUMNS..(row + 1) * COLUMNS];
        line.iter_mut().for_each(|height_m| *height_m += 200e-9 * (random.next() - 0.5));
    }
    let (mean, _) = off(spoiled_m.clone(), LineAverage::Mean, false);
    let (median, _) = off(spoiled_m, LineAverage::Median, false);
    assert!(mean > 0.5, "{mean}");
    // Of 120 lines 4 do not count: the median lies where 62 of 116 are below it.
    assert!(median.abs() < 0.06 + 4.0 * error, "{median} {error}");
}

#[test]
fn waves_that_all_lines_share_have_their_mean_for_a_median() {
    let wave_m = |i: usize| 1e-8 * (TAU * 31.3 * (i % COLUMNS) as f64 / COLUMNS as f64).sin();
    let heights_m: Vec<f64> = (0..COLUMNS * 9).map(wave_m).collect();
    let scan = Scan::Map(HeightMap::new(COLUMNS, SPACING_M, SPACING_M, heights_m).unwrap());
    let of = |line_average| {
        let recipe = Recipe { line_average, ..Recipe::default() };
        let file = without_gaps(file_of(scan.clone().into()), GapTreatment::Refuse).unwrap();
        ScanSpectrum::new(file, BandLimits::default(), &recipe).unwrap().spectrum.variance_m2
    };
    assert!((of(LineAverage::Median) / of(LineAverage::Mean) - 1.0).abs() < 1e-9);
}

#[test]
fn removed_spikes_leave_the_known_spectrum() {
    let mut spiked_m = lines_m();
    let mut random = Random(5);
    for _ in 0..100 {
        spiked_m[(random.next() * (COLUMNS * ROWS) as f64) as usize] += 1e-6;
    }
    let (kept, error) = off(spiked_m.clone(), LineAverage::Mean, false);
    let (removed, _) = off(spiked_m, LineAverage::Mean, true);
    assert!(kept > 0.5, "{kept}");
    assert!(removed.abs() < 4.0 * error + 0.005, "{removed} {error}");
}

#[test]
fn spikes_are_found_in_lines_and_edges_are_kept() {
    let wave_m = |i: usize| 1e-7 * (i as f64 * 0.37).sin() + 1e-9 * (i as f64 * 2.9).sin();
    let line = |heights_m: Vec<f64>| Scan::UniformLine(UniformLineScan::new(1e-6, heights_m).unwrap());
    let missing = |scan: Scan| {
        let file = without_spikes(file_of(scan.into())).unwrap();
        (file.scan.missing_points().indices().collect::<Vec<_>>(), file.scan.points().0, file.notes.len())
    };
    let mut heights_m: Vec<f64> = (0..1000).map(wave_m).collect();
    assert_eq!(missing(line(heights_m.clone())), (vec![], 1000, 1));
    let steps = heights_m.iter().enumerate().map(|(i, height_m)| height_m + f64::from(i as u32 / 100 % 2));
    assert_eq!(missing(line(steps.collect())), (vec![], 1000, 1));
    heights_m[300] += 4e-6;
    heights_m[301] += 4e-6;
    heights_m[999] -= 4e-6;
    assert_eq!(missing(line(heights_m.clone())), (vec![300, 301, 999], 1000, 1));
    let positions_m = (0..1000).map(|i| 1e-6 * (f64::from(i) + 0.2 * f64::from(i % 2))).collect();
    let uneven = NonuniformLineScan::new(positions_m, heights_m).unwrap();
    assert_eq!(missing(Scan::NonuniformLine(uneven)), (vec![], 997, 1));
}
