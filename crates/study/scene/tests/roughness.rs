//! A surface of a scene by its roughness parameters: the surface, its notes, and the errors.

use scene::{Overrides, Scene, SceneError, SceneProblem};
use spectrum::{Normalisation, cumulative_moments};
use study::given_roughness::RollOffFrom;
use study::{NoFiles, Note};

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
        let [Note::OfParameters(given)] = &scene.surface.notes[..] else {
            panic!("{:?}", scene.surface.notes)
        };
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
    let told = |keys: &str| of_surface(keys).unwrap_err().to_string();
    let psd = "psd = \"builtin:uncd-measured\"\n";
    assert_eq!(
        told(&format!("{psd}rms_height = \"1 um\"")),
        "[surface] has both psd and rms_height; roughness parameters stand in place of a measured spectrum: keep one of them"
    );
    assert!(told(&format!("{psd}hurst = 0.7")).contains("both psd and hurst"));
    assert!(told("scans = [\"a.txt\"]\nrms_slope = 0.1").contains("both scans and rms_slope"));
    assert_eq!(
        told(&format!("{GROUND}mean_width = \"80 um\"\nrolloff_wavelength = \"80 um\"")),
        "[surface] has both mean_width and rolloff_wavelength, and the former is taken for the latter; keep one of them"
    );
    assert_eq!(
        told(GROUND),
        "[surface] needs mean_width (RSm) or rolloff_wavelength beside rms_height and rms_slope: height and slope do not tell how \
         wide features are"
    );
    let missing = of_surface("rms_height = \"1 um\"\nmean_width = \"80 um\"").unwrap_err();
    assert!(matches!(&missing.problem, SceneProblem::MissingKey { key } if key == "rms_slope"), "{missing}");
    assert_eq!(
        told(&format!("{GROUND}mean_width = \"80 um\"\nwindow = \"hann\"")),
        "key surface.window is for scans, and roughness parameters are given; leave it out"
    );
    assert_eq!(
        told(&format!("{GROUND}mean_width = \"80 um\"\nx = \"wavevector\"")),
        "key surface.x is for a psd, and roughness parameters are given; leave it out"
    );
    assert!(told(&format!("{GROUND}mean_width = \"1 um\"")).starts_with(
        "[surface]: the rms slope 0.15 is too small for an rms height of 400 nm and a roll-off wavelength of 1 µm"
    ));
    assert!(
        told(&format!("{GROUND}mean_width = \"80 um\"\nhurst = 1.2")).contains("the Hurst exponent is 1.2")
    );
    assert!(told("rms_height = 1\nrms_slope = 0.1\nmean_width = \"1 um\"").contains("has no unit; a length"));
    assert!(told("").contains("rms_height, rms_slope and mean_width or rolloff_wavelength"));
}
