//! Spheres that flatten against the elements that the repository keeps.

use std::path::{Path, PathBuf};

use spectrum::random_surfaces::{AreaSpectrum, SelfAffine, Size};
use stat_contact::Flattening;
use trials::elements::{self, ElementsRow};
use trials::flattening_trials::{SPREADS, press, ratios_and_flattened, trials, written};
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

/// Loads of 100 ordinary scenes that spheres of the default carry, of 300: metals with an rms height of 50 nm to 5 um, a
/// roll-off at 20 to 500 um and a shortest wavelength of 0.3 to 10 um, under 1, 10 and 100 MPa.
fn ordinary_loads_with_a_state() -> usize {
    // Strength \[Pa\] and E* \[Pa\] of aluminium, mild and hardened steel, copper, and titanium.
    const METALS: [[f64; 2]; 5] =
        [[275e6, 78e9], [350e6, 229e9], [1.8e9, 229e9], [200e6, 136e9], [880e6, 128e9]];
    // Roots of 2, 3, 5 and 7, whose multiples modulo 1 fill the cube evenly.
    let share = |root: f64, scene: u32| (root.sqrt() * f64::from(scene)).fract();
    let between = |share: f64, from: f64, to: f64| from * (to / from).powf(share);
    let mut carried = 0;
    for scene in 1..=100 {
        let rolloff_m = between(share(2.0, scene), 20e-6, 500e-6);
        let surface = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent: 0.5 + 0.45 * share(3.0, scene),
            longest_m: 4.0 * rolloff_m,
            rolloff_m,
            shortest_m: between(share(5.0, scene), 0.3e-6, 10e-6),
            size: Size::RmsHeightM(between(share(7.0, scene), 50e-9, 5e-6)),
        })
        .unwrap();
        let [strength_pa, modulus_pa] = METALS[scene as usize % METALS.len()];
        for pressure_pa in [1e6, 10e6, 100e6] {
            let (strength, load) = (strength_pa / modulus_pa, pressure_pa / (3.0 * strength_pa));
            let state = press(&surface, 1.0, strength, load, Flattening::default().held_from()).unwrap();
            carried += usize::from(state.separation_m.is_some());
        }
    }
    carried
}

#[test]
fn four_fifths_of_ordinary_loads_have_a_state_and_the_page_says_how_many() {
    let carried = ordinary_loads_with_a_state();
    assert!(carried >= 240, "{carried}");
    let page = std::fs::read_to_string(file("trials.md")).unwrap();
    assert!(
        page.contains(&format!("Of the 300 loads of 100 ordinary scenes, {carried} have a state.")),
        "{carried}"
    );
}
