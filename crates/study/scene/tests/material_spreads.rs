//! Uncertainties of a material, as a scene states them.

use scene::{Overrides, Scene, SceneError};
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
    let key = "key material.youngs_modulus: ";
    for (typed, message) in [
        (
            "\"210 GPa +- -5 GPa\"",
            "'-5 GPa' is out of range; a standard uncertainty must be at least 0 and finite",
        ),
        ("\"210 GPa +- -2 %\"", "the standard uncertainty over its value is -0.02; it must be from 0 to 10"),
        (
            "\"210 GPa +- 5\"",
            "'5' has no unit; a modulus needs one of Pa, hPa, kPa, bar, MPa, GPa, TPa, psi, ksi, as in '210 GPa'",
        ),
        ("\"210 GPa +- x %\"", "'x %' is not a fraction; write '3 %' or '0.03'"),
        (
            "\"1.2 GPa to 0.8 GPa\"",
            "the interval begins at 1200000000 and ends at 800000000, which is less; the smaller value stands first",
        ),
        ("\"1 Pa to 1 GPa\"", "the end of the interval over its beginning is 1e9; it must be from 1 to 1000"),
    ] {
        let error = of_modulus(typed).unwrap_err();
        assert_eq!(error.to_string(), format!("{key}{message}"));
        assert_eq!(error.key(), Some("material.youngs_modulus"));
        assert_eq!(error.span.map(|span| span.len()), Some(typed.len()), "{typed}");
    }
    let told = |typed: &str| of_ratio(typed).unwrap_err().to_string();
    assert!(
        told("\"0.3 +- 0.2\"")
            .contains("the standard uncertainty of Poisson's ratio is 0.2; about a median of 0.3")
    );
    assert!(told("\"0.3 +- 0.2\"").contains("it must be from 0 to 0.135"), "{}", told("\"0.3 +- 0.2\""));
    assert!(told("\"0.5 +- 0.01\"").contains("a Poisson's ratio that scatters is 0.5; it must be from"));
    assert!(told("\"0.3 +- 0.02 GPa\"").ends_with("'0.02 GPa' is no number, such as 0.3"));
    assert!(told("\"0.35 to 0.25\"").contains("the smaller value stands first"));
    assert_eq!(told("\"0.3\""), "string \"0.3\" stands where a number should");
    assert_eq!(told("true"), "boolean true stands where a number should");
}

#[test]
fn tables_of_distributions_are_refused_with_what_they_need() {
    let told = |table: &str| of_modulus(&format!("{{ {table} }}")).unwrap_err().to_string();
    assert_eq!(
        told("distribution = \"normal\", median = \"1 GPa\""),
        "unknown value `normal`, did you mean `log-normal`? it may be log-normal, beta, uniform, values"
    );
    assert_eq!(
        told("distribution = \"beta\", median = \"1 GPa\", standard_uncertainty = \"1 MPa\""),
        "key material.youngs_modulus.distribution: it cannot be beta; it may be log-normal, uniform or values"
    );
    assert_eq!(
        told("distribution = \"uniform\", from = \"1 GPa\""),
        "key material.youngs_modulus: the distribution uniform needs from and to"
    );
    assert_eq!(
        told("distribution = \"values\", values = [\"1 GPa\"], median = \"1 GPa\""),
        "key material.youngs_modulus.median says nothing about the distribution values; leave it out"
    );
    assert!(told("distribution = \"values\", values = []").contains("there are no values"));
    assert!(told("distribution = \"values\", values = [\"-1 GPa\"]").contains("must be greater than 0"));
    assert!(told("distribution = \"uniform\", from = \"2 GPa\", to = \"1 GPa\"").contains("smaller value"));
    assert!(told("median = \"1 GPa\"").contains("the key distribution is missing here"));
    let ratio = of_ratio("{ distribution = \"uniform\", from = 0.3, to = 0.6 }").unwrap_err().to_string();
    assert!(ratio.ends_with("it must be greater than -1 and at most 0.5"), "{ratio}");
    let ratio = of_ratio("{ distribution = \"log-normal\", median = 0.3, standard_uncertainty = 0.1 }");
    assert!(
        ratio
            .unwrap_err()
            .to_string()
            .ends_with("it cannot be log-normal; it may be beta, uniform or values")
    );
}

#[test]
fn a_hardness_and_a_strength_do_not_both_scatter_and_none_in_h_does() {
    let told = |keys: &str| scene_of(&format!("{BODY}{keys}")).unwrap_err();
    let both = told("indentation_hardness = \"3 GPa +- 1 %\"\nyield_strength = \"1 GPa +- 1 %\"\n");
    assert!(both.to_string().contains("keep one of the two uncertainties"), "{both}");
    assert_eq!(both.span.map(|span| span.len()), Some("\"3 GPa +- 1 %\"".len()));
    for in_h in ["0.3 H +- 0.1 H", "0.3 H to 0.4 H", "1 GPa +- 0.1 H"] {
        let error = told(&format!("yield_strength = \"{in_h}\"\n")).to_string();
        assert!(error.contains("the yield strength cannot be given in H"), "{error}");
    }
}

#[test]
fn a_spread_elsewhere_is_told_where_it_belongs() {
    let text = "[surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = [\"1 MPa +- 1 kPa\"]\n[material]\n\
                youngs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n[[curve]]\nmodel = \"elastic\"\n";
    let error = Scene::parse(text, &NoFiles, &Overrides::default()).unwrap_err().to_string();
    assert!(
        error.starts_with("key loads.pressures: expected a single pressure, not '1 MPa +- 1 kPa'"),
        "{error}"
    );
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
    assert!(
        error.to_string().contains("the z-calibration of AFM is 0.01 here but 0.03 for a.txt"),
        "{error}"
    );
    assert!(error.span.is_some());
    let error = scene(&format!("{afm}2"), "").unwrap_err();
    assert_eq!(
        error.to_string(),
        "key surface.scans.z_calibration: the standard uncertainty of the height scale, as a share is 2; it must be \
         greater than 0 and at most 1"
    );
    let error = scene(", slope_uncertainty = -1", "").unwrap_err().to_string();
    assert!(error.contains("key surface.scans.slope_uncertainty"), "{error}");
    assert!(
        scene(", instrument = \"\"", "").unwrap_err().to_string().contains("name of an instrument is empty")
    );
}
