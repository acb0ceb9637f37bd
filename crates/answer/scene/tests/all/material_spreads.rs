//! Uncertainties of a material, as a scene states them.

use scene::{Overrides, Scene, SceneError, SceneProblem};
use study::NoFiles;
use study::spread::Spread;

const BODY: &str = "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n";

fn scene_of(keys: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{keys}[loads]\npressures = [\"1 MPa\"]\n[[curve]]\n\
         model = \"elastic\"\n"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default())
}

fn of_modulus(typed: &str) -> Result<Scene, SceneError> {
    scene_of(&format!("youngs_modulus = {typed}\npoisson_ratio = 0.3\n"))
}

/// The key and the value that a scene is refused for.
fn key_and_value(refused: Result<Scene, SceneError>) -> (String, String) {
    match refused.unwrap_err().problem {
        SceneProblem::Value { key, value, .. } => (key, value),
        other => panic!("{other}"),
    }
}

fn of_ratio(typed: &str) -> Result<Scene, SceneError> {
    scene_of(&format!("youngs_modulus = \"210 GPa\"\npoisson_ratio = {typed}\n"))
}

#[test]
fn every_form_of_a_spread_has_its_centre_in_the_plain_run() {
    for (typed, centre_pa, uncertainty_pa) in [
        ("\"210 GPa +- 5 GPa\"", 210e9, 5e9),
        ("\"210 GPa ± 5e9 Pa\"", 210e9, 5e9),
        ("\"210 GPa +- 2 %\"", 210e9, 4.2e9),
        (
            "{ distribution = \"log-normal\", median = \"210 GPa\", standard_uncertainty = \"5 GPa\" }",
            210e9,
            5e9,
        ),
        (
            "{ distribution = \"log-normal\", median = \"210 GPa\", standard_uncertainty = \"2%\" }",
            210e9,
            4.2e9,
        ),
        ("{ distribution = \"uniform\", from = \"200 GPa\", to = \"220 GPa\" }", 210e9, 20e9 / 12f64.sqrt()),
        ("{ distribution = \"values\", values = [\"215 GPa\", \"210 GPa\", \"205 GPa\"] }", 210e9, 4.0825e9),
    ] {
        let scene = of_modulus(typed).unwrap();
        let plain = of_modulus("\"210 GPa\"").unwrap();
        assert_eq!(scene.material, plain.material, "{typed}");
        assert_eq!(scene.needs.curves[0].model, plain.needs.curves[0].model, "{typed}");
        assert!(plain.spreads.is_empty() && !scene.spreads.is_empty() && scene.scatters());
        let spread = scene.spreads.youngs_modulus.unwrap();
        assert_eq!(spread.centre(), centre_pa);
        assert!((spread.standard_uncertainty() / uncertainty_pa - 1.0).abs() < 1e-5, "{typed}: {spread:?}");
    }
    let scene = of_modulus("\"200 GPa to 220 GPa\"").unwrap();
    assert_eq!(scene.material.unwrap().pair.body().youngs_modulus_pa(), (200e9 * 220e9f64).sqrt());
    for none in ["\"210 GPa +- 0 GPa\"", "\"210 GPa +- 0 %\"", "\"210 GPa to 210 GPa\""] {
        let scene = of_modulus(none).unwrap();
        assert!(scene.spreads.is_empty() && !scene.scatters(), "{none}");
        assert_eq!(scene.material.unwrap().pair.body().youngs_modulus_pa(), 210e9);
    }
}

#[test]
fn a_poisson_ratio_scatters_between_0_and_a_half() {
    for typed in [
        "\"0.3 +- 0.02\"",
        "\"0.25 to 0.35\"",
        "{ distribution = \"beta\", median = 0.3, standard_uncertainty = 0.02 }",
    ] {
        let scene = of_ratio(typed).unwrap();
        assert_eq!(scene.material.unwrap().pair.body().poisson_ratio(), 0.3, "{typed}");
        assert!(matches!(scene.spreads.poisson_ratio, Some(Spread::Beta { median: 0.3, .. })), "{typed}");
    }
    let uniform = of_ratio("{ distribution = \"uniform\", from = -0.1, to = 0.5 }").unwrap();
    assert_eq!(uniform.material.unwrap().pair.body().poisson_ratio(), 0.2);
    assert!(of_ratio("\"0.3 +- 0\"").unwrap().spreads.is_empty());
    assert!(of_ratio("0").unwrap().spreads.is_empty());
}

