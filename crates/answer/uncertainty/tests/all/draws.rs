//! Draws against results derived by hand.

use std::collections::BTreeMap;

use scene::{Overrides, Scene};
use study::Unobserved;
use study::plan::Results;
use uncertainty::{Group, Uncertainty, UncertaintyPlan, UncertaintySettings};

/// A spectrum with these relative standard errors, over two decades.
fn psd(relative_error: f64) -> String {
    let row = |at: i32| {
        let wavelength_nm = 10f64.powf(4.0 - 0.1 * f64::from(at));
        let c1d_nm3 = 1e5 * (wavelength_nm / 1e4).powf(2.6);
        format!("{wavelength_nm},{c1d_nm3},{}\n", relative_error * c1d_nm3)
    };
    std::iter::once("wavelength_nm,C1D_nm3,C1D_se_nm3\n".to_owned()).chain((0..=20).map(row)).collect()
}

fn scene(psd: &str, material: &str, curves: &[&str]) -> Scene {
    let curves: String = curves.iter().map(|model| format!("[[curve]]\nmodel = \"{model}\"\n")).collect();
    let text = format!(
        "surface = {{ psd = \"psd.csv\" }}\nloads = {{ pressures = [\"1 MPa\"] }}\nmaterial = {{ {material} }}\n{curves}"
    );
    let files = BTreeMap::from([("psd.csv".to_owned(), psd.as_bytes().to_vec())]);
    Scene::parse(&text, &files, &Overrides::default()).unwrap()
}

fn found(scene: &Scene, settings: &UncertaintySettings) -> (Results, Uncertainty) {
    let results = scene.plan().compute().unwrap();
    let found = UncertaintyPlan::new(scene, &results, settings).unwrap().run(&Unobserved).unwrap();
    (results, found)
}

const CERTAIN: &str = "youngs_modulus = \"100 GPa\", poisson_ratio = 0.3, yield_strength = \"1 GPa\"";

#[test]
fn where_nothing_scatters_there_is_nothing_to_draw() {
    let scene = scene(&psd(0.0), CERTAIN, &["elastic"]);
    let results = scene.plan().compute().unwrap();
    assert!(UncertaintyPlan::new(&scene, &results, &UncertaintySettings::default()).is_none());
}

#[test]
fn what_does_not_depend_on_what_scatters_does_not_scatter() {
    let material = "youngs_modulus = \"100 GPa\", poisson_ratio = 0.3, yield_strength = \"1 GPa +- 10 %\"";
    let (results, found) =
        found(&scene(&psd(0.0), material, &["hertz", "ep-sphere"]), &UncertaintySettings::default());
    let [hertz, sphere] = &found.areas[..] else { panic!("two curves") };
    assert_eq!(
        (hertz.low, hertz.high, hertz.ln_area_sd, hertz.monte_carlo_error),
        (hertz.median, hertz.median, 0.0, 0.0)
    );
    let own = results.curves[0].area_fractions(0).last().unwrap().1;
    assert!((hertz.median / own - 1.0).abs() < 1e-6);
    assert!(sphere.high > 1.05 * sphere.low);
    assert_eq!(found.groups, [Group::Strength]);
}

#[test]
fn the_elastic_constants_follow_the_linear_law() {
    // Under a light load ln A goes like -ln E*; 1 % of E and 1 % of nu = 0.3, which moves 1 - nu^2 by 0.198 %.
    let material = "youngs_modulus = \"100 GPa +- 1 %\", poisson_ratio = \"0.3 +- 0.003\"";
    let settings = UncertaintySettings { draws: 4000, ..UncertaintySettings::default() };
    let (_, found) = found(&scene(&psd(0.0), material, &["elastic", "bgt", "persson"]), &settings);
    let linear = (0.01f64.powi(2) + (2.0 * 0.3 * 0.003 / (1.0 - 0.09_f64)).powi(2)).sqrt();
    for area in &found.areas {
        assert!((area.ln_area_sd / linear - 1.0).abs() < 0.05, "{area:?}");
        assert!(((area.high / area.low).ln() / (2.0 * 1.96 * linear) - 1.0).abs() < 0.05, "{area:?}");
    }
}

