//! What plans yield: as figures, as doubts, as data for others.

use std::sync::atomic::{AtomicUsize, Ordering};

use study::answer::Answer;
use study::doubts::Doubt;
use study::figure::FigureData;
use study::plan::{PlanError, Results};
use study::scene::{Overrides, Scene};
use study::sensitivity::sensitivities;
use study::{NoFiles, Progress, Unobserved};

fn scene(sections: &str) -> Scene {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         yield_strength = \"1 GPa\"\n{sections}"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap()
}

/// Hertz against load at these cutoffs, with more sections.
fn against_load(multiples: &str, more: &str) -> (Results, FigureData) {
    let scene = scene(&format!(
        "[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"hertz\"\n[[figure]]\nname = \"f\"\n\
         shows = \"area-against-load\"\ncutoff_multiples = {multiples}\n\
         loads = {{ from = \"1 MPa\", to = \"10 MPa\", points = 2 }}\n{more}"
    ));
    let results = scene.plan().compute().unwrap();
    let figure = scene.figures[0].data(&results, &scene.needs, scene.hardness_pa());
    (results, figure)
}

#[test]
fn f_a_8_a_line_is_labelled_with_the_cutoff_whose_values_it_draws() {
    let (results, figure) = against_load("[1]", "[cutoffs]\nshortest_wavelength = \"10.2 nm\"\n");
    assert_eq!(figure.series[0].condition, "10.2 nm");
    assert_eq!(results.sweeps[0].cutoff_m, 10.2e-9);
    // The spectrum has no sample there; the area is that of a spectrum that ends there, not at the sample above.
    assert!(results.psd.shortest_wavelength_m() > 10.2e-9);
    let (above, _) = against_load("[1]", "[cutoffs]\nshortest_wavelength = \"11 nm\"\n");
    assert!(figure.series[0].points[0].1 < above.sweeps[0].states[0].area_fraction);
}

#[test]
fn f_a_9_cutoffs_that_read_the_same_have_columns_of_their_own() {
    let (_, figure) = against_load("[10, 10.001, 20, 10]", "");
    let table = figure.table();
    let columns: Vec<&str> = table.columns().map(|(name, _)| name).collect();
    assert_eq!(
        columns,
        ["nominal_pressure_pa", "hertz at 34.989 nm", "hertz at 34.992 nm", "hertz at 70 nm"]
    );
}

#[test]
fn results_and_what_they_say_serialise() {
    let scene = scene(
        "[loads]\npressures = [\"1 MPa\", \"1 H\"]\n[[curve]]\nmodel = \"hertz\"\n[[curve]]\nmodel = \"elastic\"\n",
    );
    let results = scene.plan().compute().unwrap();
    let answer = Answer::of(&scene, &results);
    let varied = sensitivities(&scene, &results, &Unobserved).unwrap();
    let figure = scene.figures[0].data(&results, &scene.needs, scene.hardness_pa());
    let all = serde_json::json!({
        "results": results, "answer": answer, "sensitivities": varied, "figure": figure,
        "doubts": Doubt::of_scene(&scene, &answer), "notes": scene.notes, "loads": scene.needs.loads,
    });
    let area = &all["results"]["curves"][1]["stacked"][0][45]["area_fraction"];
    assert_eq!(area.as_f64(), answer.curves[1][0].as_ref().map(|answer| answer.area_fraction));
    assert_eq!(all["answer"]["curves"][1][0]["area_fraction"], *area);
    assert_eq!(all["figure"]["series"].as_array().map(Vec::len), Some(4));
    assert_eq!(all["sensitivities"].as_array().map(Vec::len), Some(varied.len()));
    assert_eq!(all["loads"][0], serde_json::json!({ "nominal_pressure": 1e6, "label": "1 MPa" }));
}

/// Ends work after so many steps.
struct Impatient {
    steps: AtomicUsize,
    at_most: usize,
}

impl Progress for Impatient {
    fn advance(&self, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.steps.load(Ordering::Relaxed) >= self.at_most
    }
}

#[test]
fn whoever_watches_may_end_curves_stacks_and_sensitivities() {
    for model in ["hertz", "elastic"] {
        let scene = scene(&format!("[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"{model}\"\n"));
        let ended = |at_most| Impatient { steps: AtomicUsize::new(0), at_most };
        assert_eq!(scene.plan().compute_observed(&ended(0)).unwrap_err(), PlanError::Cancelled);
        let results = scene.plan().compute_observed(&ended(1000)).unwrap();
        assert_eq!(sensitivities(&scene, &results, &ended(0)).unwrap_err(), PlanError::Cancelled);
    }
}

fn doubts(sections: &str) -> Vec<Doubt> {
    let scene = scene(sections);
    let results = scene.plan().compute().unwrap();
    Doubt::of_scene(&scene, &Answer::of(&scene, &results))
}

#[test]
fn f_a_19_pressures_above_what_the_body_bears_are_doubted_with_their_places() {
    let found = doubts("[loads]\npressures = [\"1 MPa\", \"2 H\", \"4 H\"]\n[[curve]]\nmodel = \"hertz\"\n");
    let [Doubt::NominalAboveHardness { load, others: 1, .. }, Doubt::RealAboveHardness { highest, .. }, ..] =
        &found[..]
    else {
        panic!("{found:?}")
    };
    assert_eq!((load.as_str(), highest.curve.as_str(), highest.load.as_str()), ("4 H", "hertz", "4 H"));
    assert!(
        matches!(&found[2..], [Doubt::RealAboveThirdModulus { bound_pa, .. }] if *bound_pa < 210e9 / 2.0)
    );
}

#[test]
fn f_a_19_a_spectrum_in_the_wrong_unit_and_a_body_too_strong_are_doubted() {
    let file = "wavelength_m,C1D_m3\n1e-4,1e-7\n1e-5,1e-9\n1e-6,1e-11\n";
    let files = std::collections::BTreeMap::from([("psd.csv".to_owned(), file.as_bytes().to_vec())]);
    let text = "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
                yield_strength = \"30 GPa\"\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n";
    let scene = Scene::parse(text, &files, &Overrides::default()).unwrap();
    let found = Doubt::of_spectrum(&scene.surface.psd);
    assert!(matches!(found[..], [Doubt::SteepSurface { rms_slope }, Doubt::SteepScale { aspect_ratio, .. }]
        if rms_slope > 1e3 && aspect_ratio > 1e3));
    let material = scene.material.as_ref().and_then(Doubt::of_material);
    assert_eq!(material, Some(Doubt::StrongerThanSolids { yield_strength_pa: 30e9, bound_pa: 21e9 }));
}

#[test]
fn f_a_19_nothing_is_doubted_where_physics_has_nothing_against_it() {
    assert_eq!(
        doubts(
            "[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic-plastic\"\n\
                       [cutoffs]\nshortest_wavelength = \"20 um\"\n"
        ),
        []
    );
}
