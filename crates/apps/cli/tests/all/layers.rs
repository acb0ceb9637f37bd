//! Layers from flags and scenes to tables.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::support::{Bench, numbers};

const LAYER: [&str; 6] =
    ["--layer-thickness", "50nm", "--layer-youngs-modulus", "1GPa", "--layer-poisson-ratio", "0.3"];
const RIGID: [&str; 2] = ["--layer-base", "rigid"];
const STEEL: [&str; 4] = ["--youngs-modulus", "210GPa", "--poisson-ratio", "0.3"];
/// The material of the layer.
const SAME: [&str; 4] = ["--youngs-modulus", "1GPa", "--poisson-ratio", "0.3"];
const PERSSON: [&str; 6] = ["persson", "builtin:uncd-measured", "--model", "elastic", "--pressure", "1MPa"];
const MAP: [&str; 10] =
    ["bem", "waves.txt", "--unit", "um", "--size", "1um", "--boundary", "periodic", "--pressure", "20MPa"];

/// Two waves of a map of 32 points a side.
fn with_map() -> Bench {
    let bench = Bench::new();
    let mut text = String::new();
    for row in 0..32 {
        let height = |column: i32| {
            let [x, y] = [column, row].map(|at| TAU * f64::from(at) / 32.0);
            format!("{:e}", 0.01 * x.cos() + 0.004 * (3.0 * y + x).sin())
        };
        let _ = writeln!(text, "{}", (0..32).map(height).collect::<Vec<_>>().join(" "));
    }
    bench.write("waves.txt", text);
    bench
}

#[test]
fn a_layer_of_the_material_of_its_base_is_no_layer() {
    let bench = with_map();
    for command in [&MAP[..], &PERSSON] {
        let plain = bench.run(&[command, &SAME].concat()).ok();
        let layered = bench.run(&[command, &SAME, &LAYER].concat()).ok();
        for column in ["area_fraction", "mean_gap_m", "stiffness_pa_per_m"] {
            let [plain, layered] = [&plain, &layered].map(|table| {
                // The first cutoff of a curve has neither gap nor stiffness.
                let rows = crate::support::column(table, column).len();
                let last = crate::support::column(table, column)[rows - 1];
                last.parse::<f64>().unwrap()
            });
            assert!((layered / plain - 1.0).abs() < 1e-9, "{command:?} {column}: {plain} {layered}");
        }
    }
}

#[test]
fn a_stiffer_base_leaves_less_contact() {
    let bench = with_map();
    let area = |parts: &[&[&str]]| numbers(&bench.run(&parts.concat()).ok(), "area_fraction").pop().unwrap();
    for command in [&MAP[..], &PERSSON] {
        let [half_space, on_steel, on_rigid] =
            [area(&[command, &SAME]), area(&[command, &STEEL, &LAYER]), area(&[command, &LAYER, &RIGID])];
        assert!(
            on_rigid <= on_steel && on_steel < half_space,
            "{command:?}: {on_rigid} {on_steel} {half_space}"
        );
        assert!((on_steel / on_rigid - 1.0).abs() < 0.1, "{command:?}: {on_rigid} {on_steel}");
    }
}

#[test]
fn gap_and_law_take_a_layer_by_the_theory() {
    let bench = Bench::new();
    let spectrum = ["builtin:uncd-measured", "--model", "persson"];
    let under = |column: &str, parts: &[&str]| {
        let call = [&["gap"], &spectrum[..], &["--pressure", "1MPa"], parts].concat();
        numbers(&bench.run(&call).ok(), column)[0]
    };
    let thin = [&LAYER[..], &RIGID].concat();
    let thick = [&["--layer-thickness", "1mm"], &LAYER[2..], &RIGID].concat();
    for column in ["area_fraction", "mean_gap_m", "stiffness_pa_per_m"] {
        assert!((under(column, &thick) / under(column, &SAME) - 1.0).abs() < 1e-3, "{column}");
    }
    assert!(under("stiffness_pa_per_m", &thin) > 1.4 * under("stiffness_pa_per_m", &SAME));
    let law =
        [&["law"], &spectrum[..], &["--dialect", "abaqus", "--pressure-range", "1kPa:1MPa"], &LAYER, &RIGID];
    bench.run(&law.concat()).ok();
    let told = bench.run(&[&PERSSON[..], &LAYER, &RIGID].concat()).ok_remarking(&["layer", "bem"]);
    assert!(told.starts_with("wavelength_m"));
}

#[test]
fn scenes_with_a_layer_run_persson_and_are_judged() {
    let bench = Bench::new();
    let scene = |base: &str, more: &str| {
        format!(
            "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{base}\n[material.layer]\nthickness = \"50 nm\"\n\
             youngs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n{more}\n[loads]\npressures = [\"1 MPa\"]\n"
        )
    };
    let steel = "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3";
    let summary = bench.write("s.toml", scene(steel, "")).run(&["run", "s.toml", "-v", "--no-judge"]).ok();
    crate::support::assert_names(&summary, &["persson", "layer of this material", "areas of a layer"]);
    assert!(!summary.contains("\n  bgt"), "{summary}");
    bench.write("s.toml", scene("", "base = \"rigid\"")).run(&["run", "s.toml"]).ok();
    let named = bench.write("s.toml", scene("name = \"100Cr6\"", "")).run(&["run", "s.toml"]).ok();
    crate::support::assert_names(&named, &["coated", "100Cr6", "boundary elements"]);
    let judged = bench.write("s.toml", scene(steel, "[judge]\ngrid = 48")).run(&["run", "s.toml"]).ok();
    crate::support::assert_names(&judged, &["boundary elements"]);
    assert!(!judged.contains("areas of a layer"), "{judged}");
}
