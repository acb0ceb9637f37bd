//! Choices of a scene for its draws.

use std::collections::BTreeMap;

use scene::{Overrides, Scene, SceneError, SceneProblem, Template, UncertaintySettings};
use units::RemarkCode;

/// A spectrum whose standard errors scatter, one with a hole, and one without either.
const WITH_ERRORS: &str = "with-errors.csv";
const WITH_HOLE: &str = "with-hole.csv";
const WITHOUT: &str = "without.csv";

fn parsed_with(psd: &str, section: &str, overrides: &Overrides) -> Result<Scene, SceneError> {
    let files = BTreeMap::from([
        (
            WITH_ERRORS.to_owned(),
            b"wavelength_m,C1D_m3,C1D_se_m3\n1e-6,4e-24,1e-24\n1e-7,4e-26,1e-26\n1e-8,4e-28,1e-28\n".to_vec(),
        ),
        (WITHOUT.to_owned(), b"wavelength_m,C1D_m3\n1e-6,4e-24\n5e-7,1e-24\n".to_vec()),
        (WITH_HOLE.to_owned(), b"wavelength_m,C1D_m3\n1e-6,4e-24\n1e-7,4e-26\n".to_vec()),
    ]);
    let text = format!(
        "[surface]\npsd = \"{psd}\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"hertz\"\n{section}"
    );
    Scene::parse(&text, &files, overrides)
}

fn parsed(section: &str) -> Result<Scene, SceneError> {
    parsed_with(WITH_ERRORS, section, &Overrides::default())
}

#[test]
fn what_is_typed_is_what_is_chosen_and_the_rest_is_left_open() {
    let uncertainty = |section: &str| parsed(section).unwrap().uncertainty;
    assert_eq!(uncertainty(""), None);
    assert_eq!(uncertainty("[uncertainty]\n"), Some(UncertaintySettings::default()));
    let all = "[uncertainty]\nlevel = 0.95\ndraws = 1000\nseed = 9223372036854775807\nshares_draws = 4096\n";
    let expected = UncertaintySettings {
        level: 0.95,
        draws: 1000,
        seed: i64::MAX as u64,
        shares_draws: Some(4096),
        off: false,
    };
    assert_eq!(uncertainty(all), Some(expected));
    for (draws, shares_draws) in [(20, 64), (1_000_000, 1_000_000)] {
        let ends = uncertainty(&format!(
            "[uncertainty]\ndraws = {draws}\nshares_draws = {shares_draws}\nseed = 0\n"
        ))
        .unwrap();
        assert_eq!((ends.draws, ends.shares_draws, ends.seed), (draws, Some(shares_draws), 0));
    }
}

#[test]
fn values_out_of_bounds_are_refused_with_key_value_and_bound() {
    for (typed, key) in [
        ("level = 0.0", "uncertainty.level"),
        ("level = 1", "uncertainty.level"),
        ("level = 95", "uncertainty.level"),
        ("level = nan", "uncertainty.level"),
        ("draws = 19", "uncertainty.draws"),
        ("draws = 1000001", "uncertainty.draws"),
        ("seed = -1", "uncertainty.seed"),
        ("shares_draws = 63", "uncertainty.shares_draws"),
    ] {
        let error = parsed(&format!("[uncertainty]\n{typed}\n")).unwrap_err();
        assert!(matches!(&error.problem, SceneProblem::Value { key: found, .. } if found == key), "{error}");
        let value = typed.split(" = ").nth(1).unwrap();
        assert_eq!(error.span.map(|span| span.len()), Some(value.len()), "{typed}");
    }
}

