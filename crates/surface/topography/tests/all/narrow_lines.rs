//! Waves of one length that carry much of the variance are named, and drift of random roughness is not.

use std::f64::consts::TAU;

use crate::kept_moments::{arcs_m, line, map, self_affine_m, spectrum};
use scans::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use topography::{NarrowLine, Recipe};
use units::RemarkCode;

fn named(scan: Scan) -> Option<NarrowLine> {
    let found = spectrum(scan, &Recipe::default());
    let is_named = found.remarks().iter().any(|remark| remark.code == RemarkCode::NarrowLine);
    assert_eq!(is_named, found.checks.line.is_some());
    found.checks.line
}

fn rough_m(hurst_exponent: f64, seed: u64, rms_m: f64) -> Vec<f64> {
    let heights_m = self_affine_m(hurst_exponent, seed);
    let square = heights_m.iter().map(|height_m| height_m * height_m).sum::<f64>() / heights_m.len() as f64;
    heights_m.iter().map(|height_m| height_m * rms_m / square.sqrt()).collect()
}

#[test]
fn no_random_surface_without_roll_off_is_named() {
    for number in 0..200 {
        let hurst_exponent = [0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0][number % 7];
        let heights_m = rough_m(hurst_exponent, number as u64, 1e-6);
        // Long traces, and short ones with few waves.
        let points = [4000, 300, 60][number % 3];
        let trace = UniformLineScan::new(1e-6, heights_m[..points].to_vec()).unwrap();
        assert_eq!(named(Scan::UniformLine(trace)), None, "{number}");
    }
    for number in 0..40 {
        let spectrum = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent: [0.2, 0.5, 0.8, 1.0][number % 4],
            longest_m: 256e-6,
            rolloff_m: 256e-6,
            shortest_m: 2e-6,
            size: Size::RmsHeightM(1e-6),
        });
        let synthesis = Synthesis::square(256, 256e-6, number as u64, Phases::Gaussian);
        let heights_m = spectrum.unwrap().surface(&synthesis, 0).unwrap().heights_m;
        // A piece that is not periodic.
        let piece: Vec<f64> = heights_m.chunks(256).take(90).flat_map(|row| row[..128].to_vec()).collect();
        assert_eq!(named(Scan::Map(HeightMap::new(128, 1e-6, 1e-6, piece).unwrap())), None, "{number}");
    }
}

#[test]
fn turned_profiles_and_gratings_are_named_with_wavelength_and_share() {
    let rough = rough_m(0.8, 1, 0.3e-6);
    let at = |x_m: f64| rough[(x_m / 1e-6).round() as usize];
    let sine = |x_m: f64| 1e-6 * (TAU * x_m / 61.7e-6).sin();
    for (scan, wavelength_m, share) in [
        (line(|x_m| arcs_m(x_m, 100e-6) + at(x_m)), 100e-6, 0.92),
        (line(|x_m| sine(x_m) + at(x_m)), 61.7e-6, 0.92),
        (line(|x_m| 1e-6 * sine(x_m).signum()), 61.7e-6, 8.0 / 9.87),
        (line(|x_m| (TAU * x_m / 800e-6).sin()), 800e-6, 1.0),
        (line(|x_m| (TAU * x_m / 4.3e-6).sin()), 4.3e-6, 1.0),
    ] {
        let found = named(scan).unwrap();
        assert!((found.wavelength_m / wavelength_m - 1.0).abs() < 0.01, "{found:?} {wavelength_m}");
        assert!((found.share - share).abs() < 0.08 && found.angle_degrees.is_none(), "{found:?} {share}");
    }
    let positions_m: Vec<f64> = (0..3000).map(|i| 1e-6 * (f64::from(i) + 0.3 * f64::from(i % 3))).collect();
    let heights_m = positions_m.iter().map(|x_m| arcs_m(*x_m, 100e-6)).collect();
    let found =
        named(Scan::NonuniformLine(NonuniformLineScan::new(positions_m, heights_m).unwrap())).unwrap();
    assert!((found.wavelength_m / 100e-6 - 1.0).abs() < 0.01, "{found:?}");
    // Four lines of a quarter each, and one of few waves, are not one line that carries the surface.
    let sine = |x_m: f64, wavelength_m: f64| 0.2e-6 * (TAU * x_m / wavelength_m).sin();
    let four_m = |x_m: f64| [61e-6, 37e-6, 23e-6, 12e-6].map(|wavelength_m| sine(x_m, wavelength_m));
    assert_eq!(named(line(|x_m| four_m(x_m).iter().sum::<f64>() + at(x_m))), None);
    assert_eq!(named(line(|x_m| sine(x_m, 1600e-6))), None);
}

#[test]
fn milled_maps_are_named_with_the_direction_of_their_waves() {
    let rough = rough_m(0.8, 2, 0.2e-6);
    for degrees in [0.0, 20.0, 45.0, 70.0, 90.0, -30.0] {
        let (sine, cosine) = f64::to_radians(degrees).sin_cos();
        let scan = map(600, 500, |x_m, y_m| {
            let noise_m = rough[(x_m / 1e-6) as usize] + rough[(y_m / 1e-6) as usize + 1000];
            arcs_m(x_m * cosine + y_m * sine + 2e-3, 40e-6) + noise_m
        });
        let found = named(scan).unwrap();
        assert!((found.wavelength_m / 40e-6 - 1.0).abs() < 0.02, "{degrees}: {found:?}");
        assert!(
            (found.angle_degrees.unwrap() - degrees).abs() < 3.0 && found.share > 0.5,
            "{degrees}: {found:?}"
        );
    }
}
