//! Spectra of areas: from profiles and back, their moments, and what is done about noise.

use std::num::NonZeroU32;

use approx::assert_relative_eq;
use spectrum::random_surfaces::{AreaSpectrum, RandomSurfaceError, SelfAffine, Size};
use spectrum::{Convention, Normalisation, ProfilePsd, Psd, cumulative_moments};

const TWENTY: NonZeroU32 = NonZeroU32::new(20).unwrap();

/// A self-affine surface whose box is 1 m long, by the numbers of waves that fit into it.
fn self_affine(longest: f64, rolloff: f64, shortest: f64, hurst_exponent: f64) -> AreaSpectrum {
    AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent,
        longest_m: 1.0 / longest,
        rolloff_m: 1.0 / rolloff,
        shortest_m: 1.0 / shortest,
        size: Size::RmsGradient(0.3),
    })
    .unwrap()
}

/// C1D that falls as q^-(1 + 2H) over `decades` from 1 mm down, with so many samples a decade.
fn power_law(hurst: f64, decades: u32, per_decade: u32) -> ProfilePsd {
    let wavelengths_m: Vec<f64> = (0..=decades * per_decade)
        .map(|i| 1e-3 * 10f64.powf(-f64::from(i) / f64::from(per_decade)))
        .collect();
    let c1d_m3 =
        wavelengths_m.iter().map(|lambda_m| 1e-16 * (lambda_m / 1e-3).powf(1.0 + 2.0 * hurst)).collect();
    ProfilePsd::new(wavelengths_m, c1d_m3).unwrap()
}

#[test]
fn a_power_law_becomes_the_one_that_theory_names() {
    // Ciso = 2 sqrt(pi) Gamma(1 + H)/Gamma(H + 1/2) C1D/q without end; factors from tables of the gamma function.
    for (hurst, factor) in [(0.5, std::f64::consts::PI), (1.0, 4.0)] {
        let profile = power_law(hurst, 3, 5);
        let area = AreaSpectrum::from_profile(&profile).unwrap();
        assert_eq!(area.conversion().levelled_share, 0.0);
        assert!(area.conversion().end_error < 1e-12);
        for (lambda_m, c1d_m3) in profile.wavelengths_m().iter().zip(profile.c1d_m3()) {
            let q = std::f64::consts::TAU / lambda_m;
            assert_relative_eq!(area.ciso_m4(q), factor * c1d_m3 / q, max_relative = 1e-8);
        }
    }
}

#[test]
fn moments_are_the_integrals_of_powers() {
    let area = self_affine(2.0, 8.0, 64.0, 0.8);
    let q = |waves: f64| std::f64::consts::TAU * waves;
    let at_rolloff = area.ciso_m4(q(8.0));
    let integral = |k: f64| {
        let level = at_rolloff * (q(8.0).powf(k + 1.0) - q(2.0).powf(k + 1.0)) / (k + 1.0);
        let exponent = k + 1.0 - 3.6;
        let fall =
            at_rolloff * q(8.0).powf(3.6) * (q(64.0).powf(exponent) - q(8.0).powf(exponent)) / exponent;
        (level + fall) / std::f64::consts::TAU
    };
    assert_relative_eq!(area.mean_square_height_m2(), integral(1.0), max_relative = 1e-13);
    assert_relative_eq!(area.mean_square_gradient(), integral(3.0), max_relative = 1e-13);
    assert_relative_eq!(area.mean_square_laplacian_per_m2(), integral(5.0), max_relative = 1e-13);
    assert_relative_eq!(area.mean_square_gradient().sqrt(), 0.3, max_relative = 1e-14);
    let moments = area.moments();
    assert_relative_eq!(moments.rms_gradient(), 0.3, max_relative = 1e-14);
    // A thin ring has the least that Nayak's parameter can be.
    let ring = self_affine(1.0, 1.0, 1.0 + 1e-6, 0.8).moments();
    assert_relative_eq!(ring.m0_m2 * ring.m4_per_m2 / (ring.m2 * ring.m2), 1.5, max_relative = 1e-9);
}

