//! Loads: their number is free, and one bound holds for all.

use scene::{Overrides, Scene};
use study::plan::{LoadRange, Needs, NominalPressure, Part, Plan, PlanError};
use study::{NoFiles, Unobserved};

const STEEL: &str = "[surface]\npsd = \"builtin:uncd-measured\"\n\
                     [material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"1 GPa\"\n";

fn parsed(sections: &str) -> Result<Scene, String> {
    Scene::parse(&format!("{STEEL}{sections}"), &NoFiles, &Overrides::default())
        .map_err(|error| error.to_string())
}

#[test]
fn loads_beyond_what_the_models_take_are_refused_with_value_and_bound() {
    let refused =
        |loads: &str| parsed(&format!("[loads]\n{loads}\n[[curve]]\nmodel = \"hertz\"\n")).unwrap_err();
    assert_eq!(
        refused("pressures = [\"1e308 H\"]"),
        "key loads.pressures: 1e308 H: nominal pressure in Pa is inf; it must be finite and greater than 0"
    );
    assert_eq!(
        refused("pressures = [\"1e40 Pa\"]"),
        "key loads.pressures: 1e40 Pa: nominal pressure in Pa is 1e40; it must be from 1e-30 to 1e30"
    );
    assert_eq!(
        refused("force = \"1e300 N\"\nnominal_area = \"1e-300 m2\""),
        "key loads.force: 1e300 N on 1e-300 m2: nominal pressure in Pa is inf; it must be finite and greater than 0"
    );
    let figure = "[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"hertz\"\n\
                  [[figure]]\nname = \"f\"\nshows = \"area-against-load\"\n\
                  loads = { from = \"1e-200 Pa\", to = \"1e200 Pa\", points = 4 }\n";
    assert_eq!(
        parsed(figure).unwrap_err(),
        "key figure.loads.from: 1e-200 Pa: nominal pressure in Pa is 1e-200; it must be from 1e-30 to 1e30"
    );
}

#[test]
fn scales_loads_and_curves_are_bounded_together() {
    let curves = "[[curve]]\nmodel = \"hertz\"\n[[curve]]\nmodel = \"elastic\"\n";
    let scene =
        parsed(&format!("[loads]\npressures = [\"1 MPa\"]\n{curves}[options]\nscales_per_decade = 400000\n"));
    let mut plan = scene.as_ref().unwrap().plan();
    plan.needs.loads = vec![plan.needs.loads[0].clone(); 10];
    let refused = plan.compute().unwrap_err();
    assert!(matches!(refused, PlanError::TooManyRows { curves: 2, loads: 10, .. }), "{refused}");
}

#[test]
fn a_range_of_loads_streams_like_loads_with_names() {
    let scene =
        parsed("[loads]\npressures = [\"1 kPa\", \"1 MPa\", \"1 GPa\"]\n[[curve]]\nmodel = \"elastic\"\n");
    let scene = scene.unwrap();
    let [from, to] = [1e3, 1e9].map(|pa| NominalPressure::new(pa).unwrap());
    let range = LoadRange::new(from, to, 3);
    let plan = scene.plan();
    let needs = Needs { loads: Vec::new(), load_ranges: vec![range], ..plan.needs.clone() };
    let ranged = Plan { needs, ..plan };
    let streamed = |plan: &Plan<'_>| {
        let mut seen: Vec<(Vec<f64>, usize)> = Vec::new();
        let stream = plan.stream().unwrap();
        let each = |part: Part| {
            seen.push((part.pressures_pa, part.rows.blocks()));
            Ok::<(), PlanError>(())
        };
        stream.parts(&plan.needs.curves[0], &Unobserved, each).unwrap();
        seen
    };
    let (named, ranged) = (streamed(&scene.plan()), streamed(&ranged));
    assert_eq!((ranged.len(), ranged[0].1), (1, 3));
    assert_eq!(named[0].1, ranged[0].1);
    for (named_pa, ranged_pa) in named[0].0.iter().zip(&ranged[0].0) {
        assert!((ranged_pa / named_pa - 1.0).abs() < 1e-14);
    }
}
