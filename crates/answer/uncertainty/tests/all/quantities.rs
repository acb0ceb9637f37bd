//! Intervals of the quantities of an interface, against the linear law.

use std::collections::BTreeMap;

use persson::separation::STIFFNESS_WITHIN;
use scene::{Overrides, Scene};
use study::Unobserved;
use study::interface::{Quantity, Slot};
use uncertainty::{Uncertainty, UncertaintyPlan, UncertaintySettings};

fn found(modulus: &str) -> Uncertainty {
    found_with(modulus, "", "")
}

/// Draws with further keys of the rough body, and further curves.
fn found_with(modulus: &str, body: &str, curves: &str) -> Uncertainty {
    let row = |at: i32| {
        let wavelength_m = 10f64.powf(-4.0 - 0.1 * f64::from(at));
        format!("{wavelength_m:e},{:e}\n", 1e-18 * (wavelength_m / 3e-5).min(1.0).powf(2.6))
    };
    let psd: String = std::iter::once("wavelength_m,C1D_m3\n".to_owned()).chain((0..=20).map(row)).collect();
    let text = format!(
        "surface = {{ psd = \"psd.csv\" }}\nloads = {{ pressures = [\"1 MPa\"] }}\n\
         [material]\nyoungs_modulus = \"{modulus}\"\npoisson_ratio = 0.3\nthermal_conductivity = \"20 W/(m K)\"\n{body}\
         [counterface]\nthermal_conductivity = \"20 W/(m K)\"\n[interface]\nshear_strength = \"1 GPa\"\n[[curve]]\nmodel = \"persson\"\n{curves}"
    );
    let files = BTreeMap::from([("psd.csv".to_owned(), psd.into_bytes())]);
    let scene = Scene::parse(&text, &files, &Overrides::default()).unwrap();
    let results = scene.plan().compute().unwrap();
    let settings = UncertaintySettings { draws: 4000, ..UncertaintySettings::default() };
    UncertaintyPlan::new(&scene, &results, &settings).unwrap().run(&Unobserved).unwrap()
}

#[test]
fn conductance_under_a_light_load_falls_with_the_modulus() {
    let found = found("100 GPa +- 1 GPa");
    let interval = |quantity, curve| found.quantity(Slot { quantity, load: Some(0), curve }).unwrap();
    // K hardly depends on the modulus, so that K/E* falls with it, and the theory is less certain under light loads.
    let of_theory = STIFFNESS_WITHIN.ln();
    let expected =
        [(Quantity::ThermalConductance, of_theory.hypot(1.96 * 0.01)), (Quantity::Stiffness, of_theory)];
    for (quantity, expected) in expected {
        let found = interval(quantity, None);
        for ratio in [found.median / found.low, found.high / found.median] {
            assert!((ratio.ln() / expected - 1.0).abs() < 0.01, "{found:?}");
        }
        assert!((found.median / found.value - 1.0).abs() < 1e-3, "{found:?}");
    }
    // Friction is in proportion to the area.
    let (friction, area) = (interval(Quantity::FrictionStress, Some(0)), &found.areas[0]);
    for (found, expected) in
        [(friction.low, area.low), (friction.high, area.high), (friction.value, area.area_fraction)]
    {
        assert!((found / (1e9 * expected) - 1.0).abs() < 1e-12, "{friction:?} {area:?}");
    }
}

#[test]
fn draws_of_a_hardness_move_what_flows_alone() {
    let yields = "[[curve]]\nmodel = \"persson-plastic\"\n";
    let found = found_with("100 GPa", "indentation_hardness = \"50 MPa +- 5 MPa\"\n", yields);
    let [elastic, plastic] = [0, 1].map(|curve| found.areas.iter().find(|area| area.curve == curve).unwrap());
    let is_same = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-12;
    assert!(is_same(elastic.low, elastic.area_fraction) && is_same(elastic.high, elastic.area_fraction));
    // The area and the conductance by the correlation go as H^-1 and H^-0.95, and the gap follows.
    let width = 2.0 * 1.96 * 0.1;
    assert!(((plastic.high / plastic.low).ln() / width - 1.0).abs() < 0.03, "{plastic:?}");
    let interval = |quantity| found.quantity(Slot { quantity, load: Some(0), curve: None }).unwrap();
    let flowed = interval(Quantity::YovanovichConductance);
    assert!(((flowed.high / flowed.low).ln() / (0.95 * width) - 1.0).abs() < 0.03, "{flowed:?}");
    let gap = interval(Quantity::MeanGap);
    let of_gap = (gap.high / gap.low).ln();
    assert!(0.05 < of_gap && of_gap < 0.25, "{gap:?}");
}