#[test]
fn profiles_of_a_cut_surface_have_its_moments_and_lead_back_to_it() {
    for area in [
        self_affine(1.0, 1.0, 100.0, 0.8),
        self_affine(8.0, 8.0, 64.0, 0.8),
        self_affine(1.0, 10.0, 1e4, 0.3),
    ] {
        let wavelengths_m = area.profile_wavelengths_m(100.0 * area.longest_m(), TWENTY);
        let profile = area.profile(&wavelengths_m).unwrap();
        let found = *cumulative_moments(&profile, Normalisation::Parseval).last().unwrap();
        let expected = area.moments();
        assert_relative_eq!(found.m0_m2, expected.m0_m2, max_relative = 1e-2);
        assert_relative_eq!(found.m2, expected.m2, max_relative = 2e-3);
        assert_relative_eq!(found.m4_per_m2, expected.m4_per_m2, max_relative = 5e-3);
        // The last sample is just above the shortest wavelength.
        let known = AreaSpectrum::from_profile(&profile).unwrap();
        assert_relative_eq!(known.mean_square_gradient(), 2.0 * expected.m2, max_relative = 3e-3);
        // The samples alone lead back too. At wavelengths without waves, they leave small values of either sign.
        let samples = (profile.wavelengths_m().to_vec(), profile.c1d_m3().to_vec());
        let back = AreaSpectrum::from_profile(&ProfilePsd::new(samples.0, samples.1).unwrap()).unwrap();
        assert_eq!(back.conversion().levelled_share, 0.0);
        let known_gradient = known.mean_square_gradient();
        assert_relative_eq!(back.mean_square_gradient(), known_gradient, max_relative = 2e-3);
        for share in [0.1, 0.5, 0.9] {
            let q =
                std::f64::consts::TAU / (area.longest_m().powf(1.0 - share) * area.shortest_m().powf(share));
            assert_relative_eq!(back.ciso_m4(q), area.ciso_m4(q), max_relative = 1e-2);
        }
    }
}

#[test]
fn the_profile_of_a_level_surface_is_a_quarter_of_an_ellipse() {
    // Ciso = c between q_1 and q_2: C1D = (c/pi) [sqrt(q_2^2 - q^2) - sqrt(q_1^2 - q^2)], the latter below q_1 alone.
    let area = self_affine(2.0, 5.0, 5.0, 0.7);
    let c = area.ciso_m4(std::f64::consts::TAU * 3.0);
    let waves = [0.1, 1.0, 1.9, 2.5, 4.9];
    let profile = area.profile(&waves.map(|waves| 1.0 / waves)).unwrap();
    for (waves, found) in waves.into_iter().zip(profile.c1d_m3()) {
        let root = |end: f64| (end * end - waves * waves).max(0.0).sqrt();
        let expected = 2.0 * c * (root(5.0) - root(2.0));
        assert_relative_eq!(*found, expected, max_relative = 1e-12);
    }
    assert!(matches!(area.profile(&[1.0, 0.2]), Err(RandomSurfaceError::NoWaves { .. })));
    assert!(matches!(area.profile(&[1.0, 2.0]), Err(RandomSurfaceError::Samples(_))));
}

#[test]
fn windows_add_up_to_the_whole() {
    let area = AreaSpectrum::from_profile(&power_law(0.7, 3, 10)).unwrap();
    let parts = [area.cut(1e-3, 3e-5).unwrap(), area.cut(3e-5, 1e-6).unwrap()];
    let sum: f64 = parts.iter().map(AreaSpectrum::mean_square_gradient).sum();
    assert_relative_eq!(sum, area.mean_square_gradient(), max_relative = 1e-13);
    assert_eq!(area.cut(1e-3, 1e-6).unwrap().mean_square_gradient(), area.mean_square_gradient());
    assert_eq!(parts[0].ciso_m4(std::f64::consts::TAU / 2e-5), 0.0);
    assert!(matches!(area.cut(1e-2, 1e-5), Err(RandomSurfaceError::BeyondSpectrum { .. })));
    assert!(matches!(area.cut(1e-5, 1e-5), Err(RandomSurfaceError::EmptyBand { .. })));
    assert!(matches!(area.cut(1e-5, f64::NAN), Err(RandomSurfaceError::EmptyBand { .. })));
}

#[test]
fn noise_is_smoothed_where_profiles_are_those_of_no_surface() {
    let clean = power_law(0.7, 3, 20);
    let noisy = |size: f64| {
        let factors = (0..clean.len()).map(|i| (size * (1.2 * i as f64).sin()).exp());
        let c1d_m3 = clean.c1d_m3().iter().zip(factors).map(|(c, factor)| c * factor).collect();
        AreaSpectrum::from_profile(&ProfilePsd::new(clean.wavelengths_m().to_vec(), c1d_m3).unwrap()).unwrap()
    };
    let exact = AreaSpectrum::from_profile(&clean).unwrap().mean_square_gradient();
    let a_little = noisy(0.05);
    assert_eq!(a_little.conversion().levelled_share, 0.0);
    let much = noisy(0.7);
    assert!(much.conversion().levelled_share > 0.05, "{:?}", much.conversion());
    assert_relative_eq!(much.mean_square_gradient(), exact, max_relative = 0.15);
}

