//! The last channel of a spectrum whose values were computed independently, and what holds for any.

use std::f64::consts::{PI, TAU};

use persson::corrections::Correction;
use persson::sealing::{PercolationThreshold, SealingLaw};
use persson::{EnergyFactor, PerssonModel, Roughness, RoughnessSample};
use proptest::prelude::*;

/// Persson's C(q) = C0 q^-3.6 from 1e4 to 1e6 rad/m, h_rms = 6 um: the spectrum of the separations.
const C0: f64 = 0.000_023_041_816_986_325_86;
const SHARPEST: f64 = 1e6;
const FLATTEST: f64 = 1e4;

/// C1D = pi^2 q C(q), at this number of samples.
fn roughness(intervals: u32) -> Roughness {
    let moment = |q: f64, k: f64| PI * C0 * (q.powf(k - 1.6) - FLATTEST.powf(k - 1.6)) / (k - 1.6);
    let sample = |i: u32| {
        let q = FLATTEST * (SHARPEST / FLATTEST).powf(f64::from(i) / f64::from(intervals));
        RoughnessSample {
            wavelength_m: TAU / q,
            c1d_m3: PI * PI * C0 * q.powf(-2.6),
            moments: [0.0, 2.0, 4.0].map(|k| moment(q, k)),
            amplitude_m: 0.0,
        }
    };
    Roughness::new(&(0..=intervals).map(sample).collect::<Vec<_>>(), None)
}

fn law(intervals: u32, gamma: f64, correction: Option<Correction>, threshold: f64) -> SealingLaw {
    SealingLaw::new(
        &roughness(intervals),
        1.0,
        EnergyFactor::new(gamma).unwrap(),
        correction,
        PercolationThreshold::new(threshold).unwrap(),
    )
}

fn forms() -> impl Iterator<Item = Option<Correction>> {
    std::iter::once(None).chain(Correction::ALL.iter().copied().map(Some))
}

