//! Intervals of the quantities of an interface, against the linear law.

use std::collections::BTreeMap;

use persson::separation::STIFFNESS_WITHIN;
use scene::{Overrides, Scene};
use study::Unobserved;
use study::interface::{Quantity, Slot};
use uncertainty::{Uncertainty, UncertaintyPlan, UncertaintySettings};

fn found(modulus: &str) -> Uncertainty {
    let row = |at: i32| {
        let wavelength_m = 10f64.powf(-4.0 - 0.1 * f64::from(at));
        format!("{wavelength_m:e},{:e}\n", 1e-18 * (wavelength_m / 3e-5).min(1.0).powf(2.6))
    };
    let psd: String = std::iter::once("wavelength_m,C1D_m3\n".to_owned()).chain((0..=20).map(row)).collect();
    let text = format!(
        "surface = {{ psd = \"psd.csv\" }}\nloads = {{ pressures = [\"1 MPa\"] }}\n\
         [material]\nyoungs_modulus = \"{modulus}\"\npoisson_ratio = 0.3\nthermal_conductivity = \"20 W/(m K)\"\n\
         [counterface]\nthermal_conductivity = \"20 W/(m K)\"\n[interface]\nshear_strength = \"1 GPa\"\n[[curve]]\nmodel = \"persson\"\n"
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
