//! Spectra of evenly spaced lines and of maps line by line.

use std::f64::consts::TAU;
use std::num::NonZeroU32;

use crate::transform_support::{Random, periodic_profile_m, self_affine_c1d_m3};
use approx::assert_relative_eq;
use proptest::prelude::*;
use scans::{HeightMap, Scan, UniformLineScan};
use topography::{
    BandLimits, BinMean, DerivativeOf, Detrend, MapLines, Preparation, ReliableBand, ScanBoundary,
    TransformError, Window, fundamental_kept, line_spectrum, log_binned, map_line_spectrum,
    real_space_derivatives, real_space_derivatives_across, uniform_line_spectrum,
};

fn preparations() -> impl Iterator<Item = Preparation> {
    let with = |&detrend| Window::ALL.iter().map(move |&window| Preparation { detrend, window });
    Detrend::ALL.iter().flat_map(with)
}

fn line(spacing_m: f64, heights_m: Vec<f64>) -> UniformLineScan {
    UniformLineScan::new(spacing_m, heights_m).unwrap()
}

#[test]
fn the_spectrum_adds_up_to_the_variance_for_every_size() {
    for points in (2..41).chain([97, 128, 1000, 1024]) {
        let rough = Random(points as u64).numbers(points);
        let rows = Random(1).numbers(5 * points);
        let map = HeightMap::new(points, 2e-9, 3e-9, rows).unwrap();
        for preparation in preparations() {
            let single = uniform_line_spectrum(&line(3e-9, rough.clone()), preparation);
            let rows = map_line_spectrum(&map, preparation);
            assert_eq!(single.c1d_m3.len(), points / 2);
            for share in [single.parseval_share(), rows.parseval_share()] {
                // Two points on a straight line are flat but for the rounding of the line.
                let flat = points == 2 && preparation.detrend != Detrend::Mean;
                assert!((share - 1.0).abs() < 1e-12 || flat, "{points} {preparation:?}: {share}");
            }
        }
    }
}

#[test]
fn the_variance_is_that_of_the_prepared_heights() {
    let heights = vec![1.0, 4.0, -2.0, 0.5, 3.0, 3.0];
    let plain = uniform_line_spectrum(&line(1.0, heights.clone()), Preparation::PERIODIC);
    let mean = heights.iter().sum::<f64>() / 6.0;
    let variance = heights.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / 6.0;
    assert_relative_eq!(plain.variance_m2, variance, max_relative = 1e-15);
}

#[test]
fn a_sine_wave_has_its_variance_in_one_bin() {
    let (points, amplitude_m, spacing_m) = (200, 3e-9, 2e-9);
    let height_m = |i: usize| amplitude_m * (TAU * 7.0 * i as f64 / points as f64 + 0.3).cos();
    let scan = line(spacing_m, (0..points).map(height_m).collect());
    let spectrum = uniform_line_spectrum(&scan, Preparation::PERIODIC);
    let in_bin_m2 = 2.0 / spectrum.length_m * spectrum.c1d_m3[6];
    assert_relative_eq!(in_bin_m2, amplitude_m * amplitude_m / 2.0, max_relative = 1e-13, epsilon = 0.0);
    let elsewhere: f64 =
        spectrum.c1d_m3.iter().enumerate().filter(|&(bin, _)| bin != 6).map(|(_, c)| c).sum();
    assert!(elsewhere < 1e-28 * spectrum.c1d_m3[6]);
    assert_relative_eq!(
        spectrum.wavelengths_m().nth(6).unwrap(),
        scan.length_m() / 7.0,
        max_relative = 1e-15
    );

    // The Hann window spreads it over three bins, 1/4 : 1 : 1/4 in power, and keeps the sum.
    let preparation = Preparation { detrend: Detrend::Mean, window: Window::Hann };
    let hann = uniform_line_spectrum(&scan, preparation);
    let shares = [5, 6, 7].map(|bin| hann.c1d_m3[bin] / spectrum.c1d_m3[6]);
    for (share, expected) in shares.into_iter().zip([1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]) {
        assert_relative_eq!(share, expected, max_relative = 1e-12);
    }
}

#[test]
fn numpy_finds_the_same_spectrum_of_a_map() {
    // A least-squares plane and the transform of numpy 2, with sin^2(pi (i + 1/2)/N). With sin^2(pi i/N) the same lines
    // reproduce SurfaceTopography 1.27.1 (0.6512, 1.0543, 0.1394, 0.0199, 0.0173) in all digits.
    let expected = [
        0.6536747556880009,
        1.0596052007016203,
        0.1345762503067458,
        0.020637167521077117,
        0.017070679566913157,
    ];
    let spectrum = map_line_spectrum(&small_map(), Preparation::default());
    for (found, expected) in spectrum.c1d_m3.iter().zip(expected) {
        assert_relative_eq!(*found, expected, max_relative = 1e-12);
    }
}

