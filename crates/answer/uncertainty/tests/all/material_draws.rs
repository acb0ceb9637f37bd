//! Draws of a scene's material against the distributions that the scene states.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::SeedableRng;
use scene::{Overrides, Scene};
use study::NoFiles;
use study::models::{CurveModel, MODELS};
use uncertainty::{DrawnMaterial, MaterialDraws};

const DRAWS: usize = 40_000;

/// A scene of every model, with these keys of its material and counterface.
fn scene(material: &str, options: &str) -> Scene {
    let curves: String = MODELS
        .iter()
        .map(|model| format!("[[curve]]\nmodel = \"{model}\"\nstrain_gradient = true\n"))
        .collect();
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{material}[loads]\npressures = [\"1e-3 H\"]\n{options}{curves}"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap()
}

fn draws(scene: &Scene) -> impl Iterator<Item = DrawnMaterial> {
    let draws = MaterialDraws::from_scene(scene).unwrap();
    let [mut elastic, mut strength] = [1, 2].map(ChaCha8Rng::seed_from_u64);
    (0..DRAWS).map(move |_| draws.draw(&mut elastic, &mut strength))
}

/// Mean and standard deviation.
fn moments(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    (mean, (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count).sqrt())
}

fn share_below(values: &[f64], bound: f64) -> f64 {
    values.iter().filter(|value| **value < bound).count() as f64 / values.len() as f64
}

/// Five standard errors of a share about a half, and of a standard deviation, of so many draws.
const OF_SHARE: f64 = 5.0 * 0.5 / 200.0;
const OF_DEVIATION: f64 = 5.0 * 0.8 / 200.0;

const STEEL: &str = "youngs_modulus = \"210 GPa +- 21 GPa\"\npoisson_ratio = \"0.3 +- 0.03\"\n\
                     yield_strength = \"0.8 GPa to 1.2 GPa\"\nstrain_gradient_length = \"5 um +- 1 um\"\n";

#[test]
fn draws_have_the_medians_and_standard_deviations_that_were_asked_for() {
    let drawn: Vec<DrawnMaterial> = draws(&scene(STEEL, "")).collect();
    let column = |of: fn(&DrawnMaterial) -> f64| drawn.iter().map(of).collect::<Vec<f64>>();
    for (values, median, deviation) in [
        (column(|drawn| drawn.pair.body().youngs_modulus_pa()), 210e9, 21e9),
        (column(|drawn| drawn.pair.body().poisson_ratio()), 0.3, 0.03),
        (column(|drawn| drawn.strain_gradient_length_m.unwrap()), 5e-6, 1e-6),
        (column(|drawn| drawn.strength_over_centre.ln()), 0.0, 1.5f64.ln() / 3.919928),
    ] {
        assert!((share_below(&values, median) - 0.5).abs() < OF_SHARE, "{median}");
        assert!(
            (moments(&values).1 / deviation - 1.0).abs() < OF_DEVIATION,
            "{median}: {:?}",
            moments(&values)
        );
    }
    // 95 % of strengths lie in the interval, which is relative to its geometric mean here.
    let strengths = column(|drawn| drawn.strength_over_centre);
    let within = share_below(&strengths, 1.5f64.sqrt()) - share_below(&strengths, 1.5f64.sqrt().recip());
    assert!((within - 0.95).abs() < OF_SHARE, "{within}");
}

#[test]
fn uniform_and_measured_values_are_drawn_evenly() {
    let keys = "youngs_modulus = { distribution = \"uniform\", from = \"200 GPa\", to = \"220 GPa\" }\npoisson_ratio = 0.3\n\
                yield_strength = { distribution = \"values\", values = [\"1 GPa\", \"2 GPa\", \"4 GPa\"] }\n\
                strain_gradient_length = \"5 um\"\n";
    let drawn: Vec<DrawnMaterial> = draws(&scene(keys, "")).collect();
    let moduli: Vec<f64> = drawn.iter().map(|drawn| drawn.pair.body().youngs_modulus_pa()).collect();
    for quarter in [0.25, 0.5, 0.75] {
        assert!((share_below(&moduli, 200e9 + quarter * 20e9) - quarter).abs() < OF_SHARE);
    }
    for value in [0.5, 1.0, 2.0] {
        let hits = drawn.iter().filter(|drawn| drawn.strength_over_centre == value).count();
        assert!((hits as f64 / DRAWS as f64 - 1.0 / 3.0).abs() < OF_SHARE, "{value}");
    }
    assert!(drawn.iter().all(|drawn| drawn.strain_gradient_length_m.is_none()));
}

#[test]
fn elastic_constants_and_strength_come_from_streams_of_their_own() {
    let scene = scene(STEEL, "");
    let draws = MaterialDraws::from_scene(&scene).unwrap();
    assert!(draws.elastic_scatters() && draws.strength_scatters());
    let drawn = |elastic: u64, strength: u64| {
        let [mut elastic, mut strength] = [elastic, strength].map(ChaCha8Rng::seed_from_u64);
        draws.draw(&mut elastic, &mut strength)
    };
    let (first, second) = (drawn(1, 2), drawn(1, 3));
    assert_eq!(first.pair, second.pair);
    assert_ne!(first.strength_over_centre, second.strength_over_centre);
    let third = drawn(4, 2);
    assert_eq!(first.strength_over_centre, third.strength_over_centre);
    assert_eq!(first.strain_gradient_length_m, third.strain_gradient_length_m);
    assert_ne!(first.pair, third.pair);
}

#[test]
fn what_does_not_scatter_stays_to_the_last_bit() {
    let exact = "poisson_ratio = 0.3\nyield_strength = \"1.1 GPa\"\nstrain_gradient_length = \"5 um\"\n";
    let plain =
        scene(&format!("youngs_modulus = \"210 GPa\"\n{exact}"), "[options]\nstrength_cap = \"21 GPa\"\n");
    assert_eq!(MaterialDraws::from_scene(&plain), None);
    let options = "[counterface]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.33\n[options]\nstrength_cap = \"21 GPa\"\n";
    let scene = scene(&format!("youngs_modulus = \"210 GPa +- 1e-9 %\"\n{exact}"), options);
    let draws = MaterialDraws::from_scene(&scene).unwrap();
    assert!(!draws.strength_scatters());
    let drawn = draws.draw(&mut ChaCha8Rng::seed_from_u64(1), &mut ChaCha8Rng::seed_from_u64(1));
    let unmoved = DrawnMaterial { pair: scene.material.unwrap().pair, ..drawn };
    for curve in &scene.needs.curves {
        assert_eq!(unmoved.apply(&curve.model), curve.model);
        assert_eq!(drawn.apply(&curve.model).strength(), curve.model.strength());
    }
}

#[test]
fn models_follow_the_material_and_a_cap_is_never_below_the_strength() {
    let scene = scene(STEEL, "[options]\nstrength_cap = \"1.1 GPa\"\n");
    let mut capped_above = 0;
    for drawn in draws(&scene).take(1000) {
        for curve in &scene.needs.curves {
            let model: CurveModel = drawn.apply(&curve.model);
            assert_eq!((model.pair(), model.entry), (drawn.pair, curve.model.entry));
            let (Some(plain), Some(strength)) = (curve.model.strength(), model.strength()) else {
                assert!(curve.model.strength().is_none() && model.strength().is_none());
                continue;
            };
            let strength_pa = drawn.strength_over_centre * plain.macroscopic_strength_pa();
            assert_eq!(strength.macroscopic_strength_pa(), strength_pa);
            assert_eq!(strength.strain_gradient_length_m(), drawn.strain_gradient_length_m);
            assert_eq!(strength.cap_pa(), Some(strength_pa.max(1.1e9)));
            capped_above += usize::from(strength_pa > 1.1e9);
        }
    }
    assert!(capped_above > 0);
}

#[test]
fn the_body_that_flows_brings_the_scatter_of_its_poisson_ratio_into_the_law() {
    let glass = "youngs_modulus = \"73 GPa\"\npoisson_ratio = 0.17\nyield_strength = \"5 GPa\"\n";
    let gold = "[counterface]\nyoungs_modulus = \"78 GPa\"\npoisson_ratio = \"0.44 +- 0.02\"\nyield_strength = \"0.2 GPa\"\n\
                strain_gradient_length = \"5 um\"\n";
    let drawn: Vec<DrawnMaterial> = draws(&scene(&format!("{glass}{gold}"), "")).collect();
    let ratios: Vec<f64> = drawn.iter().map(|drawn| drawn.pair.yielding_body().poisson_ratio()).collect();
    assert!((share_below(&ratios, 0.44) - 0.5).abs() < OF_SHARE);
    assert!((moments(&ratios).1 / 0.02 - 1.0).abs() < OF_DEVIATION);
    assert!(drawn.iter().all(|drawn| drawn.pair.body().poisson_ratio() == 0.17));
}
