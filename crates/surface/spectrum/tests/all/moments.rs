//! Spectral moments and asperity parameters against values of 50-digit arithmetic.

use approx::assert_relative_eq;
use spectrum::{
    AsperityParameters, Convention, Moments, Normalisation, ProfilePsd, Psd, cumulative_moments,
    cumulative_moments_to,
};

fn profile(wavelengths_m: Vec<f64>, c1d_m3: Vec<f64>) -> ProfilePsd {
    Psd::new(wavelengths_m, c1d_m3, Convention::C1D).unwrap().profile().unwrap()
}

/// A plateau, a steeper part, an interval that falls like 1/q, and steep parts.
fn kinked() -> ProfilePsd {
    profile(
        vec![2e-3, 5e-4, 1e-5, 8e-6, 5.65e-9, 1e-9],
        vec![1.2e-22, 1.2e-22, 3e-23, 2.4e-23, 5.8e-28, 7e-30],
    )
}

/// 100,000 samples of a self-affine spectrum (H = 0.75, roll-off at 1 um) over 7 decades, made with correctly
/// rounded operations only, so that any other program gets the same numbers.
fn dense() -> ProfilePsd {
    let wavelengths_m: Vec<f64> =
        std::iter::successors(Some(1e-3), |wavelength| Some(wavelength * (1.0 - 1.61e-4)))
            .take(100_000)
            .collect();
    let c1d_m3 = |wavelength_m: &f64| {
        let ratio = 1e-6 / wavelength_m;
        let x: f64 = 1.0 + ratio * ratio;
        1e-22 / (x * x.sqrt().sqrt())
    };
    let values = wavelengths_m.iter().map(c1d_m3).collect();
    profile(wavelengths_m, values)
}

fn assert_moments(actual: &Moments, expected: (f64, f64, f64, f64), max_relative: f64) {
    let (wavelength_m, m0_m2, m2, m4_per_m2) = expected;
    assert_relative_eq!(*actual, Moments { wavelength_m, m0_m2, m2, m4_per_m2 }, max_relative = max_relative);
}

#[test]
fn moments_of_a_kinked_spectrum_agree_with_high_precision_values_at_every_cutoff() {
    let expected = [
        (5e-4, 3.6e-19, 2.4871403090745183e-11, 0.0023915880030668277),
        (1e-5, 8.90975732988039e-18, 8.953228325840519e-7, 201291.70813719014),
        (8e-6, 1.0248618637765647e-17, 1.561521129657584e-6, 538266.2824329425),
        (5.65e-9, 2.2706004288571442e-17, 0.16542735735636185, 8.883121219943805e16),
        (1e-9, 2.2829365748207636e-17, 0.8306019071813957, 8.869530251422787e18),
    ];
    let moments = cumulative_moments(&kinked(), Normalisation::Parseval);
    assert_eq!(moments.len(), expected.len());
    for (actual, expected) in moments.iter().zip(expected) {
        assert_moments(actual, expected, 2e-15);
    }
}

#[test]
fn moments_of_100_000_samples_stay_within_1e_13_of_high_precision_values() {
    let moments = cumulative_moments(&dense(), Normalisation::Parseval);
    assert_eq!(moments.len(), 99_999);
    for (entry, expected) in [
        (0, (0.000999839, 3.2205144771879844e-23, 1.2716128949762975e-15, 5.0209349471875635e-8)),
        (999, (0.0008512810368234339, 3.493998726092693e-20, 1.6343854588228856e-12, 7.710682953167858e-5)),
        (49_999, (3.188951812618703e-7, 2.1663697629595692e-16, 0.010174074612858484, 1637223890869.6765)),
        (99_998, (1.0171051202447785e-10, 2.3942790991637405e-16, 1.5468816057314692, 1.195074091170741e21)),
    ] {
        assert_moments(&moments[entry], expected, 3e-15);
    }
}