#[test]
fn a_narrow_peak_of_turning_keeps_its_slopes() {
    let clean = power_law(0.7, 3, 10);
    let peaked = clean.c1d_m3().iter().enumerate().map(|(i, c1d)| if i == 12 { 1e6 * c1d } else { *c1d });
    let peaked = ProfilePsd::new(clean.wavelengths_m().to_vec(), peaked.collect()).unwrap();
    let m2 = cumulative_moments(&peaked, Normalisation::Parseval).last().unwrap().m2;
    let surface = AreaSpectrum::from_profile(&peaked).unwrap();
    // The fall behind the peak is narrower than half a step. Means of logarithms would leave a millionth.
    let kept = surface.mean_square_gradient() / (2.0 * m2);
    assert!((0.7..1.1).contains(&kept), "{kept}");
}

#[test]
fn spectra_of_areas_are_taken_as_they_are() {
    let (wavelengths_m, ciso_m4) = (vec![1e-3, 1e-4, 1e-5], vec![1e-20, 1e-22, 1e-26]);
    let direct =
        AreaSpectrum::from_psd(&Psd::new(wavelengths_m.clone(), ciso_m4.clone(), Convention::Ciso).unwrap())
            .unwrap();
    assert_relative_eq!(direct.ciso_m4(std::f64::consts::TAU / 1e-4), 1e-22, max_relative = 1e-12);
    let persson = ciso_m4.iter().map(|ciso| ciso / (4.0 * std::f64::consts::PI.powi(2))).collect();
    let persson = Psd::new(wavelengths_m, persson, Convention::Persson).unwrap();
    let of_persson = AreaSpectrum::from_psd(&persson).unwrap();
    assert_relative_eq!(
        of_persson.mean_square_gradient(),
        direct.mean_square_gradient(),
        max_relative = 1e-12
    );
    // Profiles lead back by the integral, in any convention of theirs.
    let profile = power_law(0.6, 2, 10);
    let halved = profile.c1d_m3().iter().map(|c1d_m3| 2.0 * c1d_m3).collect();
    let frequency = Psd::new(profile.wavelengths_m().to_vec(), halved, Convention::Frequency).unwrap();
    assert_eq!(AreaSpectrum::from_psd(&frequency).unwrap(), AreaSpectrum::from_profile(&profile).unwrap());
}

#[test]
fn the_error_of_the_end_is_what_another_end_changes_the_rms_gradient_by() {
    // C1D that falls more gently than that of any surface is taken to go on as 1/q, or else as q^-3.
    let profile = |beyond: Option<i32>| {
        let last = if beyond.is_some() { 15 } else { 3 };
        let wavelengths_m: Vec<f64> = (0..=last).map(|i| 1e-3 * 10f64.powf(-f64::from(i) / 3.0)).collect();
        let c1d_m3 = wavelengths_m.iter().map(|lambda_m| {
            let shorter = (lambda_m / 1e-4).min(1.0);
            1e-16 * lambda_m.max(1e-4).sqrt() * beyond.map_or(1.0, |exponent| shorter.powi(exponent))
        });
        ProfilePsd::new(wavelengths_m.clone(), c1d_m3.collect()).unwrap()
    };
    let cut = |psd: &ProfilePsd, shortest_m: f64| {
        AreaSpectrum::from_profile(&psd.truncated_at(0.99 * shortest_m).unwrap()).unwrap()
    };
    for (shortest_m, least) in [(1e-4, 0.1), (2.154e-4, 0.005)] {
        let found = cut(&profile(None), shortest_m).conversion().end_error;
        let [gentle, steep] =
            [1, 3].map(|exponent| cut(&profile(Some(exponent)), shortest_m).mean_square_gradient());
        let expected = ((steep / gentle).sqrt() - 1.0).abs();
        assert!(expected > least);
        assert_relative_eq!(found, expected, max_relative = 5e-3);
    }
}

