//! Truths of realistic scenes, on scans made here, and the table that the repository keeps.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

use trials::elements;
use trials::scene_trials::{SceneRow, scenes, written};

/// Height \[nm\] of many waves of unrelated directions and phases, 1.2 to 10 shortest wavelengths \[nm\] long, at a place \[nm\].
fn height_nm(shortest: f64, x: f64, y: f64) -> f64 {
    let wave = |number: u32| {
        let share = |root: f64| (root.sqrt() * f64::from(number)).fract();
        let length = 10.0 * shortest * 0.12f64.powf(share(2.0));
        let (along, across) = (TAU * share(3.0)).sin_cos();
        0.01 * length * (TAU * ((x * along + y * across) / length + share(5.0))).cos()
    };
    (1..=60).map(wave).sum()
}

/// The scene of a file and a material.
fn scene(file: &str, material: &str) -> SceneRow {
    scenes().into_iter().find(|row| row.file.starts_with(file) && row.material == material).unwrap()
}

/// A trace, or a map whose shortest trusted wave has four points, under the name of the file of a scene.
fn files(row: &SceneRow, shortest: f64) -> BTreeMap<String, Vec<u8>> {
    let height_m = |x: u32, y: u32| {
        1e-9 * height_nm(shortest, 0.25 * shortest * f64::from(x), 0.25 * shortest * f64::from(y))
    };
    let text = if row.is_map {
        let line = |y: u32| (0..96).map(|x| format!("{:e}", height_m(x, y))).collect::<Vec<_>>().join(" ");
        let side = format!("{} nm", 24.0 * shortest);
        let lines: Vec<String> = (0..96).map(line).collect();
        format!(
            "# Channel: made\n# Width: {side}\n# Height: {side}\n# Value units: m\n{}\n",
            lines.join("\n")
        )
    } else {
        let line = |x: u32| format!("{:e} {:e}", 0.25e-9 * shortest * f64::from(x), height_m(x, 0));
        format!("# x [m] z [m]\n{}\n", (0..160).map(line).collect::<Vec<_>>().join("\n"))
    };
    BTreeMap::from([(row.file.clone(), text.into_bytes())])
}

#[test]
fn soft_metal_flows_wholly_and_a_polymer_touches_elastically() {
    for (file, shortest) in [("80_Scale", 6.2), ("di-6", 78.2)] {
        let metal = scene(file, "C45");
        let flowed = metal.clone().with_truth(&files(&metal, shortest)).unwrap();
        let least = flowed.pressure_mpa / 1020.0;
        assert!(
            flowed.flowing > 0.9 && flowed.truth >= least * 0.999 && flowed.truth < 1.05 * least,
            "{flowed:?}"
        );
        let polymer = scene(file, "PTFE");
        let elastic = polymer.clone().with_truth(&files(&polymer, shortest)).unwrap();
        assert_eq!(elastic.flowing, 0.0);
        let slope = elastic.truth / elastic.pressure_over_gradient;
        assert!((1.2..2.6).contains(&slope), "{elastic:?}");
        assert!(elastic.truth_error >= 0.02);
    }
}

#[test]
fn the_committed_rows_are_those_of_all_scenes_and_the_table_of_the_page_is_theirs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/develop");
    let rows: Vec<SceneRow> =
        elements::read(&std::fs::read(folder.join("trials/scenes.csv")).unwrap()[..]).unwrap();
    let of_scene = |row: &SceneRow| (row.scene, row.file.clone(), row.material.clone(), row.pressure_mpa);
    assert_eq!(
        rows.iter().map(of_scene).collect::<Vec<_>>(),
        scenes().iter().map(of_scene).collect::<Vec<_>>()
    );
    let page = std::fs::read_to_string(folder.join("trials.md")).unwrap();
    assert_eq!(written(&page, &rows).unwrap(), page);
}
