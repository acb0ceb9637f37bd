//! Spectra of unevenly spaced lines.

use std::f64::consts::{PI, TAU};

use crate::transform_support::Random;
use approx::assert_relative_eq;
use scans::{NonuniformLineScan, Scan, UniformLineScan};
use topography::{
    DerivativeOf, Detrend, Preparation, ScanBoundary, Window, nonuniform_line_spectrum,
    nonuniform_line_spectrum_to, real_space_derivatives, uniform_line_spectrum,
};

const HANN: Preparation = Preparation { detrend: Detrend::Mean, window: Window::Hann };

fn small() -> NonuniformLineScan {
    let positions = vec![0.0, 0.3, 1.1, 1.25, 2.4, 3.0, 3.1];
    NonuniformLineScan::new(positions, vec![0.2, -0.4, 0.9, 0.3, -1.0, 0.5, 0.1]).unwrap()
}

#[test]
fn the_transform_is_that_of_the_straight_lines() {
    // SurfaceTopography 1.27.1 without a window ("brute-force"); with one, Gauss-Legendre of 40 points on each segment,
    // because SurfaceTopography windows the points and joins them by straight lines afterwards.
    let line = Preparation { detrend: Detrend::Line, window: Window::None };
    for (preparation, expected) in [
        (Preparation::PERIODIC, [0.1994410821100994, 0.07935619944578623, 0.05068700024057851]),
        (line, [0.08708635398580178, 0.12314010778117633, 0.06951721549046845]),
        (HANN, [0.22327497517784578, 0.1056738424677886, 0.006270714659651276]),
    ] {
        let spectrum = nonuniform_line_spectrum(&small(), preparation);
        assert_eq!(spectrum.c1d_m3.len(), 3);
        for (found, expected) in spectrum.c1d_m3.iter().zip(expected) {
            assert_relative_eq!(*found, expected, max_relative = 1e-13);
        }
    }
    let hann = nonuniform_line_spectrum(&small(), HANN);
    assert_relative_eq!(hann.variance_m2, 0.22526486597173814, max_relative = 1e-14);
}

/// The periodic heights of `points` points, as an even scan and as an uneven one that ends where it began.
fn both(points: usize) -> (UniformLineScan, NonuniformLineScan) {
    let heights = Random(21).numbers(points);
    let mean = heights.iter().sum::<f64>() / points as f64;
    let heights: Vec<f64> = heights.iter().map(|height| height - mean).collect();
    let positions = (0..=points).map(|i| 0.5 * i as f64).collect();
    let closed = [heights.as_slice(), &heights[..1]].concat();
    (UniformLineScan::new(0.5, heights).unwrap(), NonuniformLineScan::new(positions, closed).unwrap())
}

#[test]
fn even_spacing_gives_the_discrete_spectrum_times_sinc_to_the_fourth() {
    for points in [40, 41, 1000] {
        let (even, uneven) = both(points);
        let discrete = uniform_line_spectrum(&even, Preparation::PERIODIC);
        let straight = nonuniform_line_spectrum(&uneven, Preparation::PERIODIC);
        assert_relative_eq!(straight.length_m, discrete.length_m);
        assert_eq!(straight.c1d_m3.len(), points / 2);
        for (n, (straight, discrete)) in (1..).zip(straight.c1d_m3.iter().zip(&discrete.c1d_m3)) {
            let angle = PI * f64::from(n) / points as f64;
            let expected = discrete * (angle.sin() / angle).powi(4);
            assert_relative_eq!(*straight, expected, max_relative = 1e-11, epsilon = 1e-28);
        }
    }
}

