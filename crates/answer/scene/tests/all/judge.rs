//! Choices of a scene for its judge.

use scene::{JudgeSettings, Overrides, Scene, SceneError, SceneProblem, Template};
use study::NoFiles;
use units::RemarkCode;

fn parsed_with(section: &str, overrides: &Overrides) -> Result<Scene, SceneError> {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"hertz\"\n{section}"
    );
    Scene::parse(&text, &NoFiles, overrides)
}

fn parsed(section: &str) -> Result<Scene, SceneError> {
    parsed_with(section, &Overrides::default())
}

#[test]
fn what_is_typed_is_what_is_chosen_and_the_rest_is_left_open() {
    let judge = |section: &str| parsed(section).unwrap().judge;
    assert_eq!(judge(""), None);
    assert_eq!(judge("[judge]\n"), Some(JudgeSettings::default()));
    let all = "[judge]\ngrid = 33\nrealisations = 8\nseed = 9223372036854775807\nbudget = 2e8\n";
    let expected = JudgeSettings {
        grid: Some(33),
        realisations: Some(8),
        seed: i64::MAX as u64,
        budget: 2e8,
        off: false,
    };
    assert_eq!(judge(all), Some(expected));
    // A budget may be a whole number.
    assert_eq!(judge("[judge]\nbudget = 1\n").map(|judge| judge.budget), Some(1.0));
    for (grid, realisations) in [(32, 2), (8192, 10_000)] {
        let ends =
            judge(&format!("[judge]\ngrid = {grid}\nrealisations = {realisations}\nseed = 0\n")).unwrap();
        assert_eq!((ends.grid, ends.realisations, ends.seed), (Some(grid), Some(realisations), 0));
    }
}

#[test]
fn values_out_of_bounds_are_refused_with_key_value_and_bound() {
    for (typed, key) in [
        ("grid = 31", "judge.grid"),
        ("grid = 8193", "judge.grid"),
        ("realisations = 1", "judge.realisations"),
        ("seed = -1", "judge.seed"),
        ("budget = 0.0", "judge.budget"),
        ("budget = inf", "judge.budget"),
    ] {
        let error = parsed(&format!("[judge]\n{typed}\n")).unwrap_err();
        assert!(matches!(&error.problem, SceneProblem::Value { key: found, .. } if found == key), "{error}");
        let value = typed.split(" = ").nth(1).unwrap();
        assert_eq!(error.span.map(|span| span.len()), Some(value.len()), "{typed}");
    }
}

#[test]
fn unknown_keys_and_wrong_kinds_are_told_with_what_was_meant() {
    let error = parsed("[judge]\nrealizations = 8\n").unwrap_err();
    let SceneProblem::UnknownKey { meant, .. } = &error.problem else { panic!("{error}") };
    assert_eq!(meant.as_deref(), Some("realisations"));
    let problem = |typed: &str| parsed(typed).unwrap_err().problem;
    assert!(matches!(problem("[judge]\ngrid = 512.5\n"), SceneProblem::WrongType { .. }));
    assert!(matches!(problem("[judge]\noff = \"yes\"\n"), SceneProblem::WrongType { .. }));
    let SceneProblem::UnknownKey { meant, .. } = problem("[juge]\ngrid = 512\n") else { panic!() };
    assert_eq!(meant.as_deref(), Some("judge"));
    let SceneProblem::UnknownKey { key, .. } = problem("[judge]\n\n[options]\njudge = 1\n") else { panic!() };
    assert_eq!(key, "judge");
}

#[test]
fn keys_beside_a_judge_that_is_off_are_noted() {
    let section = "[judge]\ngrid = 64\noff = true\n";
    let scene = parsed(section).unwrap();
    assert_eq!(scene.notes.iter().map(|note| note.code).collect::<Vec<_>>(), [RemarkCode::JudgeIsOff]);
    assert_eq!(scene.notes[0].place.key.as_deref(), Some("judge.grid"));
    assert!(scene.judge.unwrap().off);
}

#[test]
fn the_keys_that_the_template_shows_are_keys_that_there_are() {
    let text = Template::New.text();
    let section = &text[text.find("# [judge]").unwrap()..];
    let lines = section.lines().filter(|line| !line.contains("off = true"));
    let typed: String = lines.map(|line| format!("{}\n", line.trim_start_matches("# "))).collect();
    let judge = parsed(&typed).unwrap().judge.unwrap();
    assert!(judge.grid.is_some() && judge.realisations.is_some());
    assert!(!judge.off);
}
