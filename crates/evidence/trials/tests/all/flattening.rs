//! Spheres that flatten against the elements that the repository keeps.

use std::path::{Path, PathBuf};

use stat_contact::Flattening;
use trials::elements::{self, ElementsRow};
use trials::flattening_trials::{SPREADS, ratios_and_flattened, trials, written};
use trials::judge_spectra::Set;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop").join(name)
}

fn committed() -> Vec<ElementsRow> {
    elements::read(&std::fs::read(file("trials/flattening.csv")).unwrap()[..]).unwrap()
}

#[test]
fn every_trial_has_been_pressed_and_the_table_of_the_page_is_theirs() {
    let rows = committed();
    for trial in [Set::Calibration, Set::Report].into_iter().flat_map(trials) {
        assert!(elements::known(&rows, &trial).is_some(), "{:?}", trial.band);
    }
    let page = std::fs::read_to_string(file("trials.md")).unwrap();
    assert_eq!(written(&page, &rows).unwrap(), page);
}

#[test]
fn held_spheres_are_within_a_factor_of_elements_that_flow_and_others_are_not() {
    let rows = committed();
    let range = |held_from| {
        let of_spread = |spread| ratios_and_flattened(&rows, Set::Report, held_from, spread).unwrap();
        let ratios: Vec<f64> = SPREADS.into_iter().flat_map(|spread| of_spread(spread)[0].clone()).collect();
        [f64::min, f64::max].map(|of| ratios.iter().copied().reduce(of).unwrap())
    };
    let [least, most] = range(Flattening::AreaAndForce.held_from());
    assert!(1.0 < least && most < 1.75, "{least} to {most}");
    let [least, most] = range(Flattening::Area.held_from());
    assert!(least < 0.2 && most > 2.0, "{least} to {most}");
}
