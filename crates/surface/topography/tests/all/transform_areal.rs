//! Two-dimensional spectra of maps.

use std::f64::consts::{PI, TAU};

use crate::transform_support::Random;
use approx::assert_relative_eq;
use numerics::transforms::Complex;
use scans::{HeightMap, Scan};
use spectrum::Convention;
use topography::{ArealTransform, BandLimits, Detrend, Preparation, ReliableBand, Window, areal_spectrum};

#[test]
fn the_modes_add_up_to_the_variance_for_every_size() {
    for (columns, rows) in
        [(2, 2), (2, 3), (3, 2), (5, 7), (8, 8), (31, 20), (40, 97), (128, 65), (100, 1000)]
    {
        let map = HeightMap::new(columns, 2e-9, 5e-9, Random(11).numbers(columns * rows)).unwrap();
        for &detrend in Detrend::ALL {
            for &window in Window::ALL {
                let spectrum = areal_spectrum(&map, Preparation { detrend, window });
                let share = spectrum.parseval_share();
                let flat = columns == 2 && detrend == Detrend::Line;
                assert!(
                    (share - 1.0).abs() < 1e-12 || flat,
                    "{columns} x {rows} {detrend} {window}: {share}"
                );
                let modes: u64 = spectrum.bins.iter().map(|bin| bin.modes).sum();
                assert_eq!(modes as usize, columns * rows - 1);
            }
        }
    }
}

#[test]
fn a_wave_has_its_variance_in_the_ring_of_its_wavevector() {
    // 3 periods along x and 2 along y of a map twice as long as wide with oblong pixels.
    let (columns, rows, spacing_x, spacing_y) = (32, 24, 1.0, 0.5);
    let wave = |i: usize| {
        let (x, y) = ((i % columns) as f64 / columns as f64, (i / columns) as f64 / rows as f64);
        (TAU * (3.0 * x + 2.0 * y)).cos()
    };
    let heights = (0..columns * rows).map(wave).collect();
    let map = HeightMap::new(columns, spacing_x, spacing_y, heights).unwrap();
    let spectrum = areal_spectrum(&map, Preparation::PERIODIC);
    let q = (TAU * 3.0 / 32.0).hypot(TAU * 2.0 / 12.0);
    let ring = ((q / (TAU / 32.0)) + 0.5).floor() as usize;
    let bin = spectrum.bins[ring - 1];
    assert!((bin.wavevector_rad_per_m - q).abs() < TAU / 32.0);
    assert_relative_eq!(bin.sum_m4 / (32.0 * 12.0), 0.5, max_relative = 1e-13);
    assert_relative_eq!(spectrum.spectral_variance_m2(), 0.5, max_relative = 1e-13);
}

#[test]
fn the_unit_of_lengths_moves_no_mode_into_another_ring() {
    let (columns, rows) = (18, 12);
    let modes = |spacing_m: f64| -> Vec<u64> {
        let map = HeightMap::new(columns, spacing_m, spacing_m, Random(3).numbers(columns * rows)).unwrap();
        areal_spectrum(&map, Preparation::PERIODIC).bins.iter().map(|bin| bin.modes).collect()
    };
    for at in 1..100 {
        assert_eq!(modes(f64::from(at) * 0.1e-6), modes(1.0), "{at}");
    }
}

#[test]
fn sides_of_absurd_ratio_make_no_map() {
    assert!(HeightMap::new(2, 1e-320, 1.0, vec![0.0; 4]).is_err());
}

#[test]
fn the_two_directions_are_treated_alike() {
    let (columns, rows) = (48, 30);
    let heights = Random(4).numbers(columns * rows);
    let turned =
        (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y))).map(|(x, y)| heights[y * columns + x]);
    let turned = HeightMap::new(rows, 0.75, 0.5, turned.collect()).unwrap();
    let map = HeightMap::new(columns, 0.5, 0.75, heights).unwrap();
    let (map, turned) =
        (areal_spectrum(&map, Preparation::default()), areal_spectrum(&turned, Preparation::default()));
    assert_eq!(map.nyquist_rad_per_m, PI / 0.75);
    for (bin, turned) in map.bins.iter().zip(&turned.bins) {
        assert_eq!(bin.modes, turned.modes);
        assert_relative_eq!(bin.sum_m4, turned.sum_m4, max_relative = 1e-11);
    }
}