#[test]
fn standard_errors_of_a_spectrum_follow_the_linear_law() {
    let own = scene(&psd(0.01), CERTAIN, &["elastic", "hertz", "persson"]);
    let settings = UncertaintySettings { draws: 4000, ..UncertaintySettings::default() };
    let (results, found) = found(&own, &settings);
    // d ln A/d ln C of every sample by differences of the plain plan.
    let last =
        |results: &Results, curve: usize| results.curves[curve].area_fractions(0).last().unwrap().1.ln();
    let plain = psd(0.0);
    let rows: Vec<&str> = plain.lines().collect();
    let step = 1e-3f64;
    let moved = |at: usize| {
        let mut rows: Vec<String> = rows.iter().map(|row| (*row).to_owned()).collect();
        let cells: Vec<f64> = rows[at + 1].split(',').map(|cell| cell.parse().unwrap()).collect();
        rows[at + 1] = format!("{},{},0", cells[0], cells[1] * step.exp());
        scene(&(rows.join("\n") + "\n"), CERTAIN, &["elastic", "hertz", "persson"]).plan().compute().unwrap()
    };
    let moved: Vec<Results> = (0..21).map(moved).collect();
    for area in &found.areas {
        let gradient: Vec<f64> =
            moved.iter().map(|moved| (last(moved, area.curve) - last(&results, area.curve)) / step).collect();
        // Samples a tenth of a decade apart, correlated as exp(-distance/half a decade).
        let mut variance = 0.0;
        for (i, a) in gradient.iter().enumerate() {
            for (j, b) in gradient.iter().enumerate() {
                variance += a * b * 1e-4 * (-0.2 * (i as f64 - j as f64).abs()).exp();
            }
        }
        assert!((area.ln_area_sd / variance.sqrt() - 1.0).abs() < 0.05, "{area:?} {}", variance.sqrt());
    }
}

#[test]
fn shares_are_those_of_a_brute_force() {
    for (model, error, modulus, strength) in [
        ("ep-sphere", 0.3, 10.0, 15.0),
        ("elastic-plastic", 0.2, 15.0, 20.0),
        ("persson-plastic", 0.3, 10.0, 10.0),
    ] {
        hold_shares_against_a_brute_force(model, error, modulus, strength);
    }
}

/// Compares shares with a brute force, for these standard uncertainties of modulus and strength in per cent.
fn hold_shares_against_a_brute_force(model: &str, error: f64, modulus_percent: f64, strength_percent: f64) {
    // The variance of the mean over all else, with each input fixed in turn at values of its distribution.
    let with = |modulus: &str, strength: &str| {
        let material =
            format!("youngs_modulus = \"{modulus}\", poisson_ratio = 0.3, yield_strength = \"{strength}\"");
        scene(&psd(error), &material, &[model])
    };
    let (modulus, strength) =
        (format!("100 GPa +- {modulus_percent} %"), format!("1 GPa +- {strength_percent} %"));
    let full =
        UncertaintySettings { draws: 4096, shares_draws: Some(1 << 13), ..UncertaintySettings::default() };
    let (_, all) = found(&with(&modulus, &strength), &full);
    let total = all.areas[0].ln_area_sd.powi(2);
    let sigma = |percent: f64| (0.5 * (1.0 + (1.0 + 4e-4 * percent * percent).sqrt())).ln().sqrt();
    // The middles of 64 parts of equal probability, each with 256 draws of all else: 2^14 in all.
    let deviates: Vec<f64> = (0..64).map(|at| normal_quantile((f64::from(at) + 0.5) / 64.0)).collect();
    let share = |of: &dyn Fn(f64) -> Scene| {
        let mean = |&deviate: &f64| median_of_draws(&of(deviate), 256).ln();
        let means: Vec<f64> = deviates.iter().map(mean).collect();
        let middle = means.iter().sum::<f64>() / 64.0;
        means.iter().map(|mean| (mean - middle).powi(2)).sum::<f64>() / 64.0 / total
    };
    let moved = |centre: f64, percent: f64, deviate: f64| {
        format!("{} GPa", centre * (sigma(percent) * deviate).exp())
    };
    let of_modulus = share(&|deviate| with(&moved(100.0, modulus_percent, deviate), &strength));
    let of_strength = share(&|deviate| with(&modulus, &moved(1.0, strength_percent, deviate)));
    let told: Vec<f64> = all.areas[0].indices.iter().map(|indices| indices.first_order.value).collect();
    assert_eq!(all.groups, [Group::Scans, Group::Material, Group::Strength]);
    assert!((told[1] - of_modulus).abs() < 0.03, "{model}: {told:?} {of_modulus}");
    assert!((told[2] - of_strength).abs() < 0.03, "{model}: {told:?} {of_strength}");
    assert!((told.iter().sum::<f64>() - 1.0).abs() < 0.05, "{model}: {told:?}");
}