#[test]
fn strength_hardness_length_and_counterface_scatter_likewise() {
    let keys = "strain_gradient_length = \"5 um +- 1 um\"\n";
    let scene = |strength: &str| scene_of(&format!("{BODY}{keys}{strength}")).unwrap();
    let strong = scene("yield_strength = \"0.8 GPa to 1.2 GPa\"\n");
    let Some(Spread::LogNormal { median, sigma_ln }) = strong.spreads.strength else { panic!() };
    assert_eq!(median, 1.0);
    assert!((sigma_ln - 1.5f64.ln() / (2.0 * 1.959964)).abs() < 1e-9);
    assert_eq!(strong.hardness_pa(), Some(3.0 * (0.8e9 * 1.2e9f64).sqrt()));
    let hard = scene("indentation_hardness = \"300 HV +- 10 HV\"\n");
    assert!(hard.spreads.strength.is_some() && hard.spreads.strain_gradient_length.is_some());
    assert_eq!(hard.hardness_pa(), Some(300.0 * 9.80665e6));
    let one = scene("indentation_hardness = \"3 GPa\"\nyield_strength = \"1 GPa +- 5 %\"\n");
    assert!(one.spreads.strength.is_some());

    let counterface = format!(
        "{BODY}[counterface]\nyoungs_modulus = \"70 GPa +- 2 GPa\"\npoisson_ratio = \"0.33 +- 0.01\"\n"
    );
    let scene = scene_of(&counterface).unwrap();
    assert_eq!(
        scene.spreads.describe(),
        [
            "Young's modulus of the counterface 70 GPa, standard uncertainty 2 GPa (log-normal)",
            "Poisson's ratio of the counterface 0.33, standard uncertainty 0.01 (beta)",
        ]
    );
}

#[test]
fn spreads_are_described_in_a_line_each() {
    let keys = "youngs_modulus = { distribution = \"uniform\", from = \"200 GPa\", to = \"220 GPa\" }\n\
                poisson_ratio = 0.3\nyield_strength = \"1 GPa +- 5 %\"\n\
                strain_gradient_length = { distribution = \"values\", values = [\"4 um\", \"5 um\", \"6 um\"] }\n";
    assert_eq!(
        scene_of(keys).unwrap().spreads.describe(),
        [
            "Young's modulus from 200 GPa to 220 GPa (uniform)",
            "yield strength and hardness 100 %, standard uncertainty 5 % (log-normal)",
            "strain-gradient length 5 µm, the median of 3 values, standard uncertainty 816 nm",
        ]
    );
}

#[test]
fn what_is_no_spread_is_refused_with_key_value_and_bound() {
    for typed in [
        "\"210 GPa +- -5 GPa\"",
        "\"210 GPa +- -2 %\"",
        "\"210 GPa +- 5\"",
        "\"210 GPa +- x %\"",
        "\"1.2 GPa to 0.8 GPa\"",
        "\"1 Pa to 1 GPa\"",
    ] {
        let error = of_modulus(typed).unwrap_err();
        assert_eq!(error.key(), Some("material.youngs_modulus"));
        assert_eq!(error.span.map(|span| span.len()), Some(typed.len()), "{typed}");
    }
    for typed in ["0.3 +- 0.2", "0.5 +- 0.01", "0.3 +- 0.02 GPa", "0.35 to 0.25"] {
        let (key, value) = key_and_value(of_ratio(&format!("\"{typed}\"")));
        assert_eq!((key.as_str(), value.as_str()), ("material.poisson_ratio", typed));
    }
    for typed in ["\"0.3\"", "true"] {
        let error = of_ratio(typed).unwrap_err();
        assert!(matches!(error.problem, SceneProblem::WrongType { .. }), "{error}");
    }
}

