//! The self-affine fit on exact, noisy and measured spectra.

use approx::assert_relative_eq;
use spectrum::{Convention, FitError, ProfilePsd, Psd, RollOff, SelfAffineFit, fit_self_affine};

/// Ultrananocrystalline diamond, 150 um to 3.5 nm: wavelength in m and C1D in m^3 of a composite computed
/// from "Demo UNCD data" (L. Pastewka, CC BY 4.0, contact.engineering) and from MIT-licensed test scans of
/// SurfaceTopography.
const DIAMOND: [(f64, f64); 46] = [
    (1.49392e-04, 1.03863e-22),
    (9.95945e-05, 1.82954e-22),
    (7.46959e-05, 4.41764e-23),
    (5.97567e-05, 2.12948e-22),
    (4.59667e-05, 1.45464e-22),
    (3.51510e-05, 7.93017e-23),
    (2.84556e-05, 9.88461e-23),
    (2.21321e-05, 3.24358e-22),
    (1.75755e-05, 7.62285e-23),
    (1.42278e-05, 1.96291e-22),
    (1.10661e-05, 7.89437e-23),
    (8.78775e-06, 2.38258e-22),
    (7.03020e-06, 1.32412e-22),
    (5.27622e-06, 1.03336e-22),
    (4.42642e-06, 6.96013e-23),
    (3.42180e-06, 8.36128e-23),
    (2.79237e-06, 7.10830e-23),
    (2.21771e-06, 6.04415e-23),
    (1.66667e-06, 4.91837e-23),
    (1.42857e-06, 5.97601e-23),
    (1.11111e-06, 4.60197e-23),
    (8.55716e-07, 2.46438e-23),
    (7.14286e-07, 2.93073e-23),
    (5.58529e-07, 2.21061e-23),
    (4.27858e-07, 1.78968e-23),
    (3.43757e-07, 9.09403e-24),
    (2.80767e-07, 9.25562e-25),
    (2.36628e-07, 3.46246e-24),
    (1.71831e-07, 1.29372e-24),
    (1.40383e-07, 5.13820e-25),
    (1.12607e-07, 2.80038e-25),
    (8.83316e-08, 2.38813e-25),
    (7.25471e-08, 1.74476e-25),
    (5.60938e-08, 1.03161e-25),
    (4.56143e-08, 1.03892e-25),
    (3.58852e-08, 2.16223e-26),
    (2.78369e-08, 9.85187e-27),
    (2.19110e-08, 1.63819e-27),
    (1.77173e-08, 8.49686e-28),
    (1.41313e-08, 3.00167e-27),
    (1.12548e-08, 4.80729e-28),
    (8.94518e-09, 4.94056e-28),
    (7.05353e-09, 1.12188e-28),
    (5.58777e-09, 8.64866e-29),
    (4.40448e-09, 2.51656e-29),
    (3.49889e-09, 6.92311e-30),
];

fn profile(rows: impl IntoIterator<Item = (f64, f64)>) -> ProfilePsd {
    let (wavelengths_m, values) = rows.into_iter().unzip();
    Psd::new(wavelengths_m, values, Convention::C1D).unwrap().profile().unwrap()
}

fn wavelengths_m(longest_m: f64, step: f64, points: usize) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(longest_m), move |wavelength| Some(wavelength * step)).take(points)
}

fn self_affine_m3(wavelength_m: f64, hurst_exponent: f64, rolloff_m: f64) -> f64 {
    2e-22 * (-(hurst_exponent + 0.5) * (rolloff_m / wavelength_m).powi(2).ln_1p()).exp()
}

/// Uniform numbers in -0.5..0.5 from a linear congruential generator.
fn uniform(seed: u64) -> impl Iterator<Item = f64> {
    let next = |state: &u64| Some((state * 1_103_515_245 + 12_345) % (1 << 31));
    std::iter::successors(Some(seed), next).skip(1).map(|state| state as f64 / (1u64 << 31) as f64 - 0.5)
}

#[test]
fn an_exact_self_affine_spectrum_gives_its_parameters_back() {
    for hurst_exponent in [-0.2, 0.3, 0.8, 1.0, 1.7] {
        for rolloff_m in [4e-5, 1e-6, 3e-9] {
            let row = |wavelength_m| (wavelength_m, self_affine_m3(wavelength_m, hurst_exponent, rolloff_m));
            let fit = fit_self_affine(&profile(wavelengths_m(1e-4, 0.8, 50).map(row)), ..).unwrap();
            let rolloff = fit.rolloff.unwrap();
            assert_relative_eq!(fit.hurst_exponent, hurst_exponent, epsilon = 1e-9);
            assert_relative_eq!(rolloff.wavelength_m, rolloff_m, max_relative = 1e-9, epsilon = 0.0);
            assert_relative_eq!(rolloff.plateau_m3, 2e-22, max_relative = 1e-9, epsilon = 0.0);
            assert!(fit.rms_log10_residual < 1e-12);
            assert_eq!(fit.points, 50);
        }
    }
}

