//! The spectrum that models get has the variance and the mean square slope of the scan in its band.

use std::f64::consts::TAU;
use std::num::NonZeroU32;

use crate::transform_support::Random;
use crate::transform_support::files::file_of;
use scans::{HeightMap, Scan, UniformLineScan};
use spectrum::{Normalisation, cumulative_moments};
use topography::{
    Average, BandLimits, CompositeSpectrum, GapTreatment, ModelsGet, Recipe, ScanSpectrum, without_gaps,
};
use units::{RemarkCode, RemarkLevel};

const SPACING_M: f64 = 1e-6;
const POINTS: usize = 4000;

pub fn line(height_m: impl FnMut(f64) -> f64) -> Scan {
    let heights_m = (0..POINTS).map(|i| i as f64 * SPACING_M).map(height_m).collect();
    Scan::UniformLine(UniformLineScan::new(SPACING_M, heights_m).unwrap())
}

pub fn map(columns: usize, rows: usize, height_m: impl Fn(f64, f64) -> f64) -> Scan {
    let at = |i: usize| height_m((i % columns) as f64 * SPACING_M, (i / columns) as f64 * SPACING_M);
    let heights_m = (0..columns * rows).map(at).collect();
    Scan::Map(HeightMap::new(columns, SPACING_M, SPACING_M, heights_m).unwrap())
}

/// Random waves on a length of 4 mm, or of 4 x 0.2 mm, with a spectrum q^-(1 + 2 H) down to two points and no roll-off.
pub fn self_affine_m(hurst_exponent: f64, seed: u64) -> Vec<f64> {
    let mut random = Random(seed);
    let mut gaussian = || {
        let radius = (-2.0 * (1.0 - random.next()).ln()).sqrt();
        numerics::transforms::Complex::from_polar(radius, TAU * random.next())
    };
    // Cut from a surface four times as long, whose waves do not end where it does.
    let mut values = vec![numerics::transforms::Complex::default(); 4 * POINTS];
    for (n, value) in values.iter_mut().enumerate().take(2 * POINTS).skip(1) {
        *value = gaussian() * 1e-6 * (n as f64).powf(-0.5 - hurst_exponent);
    }
    numerics::transforms::inverse(4 * POINTS).process(&mut values);
    values[..POINTS].iter().map(|value| value.re).collect()
}

/// Circular arcs of a tool with this feed, as parabolas.
pub fn arcs_m(x_m: f64, feed_m: f64) -> f64 {
    (x_m / feed_m - (x_m / feed_m).floor() - 0.5).powi(2) * 10e-6
}

pub fn spectrum(scan: Scan, recipe: &Recipe) -> ScanSpectrum {
    let file = without_gaps(file_of(scan.into()), GapTreatment::Refuse).unwrap();
    ScanSpectrum::new(file, BandLimits::default(), recipe).unwrap()
}

fn composite(scans: &[Scan], recipe: &Recipe) -> CompositeSpectrum {
    CompositeSpectrum::new(scans.iter().map(|scan| spectrum(scan.clone(), recipe)).collect(), recipe).unwrap()
}

/// Ratio of m0 and m2 of the composite to those of its only scan, whose first and last sample count half.
fn kept(found: &CompositeSpectrum) -> [f64; 2] {
    let moments = cumulative_moments(&found.composite.profile(), Normalisation::Parseval);
    let moments = moments.last().unwrap();
    let scan = &found.scans[0];
    let reliable = |wavelength_m: &f64| scan.reliable.wavelengths_m().contains(wavelength_m);
    let waves = scan.spectrum.wavelengths_m().zip(scan.spectrum.mean_squares_m2());
    let mut waves: Vec<(f64, f64)> = waves.filter(|(wavelength_m, _)| reliable(wavelength_m)).collect();
    waves[0].1 *= 0.5; // the last is the Nyquist wave, which counts half already
    let sum = |power: i32| waves.iter().map(|(l, m2)| (TAU / l).powi(power) * m2).sum::<f64>();
    [moments.m0_m2 / sum(0), moments.m2 / sum(2)]
}

fn surfaces() -> Vec<(&'static str, Scan)> {
    let mut random = Random(1);
    let mut noise = move || 1e-9 * (random.next() - 0.5);
    let sine = |x_m: f64, wavelength_m: f64| 1e-6 * (TAU * x_m / wavelength_m).sin();
    let mut levels = Random(3);
    let levels_m: Vec<f64> = (0..12).map(|_| levels.next() * 1e-6).collect();
    let rough = |hurst_exponent: f64| {
        let heights_m = self_affine_m(hurst_exponent, 5);
        Scan::UniformLine(UniformLineScan::new(SPACING_M, heights_m).unwrap())
    };
    vec![
        ("turned", line(|x_m| arcs_m(x_m, 100e-6) + noise())),
        ("grating", line(|x_m| sine(x_m, 37.3e-6))),
        ("milled", map(1000, 200, |x_m, y_m| arcs_m(x_m + 5.0 * y_m * y_m, 80e-6))),
        ("two tones", line(|x_m| sine(x_m, 190e-6) + 0.05 * sine(x_m, 7.63e-6))),
        ("three tones", line(|x_m| sine(x_m, 190e-6) + 0.2 * sine(x_m, 31e-6) + 0.03 * sine(x_m, 4.1e-6))),
        ("square steps", line(|x_m| 1e-6 * sine(x_m, 231e-6).signum())),
        ("few steps", line(|x_m| levels_m[(x_m / 350e-6) as usize])),
        ("rough 0.1", rough(0.1)),
        ("rough 0.5", rough(0.5)),
        ("rough 0.8", rough(0.8)),
        ("rough 1", rough(1.0)),
    ]
}

