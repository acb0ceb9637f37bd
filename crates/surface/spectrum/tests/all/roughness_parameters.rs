//! Spectra made from roughness parameters have these parameters, and large standard errors.

use std::f64::consts::TAU;

use proptest::prelude::*;
use spectrum::{Normalisation, RoughnessError, RoughnessParameters, SelfAffineProfile, cumulative_moments};

const GROUND: RoughnessParameters =
    RoughnessParameters { rms_height_m: 0.4e-6, rms_slope: 0.15, rolloff_m: 80e-6, hurst_exponent: 0.8 };

#[test]
fn the_spectrum_has_the_height_and_the_slope_that_were_asked_for() {
    for hurst_exponent in [0.3, 0.5, 0.8, 1.0] {
        for rms_slope in [0.03, 0.06, 0.09] {
            let parameters = RoughnessParameters { hurst_exponent, rms_slope, ..GROUND };
            let psd = SelfAffineProfile::new(parameters).unwrap().psd().profile().unwrap();
            let moments = cumulative_moments(&psd, Normalisation::Parseval);
            let last = moments.last().unwrap();
            assert!((last.rms_height_m() / 0.4e-6 - 1.0).abs() < 1e-12, "{hurst_exponent} {rms_slope}");
            assert!((last.rms_slope() / rms_slope - 1.0).abs() < 1e-12, "{hurst_exponent} {rms_slope}");
        }
    }
}

#[test]
fn the_band_begins_a_decade_above_the_roll_off_and_is_level_to_it() {
    let profile = SelfAffineProfile::new(GROUND).unwrap();
    let psd = profile.psd().profile().unwrap();
    assert!((psd.longest_wavelength_m() / 800e-6 - 1.0).abs() < 1e-14);
    assert!((psd.shortest_wavelength_m() / profile.shortest_m() - 1.0).abs() < 1e-14);
    let at_rolloff = psd.value_at(80e-6).unwrap();
    assert!((psd.c1d_m3()[0] / at_rolloff - 1.0).abs() < 1e-13);
    // q^-2.6 from there on.
    let ratio = psd.value_at(8e-6).unwrap() / at_rolloff;
    assert!((ratio.log10() + 2.6).abs() < 1e-9, "{ratio}");
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    assert!((psd.len() as f64 / decades - 20.0).abs() < 1.0);
}

#[test]
fn what_was_assumed_makes_the_spectrum_uncertain_by_a_factor_or_so() {
    let psd = SelfAffineProfile::new(GROUND).unwrap().psd().profile().unwrap();
    let errors_m3 = psd.standard_errors_m3().unwrap();
    let sd: Vec<f64> = psd
        .c1d_m3()
        .iter()
        .zip(errors_m3)
        .map(|(value_m3, error_m3)| {
            let relative = error_m3.unwrap() / value_m3;
            (0.5 * (1.0 + (1.0 + 4.0 * relative * relative).sqrt())).ln().sqrt()
        })
        .collect();
    // The level goes like the roll-off wavelength, of which a factor of 2 is one standard uncertainty.
    assert!((sd[0] / 2f64.ln() - 1.0).abs() < 0.1, "{}", sd[0]);
    // Next to the roll-off the height holds it best; far below it the exponent adds up.
    assert!(sd.iter().all(|sd| (0.05..2.0).contains(sd)), "{sd:?}");
    assert!(sd[sd.len() - 1] > 2.0 * sd[0], "{}", sd[sd.len() - 1]);
}

#[test]
fn slopes_that_do_not_go_with_the_heights_are_refused_with_the_bound_and_the_mend() {
    let told = |parameters| SelfAffineProfile::new(parameters).unwrap_err();
    let small = told(RoughnessParameters { rms_slope: 0.001, ..GROUND });
    let RoughnessError::SlopeTooSmall { least, .. } = small else { panic!("{small}") };
    // (q_r^2 + q_r q_0 + q_0^2)/3 of a level spectrum.
    assert!((least / (0.4e-6 * TAU / 80e-6 * (1.11f64 / 3.0).sqrt()) - 1.0).abs() < 1e-12);
    assert_eq!(
        small.to_string(),
        "the rms slope 0.001 is too small for an rms height of 400 nm and a roll-off wavelength of 80 µm: waves \
         from there up alone have 0.0191; give a longer roll-off wavelength or mean width, or a larger slope (dimensionless: \
         0.1 is 5.7 degrees)"
    );
    assert!(SelfAffineProfile::new(RoughnessParameters { rms_slope: least, ..GROUND }).is_ok());
    let large = told(RoughnessParameters { rms_slope: 1.0, hurst_exponent: 1.0, ..GROUND });
    assert!(matches!(large, RoughnessError::SlopeTooLarge { largest, .. } if largest < 0.5), "{large}");
    assert!(large.to_string().contains("waves down to 100 pm"), "{large}");
    for (parameters, word) in [
        (RoughnessParameters { rms_height_m: 0.0, ..GROUND }, "the rms height in m is 0"),
        (RoughnessParameters { rms_slope: -0.1, ..GROUND }, "the rms slope is -0.1"),
        (RoughnessParameters { rms_slope: f64::NAN, ..GROUND }, "the rms slope is NaN"),
        (RoughnessParameters { rolloff_m: 1e-11, ..GROUND }, "the roll-off wavelength in m is 1e-11"),
        (RoughnessParameters { hurst_exponent: 1.1, ..GROUND }, "the Hurst exponent is 1.1"),
    ] {
        assert!(told(parameters).to_string().starts_with(word), "{}", told(parameters));
    }
}

