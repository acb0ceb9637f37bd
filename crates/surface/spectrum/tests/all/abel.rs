//! The conversion between line and area spectra against closed forms, and there and back.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use spectrum::{Convention, ConversionError, Psd};

/// A spectrum at `per_decade` samples for each of `decades`, from q = 1 on.
fn sampled(per_decade: usize, decades: usize, convention: Convention, value: impl Fn(f64) -> f64) -> Psd {
    let q = |i: usize| 10f64.powf(i as f64 / per_decade as f64);
    let (wavelengths_m, values) = (0..=per_decade * decades).map(|i| (TAU / q(i), value(q(i)))).unzip();
    Psd::new(wavelengths_m, values, convention).unwrap()
}

/// (1/pi) Int_end^inf p^(-1-2H) (p^2 - q^2)^(-1/2) dp for q <= end/2, term by term.
fn tail(q: f64, end: f64, hurst: f64) -> f64 {
    let (mut term, mut sum) = (end.powf(-1.0 - 2.0 * hurst) / PI, 0.0);
    for k in 0..40 {
        let k = f64::from(k);
        sum += term / (1.0 + 2.0 * hurst + 2.0 * k);
        term *= (2.0 * k + 1.0) / (2.0 * k + 2.0) * (q / end).powi(2);
    }
    sum
}

#[test]
fn a_power_law_has_the_closed_profile() {
    // Gamma(H + 1/2)/(2 sqrt(pi) Gamma(H + 1)), computed with mpmath.
    for (hurst, factor) in [(0.3, 0.365_943_021_896_974_8), (0.5, 1.0 / PI), (0.8, 0.271_823_298_929_960_8)] {
        for per_decade in [1, 7, 30] {
            let area = sampled(per_decade, 4, Convention::Ciso, |q| q.powf(-2.0 - 2.0 * hurst));
            let profile = area.profile().unwrap();
            assert_eq!(profile.len(), area.len());
            assert_eq!(profile.wavelengths_m(), &area.wavelengths_m()[..profile.len()]);
            for (wavelength_m, c1d_m3) in profile.wavelengths_m().iter().zip(profile.c1d_m3()) {
                let q = TAU / wavelength_m;
                if q < 5e3 {
                    let whole = factor * q.powf(-1.0 - 2.0 * hurst);
                    assert_relative_eq!(
                        c1d_m3 + tail(q, 1e4, hurst),
                        whole,
                        max_relative = 1e-12,
                        epsilon = 0.0
                    );
                }
            }
        }
    }
}

#[test]
fn persson_spectra_are_four_pi_squared_times_smaller() {
    let ciso = sampled(10, 2, Convention::Ciso, |q| 4.0 * PI * PI * q.powi(-3));
    let persson = sampled(10, 2, Convention::Persson, |q| q.powi(-3));
    let (ciso, persson) = (ciso.profile().unwrap(), persson.profile().unwrap());
    for (ciso, persson) in ciso.c1d_m3().iter().zip(persson.c1d_m3()) {
        assert_relative_eq!(ciso, persson, max_relative = 1e-13, epsilon = 0.0);
    }
}

/// The largest relative deviation two decades and more from the end of the band.
fn worst_inside(original: &Psd, back: &Psd) -> f64 {
    assert_eq!(back.len(), original.len() - 1);
    let rows = original.wavelengths_m().iter().zip(original.values()).zip(back.values());
    let inside = rows.filter(|((wavelength_m, _), _)| TAU / **wavelength_m < 100.0);
    inside.map(|((_, original), back)| (back / original - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn there_and_back_again_agrees_inside_the_band_as_samples_grow_dense() {
    let self_affine = |power: f64| move |q: f64| (1.0 + (q / 10.0).powi(2)).powf(power);
    // The remaining error: between samples the second spectrum is a chord, whose slope is off by the curvature.
    for (per_decade, bound) in [(40, 4e-3), (80, 1.5e-3), (160, 6e-4)] {
        let area = sampled(per_decade, 4, Convention::Ciso, self_affine(-1.8));
        let back = area.to(Convention::C1D).unwrap().to(Convention::Ciso).unwrap();
        assert!(worst_inside(&area, &back) < bound, "{per_decade}: {}", worst_inside(&area, &back));
        let profile = sampled(per_decade, 4, Convention::C1D, self_affine(-1.3));
        let back = profile.to(Convention::Persson).unwrap().to(Convention::C1D).unwrap();
        assert!(worst_inside(&profile, &back) < bound, "{per_decade}: {}", worst_inside(&profile, &back));
    }
}

#[test]
fn a_profile_that_rises_belongs_to_no_isotropic_surface() {
    let rising = Psd::new(vec![8.0, 4.0, 2.0], vec![1.0, 1e3, 1e-3], Convention::W1).unwrap();
    let error = rising.to(Convention::Persson).unwrap_err();
    assert!(matches!(error, ConversionError::NotPositive { wavelength_m: 8.0, .. }), "{error}");
    assert!(
        error
            .to_string()
            .starts_with("converting a spectrum from w1 (m^3) to ciso (m^4): the Abel integral is -")
    );
}