#[test]
fn the_composite_of_a_scan_keeps_its_variance_and_slope() {
    for (name, scan) in surfaces() {
        for (bins, bound) in [(10, 1e-3), (5, 0.01), (20, 1e-3), (50, 1e-3), (200, 0.01)] {
            let recipe = Recipe { bins_per_decade: NonZeroU32::new(bins).unwrap(), ..Recipe::default() };
            let found = composite(std::slice::from_ref(&scan), &recipe);
            let [height, slope] = kept(&found);
            assert!(
                (height - 1.0).abs() < bound && (slope - 1.0).abs() < bound,
                "{name} {bins}: {height} {slope}"
            );
        }
    }
}

#[test]
fn scans_of_one_turned_face_keep_what_each_has() {
    let turned = |seed: u64| {
        let mut random = Random(seed);
        let offset_m = random.next() * 100e-6;
        line(|x_m| arcs_m(x_m + offset_m, 100e-6) + 1e-9 * (random.next() - 0.5))
    };
    let scans: Vec<Scan> = (0..4).map(turned).collect();
    for average in [Average::LogUnbiased, Average::Log, Average::Arithmetic] {
        let found = composite(&scans, &Recipe { average, ..Recipe::default() });
        let models = ModelsGet::new(&found.composite.profile(), &found.scans).unwrap();
        assert!((models.height - 1.0).abs() < 0.01 && (models.slope - 1.0).abs() < 0.01, "{models:?}");
    }
}

#[test]
fn smooth_spectra_stay_as_they_are() {
    for hurst_exponent in [0.2, 0.5, 0.8] {
        let rows: Vec<f64> =
            (0..200).flat_map(|row| self_affine_m(hurst_exponent, row)[..1000].to_vec()).collect();
        let found = composite(
            &[Scan::Map(HeightMap::new(1000, SPACING_M, SPACING_M, rows).unwrap())],
            &Recipe::default(),
        );
        for bin in &found.composite.bins {
            let bound = if bin.wavelength_m > 200e-6 { 0.6 } else { 0.04 };
            assert!((bin.kept - 1.0).abs() < bound, "{hurst_exponent}: {bin:?}");
        }
    }
}

#[test]
fn what_models_get_is_checked_after_binning() {
    for (name, scan) in surfaces() {
        let found = composite(&[scan], &Recipe::default());
        let models = ModelsGet::new(&found.composite.profile(), &found.scans).unwrap();
        assert!((models.height - 1.0).abs() < 0.01, "{name}: {models:?}");
    }
    let level = |scan: Scan| {
        let found = composite(&[scan], &Recipe::default());
        found.remarks().into_iter().find(|remark| remark.code == RemarkCode::ModelsGet).unwrap().level
    };
    assert_eq!(level(line(|x_m| arcs_m(x_m, 100e-6))), RemarkLevel::Passed);
    // White heights: their slope hangs on waves of two points.
    let mut random = Random(7);
    assert_eq!(level(line(|_| random.next())), RemarkLevel::Caution);
    // Scans that differ tenfold: the mean of the logarithms has a third of their variance.
    let found = composite(
        &[line(|x_m| arcs_m(x_m, 100e-6)), line(|x_m| 10.0 * arcs_m(x_m, 100e-6))],
        &Recipe::default(),
    );
    assert!(ModelsGet::new(&found.composite.profile(), &found.scans).unwrap().height < 0.5);
}

#[test]
fn bins_without_a_line_stand_where_their_samples_do() {
    let wavelengths_m = |seed: u64| -> Vec<f64> {
        let scan = UniformLineScan::new(SPACING_M, self_affine_m(0.8, seed)).unwrap();
        let bins = spectrum(Scan::UniformLine(scan), &Recipe::default());
        bins.in_bins(Recipe::default().bins_per_decade).iter().map(|bin| bin.wavelength_m).collect()
    };
    let found = wavelengths_m(1);
    assert_eq!(found, wavelengths_m(2));
    // A line moves its own bin, to itself.
    let rough_m = self_affine_m(0.8, 1);
    let tone = line(|x_m| 1e-6 * (TAU * x_m / 43e-6).sin() + rough_m[(x_m / SPACING_M).round() as usize]);
    let with_line = spectrum(tone, &Recipe::default()).in_bins(Recipe::default().bins_per_decade);
    let moved: Vec<f64> = with_line
        .iter()
        .map(|bin| bin.wavelength_m)
        .filter(|wavelength_m| !found.contains(wavelength_m))
        .collect();
    assert!(matches!(moved[..], [at_m] if (at_m / 43e-6 - 1.0).abs() < 0.03), "{moved:?}");
}
