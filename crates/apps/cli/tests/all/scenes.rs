//! Scenes from file to folder.

use crate::support::{Bench, assert_names, column, numbers};

const SMALL: &str = r#"
title = "small"
[surface]
psd = "builtin:uncd-measured"
[material]
youngs_modulus = "463 GPa"
poisson_ratio = 0.2
yield_strength = "1.8 GPa"
strain_gradient_length = "5 um"
[loads]
pressures = ["1e-3 H", "54 MPa"]
[[curve]]
model = "elastic"
[[curve]]
model = "elastic-plastic"
strain_gradient = true
name = "hardening"
"#;

#[test]
fn every_template_reads_and_the_shipped_scenes_run_from_any_folder() {
    let bench = Bench::new();
    for name in ["uncd-measured", "uncd-reconstructed"] {
        let scene = bench.run(&["scene", name]).ok();
        let summary = bench.run_with_input(&["run", "-", "-v", "--out", name], &scene).ok();
        assert_names(&summary, &["\n  elastic-plastic-strain-gradient "]);
        for figure in ["1", "2", "3a", "3b", "4", "7"] {
            let svg = bench.read(&format!("{name}/figure-{figure}.svg"));
            assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
            assert!(bench.read(&format!("{name}/figure-{figure}.csv")).starts_with("# truearea "));
        }
    }
    let blank = bench.run(&["scene", "new"]).ok();
    let filled = blank.replace("my_psd.csv", "builtin:uncd-measured");
    assert!(bench.run_with_input(&["run", "-"], &filled).ok().contains("scene-results"));
    let models = column(&bench.read("scene-results/report-models.csv"), "curve").join("\n");
    assert_names(&models, &["elastic", "bgt", "persson-plastic"]);
}

#[test]
fn a_scene_writes_a_table_per_curve_and_a_table_and_picture_per_figure() {
    let bench = Bench::new();
    let summary = bench.write("s.toml", SMALL).run(&["run", "s.toml", "-v"]).ok();
    assert_names(&summary, &["46 scales", "149 µm", "3.5 nm", "9.72"]);
    let mut files: Vec<String> = std::fs::read_dir(bench.path("s-results"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    assert_eq!(
        files,
        [
            ".truearea-files",
            "answer.json",
            "area-fraction.csv",
            "area-fraction.svg",
            "elastic.csv",
            "hardening.csv",
            "report-decades.csv",
            "report-judge.csv",
            "report-models.csv",
            "report-scales.csv",
            "report-sensitivity.csv",
            "report.html"
        ]
    );
    let table = bench.read("s-results/hardening.csv");
    assert!(table.starts_with(
        "# truearea 0.1.0: scene \"small\", curve hardening\n# spectrum: builtin:uncd-measured\n"
    ));
    assert!(table.contains("CC BY 4.0"), "the spectrum's attribution goes along");
}

#[test]
fn paths_are_relative_to_the_scene() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("inner")).unwrap();
    bench.write("inner/psd.csv", "wavelength_m,C1D_m3\n1e-5,1e-22\n1e-6,1e-24\n");
    bench.write("inner/s.toml", SMALL.replace("builtin:uncd-measured", "psd.csv"));
    bench.run(&["run", "inner/s.toml", "--out", "here"]).ok();
    assert!(bench.path("here/elastic.csv").exists());
}

#[test]
fn a_curve_may_be_wanted_at_the_shortest_cutoff_alone() {
    let bench = Bench::new();
    let statistical = "[[curve]]\nmodel = \"ep-sphere\"\n";
    let whole = format!("{SMALL}\n{statistical}");
    let alone = whole.replace("[[curve]]", "[[curve]]\ncutoffs = \"shortest\"");
    bench.write("whole.toml", &whole).write("alone.toml", &alone);
    bench.run(&["run", "whole.toml"]).ok();
    bench.run(&["run", "alone.toml"]).ok();
    for curve in ["elastic", "hardening", "ep-sphere"] {
        let [whole, alone] =
            ["whole", "alone"].map(|scene| bench.read(&format!("{scene}-results/{curve}.csv")));
        for name in ["area_fraction", "wavelength_m"] {
            let last_of_blocks: Vec<&str> =
                column(&whole, name).chunks(46).filter_map(|block| block.last().copied()).collect();
            assert_eq!(column(&alone, name), last_of_blocks, "{curve}");
        }
    }
    // Without a curve to follow over cutoffs there is nothing to draw, and nothing to say of where it settles.
    assert!(!bench.path("alone-results/area-fraction.svg").exists());
    let scales = bench.read("alone-results/report-scales.csv");
    assert!(column(&scales, "settled").iter().all(|settled| settled.is_empty()), "{scales}");
    let [whole, alone] =
        ["whole", "alone"].map(|scene| bench.read(&format!("{scene}-results/report-sensitivity.csv")));
    assert_eq!(numbers(&whole, "area_fraction"), numbers(&alone, "area_fraction"));
}

#[test]
fn options_on_the_command_line_count_more_than_the_scene_s() {
    let bench = Bench::new();
    bench.write("s.toml", format!("{SMALL}\n[options]\nscales_per_decade = 20\n"));
    let summary = |more: &[&str]| bench.run(&[&["run", "s.toml", "-v"], more].concat()).ok();
    assert!(summary(&[]).contains("94 scales"), "{}", summary(&[]));
    assert!(summary(&["--scales-per-decade", "3"]).contains("3.02 per decade"));
}