#[test]
fn all_wavelengths_together_hold_the_variance() {
    // On even spacing the aliases of a bin add up in closed form: Sum_j sinc^4(pi (x + j)) = (2 + cos(2 pi x))/3.
    let points = 64;
    let (even, uneven) = both(points);
    let discrete = uniform_line_spectrum(&even, Preparation::PERIODIC);
    let all: f64 = discrete
        .c1d_m3
        .iter()
        .enumerate()
        .map(|(bin, c)| {
            let n = bin + 1;
            let weight = if 2 * n == points { 0.5 } else { 1.0 };
            weight * c * (2.0 + (TAU * n as f64 / points as f64).cos()) / 3.0
        })
        .sum();
    let straight = nonuniform_line_spectrum(&uneven, Preparation::PERIODIC);
    assert_relative_eq!(2.0 / straight.length_m * all, straight.variance_m2, max_relative = 1e-12);
}

#[test]
fn the_share_tends_to_one_with_the_cube_of_the_bins() {
    let mut random = Random(31);
    let mut position = 3.0;
    let positions = (0..200).map(|_| {
        position += 0.02 + random.next();
        position
    });
    let positions = positions.collect();
    let scan = NonuniformLineScan::new(positions, Random(32).numbers(200)).unwrap();
    for preparation in [HANN, Preparation::default(), Preparation { detrend: Detrend::Line, ..HANN }] {
        let rest = |bins| 1.0 - nonuniform_line_spectrum_to(&scan, preparation, bins).parseval_share();
        let rests = [rest(4000), rest(8000), rest(16000)];
        assert!(rests.iter().all(|&rest| rest > 0.0), "{rests:?}");
        // The windowed profile has corners: C falls as q^-4, the rest as N^-3, and the extrapolation to none.
        assert!((rests[1] / rests[0] * 8.0 - 1.0).abs() < 0.1, "{rests:?}");
        let extrapolated = (8.0 * rests[2] - rests[1]) / 7.0;
        assert!(extrapolated.abs() < 0.1 * rests[2] && rests[2] < 1e-5, "{rests:?}");
    }
}

#[test]
fn where_a_scan_starts_and_how_it_is_tilted_does_not_matter() {
    let (positions, heights) = (small().positions_m().to_vec(), small().heights_m().to_vec());
    let moved = positions.iter().map(|x| x + 1024.0).collect();
    let tilted = positions.iter().zip(&heights).map(|(x, h)| h + 1e6 - 3e5 * x).collect();
    let moved = NonuniformLineScan::new(moved, tilted).unwrap();
    let (level, tilted) = (
        nonuniform_line_spectrum(&small(), Preparation::default()),
        nonuniform_line_spectrum(&moved, Preparation::default()),
    );
    for (level, tilted) in level.c1d_m3.iter().zip(&tilted.c1d_m3) {
        assert_relative_eq!(level, tilted, max_relative = 1e-6); // positions and heights lose digits when they are moved
    }
}

#[test]
fn two_points_make_a_spectrum_of_one_bin() {
    let scan = NonuniformLineScan::new(vec![0.0, 2.0], vec![0.0, 1.0]).unwrap();
    let spectrum = nonuniform_line_spectrum(&scan, Preparation::PERIODIC);
    // The transform of a ramp: |h~| = L/(2 pi n) times its height.
    assert_relative_eq!(spectrum.c1d_m3[0], 2.0 / (TAU * TAU), max_relative = 1e-14);
    assert_relative_eq!(spectrum.variance_m2, 1.0 / 12.0, max_relative = 1e-15);
}

#[test]
fn slopes_are_those_of_the_straight_lines() {
    let scan = Scan::NonuniformLine(small());
    let found = real_space_derivatives(&scan, Detrend::Mean, ScanBoundary::Open);
    let segments = small();
    let (x, h) = (segments.positions_m(), segments.heights_m());
    let squares: f64 = (1..7).map(|i| (h[i] - h[i - 1]).powi(2) / (x[i] - x[i - 1])).sum();
    assert_relative_eq!(found.slope, (squares / 3.1).sqrt(), max_relative = 1e-14);
    let spectrum = nonuniform_line_spectrum(&small(), Preparation::PERIODIC);
    assert_eq!(spectrum.rms_derivatives(DerivativeOf::Differences), None);
}