/// RSm counted as the standard does, on a Gaussian profile of the spectrum: what the page of the module says of it.
#[test]
fn the_mean_width_of_elements_is_about_the_roll_off_wavelength() {
    let parameters =
        RoughnessParameters { rms_height_m: 1e-6, rms_slope: 0.12, rolloff_m: 100e-6, hurst_exponent: 0.8 };
    let profile = SelfAffineProfile::new(parameters).unwrap();
    let psd = profile.psd().profile().unwrap();
    let length_m = 80.0 * parameters.rolloff_m;
    let points = 1 << 13;
    assert!(profile.shortest_m() > 4.0 * length_m / f64::from(points));
    let heights_m = gaussian_profile(&psd, length_m, points as usize);
    let section = heights_m.len() / 8;
    let peak_to_valley = |part: &[f64]| {
        part.iter().copied().fold(f64::MIN, f64::max) - part.iter().copied().fold(f64::MAX, f64::min)
    };
    let rz_m = heights_m.chunks(section).map(peak_to_valley).sum::<f64>() / 8.0;
    let width_m = |least_m: f64| length_m / rises(&heights_m, least_m) as f64;
    let over_rolloff = width_m(0.1 * rz_m) / parameters.rolloff_m;
    assert!((0.8..1.4).contains(&over_rolloff), "{over_rolloff}");
    // Without the standard's discrimination it is Rice's, and tells nothing besides height and slope.
    let rice_m = TAU * parameters.rms_height_m / parameters.rms_slope;
    assert!((width_m(0.0) / rice_m - 1.0).abs() < 0.15, "{}", width_m(0.0) / rice_m);
}

/// Counts how often heights rise from more than `least_m` below the mean line to more than `least_m` above it.
fn rises(heights_m: &[f64], least_m: f64) -> usize {
    let beyond: Vec<bool> = heights_m
        .iter()
        .filter(|height_m| height_m.abs() > least_m)
        .map(|height_m| *height_m > 0.0)
        .collect();
    beyond.windows(2).filter(|pair| !pair[0] && pair[1]).count()
}

/// A sum of the waves that fit on the length, with random phases.
fn gaussian_profile(psd: &spectrum::ProfilePsd, length_m: f64, points: usize) -> Vec<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut heights_m = vec![0.0; points];
    let step_rad_per_m = TAU / length_m;
    for wave in 1..points / 2 {
        let Some(c1d_m3) = psd.value_at(length_m / wave as f64) else { continue };
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let phase = TAU * (state >> 11) as f64 / (1u64 << 53) as f64;
        let amplitude_m = (2.0 * c1d_m3 * step_rad_per_m / std::f64::consts::PI).sqrt();
        for (at, height_m) in heights_m.iter_mut().enumerate() {
            let turns = (wave * at % points) as f64 / points as f64;
            *height_m += amplitude_m * (TAU * turns + phase).cos();
        }
    }
    heights_m
}

proptest! {
    #[test]
    fn whatever_is_typed_is_a_spectrum_or_an_error(
        ln_height in -40.0..10.0f64, ln_slope in -12.0..5.0f64, ln_rolloff in -40.0..10.0f64, hurst_exponent in 0.001..1.0f64,
    ) {
        let parameters = RoughnessParameters {
            rms_height_m: ln_height.exp(),
            rms_slope: ln_slope.exp(),
            rolloff_m: ln_rolloff.exp(),
            hurst_exponent,
        };
        if let Ok(profile) = SelfAffineProfile::new(parameters) {
            let psd = profile.psd().profile().unwrap();
            prop_assert!(psd.wavelengths_m().windows(2).all(|pair| pair[0] > pair[1]));
            prop_assert!(psd.standard_errors_m3().unwrap().iter().flatten().all(|error_m3| error_m3.is_finite()));
            let moments = cumulative_moments(&psd, Normalisation::Parseval);
            let last = moments.last().unwrap();
            prop_assert!((last.rms_slope() / parameters.rms_slope - 1.0).abs() < 1e-9);
            prop_assert!((last.rms_height_m() / parameters.rms_height_m - 1.0).abs() < 1e-9);
        }
    }
}
