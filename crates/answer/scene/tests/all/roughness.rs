//! A surface of a scene by its roughness parameters: the surface, its notes, and the errors.

use scene::{Overrides, Scene, SceneError, SceneProblem};
use spectrum::{Normalisation, cumulative_moments};
use study::NoFiles;
use study::given_roughness::RollOffFrom;

/// A scene of steel with these keys of its surface.
fn of_surface(keys: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "[surface]\n{keys}\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n[loads]\n\
         pressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default())
}

const GROUND: &str = "rms_height = \"0.4 um\"\nrms_slope = 0.15\n";

#[test]
fn height_slope_and_a_width_become_a_spectrum_that_has_them() {
    for (keys, rolloff_from, rolloff_m, hurst, is_assumed) in [
        ("rolloff_wavelength = \"80 um\"\nhurst = 0.7", RollOffFrom::Given, 80e-6, 0.7, false),
        ("mean_width = \"0.08 mm\"", RollOffFrom::MeanWidth, 80e-6, 0.8, true),
    ] {
        let scene = of_surface(&format!("{GROUND}{keys}")).unwrap();
        let moments = cumulative_moments(&scene.surface.psd, Normalisation::Parseval);
        let last = moments.last().unwrap();
        assert!((last.rms_height_m() / 0.4e-6 - 1.0).abs() < 1e-12);
        assert!((last.rms_slope() / 0.15 - 1.0).abs() < 1e-12);
        assert!(scene.surface.sources.is_empty() && scene.surface.made_from.is_none());
        let given = scene.surface.roughness.unwrap();
        assert_eq!(scene.surface.notes, [given.remark()]);
        assert_eq!((given.rolloff_from, given.hurst_is_assumed), (rolloff_from, is_assumed));
        let parameters = given.profile.parameters();
        assert_eq!((parameters.rolloff_m, parameters.hurst_exponent), (rolloff_m, hurst));
        // What was assumed makes the areas uncertain without being asked for.
        assert!(scene.scatters());
        assert_eq!(scene.plan().compute().unwrap().curves.len(), 1);
    }
}

#[test]
fn a_counterface_may_be_given_likewise() {
    let keys =
        format!("psd = \"builtin:uncd-measured\"\n[counterface.surface]\n{GROUND}mean_width = \"80 um\"\n");
    let scene = of_surface(&keys).unwrap();
    let parts = scene.surface.each();
    assert!(parts[0].roughness.is_none() && parts[1].roughness.is_some());
    assert!(
        scene.surface.name.ends_with("against Rq 400 nm, Rdq 0.15, RSm 80 µm, H 0.8"),
        "{}",
        scene.surface.name
    );
}

#[test]
fn keys_that_contradict_lack_or_repeat_one_another_are_refused_with_the_mend() {
    let psd = "psd = \"builtin:uncd-measured\"\n";
    for keys in [
        format!("{psd}rms_height = \"1 um\""),
        format!("{psd}hurst = 0.7"),
        "scans = [\"a.txt\"]\nrms_slope = 0.1".to_owned(),
        format!("{GROUND}mean_width = \"80 um\"\nrolloff_wavelength = \"80 um\""),
        GROUND.to_owned(),
        format!("{GROUND}mean_width = \"80 um\"\nwindow = \"hann\""),
        format!("{GROUND}mean_width = \"80 um\"\nx = \"wavevector\""),
        format!("{GROUND}mean_width = \"1 um\""),
        format!("{GROUND}mean_width = \"80 um\"\nhurst = 1.2"),
        String::new(),
    ] {
        assert!(of_surface(&keys).unwrap_err().span.is_some(), "{keys}");
    }
    let missing = of_surface("rms_height = \"1 um\"\nmean_width = \"80 um\"").unwrap_err();
    assert!(matches!(&missing.problem, SceneProblem::MissingKey { key } if key == "rms_slope"), "{missing}");
    let no_unit = of_surface("rms_height = 1\nrms_slope = 0.1\nmean_width = \"1 um\"").unwrap_err();
    assert_eq!(no_unit.key(), Some("surface.rms_height"));
}