fn median_of_draws(scene: &Scene, draws: usize) -> f64 {
    let results = scene.plan().compute().unwrap();
    let settings = UncertaintySettings { draws, ..UncertaintySettings::default() };
    let plan = UncertaintyPlan::new(scene, &results, &settings).unwrap();
    plan.intervals(&Unobserved).unwrap()[0].median
}

/// By bisection of the distribution, integrated by Simpson's rule: for the test alone.
fn normal_quantile(probability: f64) -> f64 {
    let density = |x: f64| (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
    let below = |x: f64| {
        let step = (x + 9.0) / 2000.0;
        let weight = |at: i32| match at {
            0 | 2000 => 1.0,
            at if at % 2 == 1 => 4.0,
            _ => 2.0,
        };
        (0..=2000).map(|at| weight(at) * density(-9.0 + step * f64::from(at))).sum::<f64>() * step / 3.0
    };
    let (mut low, mut high) = (-8.0, 8.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if below(middle) < probability { low = middle } else { high = middle }
    }
    low
}

#[test]
fn the_same_seed_makes_the_same_digits() {
    let own = scene(&psd(0.1), "youngs_modulus = \"100 GPa +- 5 %\", poisson_ratio = 0.3", &["hertz"]);
    let settings = UncertaintySettings { draws: 100, ..UncertaintySettings::default() };
    let (first, again) = (found(&own, &settings).1, found(&own, &settings).1);
    assert_eq!(first, again);
    let other = found(&own, &UncertaintySettings { seed: 2, ..settings }).1;
    assert_ne!(first.areas, other.areas);
}

#[test]
fn draws_compute_final_areas_and_nothing_else() {
    let own = scene(
        &psd(0.1),
        "youngs_modulus = \"100 GPa +- 5 %\", poisson_ratio = 0.3, yield_strength = \"1 GPa +- 5 %\"",
        &["elastic", "hertz", "ep-sphere"],
    );
    let settings = UncertaintySettings { draws: 200, ..UncertaintySettings::default() };
    let (results, found) = found(&own, &settings);
    // 200 draws, 3 groups of 100 pairs, the best estimates, the spectrum with each of its 20 parts moved and with none, 64 draws
    // of it prolonged at either end, and 64 and the best estimates along the cutoff.
    assert_eq!(found.plans, 200 + 300 + 1 + 21 + 128 + 65);
    // A state for each of two statistical curves, and nine cutoffs at four a decade for each along the cutoff.
    assert_eq!(found.work.statistical_states, 2 * (650 + 65 * 9));
    let (of_state, of_scene) = (
        found.work.law_evaluations as f64 / found.work.statistical_states as f64,
        results.work.law_evaluations as f64 / results.work.statistical_states as f64,
    );
    assert!(of_state < 1.5 * of_scene, "{of_state} {of_scene}");
}
