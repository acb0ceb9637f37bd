//! Limits, closed forms, scalings and costs.

use std::f64::consts::PI;

use approx::relative_eq;
use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, Flattening, InterferenceLaw, NoSeparation, Population, StatisticalContact};

const SIGMA_M: f64 = 5e-9;

fn pair(modulus_pa: f64) -> MaterialPair {
    MaterialPair::against_rigid(ElasticBody::new(modulus_pa, 0.2).unwrap())
}

fn strength() -> NixGao {
    NixGao::constant(1.8e9).unwrap()
}

fn hardening() -> NixGao {
    strength().with_strain_gradient(5e-6).unwrap()
}

fn laws() -> [AsperityLaw; 9] {
    let hardness = Hardness::default();
    [
        AsperityLaw::Hertz,
        AsperityLaw::EpSphere { strength: strength(), hardness, held_from: None },
        AsperityLaw::EpSphere { strength: hardening(), hardness, held_from: None },
        AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
        AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem },
        AsperityLaw::EpSine { strength: strength() },
        AsperityLaw::EpSine { strength: hardening() },
        AsperityLaw::EpSphere { strength: strength(), hardness, held_from: Some(Flattening::HELD_FROM) },
        AsperityLaw::EpSphere { strength: hardening(), hardness, held_from: Some(Flattening::HELD_FROM) },
    ]
}

fn contact(law: &AsperityLaw) -> StatisticalContact {
    StatisticalContact::new(&pair(463e9), &Population::new(40e-9, 3e13, SIGMA_M).unwrap(), law)
}

#[test]
fn a_hertz_state_is_closed_at_any_separation_and_at_any_load() {
    let contact = contact(&AsperityLaw::Hertz);
    for u in [-60.0, -5.0, -1.0, 0.0, 3.0, 30.0] {
        let state = contact.at_separation(u * SIGMA_M, 1e-12).unwrap();
        let back = contact.at_pressure(state.pressure_pa, 1e-12, None).unwrap();
        assert_eq!((state.evaluations, back.evaluations), (0, 0), "u = {u}");
    }
}

#[test]
fn hertz_agrees_with_its_closed_form_at_the_mean_plane_and_beyond() {
    // Int s^(3/2) phi(s) ds over s > 0 is 2^(1/4) Gamma(5/4)/sqrt(2 pi); Gamma(5/4) to 17 digits.
    let closed = 2f64.powf(0.25) * 0.906_402_477_055_477 / std::f64::consts::TAU.sqrt();
    let modulus_pa = pair(463e9).composite_modulus_pa();
    let scale_pa = 3e13 * 4.0 / 3.0 * modulus_pa * (40e-9f64).sqrt() * SIGMA_M * SIGMA_M.sqrt();
    let state = contact(&AsperityLaw::Hertz).at_separation(0.0, 1e-12).unwrap();
    assert!((state.pressure_pa / (scale_pa * closed) - 1.0).abs() < 1e-12);
    let area = 3e13 * std::f64::consts::PI * 40e-9 * SIGMA_M * 0.398_942_280_401_432_7;
    assert!((state.area_fraction / area - 1.0).abs() < 1e-14);
    // Sixty sigma below, every asperity carries: w^(3/2) at the mean, and 3/8 (sigma/w)^2 for the spread.
    let deep = contact(&AsperityLaw::Hertz).at_separation(-60.0 * SIGMA_M, 1e-12).unwrap();
    let expected = scale_pa * 60f64.powf(1.5) * (1.0 + 3.0 / 8.0 / 3600.0 + 9.0 / 128.0 / 3600.0 / 3600.0);
    assert!((deep.pressure_pa / expected - 1.0).abs() < 1e-9);
    assert!(deep.clamped && deep.area_fraction == 1.0);
}

#[test]
fn pressure_and_area_fall_with_the_separation_to_sixty_sigma_and_stay_finite_in_logarithms() {
    for law in laws() {
        let contact = contact(&law);
        let mut last = (f64::INFINITY, f64::INFINITY);
        for u in 0..=60 {
            let state = contact.at_separation(f64::from(u) * SIGMA_M, 1e-8).unwrap();
            let now = (state.ln_pressure_pa, state.ln_area_fraction);
            assert!(now.0 < last.0 && now.1 < last.1, "{law:?} at {u}");
            last = now;
        }
        assert!(last.0 < -1500.0 && last.0.is_finite(), "{law:?}: {last:?}");
    }
}