#[test]
fn unknown_keys_and_wrong_kinds_are_told_with_what_was_meant() {
    let error = parsed("[uncertainty]\nshare_draws = 8\n").unwrap_err();
    let SceneProblem::UnknownKey { meant, .. } = &error.problem else { panic!("{error}") };
    assert_eq!(meant.as_deref(), Some("shares_draws"));
    let problem = |typed: &str| parsed(typed).unwrap_err().problem;
    assert!(matches!(problem("[uncertainty]\ndraws = 512.5\n"), SceneProblem::WrongType { .. }));
    assert!(matches!(problem("[uncertainty]\nlevel = \"95 %\"\n"), SceneProblem::WrongType { .. }));
    let SceneProblem::UnknownKey { meant, .. } = problem("[uncertainity]\ndraws = 512\n") else { panic!() };
    assert_eq!(meant.as_deref(), Some("uncertainty"));
}

#[test]
fn keys_beside_draws_that_are_off_are_noted() {
    let section = "[uncertainty]\ndraws = 64\noff = true\n";
    let scene = parsed(section).unwrap();
    assert_eq!(scene.notes.iter().map(|note| note.code).collect::<Vec<_>>(), [RemarkCode::UncertaintyIsOff]);
    assert_eq!(scene.notes[0].place.key.as_deref(), Some("uncertainty.draws"));
    assert!(scene.uncertainty.unwrap().off);
}

#[test]
fn a_section_on_what_does_not_scatter_is_noted() {
    let notes = |psd: &str| {
        let scene = parsed_with(psd, "[uncertainty]\nlevel = 0.9\n", &Overrides::default()).unwrap();
        scene.notes.into_iter().map(|note| (note.place.key.unwrap(), note.code)).collect::<Vec<_>>()
    };
    assert_eq!(notes(WITHOUT), [("uncertainty.level".to_owned(), RemarkCode::NothingScatters)]);
    assert_eq!(notes(WITH_ERRORS), []);
    assert_eq!(notes(WITH_HOLE), []);
}

#[test]
fn the_keys_that_the_template_shows_are_keys_that_there_are() {
    let text = Template::New.text();
    let section = &text[text.find("# [uncertainty]").unwrap()..];
    let lines = section.lines().filter(|line| !line.contains("off = true"));
    let typed: String = lines.map(|line| format!("{}\n", line.trim_start_matches("# "))).collect();
    let uncertainty = parsed(&typed).unwrap().uncertainty.unwrap();
    assert!(uncertainty.shares_draws.is_some() && !uncertainty.off);
}

#[test]
fn a_scene_states_an_uncertainty_by_its_scans_or_its_material_and_not_by_the_table() {
    let trace: String = (0..64).map(|at| format!("{at} {}\n", (at * at % 17) as f64 * 1e-3)).collect();
    let files = BTreeMap::from([("trace.txt".to_owned(), trace.into_bytes())]);
    let states = |scan: &str, material: &str| {
        let text = format!(
            "[surface]\nscans = [{{ file = \"trace.txt\", unit = \"um\"{scan} }}]\n[material]\n{material}\n[loads]\npressures = [\"1 MPa\"]\n\
             [[curve]]\nmodel = \"hertz\"\n"
        );
        Scene::parse(&text, &files, &Overrides::default()).unwrap().states_uncertainty()
    };
    assert!(!states("", "name = \"silver\""));
    for scan in [", instrument = \"one\"", ", z_calibration = \"2 %\"", ", slope_uncertainty = 0.1"] {
        assert!(states(scan, "name = \"silver\""), "{scan}");
    }
    let typed = "poisson_ratio = 0.3\nyoungs_modulus = ";
    assert!(!states("", &format!("{typed}\"70 GPa\"\nindentation_hardness = \"300 MPa\"")));
    for material in [
        "\"70 GPa +- 1 GPa\"",
        "\"70 GPa\"\nindentation_hardness = \"300 MPa +- 30 MPa\"",
        "\"70 GPa\"\nyield_strength = \"100 MPa\"\nstrain_gradient_length = \"1 um +- 0.1 um\"",
    ] {
        assert!(states("", &format!("{typed}{material}")), "{material}");
    }
}