#[test]
fn what_is_no_surface_is_refused() {
    let single = ProfilePsd::new(vec![1.0], vec![1.0]).unwrap();
    assert!(matches!(
        AreaSpectrum::from_profile(&single),
        Err(RandomSurfaceError::TooFewSamples { samples: 1 })
    ));
    // C1D that does not fall is that of waves beyond its end.
    let level = ProfilePsd::new(vec![1.0, 0.1], vec![1.0, 1.0]).unwrap();
    let level = AreaSpectrum::from_profile(&level).unwrap();
    assert!(level.mean_square_gradient() > 0.0 && level.conversion().end_error > 0.2);
    let good = SelfAffine {
        hurst_exponent: 0.8,
        longest_m: 1.0,
        rolloff_m: 0.5,
        shortest_m: 0.1,
        size: Size::RmsHeightM(1e-6),
    };
    assert_relative_eq!(
        AreaSpectrum::self_affine(&good).unwrap().mean_square_height_m2(),
        1e-12,
        max_relative = 1e-13
    );
    let refused = |bad: SelfAffine| AreaSpectrum::self_affine(&bad).unwrap_err();
    for (bad, value) in [
        (SelfAffine { hurst_exponent: 1.2, ..good }, 1.2),
        (SelfAffine { rolloff_m: 2.0, ..good }, 2.0),
        (SelfAffine { rolloff_m: 0.05, ..good }, 0.05),
    ] {
        assert!(matches!(refused(bad), RandomSurfaceError::Bounds(out) if out.value == value), "{bad:?}");
    }
    let flat = refused(SelfAffine { size: Size::RmsGradient(f64::NAN), ..good });
    assert!(matches!(flat, RandomSurfaceError::Bounds(out) if out.value.is_nan()), "{flat}");
    let narrow = refused(SelfAffine { longest_m: 0.1, rolloff_m: 0.1, ..good });
    assert!(matches!(narrow, RandomSurfaceError::EmptyBand { .. }), "{narrow}");
}

#[test]
fn a_weight_multiplies_the_spectrum_and_its_moments() {
    let area = self_affine(2.0, 8.0, 64.0, 0.6);
    let weighted = area.weighted(|q_rad_per_m| 1.0 / q_rad_per_m.powi(2));
    assert_relative_eq!(weighted.mean_square_gradient(), area.mean_square_height_m2(), max_relative = 1e-12);
    let smooth = |q_rad_per_m: f64| (q_rad_per_m / 60.0).tanh().powi(2);
    let bent = area.weighted(smooth);
    for q_rad_per_m in [13.0, 60.0, 399.0] {
        let expected = smooth(q_rad_per_m) * area.ciso_m4(q_rad_per_m);
        assert_relative_eq!(bent.ciso_m4(q_rad_per_m), expected, max_relative = 2e-4);
    }
    assert_eq!((bent.longest_m(), bent.shortest_m()), (area.longest_m(), area.shortest_m()));
}

/// C1D and Ciso of a surface with C1D = c (1 + (q/q_0)^2)^-a, which is known in closed form.
fn rolling_off(q_0: f64, a: f64, ratio_of_gammas: f64) -> impl Fn(f64) -> [f64; 2] {
    move |q: f64| {
        let base = 1.0 + (q / q_0).powi(2);
        let factor = 2.0 * std::f64::consts::PI.sqrt() * ratio_of_gammas / q_0;
        [base.powf(-a), factor * base.powf(-a - 0.5)]
    }
}

/// C1D and Ciso against the wavevector.
type Pair<'p> = &'p dyn Fn(f64) -> [f64; 2];

/// Samples C1D between two wavevectors, converts it, and returns h' at each of the samples over that of Ciso.
fn gradients_over_true(pair: Pair<'_>, band: [f64; 2], per_decade: u32) -> Vec<f64> {
    let ln_band = (band[1] / band[0]).ln();
    let steps = (f64::from(per_decade) * ln_band / 10f64.ln()).round();
    let q = |at: f64| band[0] * (ln_band * at / steps).exp();
    let wavelengths_m: Vec<f64> =
        (0..=steps as u32).map(|at| std::f64::consts::TAU / q(f64::from(at))).collect();
    let c1d_m3 =
        wavelengths_m.iter().map(|wavelength_m| pair(std::f64::consts::TAU / wavelength_m)[0]).collect();
    let area = AreaSpectrum::from_profile(&ProfilePsd::new(wavelengths_m.clone(), c1d_m3).unwrap()).unwrap();
    let found = area.mean_square_gradients(&wavelengths_m);
    assert!(found.is_sorted_by(|one, next| one < next) && found[0] == 0.0);
    assert_relative_eq!(*found.last().unwrap(), area.mean_square_gradient(), max_relative = 1e-12);
    // Simpson's rule over ln q between neighbouring samples, in 64 parts.
    let mut truth = 0.0;
    let mut ratios = Vec::new();
    for at in 1..=steps as u32 {
        let (start, part) = (f64::from(at) - 1.0, 1.0 / 64.0);
        let density = |share: f64| q(start + share).powi(4) * pair(q(start + share))[1];
        let simpson = |i: u32| {
            let from = f64::from(i) * part;
            (density(from) + 4.0 * density(from + 0.5 * part) + density(from + part)) / 6.0
        };
        truth += (0..64).map(simpson).sum::<f64>() * part * ln_band / steps / std::f64::consts::TAU;
        // Beyond the first tenth of a decade.
        if q(f64::from(at)) > 1.26 * band[0] {
            ratios.push((found[at as usize] / truth).sqrt());
        }
    }
    ratios
}