fn small_map() -> HeightMap {
    let height =
        |i: f64, j: f64| (0.9 * i + 0.4 * j * j).sin() + 0.3 * (1.7 * i * j).cos() + 0.05 * i - 0.02 * j;
    let heights = (0..9).flat_map(|j| (0..12).map(move |i| height(f64::from(i), f64::from(j))));
    HeightMap::new(12, 0.5, 0.75, heights.collect()).unwrap()
}

#[test]
fn an_offset_and_a_slope_a_million_times_the_roughness_cost_no_digits() {
    // Heights on a binary grid, so that the slope is added exactly.
    let rough: Vec<f64> = Random(3).numbers(1000).iter().map(|h| (h * 1024.0).round() / 1024.0).collect();
    let tilted = rough.iter().enumerate().map(|(i, h)| h + 2e6 - 12345.0 * i as f64).collect();
    let level = uniform_line_spectrum(&line(1.0, rough), Preparation::default());
    let tilted = uniform_line_spectrum(&line(1.0, tilted), Preparation::default());
    for (level, tilted) in level.c1d_m3.iter().zip(&tilted.c1d_m3) {
        assert_relative_eq!(level, tilted, max_relative = 1e-10);
    }
}

#[test]
fn a_periodic_self_affine_profile_gives_its_spectrum_back() {
    let scan = line(4e-9, periodic_profile_m(4096, 4e-9, &mut Random(5)));
    let spectrum = uniform_line_spectrum(&scan, Preparation::PERIODIC);
    let bins = spectrum.wavevectors_rad_per_m().zip(&spectrum.c1d_m3);
    for (q_rad_per_m, &c1d_m3) in bins.take(2047) {
        assert_relative_eq!(c1d_m3, self_affine_c1d_m3(q_rad_per_m), max_relative = 1e-8, epsilon = 0.0);
    }
}

#[test]
fn pieces_of_a_self_affine_surface_give_the_spectrum_within_the_sampling_error() {
    // 64 rows that are not periodic: each the first quarter of a longer profile.
    let mut random = Random(7);
    let rows = (0..64).flat_map(|_| periodic_profile_m(8192, 4e-9, &mut random)[..2048].to_vec());
    let map = HeightMap::new(2048, 4e-9, 4e-9, rows.collect()).unwrap();
    let preparation = Preparation { detrend: Detrend::Line, window: Window::Hann };
    let spectrum = map_line_spectrum(&map, preparation);
    assert_eq!((spectrum.lines, spectrum.flagged_bins), (64, 1));
    let scan = Scan::Map(map);
    let band = ReliableBand::new(&scan, BandLimits::default()).unwrap();
    let profile = spectrum.profile(&band).unwrap();
    let binned = log_binned(&profile, NonZeroU32::new(10).unwrap(), BinMean::Arithmetic);
    assert!(binned.len() > 25);
    for (&wavelength_m, &c1d_m3) in binned.wavelengths_m().iter().zip(binned.c1d_m3()).skip(3) {
        // One bin of 64 rows scatters by 1/8; the Hann window leaves half as many independent ones.
        let bins = (0.23 * spectrum.length_m / wavelength_m).max(1.0);
        let error = (c1d_m3 / self_affine_c1d_m3(TAU / wavelength_m)).ln();
        assert!(error.abs() < 0.02 + 4.0 / 8.0 * (2.0 / bins).sqrt(), "{wavelength_m:e}: {error}");
    }
}

#[test]
fn blocks_in_any_order_give_the_same_digits() {
    let map = HeightMap::new(96, 1e-9, 1e-9, Random(2).numbers(96 * 200)).unwrap();
    let lines = MapLines::new(&map, Preparation::default());
    assert_eq!(lines.blocks(), 4);
    let mut sums: Vec<_> = (0..4).rev().map(|block| lines.block(block)).collect();
    sums.reverse();
    assert_eq!(lines.spectrum(&sums), map_line_spectrum(&map, Preparation::default()));
}

#[test]
fn differences_in_real_space_and_in_the_spectrum_agree_on_periodic_data() {
    for points in [64, 65] {
        let map = HeightMap::new(points, 0.5, 2.0, Random(9).numbers(points * 10)).unwrap();
        let scan = Scan::Map(map);
        let spectral = line_spectrum(&scan, Preparation::PERIODIC);
        let spectral = spectral.rms_derivatives(DerivativeOf::Differences).unwrap();
        let real = real_space_derivatives(&scan, Detrend::Mean, ScanBoundary::Periodic);
        assert_relative_eq!(spectral.slope, real.slope, max_relative = 1e-13);
        assert_relative_eq!(
            spectral.curvature_per_m.unwrap(),
            real.curvature_per_m.unwrap(),
            max_relative = 1e-13
        );
    }
}