#[test]
fn lengths_and_moduli_may_be_scaled() {
    let far = 1e3;
    let scaled = |law: &AsperityLaw| {
        let strength = law.strength().map(|strength| scale(strength, far));
        strength.map_or(Some(*law), |strength| law.with_strength(strength)).unwrap()
    };
    for law in laws() {
        let here = contact(&law).at_separation(1.3 * SIGMA_M, 1e-10).unwrap();
        let population = Population::new(40e-9 * far, 3e13 / far / far, SIGMA_M * far).unwrap();
        let there = StatisticalContact::new(&pair(463e9 * 7.0), &population, &scaled(&law))
            .at_separation(1.3 * SIGMA_M * far, 1e-10)
            .unwrap();
        assert!((there.pressure_pa / (7.0 * here.pressure_pa) - 1.0).abs() < 1e-9, "{law:?}");
        assert!((there.area_fraction / here.area_fraction - 1.0).abs() < 1e-9, "{law:?}");
    }
}

/// A strength seven times larger with its length scaled.
fn scale(strength: NixGao, length: f64) -> NixGao {
    let scaled = NixGao::constant(7.0 * strength.macroscopic_strength_pa()).unwrap();
    match strength.strain_gradient_length_m() {
        Some(length_m) => scaled.with_strain_gradient(length_m * length).unwrap(),
        None => scaled,
    }
}

#[test]
fn there_and_back_again() {
    for law in laws() {
        let contact = contact(&law);
        for u in [-3.0, -0.5, 0.0, 0.7, 3.3, 9.0, 41.0] {
            let there = contact.at_separation(u * SIGMA_M, 1e-12).unwrap();
            if there.pressure_pa < 1e-300 {
                continue;
            }
            let back = contact.at_pressure(there.pressure_pa, 1e-12, None).unwrap();
            assert!((back.separation_m.unwrap() / SIGMA_M - u).abs() < 1e-10, "{law:?} at {u}");
            assert!(
                relative_eq!(back.ln_area_fraction, there.ln_area_fraction, max_relative = 1e-10),
                "{law:?}"
            );
        }
    }
}

#[test]
fn beyond_complete_contact_there_is_no_separation() {
    for law in laws() {
        let contact = contact(&law);
        let highest_pa = contact.highest_pressure_pa();
        if highest_pa.is_infinite() {
            assert!(contact.at_pressure(1e15, 1e-8, None).unwrap().separation_m.is_some(), "{law:?}");
            continue;
        }
        let beyond = contact.at_pressure(1.0001 * highest_pa, 1e-8, None).unwrap();
        // 3e13 spheres per square metre of 40 nm, each with the area pi (0.41 R)^2.
        let held = matches!(law, AsperityLaw::EpSphere { .. });
        let area_fraction = if held { 3e13 * PI * (0.41f64 * 40e-9).powi(2) } else { 1.0 };
        let reason = if held { NoSeparation::AllFlattened } else { NoSeparation::CompleteContact };
        assert_eq!((beyond.separation_m, beyond.no_separation()), (None, Some(reason)), "{law:?}");
        assert!((beyond.area_fraction / area_fraction - 1.0).abs() < 1e-12, "{law:?}");
        let below = contact.at_pressure(0.9999 * highest_pa, 1e-8, None).unwrap();
        assert!(below.separation_m.is_some() && below.area_fraction > 0.9 * area_fraction, "{law:?}");
    }
}

#[test]
fn flattened_spheres_carry_what_they_carried_and_their_share_is_counted() {
    let [_, free, hard, .., held, hard_held] = laws().map(|law| contact(&law));
    for (free, held) in [(free, held), (hard, hard_held)] {
        let shares = [9.0, 3.0, 0.0, -3.0, -30.0].map(|u| {
            let [unlimited, state] =
                [&free, &held].map(|contact| contact.at_separation(u * SIGMA_M, 1e-12).unwrap());
            let share = state.flattened_share.unwrap();
            assert_eq!(unlimited.flattened_share, None);
            assert!(state.pressure_pa <= unlimited.pressure_pa * (1.0 + 1e-11), "u = {u}");
            let same = (state.pressure_pa / unlimited.pressure_pa - 1.0).abs() < 1e-9;
            assert_eq!(same, share < 1e-9, "u = {u}: {state:?} {unlimited:?}");
            share
        });
        assert!(shares.is_sorted() && shares[4] > 1.0 - 1e-12, "{shares:?}");
    }
}