#[test]
fn surface_topography_finds_the_same_radial_means() {
    // SurfaceTopography 1.27.1, plane subtracted, no window, with the edges of these rings as its bins; the fourth
    // differs, because it counts a mode exactly on an edge to the ring below, here it belongs to the one above.
    let height =
        |i: f64, j: f64| (0.9 * i + 0.4 * j * j).sin() + 0.3 * (1.7 * i * j).cos() + 0.05 * i - 0.02 * j;
    let heights = (0..9).flat_map(|j| (0..12).map(move |i| height(f64::from(i), f64::from(j))));
    let map = HeightMap::new(12, 0.5, 0.75, heights.collect()).unwrap();
    let preparation = Preparation { detrend: Detrend::Plane, window: Window::None };
    let spectrum = areal_spectrum(&map, preparation);
    let expected = [
        (0.9890199094634533, 0.4775666982988692),
        (1.9517688301907739, 0.48952647987124226),
        (2.9172286542545742, 0.34083326306564715),
    ];
    for (bin, (wavevector, ciso)) in spectrum.bins.iter().zip(expected) {
        assert_relative_eq!(bin.wavevector_rad_per_m, wavevector, max_relative = 1e-14);
        assert_relative_eq!(bin.ciso_m4(), ciso, max_relative = 1e-12);
    }
}

#[test]
fn an_isotropic_self_affine_map_gives_its_spectrum_back() {
    let (points, spacing_m) = (256, 1e-9);
    let length_m = points as f64 * spacing_m;
    let ciso_m4 = |q_rad_per_m: f64| 1e-34 * (1.0 + (q_rad_per_m * length_m / 25.0).powi(2)).powf(-1.8);
    let map = synthesised(points, spacing_m, ciso_m4);
    let scan = Scan::Map(map.clone());
    let band = ReliableBand::new(&scan, BandLimits::default()).unwrap();
    for preparation in [Preparation::PERIODIC, Preparation { window: Window::Hann, ..Preparation::PERIODIC }]
    {
        let spectrum = areal_spectrum(&map, preparation);
        let psd = spectrum.ciso(&band).unwrap();
        assert_eq!(psd.convention(), Convention::Ciso);
        assert_eq!(psd.len(), points / 2 - 1 - spectrum.flagged_bins); // the ring at Nyquist is cut
        let mut ln_error = 0.0;
        for (&wavelength_m, &value) in psd.wavelengths_m().iter().zip(psd.values()).skip(10) {
            let q_rad_per_m = TAU / wavelength_m;
            let modes = TAU * q_rad_per_m * length_m / TAU / 2.0; // half of them are independent
            let error = (value / ciso_m4(q_rad_per_m)).ln();
            assert!(error.abs() < 0.02 + 5.0 / (modes / 2.0).sqrt(), "{wavelength_m:e}: {error}");
            ln_error += error / (psd.len() - 10) as f64;
        }
        assert!(ln_error.abs() < 0.02, "{ln_error}");
    }
}

/// A periodic map with random phases: the real part of modes of fixed amplitude.
fn synthesised(points: usize, spacing_m: f64, ciso_m4: impl Fn(f64) -> f64) -> HeightMap {
    let mut random = Random(17);
    let length_m = points as f64 * spacing_m;
    let signed = |index: usize| if index <= points / 2 { index as f64 } else { index as f64 - points as f64 };
    let mut modes: Vec<Complex<f64>> = (0..points * points)
        .map(|i| {
            let q_rad_per_m = TAU / length_m * signed(i % points).hypot(signed(i / points));
            // The real part halves the power of each mode and shares it with the one at -q.
            let power_m2 = 2.0 * ciso_m4(q_rad_per_m) / (length_m * length_m);
            Complex::from_polar(if i == 0 { 0.0 } else { power_m2.sqrt() }, TAU * random.next())
        })
        .collect();
    let plan = numerics::transforms::inverse(points);
    for _ in 0..2 {
        plan.process(&mut modes);
        modes = (0..points * points).map(|i| modes[i % points * points + i / points]).collect();
    }
    let heights_m = modes.iter().map(|value| value.re).collect();
    HeightMap::new(points, spacing_m, spacing_m, heights_m).unwrap()
}

#[test]
fn blocks_in_any_order_give_the_same_digits() {
    let map = HeightMap::new(70, 1.0, 1.0, Random(8).numbers(70 * 150)).unwrap();
    let transform = ArealTransform::new(&map, Preparation::default());
    assert_eq!((transform.row_blocks(), transform.column_blocks()), (3, 3));
    let mut rows: Vec<_> = (0..3).rev().map(|block| transform.rows(block)).collect();
    rows.reverse();
    let mut sums: Vec<_> = (0..3).rev().map(|block| transform.columns(&rows, block)).collect();
    sums.reverse();
    assert_eq!(transform.spectrum(&rows, &sums), areal_spectrum(&map, Preparation::default()));
}

#[test]
fn pixels_of_any_shape_take_little_memory() {
    let map = HeightMap::new(4, 1e-12, 1.0, Random(6).numbers(16)).unwrap();
    let spectrum = areal_spectrum(&map, Preparation::default());
    assert!((spectrum.parseval_share() - 1.0).abs() < 1e-12);
}
