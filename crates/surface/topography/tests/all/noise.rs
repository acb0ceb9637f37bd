//! A white floor at the short end of a spectrum is found if there is one, and not otherwise.

use crate::transform_support::Random;
use crate::transform_support::files::file_of;
use scans::{HeightMap, Scan, UniformLineScan};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use topography::{BandLimits, GapTreatment, NoiseFloor, Recipe, ScanSpectrum, without_gaps};
use units::{RemarkCode, RemarkLevel};

const SPACING_M: f64 = 1e-6;

/// A self-affine map of 1024 x 256 points, whose shortest wave is so many points long; the map is made finer and every
/// `coarsening`-th point of it kept, so that waves are folded as in a measurement.
fn map(hurst_exponent: f64, roll_off_m: f64, shortest_m: f64, coarsening: usize, seed: u64) -> Vec<f64> {
    let points = 1024 * coarsening;
    let length_m = SPACING_M * 1024.0;
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent,
        longest_m: length_m,
        rolloff_m: roll_off_m,
        shortest_m,
        size: Size::RmsHeightM(1e-6),
    })
    .expect("a sound surface");
    let synthesis = Synthesis::square(points, length_m, seed, Phases::FixedModulus);
    let heights_m = spectrum.surface(&synthesis, 0).expect("a surface").heights_m;
    let rows = heights_m.chunks_exact(points).step_by(coarsening).take(256);
    rows.flat_map(|row| row.iter().step_by(coarsening).copied()).collect()
}

fn spectrum(scan: Scan) -> ScanSpectrum {
    let file = without_gaps(file_of(scan.into()), GapTreatment::Refuse).expect("no gaps");
    ScanSpectrum::new(file, BandLimits::default(), &Recipe::default()).expect("a spectrum")
}

fn floor_of_map(heights_m: Vec<f64>) -> Option<NoiseFloor> {
    spectrum(Scan::Map(HeightMap::new(1024, SPACING_M, SPACING_M, heights_m).expect("a map"))).noise_floor
}

fn floor_of_line(heights_m: &[f64]) -> Option<NoiseFloor> {
    spectrum(Scan::UniformLine(UniformLineScan::new(SPACING_M, heights_m.to_vec()).expect("a line")))
        .noise_floor
}

/// White noise of this rms height.
fn with_noise(heights_m: &[f64], rms_m: f64, seed: u64) -> Vec<f64> {
    let mut random = Random(seed);
    let noise_m = |random: &mut Random| 12f64.sqrt() * rms_m * (random.next() - 0.5);
    heights_m.iter().map(|height_m| height_m + noise_m(&mut random)).collect()
}

#[test]
fn white_noise_is_found_with_the_wavelength_where_it_sets_in() {
    for hurst_exponent in [0.3, 0.5, 0.8] {
        let clean = map(hurst_exponent, 1000e-6, 2e-6, 1, 1);
        let of_clean =
            spectrum(Scan::Map(HeightMap::new(1024, SPACING_M, SPACING_M, clean.clone()).unwrap()));
        let mut found_any = 0;
        for points in [6.0, 12.0, 25.0, 50.0] {
            // White noise of variance s^2 has C1D = s^2 times the distance of points; it equals the clean one here.
            let onset_m = points * SPACING_M;
            let at = of_clean.reliable.wavelengths_m().iter().position(|&l| l < onset_m).unwrap();
            let near = &of_clean.reliable.c1d_m3()[at - 3..at + 3];
            let level_m3 = near.iter().sum::<f64>() / 6.0;
            let noisy = with_noise(&clean, (level_m3 / SPACING_M).sqrt(), points as u64);
            // Noise that sets in just above two points hides in what sampling folds back.
            let of_map = floor_of_map(noisy.clone());
            if points < 10.0 && hurst_exponent < 0.6 && of_map.is_none() {
                continue;
            }
            let floor = of_map.unwrap_or_else(|| panic!("H {hurst_exponent}, {points} points"));
            let ratio = floor.wavelength_m / onset_m;
            assert!((0.77..1.3).contains(&ratio), "H {hurst_exponent}, {points} points: {ratio}");
            assert!((0.8..1.25).contains(&(floor.c1d_m3 / level_m3)), "{} {level_m3}", floor.c1d_m3);
            found_any += 1;
            if let Some(of_line) = floor_of_line(&noisy[..1024]) {
                let ratio = of_line.wavelength_m / onset_m;
                // The few longest waves of a single line scatter by factors; from 50 points on there are too few.
                assert!(
                    points > 40.0 || (0.4..2.5).contains(&ratio),
                    "a line, H {hurst_exponent}, {points} points: {ratio}"
                );
            }
        }
        assert!(found_any >= 3);
    }
}

