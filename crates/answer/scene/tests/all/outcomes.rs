//! Results of plans, as figures and as data for others.

use std::sync::atomic::{AtomicUsize, Ordering};

use scene::{Overrides, Scene};
use study::figure::FigureData;
use study::plan::{PlanError, Results};
use study::{NoFiles, Progress};

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
fn a_line_is_labelled_with_the_cutoff_whose_values_it_draws() {
    let (results, figure) = against_load("[1]", "[cutoffs]\nshortest_wavelength = \"10.2 nm\"\n");
    assert_eq!(figure.series[0].condition, "10.2 nm");
    assert_eq!(results.sweeps[0].cutoff_m, 10.2e-9);
    // The spectrum has no sample there; the area is that of a spectrum that ends there, not at the sample above.
    assert!(results.psd.shortest_wavelength_m() > 10.2e-9);
    let (above, _) = against_load("[1]", "[cutoffs]\nshortest_wavelength = \"11 nm\"\n");
    assert!(figure.series[0].points[0].1 < above.sweeps[0].states[0].area_fraction);
}

#[test]
fn a_model_without_asperities_has_against_load_what_it_has_along_the_cutoff() {
    let found = |model: &str| {
        let scene = scene(&format!(
            "[loads]\npressures = [\"1 MPa\", \"10 MPa\"]\n[[curve]]\nmodel = \"{model}\"\n[[figure]]\nname = \"f\"\n\
             shows = \"area-against-load\"\ncutoff_multiples = [1, 10]\n\
             loads = {{ from = \"1 MPa\", to = \"10 MPa\", points = 2 }}\n"
        ));
        scene.plan().compute().unwrap()
    };
    for model in ["persson", "elastic"] {
        let results = found(model);
        for sweep in &results.sweeps {
            assert_eq!(sweep.area_fractions.len(), 2);
            for load in 0..2 {
                let along = results.curves[0].area_fractions(load);
                let (_, expected) =
                    along.iter().rfind(|(wavelength_m, _)| *wavelength_m > 0.999 * sweep.cutoff_m).unwrap();
                let ratio = sweep.area_fractions[load] / expected;
                assert!((ratio - 1.0).abs() < 1e-9, "{model} {load}: {ratio}");
            }
        }
        assert!(results.sweeps[0].area_fractions[0] < results.sweeps[1].area_fractions[0]);
    }
}

#[test]
fn cutoffs_that_read_the_same_have_columns_of_their_own() {
    let (_, figure) = against_load("[10, 10.001, 20, 10]", "");
    let table = figure.table();
    let columns: Vec<&str> = table.columns().map(|(name, _)| name).collect();
    assert_eq!(
        columns,
        ["nominal_pressure_pa", "hertz at 34.989 nm", "hertz at 34.992 nm", "hertz at 70 nm"]
    );
}

#[test]
fn results_and_figures_serialise() {
    let scene = scene(
        "[loads]\npressures = [\"1 MPa\", \"1 H\"]\n[[curve]]\nmodel = \"hertz\"\n[[curve]]\nmodel = \"elastic\"\n",
    );
    let results = scene.plan().compute().unwrap();
    let figure = scene.figures[0].data(&results, &scene.needs, scene.hardness_pa());
    let all = serde_json::json!({
        "results": results, "figure": figure, "notes": scene.notes, "loads": scene.needs.loads,
    });
    let area = &all["results"]["curves"][1]["stacked"][0][45]["area_fraction"];
    let last = *results.curves[1].area_fractions(0).last().unwrap();
    assert_eq!(area.as_f64(), Some(last.1));
    assert_eq!(all["figure"]["series"].as_array().map(Vec::len), Some(4));
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
fn whoever_watches_may_end_curves_and_stacks() {
    for model in ["hertz", "elastic"] {
        let scene = scene(&format!("[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"{model}\"\n"));
        let ended = |at_most| Impatient { steps: AtomicUsize::new(0), at_most };
        assert_eq!(scene.plan().compute_observed(&ended(0)).unwrap_err(), PlanError::Cancelled);
        assert!(scene.plan().compute_observed(&ended(1000)).is_ok());
    }
}