#[test]
fn an_exact_power_law_has_no_rolloff() {
    for hurst_exponent in [-0.5, 0.0, 0.5, 0.8, 1.3] {
        let row = |wavelength_m: f64| (wavelength_m, 1e-10 * wavelength_m.powf(2.0 * hurst_exponent + 1.0));
        let fit = fit_self_affine(&profile(wavelengths_m(1e-4, 0.8, 50).map(row)), ..).unwrap();
        assert_relative_eq!(fit.hurst_exponent, hurst_exponent, epsilon = 1e-12);
        assert_eq!(fit.rolloff, None);
        assert!(fit.hurst_exponent_se.unwrap() < 1e-12);
    }
}

#[test]
fn a_noisy_rolloff_agrees_with_an_independent_least_squares_computation() {
    let row = |(wavelength_m, noise): (f64, f64)| {
        let ratio = 1e-6 / wavelength_m;
        let x: f64 = 1.0 + ratio * ratio;
        (wavelength_m, 1e-22 / (x * x.sqrt().sqrt()) * (1.0 + 0.4 * noise))
    };
    let fit =
        fit_self_affine(&profile(wavelengths_m(1e-4, 0.86, 60).zip(uniform(12_345)).map(row)), ..).unwrap();
    assert_fit(
        &fit,
        &SelfAffineFit {
            hurst_exponent: 0.7525732579375963,
            hurst_exponent_se: Some(0.009942853532274528),
            rolloff: Some(RollOff {
                wavelength_m: 9.992482141756025e-7,
                wavelength_se_m: Some(2.4748896213892855e-8),
                plateau_m3: 1.0030932455915852e-22,
                plateau_se_m3: Some(2.0964890961396268e-24),
            }),
            rms_log10_residual: 0.04538000149726575,
            points: 60,
        },
    );
}

#[test]
fn a_noisy_power_law_has_no_rolloff_and_agrees_with_linear_regression() {
    let row = |(wavelength_m, noise): (f64, f64)| {
        let ratio: f64 = wavelength_m / 1e-6;
        (wavelength_m, 1e-24 * ratio * ratio * ratio.sqrt() * (1.0 + 0.4 * noise))
    };
    let fit =
        fit_self_affine(&profile(wavelengths_m(1e-5, 0.85, 40).zip(uniform(777)).map(row)), ..).unwrap();
    assert_fit(
        &fit,
        &SelfAffineFit {
            hurst_exponent: 0.7460658898501181,
            hurst_exponent_se: Some(0.0046559316096381285),
            rolloff: None,
            rms_log10_residual: 0.04676815738484159,
            points: 40,
        },
    );
}

#[test]
fn measured_diamond_rolls_off_below_a_micrometre() {
    assert_fit(
        &fit_self_affine(&profile(DIAMOND), ..).unwrap(),
        &SelfAffineFit {
            hurst_exponent: 0.9287371362298898,
            hurst_exponent_se: Some(0.04443582811847939),
            rolloff: Some(RollOff {
                wavelength_m: 8.091042961659892e-7,
                wavelength_se_m: Some(9.975900019341489e-8),
                plateau_m3: 1.0785488533494739e-22,
                plateau_se_m3: Some(1.4577432349787255e-23),
            }),
            rms_log10_residual: 0.24692435462388052,
            points: 46,
        },
    );
}

#[test]
fn the_band_selects_the_samples() {
    let row = |wavelength_m| (wavelength_m, self_affine_m3(wavelength_m, 0.8, 1e-6));
    let psd = profile(wavelengths_m(1e-4, 0.5, 20).map(row));
    let band = psd.wavelengths_m()[15]..=psd.wavelengths_m()[3];
    let fit = fit_self_affine(&psd, band).unwrap();
    assert_eq!(fit.points, 13);
    assert_relative_eq!(fit.rolloff.unwrap().wavelength_m, 1e-6, max_relative = 1e-9, epsilon = 0.0);
}

