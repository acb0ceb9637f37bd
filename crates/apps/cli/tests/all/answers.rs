//! The answer to a scene: what touches, which scales decide it, what rests on what, and what the data cannot tell.

use crate::support::{Bench, assert_names, column};
use findings::answer::SceneAnswer;
use findings::sensitivity::{Sensitivity, sensitivities};
use scene::{Overrides, Scene};

const BODY: &str = r#"
[material]
youngs_modulus = "210 GPa"
poisson_ratio = 0.3
yield_strength = "1 GPa"
strain_gradient_length = "3 um"
[loads]
pressures = ["1e-3 H", "30 MPa"]
[[curve]]
model = "elastic"
[[curve]]
model = "elastic-plastic"
strain_gradient = true
[[curve]]
model = "ep-sphere"
[[curve]]
model = "elastic-sine"
[[curve]]
model = "ep-sine"
strain_gradient = true
"#;

fn scene(options: &str) -> Scene {
    let text = format!("[surface]\npsd = \"builtin:uncd-measured\"\n{BODY}{options}");
    Scene::parse(&text, &study::NoFiles, &Overrides::default()).unwrap()
}

fn final_areas(scene: &Scene) -> Vec<Vec<f64>> {
    let results = scene.plan().compute().unwrap();
    let last = |result: &study::plan::CurveResult, load| result.area_fractions(load).last().unwrap().1;
    results.curves.iter().map(|result| (0..2).map(|load| last(result, load)).collect()).collect()
}

/// A spectrum that falls as a power of q above 1 um and faster below, so that a stack settles.
fn settling_psd(rows: usize, decades: f64) -> String {
    let row = |i: usize| {
        let wavelength_m = 1e-3 * 10f64.powf(-decades * i as f64 / (rows - 1) as f64);
        let q = std::f64::consts::TAU / wavelength_m;
        format!("{wavelength_m:e},{:e}", 1e-4 * q.powf(-2.2) / (1.0 + (q / 6e6).powi(2)))
    };
    let rows: Vec<String> = (0..rows).map(row).collect();
    format!("wavelength_m,C1D_m3\n{}\n", rows.join("\n"))
}

#[test]
fn a_sensitivity_is_what_the_scene_itself_gives_with_that_option() {
    let own = scene("");
    let results = own.plan().compute().unwrap();
    let found = sensitivities(&own, &results, &study::Unobserved).unwrap();
    let ways = [
        ("normalisation of moments", "as-printed", "normalisation = \"as-printed\""),
        ("amplitude of a scale", "parseval", "amplitude = \"parseval\""),
        ("scales per decade", "20", "scales_per_decade = 20"),
        ("hardness of spheres", "cosine", "hardness_formula = \"cosine\""),
        ("interference law of sinusoids", "bem", "interference_law = \"bem\""),
        ("cap of the strength", "E/10 = 21 GPa", "strength_cap = \"21 GPa\""),
    ];
    for (choice, setting, option) in ways {
        let sensitivity = found
            .iter()
            .find(|sensitivity: &&Sensitivity| sensitivity.choice == choice && sensitivity.setting == setting)
            .unwrap_or_else(|| panic!("{choice} {setting}"));
        let (varied, before) = (final_areas(&scene(&format!("[options]\n{option}"))), final_areas(&own));
        for curve in 0..5 {
            for load in 0..2 {
                let moved = sensitivity.rows.iter().find(|row| (row.curve, row.load) == (curve, load));
                let (area, own_area) = (varied[curve][load], before[curve][load]);
                match moved {
                    Some(moved) => {
                        assert!((moved.area_fraction / area - 1.0).abs() < 1e-10, "{choice} {curve} {load}");
                        assert!((moved.ratio * own_area / area - 1.0).abs() < 1e-10);
                    }
                    None => assert_eq!(area, own_area, "{choice} moves curve {curve} and is not told"),
                }
            }
        }
    }
}

#[test]
fn a_choice_already_made_that_way_is_no_variation() {
    let scene =
        scene("[options]\nhardness_formula = \"cosine\"\nstrength_cap = \"21 GPa\"\nscales_per_decade = 10");
    let results = scene.plan().compute().unwrap();
    let found = sensitivities(&scene, &results, &study::Unobserved).unwrap();
    let settings = |choice: &str| -> Vec<&str> {
        found.iter().filter(|s| s.choice == choice).map(|s| s.setting.as_str()).collect()
    };
    assert_eq!(settings("hardness of spheres"), ["2005"]);
    assert_eq!(settings("cap of the strength"), ["none"]);
    assert_eq!(settings("scales per decade"), ["5", "20"]);
}