#[test]
fn gradients_up_to_every_sample_are_those_of_closed_forms() {
    // Gamma(a + 1/2)/Gamma(a) for a = 0.7, 1, 1.3, 1.45.
    let level_then_steep = rolling_off(3e6, 1.3, 0.931_383_770_980_243 / 0.897_470_696_306_277_2);
    let exponential = rolling_off(1.0, 1.0, 0.5 * std::f64::consts::PI.sqrt());
    let [steep, shallow] = [
        rolling_off(1.0, 1.45, 0.979_880_651_272_580_3 / 0.885_661_380_271_365_3),
        rolling_off(100.0, 0.7, 0.918_168_742_399_760_6 / 1.298_055_332_647_557_7),
    ];
    let bifractal = move |q: f64| {
        let ([c, d], [e, f]) = (steep(q), shallow(q));
        [c + 1e-5 * e, d + 1e-5 * f]
    };
    let tail = rolling_off(0.5, 1.3, 0.931_383_770_980_243 / 0.897_470_696_306_277_2);
    let bell = move |q: f64| {
        let [c, d] = tail(q);
        let bell = (-0.5 * q * q).exp();
        [bell + 1e-3 * c, std::f64::consts::TAU.sqrt() * bell + 1e-3 * d]
    };
    let pairs: [(Pair<'_>, [f64; 2]); 4] = [
        (&level_then_steep, [4e4, 1.8e9]),
        (&exponential, [0.05, 50.0]),
        (&bifractal, [0.1, 1e4]),
        (&bell, [0.03, 100.0]),
    ];
    for (of, (pair, band)) in pairs.into_iter().enumerate() {
        for (per_decade, bound) in [(5, 1e-2), (10, 1e-3), (20, 1e-4), (200, 1e-5)] {
            let off =
                gradients_over_true(pair, band, per_decade).into_iter().map(|ratio| (ratio - 1.0).abs());
            let worst = off.fold(0.0, f64::max);
            assert!(worst < bound, "pair {of}, {per_decade} a decade: {worst}");
        }
    }
}

#[test]
fn a_cutoff_cuts_the_surface() {
    let whole = power_law(0.7, 3, 10);
    let area = AreaSpectrum::from_profile(&whole).unwrap();
    let cut = AreaSpectrum::from_profile(&whole.truncated_at(2e-5).unwrap()).unwrap();
    assert_relative_eq!(cut.shortest_m(), 1e-3 * 10f64.powf(-1.6), max_relative = 1e-12);
    let expected = area.mean_square_gradients(&[cut.shortest_m()])[0];
    assert_relative_eq!(cut.mean_square_gradient(), expected, max_relative = 1e-12);
}

#[test]
fn a_table_of_areas_is_the_surface_at_every_step() {
    let wavelengths_m: Vec<f64> = (0..=20).map(|i| 1e-3 * 10f64.powf(-f64::from(i) / 10.0)).collect();
    let ciso_m4 = wavelengths_m.iter().map(|wavelength_m| wavelength_m.powf(2.4)).collect();
    let psd = Psd::new(wavelengths_m.clone(), ciso_m4, Convention::Ciso).unwrap();
    let area = AreaSpectrum::from_psd(&psd).unwrap();
    let profile = psd.profile().unwrap();
    assert_eq!(AreaSpectrum::from_profile(&profile).unwrap(), area);
    let gradient = |profile: &ProfilePsd| AreaSpectrum::from_profile(profile).unwrap().mean_square_gradient();
    let resampled = profile.resampled(NonZeroU32::new(7).unwrap());
    assert_relative_eq!(gradient(&resampled), area.mean_square_gradient(), max_relative = 1e-12);
    let cut = profile.truncated_at(1.001e-4 / 1.01).unwrap();
    assert_relative_eq!(gradient(&cut), area.mean_square_gradients(&[1e-4])[0], max_relative = 1e-9);
    let doubled = profile.with_values(profile.c1d_m3().iter().map(|c1d| 2.0 * c1d).collect()).unwrap();
    assert_relative_eq!(gradient(&doubled), 2.0 * area.mean_square_gradient(), max_relative = 1e-12);
}