#[test]
fn a_held_force_is_the_largest_even_where_the_law_steps_down_or_dips() {
    // Strong and incompressible spheres: the published force steps down at the onset, and dips by the cosine.
    let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.5).unwrap());
    for strength_pa in [1e8, 5e9, 2e10, 1e11] {
        for &hardness in Hardness::ALL {
            let strength = NixGao::constant(strength_pa).unwrap().with_strain_gradient(1e-7).unwrap();
            let law = AsperityLaw::EpSphere { strength, hardness, held_from: Some(1.0) };
            let contact = StatisticalContact::new(&pair, &Population::new(1e-6, 1e9, 1e-12).unwrap(), &law);
            let pressures = (0..200).map(|at| {
                contact.at_separation(-1e-9 * 10f64.powf(f64::from(at) / 50.0), 1e-6).unwrap().pressure_pa
            });
            let highest_pa = pressures.fold(0.0, f64::max);
            assert!(highest_pa <= contact.highest_pressure_pa() * (1.0 + 1e-9), "{hardness:?} {strength_pa}");
        }
    }
}

#[test]
fn where_the_force_steps_down_the_largest_separation_is_found() {
    // Incompressible spheres far larger than the spread: the force drops by 3.4 % at the onset of plastic flow.
    let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.5).unwrap());
    let strength = NixGao::constant(1e9).unwrap();
    let law = AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None };
    let population = Population::new(1e-2, 1e8, 1e-9).unwrap();
    let contact = StatisticalContact::new(&pair, &population, &law);
    let pressure = |u: f64| contact.at_separation(u * 1e-9, 1e-10).unwrap().pressure_pa;
    let onset = 1.9
        * (std::f64::consts::FRAC_PI_2 * 1.295 * (0.736f64 * 0.5).exp() * 1e9 * 0.75 / 1e11).powi(2)
        * 1e7;
    let (before, after) = (pressure(8.0 - onset), pressure(-8.0 - onset));
    assert!(after < before, "the pressure falls across the step: {before} {after}");
    let target = 0.5 * (before + after);
    let mut found = Vec::new();
    for start in [None, Some(-onset - 500.0), Some(0.0), Some(-onset + 100.0)] {
        let start = start.map(|u| contact.at_separation(u * 1e-9, 1e-4).unwrap());
        let state = contact.at_pressure(target, 1e-10, start.as_ref()).unwrap();
        found.push(state.separation_m.unwrap());
    }
    let largest = found[0] / 1e-9;
    assert!(largest > 8.0 - onset, "{largest} against {onset}");
    assert!((pressure(largest) / target - 1.0).abs() < 1e-9);
    assert!(found.iter().all(|d| ((d - found[0]) / 1e-9).abs() < 1e-9), "{found:?}");
}

#[test]
fn load_beyond_the_fitted_range_is_counted() {
    let share = |law: &AsperityLaw, u: f64| {
        contact(law).at_separation(u * SIGMA_M, 1e-10).unwrap().out_of_range_load_share
    };
    let [hertz, sphere, hard_sphere, ..] = laws();
    assert_eq!(share(&hertz, 1.0), 0.0);
    // a/R = 0.41 lies at w = 5.3 nm here, about sigma: the share falls as fewer asperities reach it.
    let falling = [-3.0, 0.0, 3.0].map(|u| share(&sphere, u));
    assert!(falling[0] > 0.99 && falling.is_sorted_by(|a, b| a > b) && falling[2] > 0.0, "{falling:?}");
    // Hardened near the surface, Sy exceeds E*/100 at every depth reached: all that yields, from w = 5.4 nm on, is out.
    let hard = [-10.0, 0.0].map(|u| share(&hard_sphere, u));
    assert!(hard[0] > 0.99 && 0.1 < hard[1] && hard[1] < 0.99, "{hard:?}");
}

#[test]
fn numbers_out_of_bounds_are_named() {
    let contact = contact(&AsperityLaw::Hertz);
    assert_eq!(
        contact.at_separation(f64::NAN, 1e-8).unwrap_err().to_string(),
        "separation in m is NaN; it must be finite"
    );
    assert_eq!(
        contact.at_pressure(0.0, 1e-8, None).unwrap_err().to_string(),
        "pressure in Pa is 0; it must be finite and greater than 0"
    );
}
