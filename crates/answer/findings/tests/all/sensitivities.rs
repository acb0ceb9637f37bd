//! Sensitivities as data for other programs, and cancelled by the observer.

use findings::sensitivity::sensitivities;
use scene::{Overrides, Scene};
use study::NoFiles;
use study::plan::PlanError;
use study::{Progress, Unobserved};

fn scene(sections: &str) -> Scene {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         yield_strength = \"1 GPa\"\n{sections}"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap()
}

const LOAD: &str = "[loads]\npressures = [\"1 MPa\"]\n";

#[test]
fn sensitivities_serialise() {
    let scene = scene(&format!("{LOAD}[[curve]]\nmodel = \"hertz\"\n[[curve]]\nmodel = \"elastic\"\n"));
    let results = scene.plan().compute().unwrap();
    let varied = sensitivities(&scene, &results, &Unobserved).unwrap();
    let all = serde_json::json!(varied);
    assert_eq!(all.as_array().map(Vec::len), Some(varied.len()));
    assert_eq!(all[0]["choice"], "normalisation of moments");
    assert_eq!(all[0]["rows"][0]["area_fraction"].as_f64(), Some(varied[0].rows[0].area_fraction));
}

/// Ends work at once.
struct Cancelled;

impl Progress for Cancelled {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn whoever_watches_may_end_them() {
    for model in ["hertz", "elastic"] {
        let scene = scene(&format!("{LOAD}[[curve]]\nmodel = \"{model}\"\n"));
        let results = scene.plan().compute().unwrap();
        assert_eq!(sensitivities(&scene, &results, &Cancelled).unwrap_err(), PlanError::Cancelled);
    }
}