#[test]
fn force_over_area_is_a_nominal_pressure() {
    let bench = Bench::new();
    let by_force =
        SMALL.replace(r#"pressures = ["1e-3 H", "54 MPa"]"#, "force = \"54 N\"\nnominal_area = \"1 mm^2\"");
    bench.write("s.toml", by_force).run(&["run", "s.toml"]).ok();
    assert!(bench.read("s-results/elastic.csv").contains("\nwavelength_m,amplitude_m,"));
    assert_eq!(crate::support::numbers(&bench.read("s-results/elastic.csv"), "pressure_in_pa")[0], 54e6);
}

#[test]
fn a_hardness_in_place_of_a_strength_gives_the_same_areas_and_is_told_in_summary_report_and_tables() {
    let bench = Bench::new();
    bench.write("strength.toml", SMALL);
    bench.write(
        "hardness.toml",
        SMALL.replace("yield_strength = \"1.8 GPa\"", "indentation_hardness = \"5.4 GPa\""),
    );
    let by_strength = bench.run(&["run", "strength.toml", "-v"]).ok();
    let by_hardness = bench.run(&["run", "hardness.toml", "-v"]).ok();
    let page = bench.read("hardness-results/report.html");
    for text in [by_hardness, page] {
        assert!(text.contains("H/3") && !by_strength.contains("H/3"), "{text}");
    }
    let [own, same] =
        ["strength", "hardness"].map(|name| bench.read(&format!("{name}-results/hardening.csv")));
    assert!(same.contains("# E = 463000000000 Pa") && same.contains("S0 = H/3 = 1800000000 Pa"), "{same}");
    let rows = |table: &str| -> Vec<String> {
        table.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
    };
    assert_eq!(rows(&own), rows(&same));
}

#[test]
fn tables_of_earlier_runs_are_removed() {
    let bench = Bench::new();
    bench.write("s.toml", SMALL);
    bench.run(&["run", "s.toml"]).ok();
    bench.write("s.toml", SMALL.replace("\"hardening\"", "\"harder\""));
    bench.run(&["run", "s.toml"]).ok_remarking(&["note: ", "hardening.csv"]);
    assert!(bench.path("s-results/harder.csv").is_file() && !bench.path("s-results/hardening.csv").exists());
}

#[test]
fn idle_keys_and_doubts_are_told_and_the_scene_runs() {
    let bench = Bench::new();
    bench.write("s.toml", SMALL.replacen("[[curve]]", "[[curve]]\nstrain_gradient = true", 1));
    let ran = bench.run(&["run", "s.toml", "-v"]);
    let said = ran.ok_remarking(&["note: line 13: ", "curve.strain_gradient"]).replace("\n  ", " ");
    assert_names(&said, &["lastic at 54 MPa is 9.42 H, above the hardness H = 5.4 GPa"]);
    assert_names(&bench.read("s-results/report.html"), &["H = 5.4 GPa"]);
}

#[test]
fn a_scene_with_a_map_and_a_force_says_through_how_many_spots_its_current_flows() {
    let bench = Bench::new();
    let height = |x: usize, y: usize| {
        let [x, y] = [x, y].map(|at| at as f64 * std::f64::consts::TAU / 64.0);
        (2.0 * x).sin()
            + (2.0 * y + 0.7).cos()
            + 0.3 * (7.0 * x + 3.0 * y).cos()
            + 0.2 * (5.0 * y - 6.0 * x).sin()
    };
    let row = |y| (0..64).map(|x| format!("{:.6}", 0.05 * height(x, y))).collect::<Vec<_>>().join(" ");
    bench.write("map.txt", (0..64).map(row).collect::<Vec<_>>().join("\n"));
    let scene = r#"
title = "silver"
[surface]
scans = [{ file = "map.txt", unit = "um", size = "100 um" }]
[material]
name = "silver"
[counterface]
name = "silver"
[loads]
force = "0.5 N"
nominal_area = "1 mm^2"
[[curve]]
model = "persson"
"#;
    let summary = bench.write("s.toml", scene).run(&["run", "s.toml", "--out", "o"]).ok();
    let answer: serde_json::Value = serde_json::from_str(&bench.read("o/answer.json")).unwrap();
    let spots = &answer["loads"][0]["spots"];
    let number = |key: &str| spots[key].as_f64().unwrap_or_else(|| panic!("{key}: {spots}\n{summary}"));
    assert!((number("on_nominal_area") / number("on_map") - 100.0).abs() < 1e-6);
    assert!((0.0..1.0).contains(&number("largest_share")));
    // That from the stiffness, of the same map.
    let asked = answer["loads"][0]["asked"].as_array().unwrap();
    let resistance = asked.iter().find(|asked| asked["quantity"] == "electrical-resistance").unwrap();
    let ratio = number("resistance_ohm") / resistance["value"].as_f64().unwrap();
    assert!((ratio - 1.0).abs() < 0.1, "{ratio} {answer}");
    assert_names(&summary, &["spots on the map of 100 µm x 100 µm, the largest carries"]);
}
