//! The profiles of area spectra against closed forms.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use spectrum::{Convention, Psd};

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