fn off(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

/// u_0, u_0/h_rms with h_rms = 6 um, and p_00, computed by mpmath under 1 Pa of modulus.
#[test]
fn light_loads_part_as_quadratures_find_it() {
    let rows = [
        (1.0, 6.321451744e-6, 1.053575291, 0.01884593055),
        (0.45, 2.844653285e-6, 0.4741088808, 0.08385494254),
    ];
    for (gamma, length_m, over_rms_height, pressure_pa) in rows {
        let model = PerssonModel::Elastic { contact_modulus_pa: 1.0, correction: None };
        for intervals in [1, 37] {
            let light = model
                .separation(&roughness(intervals), EnergyFactor::new(gamma).unwrap())
                .light_loads()
                .unwrap();
            assert!(off(light.decay_length_m, length_m) < 5e-10, "{light:?}");
            assert!(off(light.decay_length_m / 6e-6, over_rms_height) < 1e-9, "{light:?}");
            assert!(off(light.reference_pressure_pa, pressure_pa) < 5e-10, "{light:?}");
        }
    }
}

/// Computed by mpmath's adaptive quadrature and root search under 1 Pa of modulus and 0.01 Pa of pressure.
#[test]
fn the_last_channel_is_where_quadratures_find_it() {
    let rows = [
        // a_c, g, q_c in rad/m, ubar(q_c) in m, u_1(q_c) in m
        (0.42, 1.0, 12422.6363, 2.157053297e-6, 5.4034980e-6),
        (0.42, 0.45, 12422.6363, 2.499384676e-6, 5.6499254e-6),
        (0.5, 1.0, 11596.02104, 2.760195549e-6, 6.4260651e-6),
        (0.5, 0.45, 11596.02104, 3.065082354e-6, 6.3911599e-6),
    ];
    for (threshold, gamma, wavevector, mean_gap, constriction) in rows {
        // By one interval of the spectrum and by many.
        for intervals in [1, 37, 200] {
            let law = law(intervals, gamma, None, threshold);
            let channel = law.critical_constriction(0.01).unwrap();
            assert!(off(channel.wavevector_rad_per_m, wavevector) < 5e-10, "{channel:?}");
            assert!(off(channel.wavelength_m(), TAU / wavevector) < 5e-10, "{channel:?}");
            assert!(off(channel.mean_gap_m, mean_gap) < 5e-10, "{channel:?}");
            assert!(off(channel.opening_gap_m.unwrap(), constriction) < 2e-8, "{channel:?}");
            assert!(off(channel.area_fraction, threshold) < 1e-14);
        }
    }
}

#[test]
fn the_pressure_that_closes_it_is_the_theory_s_or_less_where_corrected() {
    let theory_pa = law(20, 0.45, None, 0.42).tight_pressure_pa();
    assert!(off(theory_pa, 0.07653239133) < 5e-10, "{theory_pa}");
    // With alpha = 139.8, as a map of such a spectrum has it: E* sqrt(m2 [g + (1 - g) a_c]) erfinv(a_c).
    let mut samples = [[0.0; 3], [1.0, 1.0, 139.8]].map(|moments| RoughnessSample {
        wavelength_m: 1.0,
        c1d_m3: 1.0,
        moments,
        amplitude_m: 0.0,
    });
    samples[1].wavelength_m = 0.01;
    let pressure = |correction| {
        let roughness = Roughness::new(&samples, None);
        SealingLaw::new(&roughness, 1.0, EnergyFactor::ALMQVIST, correction, PercolationThreshold::SIMULATED)
            .tight_pressure_pa()
    };
    let ratio = pressure(Some(Correction::AlgebraicNayak)) / pressure(None);
    assert!(off(0.07653239133 * ratio, 0.0671) < 1e-3, "{ratio}");
}

#[test]
fn it_is_tight_from_its_pressure_on() {
    for correction in forms() {
        for threshold in [0.3, 0.42, 0.5, 0.9] {
            let law = law(20, 0.45, correction, threshold);
            let tight_pa = law.tight_pressure_pa();
            assert!(law.critical_constriction(tight_pa * (1.0 + 1e-12)).is_none(), "{correction:?}");
            let last = law.critical_constriction(tight_pa * (1.0 - 1e-9)).unwrap();
            assert!(off(last.wavevector_rad_per_m, SHARPEST) < 1e-6, "{correction:?} {last:?}");
            assert!(last.opening_gap_m.unwrap() < 1e-9, "{correction:?} {last:?}");
            assert!(off(law.contact_at(SHARPEST, tight_pa).area_fraction, threshold) < 1e-12);
        }
    }
}

#[test]
fn nothing_rough_is_tight_under_any_load() {
    let smooth = Roughness::new(&[], None);
    let law = SealingLaw::new(&smooth, 1.0, EnergyFactor::ALMQVIST, None, PercolationThreshold::default());
    assert_eq!((law.tight_pressure_pa(), law.critical_constriction(1e-9)), (0.0, None));
    assert_eq!(law.contact_at(1.0, 1e-9).area_fraction, 1.0);
}

#[test]
fn what_is_no_share_is_no_threshold() {
    for share in [0.0, 1.0, -0.1, f64::NAN] {
        let error = PercolationThreshold::new(share).unwrap_err().to_string();
        assert!(error.contains("greater than 0 and less than 1"), "{error}");
    }
    assert_eq!(PercolationThreshold::default().area_fraction(), 0.42);
}

#[test]
fn what_is_seen_with_the_longest_wave_is_the_whole_gap() {
    for correction in forms() {
        let model = PerssonModel::Elastic { contact_modulus_pa: 1.0, correction };
        let whole =
            model.separation(&roughness(20), EnergyFactor::ALMQVIST).along(0.01).last().copied().unwrap();
        let first = law(20, 0.45, correction, 0.42).contact_at(FLATTEST, 0.01);
        assert_eq!((first.area_fraction, first.opening_gap_m), (1.0, None));
        assert!(off(first.mean_gap_m, whole.mean_gap_m) < 1e-14);
        let last = law(20, 0.45, correction, 0.42).contact_at(SHARPEST, 0.01);
        assert_eq!(last.mean_gap_m, 0.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn the_area_is_that_of_the_model(at in 1u32..=20, ln_p in -9.0..1.0f64) {
        for correction in forms() {
            let model = PerssonModel::Elastic { contact_modulus_pa: 1.0, correction };
            let areas = model.areas(&roughness(20), ln_p.exp()).unwrap();
            let q = roughness(20).places()[at as usize].wavevector_rad_per_m;
            let seen = law(20, 0.45, correction, 0.42).contact_at(q, ln_p.exp());
            prop_assert!(off(seen.area_fraction, areas[at as usize].contact()) < 1e-12, "{correction:?}");
        }
    }

    #[test]
    fn what_opens_is_the_slope_of_the_gap_over_that_of_the_area(ln_q in 9.4..13.6f64, ln_p in -7.0..-2.0f64) {
        let (q, pressure_pa) = (ln_q.exp(), ln_p.exp());
        for correction in forms() {
            let law = law(7, 0.45, correction, 0.42);
            let here = law.contact_at(q, pressure_pa);
            // Near full contact the area has no digits to take a difference of.
            if here.area_fraction > 0.99 {
                continue;
            }
            let step = 1e-5;
            let [more, less] = [step, -step].map(|ln: f64| law.contact_at(q * ln.exp(), pressure_pa));
            let slope = (more.mean_gap_m - less.mean_gap_m) / (more.area_fraction - less.area_fraction);
            let expected_m = here.mean_gap_m + here.area_fraction * slope;
            // Differences over a knot of alpha are of first order.
            prop_assert!(off(here.opening_gap_m.unwrap(), expected_m) < 1e-4, "{correction:?} {here:?} {expected_m}");
        }
    }

    #[test]
    fn a_larger_load_closes_longer_channels(ln_p in -7.0..-3.0f64, gamma in 0.3..1.0f64) {
        let pressure_pa = ln_p.exp();
        for correction in forms() {
            let law = law(20, gamma, correction, 0.42);
            let channel = |pressure_pa: f64| law.critical_constriction(pressure_pa);
            let (Some(light), Some(heavy)) = (channel(pressure_pa), channel(1.1 * pressure_pa)) else { continue };
            prop_assert!(heavy.wavevector_rad_per_m > light.wavevector_rad_per_m);
            prop_assert!(heavy.opening_gap_m.unwrap() < light.opening_gap_m.unwrap());
            prop_assert!(light.mean_gap_m < light.opening_gap_m.unwrap());
        }
    }

    #[test]
    fn rugged_spectra_have_a_seal_too(
        ln_c1d in prop::collection::vec(-40.0..0.0f64, 2..12), ln_p in -20.0..10.0f64, surface in any::<bool>(),
    ) {
        let rugged = rugged(&ln_c1d, surface);
        let pressure_pa = ln_p.exp();
        for correction in forms() {
            let law = SealingLaw::new(&rugged, 1.0, EnergyFactor::ALMQVIST, correction, PercolationThreshold::default());
            let tight_pa = law.tight_pressure_pa();
            prop_assert!(tight_pa.is_finite() && tight_pa >= 0.0);
            match law.critical_constriction(pressure_pa) {
                Some(channel) => {
                    prop_assert!(pressure_pa <= tight_pa * (1.0 + 1e-12), "{correction:?} {tight_pa}");
                    let seen = law.contact_at(channel.wavevector_rad_per_m, pressure_pa);
                    prop_assert!(channel.mean_gap_m.is_finite() && channel.mean_gap_m >= 0.0);
                    prop_assert!(channel.opening_gap_m.is_none_or(|gap_m| gap_m.is_finite()));
                    prop_assert!(channel.wavevector_rad_per_m.is_finite() && seen.area_fraction > 0.0);
                }
                None => prop_assert!(pressure_pa >= tight_pa * (1.0 - 1e-12), "{correction:?} {tight_pa}"),
            }
        }
    }
}

/// A spectrum that may rise or fall by decades from one sample to the next; a surface has part of the gradients of its profiles.
fn rugged(ln_c1d: &[f64], is_surface: bool) -> Roughness {
    let mut moments = [0.0; 3];
    let mut samples: Vec<RoughnessSample> = Vec::new();
    for (at, ln_c1d) in ln_c1d.iter().enumerate() {
        let q = 1.5f64.powi(at as i32);
        if let Some(before) = samples.last() {
            let (start, c1d_m3) = (TAU / before.wavelength_m, before.c1d_m3);
            let exponent = (ln_c1d - c1d_m3.ln()) / (q / start).ln();
            for (moment, k) in moments.iter_mut().zip([1.0, 3.0, 5.0]) {
                let power = k + exponent;
                *moment += c1d_m3 * start.powf(k) * (power * (q / start).ln()).exp_m1() / power / PI;
            }
        }
        samples.push(RoughnessSample {
            wavelength_m: TAU / q,
            c1d_m3: ln_c1d.exp(),
            moments,
            amplitude_m: 0.0,
        });
    }
    let of_surface: Vec<f64> =
        samples.iter().zip(1..).map(|(sample, at)| sample.moments[1] * (2.0 - 1.0 / f64::from(at))).collect();
    Roughness::new(&samples, is_surface.then_some(&of_surface[..]))
}