#[test]
fn a_stack_that_settles_is_told_with_its_decisive_scales() {
    let bench = Bench::new();
    bench.write("psd.csv", settling_psd(61, 6.0));
    let stack = BODY.split("[[curve]]\nmodel = \"ep-sphere\"").next().unwrap();
    bench.write("s.toml", format!("title = \"t\"\n[surface]\npsd = \"psd.csv\"\n{stack}"));
    bench.run(&["run", "s.toml"]).ok();
    let decades = bench.read("s-results/report-decades.csv");
    let shares: f64 = decades
        .lines()
        .filter(|line| line.starts_with("elastic,3000000,"))
        .map(|line| line.split(',').nth(4).unwrap().parse::<f64>().unwrap())
        .sum();
    assert!((shares - 1.0).abs() < 1e-12, "{shares}");
    let scales = bench.read("s-results/report-scales.csv");
    assert!(
        scales.contains("\ncurve,nominal_pressure_pa,area_fraction,real_pressure_pa,settled_1_percent_m,"),
        "{scales}"
    );
    assert_eq!(column(&scales, "settled"), ["yes"; 4]);
    for name in ["settled_1_percent_m", "setting_wavelength_m", "setting_pressure_pa"] {
        assert!(column(&scales, name).iter().all(|cell| !cell.is_empty()), "{name}: {scales}");
    }
}

#[test]
fn a_spectrum_that_ends_too_soon_leaves_every_area_unsettled() {
    let bench = Bench::new();
    bench.write("psd.csv", settling_psd(25, 2.4));
    // Spheres that are held flatten at the hardness, and their area no longer depends on the end of the spectrum.
    bench.write(
        "s.toml",
        format!("title = \"t\"\n[options]\nflattening = \"area\"\n[surface]\npsd = \"psd.csv\"\n{BODY}"),
    );
    bench.run(&["run", "s.toml"]).ok();
    let scales = bench.read("s-results/report-scales.csv");
    assert!(column(&scales, "settled").iter().all(|settled| *settled == "no"), "{scales}");
}

#[test]
fn too_few_scales_leave_every_area_unsettled_and_are_counted() {
    let bench = Bench::new();
    for (rows, decades) in [(4, 3.0), (20, 0.9)] {
        bench.write("psd.csv", settling_psd(rows, decades));
        bench.write("s.toml", format!("title = \"t\"\n[surface]\npsd = \"psd.csv\"\n{BODY}"));
        let summary = bench.run(&["run", "s.toml"]).ok().replace('\n', " ");
        assert_names(&summary, &["Trust     none", &format!("{rows} scales")]);
        let scales = bench.read("s-results/report-scales.csv");
        assert!(column(&scales, "settled").iter().all(|settled| *settled == "no"), "{scales}");
    }
}

#[test]
fn without_a_report_nothing_but_curves_and_figures_is_written() {
    let bench = Bench::new();
    bench.write("s.toml", format!("title = \"t\"\n[surface]\npsd = \"builtin:uncd-measured\"\n{BODY}"));
    assert_names(&bench.run(&["run", "s.toml", "--no-report"]).ok(), &["Touches", "1e-3 H", "30 MPa"]);
    let files = std::fs::read_dir(bench.path("s-results")).unwrap();
    let report = |file: &std::fs::DirEntry| file.file_name().to_string_lossy().starts_with("report");
    assert_eq!(files.map(Result::unwrap).filter(report).count(), 0);
}

#[test]
fn models_that_end_a_factor_of_two_apart_are_named_with_where_they_part() {
    let scene = scene("");
    let results = scene.plan().compute().unwrap();
    let answer = SceneAnswer::from_results(&scene, &results);
    let finals = final_areas(&scene);
    for disagreement in &answer.disagreements {
        let areas: Vec<f64> = finals.iter().map(|areas| areas[disagreement.load]).collect();
        let (least, most) = (areas[disagreement.least], areas[disagreement.most]);
        assert!(areas.iter().all(|area| (least..=most).contains(area)));
        assert_eq!(disagreement.ratio, most / least);
        assert_eq!(disagreement.parting_wavelength_m.is_some(), disagreement.ratio > 2.0);
    }
    assert_eq!(answer.disagreements.len(), 2);
}

#[test]
fn models_and_choices_are_told_in_the_words_of_the_field() {
    let bench = Bench::new();
    bench.write("s.toml", format!("title = \"t\"\n[surface]\npsd = \"builtin:uncd-measured\"\n{BODY}"));
    let summary = bench.run(&["run", "s.toml", "--verbose"]).ok();
    let summary = summary.replace('\n', " ");
    assert_names(
        &summary,
        &["ep-sphere", "eq5 (Eq. (5) of Jackson & Jacobs)", "2005 (Jackson & Green 2005)"],
    );
    let page = bench.read("s-results/report.html");
    assert_names(
        &page,
        &[
            "(Jackson-Green)",
            "id=\"sensitivities\"",
            "id=\"disagreements\"",
            "Eq. (1) of Jackson &amp; Jacobs",
        ],
    );
    let figure = bench.read("s-results/area-fraction.svg");
    assert_names(&figure, &["GW sinusoids, elastic"]);
}

#[test]
fn a_decade_that_the_spectrum_covers_in_part_is_told_alike_everywhere() {
    let bench = Bench::new();
    bench.write("psd.csv", settling_psd(61, 6.0));
    let text = format!(
        "title = \"t\"\n[surface]\npsd = \"psd.csv\"\n{BODY}[cutoffs]\nshortest_wavelength = \"12.5 um\"\n"
    );
    bench.write("s.toml", text);
    bench.run(&["run", "s.toml"]).ok();
    let page = bench.read("s-results/report.html");
    assert!(page.contains("100\u{a0}µm to 12.6\u{a0}µm") && !page.contains("100\u{a0}µm to 10\u{a0}µm"));
}