#[test]
fn tables_of_distributions_are_refused_with_what_they_need() {
    let refused = |table: &str| of_modulus(&format!("{{ {table} }}")).unwrap_err();
    let normal = refused("distribution = \"normal\", median = \"1 GPa\"");
    let SceneProblem::UnknownValue { meant, known, .. } = &normal.problem else { panic!("{normal}") };
    assert_eq!((meant.as_deref(), known.len()), (Some("log-normal"), 4));
    let missing = refused("median = \"1 GPa\"");
    assert!(
        matches!(&missing.problem, SceneProblem::MissingKey { key } if key == "distribution"),
        "{missing}"
    );
    for table in [
        "distribution = \"beta\", median = \"1 GPa\", standard_uncertainty = \"1 MPa\"",
        "distribution = \"uniform\", from = \"1 GPa\"",
        "distribution = \"values\", values = [\"1 GPa\"], median = \"1 GPa\"",
        "distribution = \"values\", values = []",
        "distribution = \"values\", values = [\"-1 GPa\"]",
        "distribution = \"uniform\", from = \"2 GPa\", to = \"1 GPa\"",
    ] {
        assert!(refused(table).span.is_some(), "{table}");
    }
    assert!(of_ratio("{ distribution = \"uniform\", from = 0.3, to = 0.6 }").is_err());
    assert!(of_ratio("{ distribution = \"log-normal\", median = 0.3, standard_uncertainty = 0.1 }").is_err());
}

#[test]
fn a_hardness_and_a_strength_do_not_both_scatter_and_none_in_h_does() {
    let told = |keys: &str| scene_of(&format!("{BODY}{keys}")).unwrap_err();
    let both = told("indentation_hardness = \"3 GPa +- 1 %\"\nyield_strength = \"1 GPa +- 1 %\"\n");
    assert_eq!(both.span.map(|span| span.len()), Some("\"3 GPa +- 1 %\"".len()));
    for in_h in ["0.3 H +- 0.1 H", "0.3 H to 0.4 H", "1 GPa +- 0.1 H"] {
        let error = told(&format!("yield_strength = \"{in_h}\"\n"));
        assert_eq!(error.span.map(|span| span.len()), Some(in_h.len() + 2));
    }
}

#[test]
fn a_spread_elsewhere_is_told_where_it_belongs() {
    let text = "[surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = [\"1 MPa +- 1 kPa\"]\n[material]\n\
                youngs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n[[curve]]\nmodel = \"elastic\"\n";
    let (key, value) = key_and_value(Scene::parse(text, &NoFiles, &Overrides::default()));
    assert_eq!((key.as_str(), value.as_str()), ("loads.pressures", "1 MPa +- 1 kPa"));
}

#[test]
fn a_counterface_from_outside_is_taken_for_exact() {
    let text = "[surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = [\"1 MPa\"]\n[material]\n\
                youngs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n[counterface]\nyoungs_modulus = \"1 GPa +- 1 %\"\n\
                poisson_ratio = 0.3\n[[curve]]\nmodel = \"elastic\"\n";
    let body = asperity::ElasticBody::new(1e9, 0.3).unwrap();
    let overrides = Overrides { counterface: Some(body), ..Overrides::default() };
    assert!(Scene::parse(text, &NoFiles, &overrides).unwrap().spreads.is_empty());
    assert!(!Scene::parse(text, &NoFiles, &Overrides::default()).unwrap().spreads.is_empty());
}

#[test]
fn scans_say_what_is_known_of_their_instrument() {
    let heights = "0 0\n1e-6 1e-9\n2e-6 -1e-9\n3e-6 2e-9\n4e-6 0\n5e-6 1e-9\n6e-6 0\n7e-6 1e-9\n";
    let files = std::collections::BTreeMap::from(
        ["a.txt", "b.txt"].map(|name| (name.to_owned(), heights.as_bytes().to_vec())),
    );
    let scene = |first: &str, second: &str| {
        let text = format!(
            "[surface]\nscans = [{{ file = \"a.txt\", unit = \"m\"{first} }}, {{ file = \"b.txt\", unit = \"m\"{second} }}]\n\
             {}",
            "[[figure]]\nname = \"psd\"\nshows = \"psd\"\n[uncertainty]\n"
        );
        Scene::parse(&text, &files, &Overrides::default())
    };
    let afm = ", instrument = \"AFM\", z_calibration = ";
    assert!(
        scene(&format!("{afm}\"3 %\""), &format!("{afm}0.03, slope_uncertainty = 0.05")).unwrap().scatters()
    );
    let error = scene(&format!("{afm}\"3 %\""), &format!("{afm}\"1 %\"")).unwrap_err();
    assert!(error.span.is_some(), "{error}");
    for (typed, key) in [
        (format!("{afm}2"), "surface.scans.z_calibration"),
        (", slope_uncertainty = -1".to_owned(), "surface.scans.slope_uncertainty"),
    ] {
        assert_eq!(scene(&typed, "").unwrap_err().key(), Some(key));
    }
    assert!(scene(", instrument = \"\"", "").is_err());
}