#[test]
fn a_cutoff_between_samples_ends_its_interval_there() {
    let to_cutoff = cumulative_moments_to(&kinked(), Normalisation::Parseval, 1e-7);
    assert_eq!(to_cutoff.len(), 4);
    assert_eq!(to_cutoff[..3], cumulative_moments(&kinked(), Normalisation::Parseval)[..3]);
    let expected = (1e-7, 2.1467395691689504e-17, 0.002009190963720552, 3445543904060.6284);
    assert_moments(&to_cutoff[3], expected, 3e-15);
    assert_relative_eq!(
        kinked().value_at(1e-7).unwrap(),
        3.9073108887684853e-26,
        max_relative = 1e-14,
        epsilon = 0.0
    );
}

#[test]
fn cutoffs_on_and_beyond_the_ends_of_the_spectrum_take_what_there_is() {
    let all = cumulative_moments(&kinked(), Normalisation::Parseval);
    let to_cutoff = |cutoff_m| cumulative_moments_to(&kinked(), Normalisation::Parseval, cutoff_m);
    assert_eq!(to_cutoff(1e-5), all[..2]);
    assert_eq!(to_cutoff(1e-9), all);
    assert_eq!(to_cutoff(1e-10), all);
    assert!(to_cutoff(2e-3).is_empty());
    assert!(to_cutoff(f64::NAN).is_empty());
}

#[test]
fn moments_as_printed_are_pi_times_parsevals() {
    let parseval = cumulative_moments(&kinked(), Normalisation::Parseval)[4];
    let printed = cumulative_moments(&kinked(), Normalisation::AsPrinted)[4];
    assert_relative_eq!(
        printed.m0_m2,
        std::f64::consts::PI * parseval.m0_m2,
        max_relative = 1e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(printed.rms_slope() / parseval.rms_slope(), 1.7724538509055159, max_relative = 1e-15);
}

#[test]
fn root_mean_squares_are_the_roots_of_the_moments() {
    let moments = Moments { wavelength_m: 1e-9, m0_m2: 4e-18, m2: 0.09, m4_per_m2: 1e16 };
    assert_relative_eq!(moments.rms_height_m(), 2e-9, max_relative = 1e-15, epsilon = 0.0);
    assert_relative_eq!(moments.rms_slope(), 0.3, max_relative = 1e-15);
    assert_relative_eq!(moments.rms_gradient(), 0.4242640687119285, max_relative = 1e-15);
}

#[test]
fn asperity_parameters_agree_with_high_precision_values() {
    let moments = cumulative_moments(&kinked(), Normalisation::Parseval);
    let fine = AsperityParameters {
        radius_m: 2.2318031921562723e-10,
        density_per_m2: 3.2707394174352096e17,
        sigma_s_m: 4.770703152944645e-9,
        offset_m: 6.294003266324231e-10,
        nayak_alpha: 293.5003458386162,
    };
    let coarse = AsperityParameters {
        radius_m: 13.591363286364748,
        density_per_m2: 2945264.681923182,
        sigma_s_m: 3.5782322129145195e-10,
        offset_m: 1.147734543120477e-9,
        nayak_alpha: 1.3918367346938776,
    };
    assert_relative_eq!(AsperityParameters::from_moments(&moments[4]).unwrap(), fine, max_relative = 5e-15);
    assert_relative_eq!(AsperityParameters::from_moments(&moments[0]).unwrap(), coarse, max_relative = 5e-15);
    assert!(fine.is_gaussian_isotropic());
    assert!(!coarse.is_gaussian_isotropic());
}

#[test]
fn asperity_parameters_need_moments_that_neither_vanish_nor_overflow() {
    let moments = Moments { wavelength_m: 1e-9, m0_m2: 1e-18, m2: 0.1, m4_per_m2: 1e17 };
    assert!(AsperityParameters::from_moments(&moments).is_some());
    for broken in [
        Moments { m0_m2: 0.0, ..moments },
        Moments { m2: 0.0, ..moments },
        Moments { m4_per_m2: 0.0, ..moments },
        Moments { m4_per_m2: f64::INFINITY, ..moments },
    ] {
        assert_eq!(AsperityParameters::from_moments(&broken), None, "{broken:?}");
    }
}