#[test]
fn the_slope_of_a_wave_is_that_of_the_continuum() {
    let (points, periods) = (4096, 8.0);
    let wave = (0..points).map(|i| (TAU * periods * i as f64 / points as f64).sin()).collect();
    let scan = Scan::UniformLine(line(1.0, wave));
    let q = TAU * periods / points as f64;
    let spectrum = line_spectrum(&scan, Preparation::PERIODIC);
    let continuum = spectrum.rms_derivatives(DerivativeOf::Continuum).unwrap();
    assert_relative_eq!(continuum.slope, q * 0.5f64.sqrt(), max_relative = 1e-10);
    assert_relative_eq!(continuum.curvature_per_m.unwrap(), q * q * 0.5f64.sqrt(), max_relative = 1e-6);
    let open = real_space_derivatives(&scan, Detrend::Mean, ScanBoundary::Open);
    assert_relative_eq!(open.slope, continuum.slope, max_relative = 1e-3);
}

#[test]
fn detrending_takes_most_of_a_sine_and_none_of_a_cosine() {
    let wave = |phase: f64| {
        let height = |i: usize| (TAU * (i as f64 + 0.5) / 1000.0 + phase).sin();
        Scan::UniformLine(line(1.0, (0..1000).map(height).collect()))
    };
    let kept = |phase, detrend| fundamental_kept(&wave(phase), detrend).unwrap();
    assert_eq!(kept(0.0, Detrend::Mean), 1.0);
    // The line 6/pi (1/2 - x/L) has the harmonic 6/pi^2 of the sine: (1 - 6/pi^2)^2 is left.
    let left = (1.0 - 6.0 / std::f64::consts::PI.powi(2)).powi(2);
    assert_relative_eq!(kept(0.0, Detrend::Line), left, max_relative = 1e-4);
    assert_relative_eq!(kept(TAU / 4.0, Detrend::Plane), 1.0, max_relative = 1e-4);
    let flat = Scan::UniformLine(line(1.0, vec![2.0; 8]));
    assert_eq!(fundamental_kept(&flat, Detrend::Line), None);
    assert!(!line_spectrum(&flat, Preparation::PERIODIC).holds_fundamental());
    assert!(line_spectrum(&wave(0.0), Preparation::default()).holds_fundamental());
}

#[test]
fn a_flat_surface_has_no_spectrum() {
    let scan = Scan::UniformLine(line(1e-9, vec![5.0; 16]));
    let spectrum = line_spectrum(&scan, Preparation::default());
    assert_eq!((spectrum.variance_m2, spectrum.parseval_share()), (0.0, 1.0));
    let band = ReliableBand::new(&scan, BandLimits::default()).unwrap();
    assert!(matches!(spectrum.profile(&band), Err(TransformError::NothingReliable { .. })));
}

#[test]
fn slopes_across_a_map_are_those_of_the_map_turned() {
    // h = 3 x + 0.1 cos along y: after the plane is gone, nothing is left along x.
    let (columns, rows) = (8, 64);
    let wave_m = |row: usize| 0.1e-9 * (std::f64::consts::TAU * row as f64 / 16.0).cos();
    let heights_m =
        (0..rows).flat_map(|row| (0..columns).map(move |x| 3e-9 * x as f64 + wave_m(row))).collect();
    let map = HeightMap::new(columns, 1e-9, 2e-9, heights_m).unwrap();
    let scan = Scan::Map(map.clone());
    let across = real_space_derivatives_across(&scan, Detrend::Plane, ScanBoundary::Periodic).unwrap();
    let along = real_space_derivatives(&scan, Detrend::Plane, ScanBoundary::Open);
    // (2 sin(pi/16)/a) a_0/sqrt(2)
    let slope = 2.0 * (std::f64::consts::PI / 16.0).sin() / 2e-9 * 0.1e-9 / 2f64.sqrt();
    assert!(along.slope < 1e-12 && (across.slope / slope - 1.0).abs() < 1e-2, "{along:?} {across:?}");
    assert_eq!(map.turned().turned(), map);
    assert_eq!((map.turned().columns(), map.turned().spacing_x_m()), (rows, 2e-9));
    let line = Scan::UniformLine(UniformLineScan::new(1e-9, vec![0.0, 1.0]).unwrap());
    assert_eq!(real_space_derivatives_across(&line, Detrend::Mean, ScanBoundary::Open), None);
}

proptest! {
    #[test]
    fn spectra_scale_with_heights_and_lengths(
        heights in prop::collection::vec(-1.0..1.0f64, 3..60), log_scale in -9.0..9.0f64,
    ) {
        let scale = 10f64.powf(log_scale);
        let original = uniform_line_spectrum(&line(1.0, heights.clone()), Preparation::default());
        let taller = heights.iter().map(|height| scale * height).collect();
        let taller = uniform_line_spectrum(&line(1.0, taller), Preparation::default());
        let longer = uniform_line_spectrum(&line(scale, heights), Preparation::default());
        let tolerance = 1e-12 * original.c1d_m3.iter().fold(0.0, |a: f64, &b| a.max(b));
        for ((c, taller), longer) in original.c1d_m3.iter().zip(&taller.c1d_m3).zip(&longer.c1d_m3) {
            prop_assert!((taller / (scale * scale) - c).abs() <= tolerance);
            prop_assert!((longer / scale - c).abs() <= tolerance);
        }
    }
}