#[test]
fn as_many_parameters_as_samples_leave_no_standard_errors() {
    let row = |wavelength_m| (wavelength_m, self_affine_m3(wavelength_m, 0.8, 1e-6));
    let three = fit_self_affine(&profile([1e-5, 1e-6, 1e-7].map(row)), ..).unwrap();
    let rolloff = three.rolloff.unwrap();
    assert_relative_eq!(three.hurst_exponent, 0.8, max_relative = 1e-9);
    assert_relative_eq!(rolloff.wavelength_m, 1e-6, max_relative = 1e-9, epsilon = 0.0);
    assert_eq!((three.hurst_exponent_se, rolloff.wavelength_se_m, rolloff.plateau_se_m3), (None, None, None));

    let two = fit_self_affine(&profile([(1e-5, 1e-20), (1e-6, 1e-22)]), ..).unwrap();
    assert_relative_eq!(two.hurst_exponent, 0.5, max_relative = 1e-14);
    assert_eq!((two.hurst_exponent_se, two.rolloff, two.points), (None, None, 2));
}

#[test]
fn a_band_with_fewer_than_two_samples_is_refused() {
    let psd = profile([(1e-5, 1e-20), (1e-6, 1e-22)]);
    let error = fit_self_affine(&psd, 2e-6..).unwrap_err();
    assert_eq!(error, FitError::TooFewSamples { points: 1 });
    assert_eq!(
        error.to_string(),
        "fitting a self-affine spectrum: 1 sample; widen the band to hold at least 2"
    );
    assert_eq!(fit_self_affine(&psd, f64::NAN..), Err(FitError::TooFewSamples { points: 0 }));
}

fn assert_fit(actual: &SelfAffineFit, expected: &SelfAffineFit) {
    let close = |actual: f64, expected: f64| {
        assert_relative_eq!(actual, expected, max_relative = 1e-11, epsilon = 0.0);
    };
    let close_if_any = |actual: Option<f64>, expected: Option<f64>| {
        assert_eq!(actual.is_some(), expected.is_some());
        actual.zip(expected).into_iter().for_each(|(actual, expected)| close(actual, expected));
    };
    close(actual.hurst_exponent, expected.hurst_exponent);
    close_if_any(actual.hurst_exponent_se, expected.hurst_exponent_se);
    close(actual.rms_log10_residual, expected.rms_log10_residual);
    assert_eq!(actual.points, expected.points);
    assert_eq!(actual.rolloff.is_some(), expected.rolloff.is_some());
    if let Some((actual, expected)) = actual.rolloff.zip(expected.rolloff) {
        close(actual.wavelength_m, expected.wavelength_m);
        close_if_any(actual.wavelength_se_m, expected.wavelength_se_m);
        close(actual.plateau_m3, expected.plateau_m3);
        close_if_any(actual.plateau_se_m3, expected.plateau_se_m3);
    }
}

/// The gradient of the sum of squares vanishes at the parameters of every fit: it is a minimum.
#[test]
fn many_noisy_spectra_are_fitted_at_a_minimum() {
    for seed in 1..=60 {
        let mut random = uniform(seed * 7_919);
        let mut next = || random.next().unwrap();
        let (hurst, rolloff_m) = (0.75 + 0.6 * next(), 1e-6 * 10f64.powf(2.0 * next()));
        let noise = 0.8 * next().abs();
        let rows: Vec<(f64, f64)> = wavelengths_m(1e-4, 0.85, 60)
            .map(|wavelength_m| {
                (wavelength_m, self_affine_m3(wavelength_m, hurst, rolloff_m) * (1.0 + noise * next()))
            })
            .collect();
        let fit = fit_self_affine(&profile(rows.iter().copied()), ..).unwrap();
        let rolloff = fit.rolloff.expect("two decades of plateau");
        let sum = |[ln_plateau, exponent, ln_q_r]: [f64; 3]| -> f64 {
            let residual = |(wavelength_m, c1d_m3): &(f64, f64)| {
                let x = (-2.0 * ((wavelength_m / 1e-6).ln() + ln_q_r)).exp().ln_1p();
                ln_plateau - exponent * x - (c1d_m3 / 1e-22).ln()
            };
            rows.iter().map(residual).map(|residual| residual * residual).sum()
        };
        let fitted = [
            (rolloff.plateau_m3 / 1e-22).ln(),
            fit.hurst_exponent + 0.5,
            -(rolloff.wavelength_m / 1e-6).ln(),
        ];
        let least = sum(fitted);
        assert_relative_eq!(least, (fit.rms_log10_residual * 10f64.ln()).powi(2) * 60.0, max_relative = 1e-9);
        // The true parameters fit no better, and neither do neighbours.
        assert!(least <= sum([2f64.ln(), hurst + 0.5, -(rolloff_m / 1e-6).ln()]), "{seed}");
        for parameter in 0..3 {
            for step in [-1e-4, 1e-4] {
                let mut beside = fitted;
                beside[parameter] += step;
                assert!(least <= sum(beside), "{seed}: parameter {parameter}");
            }
        }
    }
}