#[test]
fn surfaces_without_noise_raise_no_alarm() {
    for hurst_exponent in [0.1, 0.5, 1.0] {
        for (roll_off_m, shortest_m, coarsening) in
            [(1000e-6, 2e-6, 1), (60e-6, 2e-6, 1), (1000e-6, 1e-6, 2), (30e-6, 1e-6, 2), (2.2e-6, 2e-6, 1)]
        {
            let heights_m = map(hurst_exponent, roll_off_m, shortest_m, coarsening, 7);
            let lines = heights_m.chunks_exact(1024).step_by(8);
            let alarms = lines.filter(|line| floor_of_line(line).is_some()).count();
            assert!(alarms <= 1, "H {hurst_exponent}, roll-off {roll_off_m}: {alarms} of 32 lines");
            assert_eq!(
                floor_of_map(heights_m),
                None,
                "H {hurst_exponent}, roll-off {roll_off_m}, {coarsening}"
            );
        }
    }
}

#[test]
fn smoothed_and_interpolated_heights_raise_no_alarm() {
    let heights_m = map(0.8, 1000e-6, 2e-6, 1, 3);
    let noisy = with_noise(&heights_m, 3e-8, 1);
    let row = |row: &[f64]| -> Vec<f64> {
        // Twice as many points, those between on straight lines.
        (0..1024).map(|i| if i % 2 == 0 { row[i / 2] } else { 0.5 * (row[i / 2] + row[i / 2 + 1]) }).collect()
    };
    let interpolated: Vec<f64> = noisy.chunks_exact(1024).flat_map(row).collect();
    assert_eq!(floor_of_map(interpolated), None);
    let smooth = |row: &[f64]| -> Vec<f64> {
        (0..1024)
            .map(|i| {
                (0..9)
                    .map(|k| {
                        row[(i + k + 1020) % 1024] * [1.0, 8.0, 28.0, 56.0, 70.0, 56.0, 28.0, 8.0, 1.0][k]
                    })
                    .sum::<f64>()
                    / 256.0
            })
            .collect()
    };
    let smoothed: Vec<f64> = noisy.chunks_exact(1024).flat_map(smooth).collect();
    assert_eq!(floor_of_map(smoothed), None);
    // Rounding to single precision leaves a floor of its own, far below.
    let band_limited = map(0.8, 1000e-6, 20e-6, 1, 3);
    assert_eq!(floor_of_map(band_limited.iter().map(|&height_m| f64::from(height_m as f32)).collect()), None);
}

#[test]
fn a_floor_inside_the_band_is_warned_of_and_one_beyond_it_is_not() {
    let heights_m = with_noise(&map(0.8, 1000e-6, 2e-6, 1, 1), 3e-8, 1);
    let scan = || Scan::Map(HeightMap::new(1024, SPACING_M, SPACING_M, heights_m.clone()).unwrap());
    let told = |found: &ScanSpectrum| {
        found.remarks().into_iter().find(|remark| remark.code == RemarkCode::NoiseFloor)
    };
    let whole = spectrum(scan());
    assert_eq!(told(&whole).expect("a remark").level, RemarkLevel::Caution);
    let file = without_gaps(file_of(scan().into()), GapTreatment::Refuse).unwrap();
    let limits = BandLimits { tip_radius_m: None, shortest_m: Some(100e-6) };
    assert_eq!(told(&ScanSpectrum::new(file, limits, &Recipe::default()).unwrap()), None);
}
