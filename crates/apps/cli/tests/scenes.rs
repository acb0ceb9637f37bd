//! Scenes from file to folder.

mod support;

use support::{Bench, column, numbers};

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
        let summary = bench.run_with_input(&["run", "-", "--out", name], &scene).ok();
        assert!(summary.contains("elastic-plastic-strain-gradient: Archard stack, elastic-plastic (Jackson-Streator), strain gradient\n  nominal pressure"), "{summary}");
        for figure in ["1", "2", "3a", "3b", "4", "7"] {
            let svg = bench.read(&format!("{name}/figure-{figure}.svg"));
            assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
            assert!(bench.read(&format!("{name}/figure-{figure}.csv")).starts_with("# truearea "));
        }
    }
    let blank = bench.run(&["scene", "new"]).ok();
    let message = bench.run_with_input(&["run", "-"], &blank).refused();
    assert!(message.contains("my_psd.csv"), "{message}");
    let filled = blank.replace("my_psd.csv", "builtin:uncd-measured");
    assert!(bench.run_with_input(&["run", "-"], &filled).ok().contains("scene-results"));
}

#[test]
fn a_scene_writes_a_table_per_curve_and_a_table_and_picture_per_figure() {
    let bench = Bench::new();
    let summary = bench.write("s.toml", SMALL).run(&["run", "s.toml"]).ok();
    assert!(
        summary.lines().next().is_some_and(|line| line.contains("of the area touches at 1e-3 H")),
        "{summary}"
    );
    assert!(summary.contains("\n\nsmall\n46 scales from 149 µm to 3.5 nm, 9.72 per decade\n"), "{summary}");
    let mut files: Vec<String> = std::fs::read_dir(bench.path("s-results"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    assert_eq!(
        files,
        [
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
fn a_scene_and_the_command_give_the_same_curve() {
    let bench = Bench::new();
    bench.write("s.toml", SMALL).run(&["run", "s.toml", "--cutoff", "50nm"]).ok();
    let mut args = vec![
        "stacked",
        "builtin:uncd-measured",
        "--model",
        "elastic-plastic",
        "--details",
        "--cutoff",
        "50nm",
    ];
    args.extend(support::DIAMOND);
    args.extend(["--strain-gradient-length", "5um", "--pressure", "1e-3H", "--pressure", "54MPa"]);
    let command = bench.run(&args).ok();
    let table = bench.read("s-results/hardening.csv");
    let table: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(table, command.lines().collect::<Vec<_>>());
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
fn explaining_computes_and_writes_nothing() {
    let bench = Bench::new();
    let explanation = bench.write("s.toml", SMALL).run(&["run", "s.toml", "--dry-run"]).ok();
    assert_eq!(
        explanation,
        "small\n  \
         spectrum  builtin:uncd-measured: 46 wavelengths from 149 µm to 3.5 nm, 9.72 per decade\n  \
         skipped   resampling: options.scales_per_decade is not set\n  \
         skipped   moments and asperity parameters: no curve and no figure uses them\n  \
         needed    amplitudes, eq5: Eq. (5) of Jackson & Jacobs (the stacked curves)\n  \
         needed    stacked curve elastic at 2 loads\n  \
         needed    stacked curve hardening at 2 loads\n  \
         skipped   statistical model: no curve asks for it\n  \
         skipped   persson model: no curve asks for it\n  \
         at most   184 levels of stacks, each once\n  \
         needed    18 final areas with other modelling choices, for the report (not with --no-report)\n  \
         skipped   self-affine fit: only `truearea fit` computes it\n  \
         needed    figure area-fraction\n"
    );
    assert_eq!(bench.files(), ["s.toml"]);
}

#[test]
fn an_explanation_gives_the_reasons_behind_every_number_and_writes_nothing() {
    let bench = Bench::new();
    let scene = SMALL.replacen("[[curve]]", "[[curve]]\nmodel = \"hertz\"\n[[curve]]", 1);
    let explanation = bench.write("s.toml", scene).run(&["run", "s.toml", "--explain"]).ok();
    assert_eq!(bench.files(), ["s.toml"]);
    let plan = bench.run(&["run", "s.toml", "--dry-run"]).ok();
    let reasons = explanation.strip_prefix(&plan).unwrap();
    for words in [
        "\nelastic: Archard stack, elastic (Jackson-Streator)\n  1e-3 H: area fraction ",
        "\n  54 MPa: area fraction ",
        "\n    the scale of 45.6 nm sets it (aspect ratio 0.027): it takes ",
        "\nhertz: Greenwood-Williamson (Hertz)\n",
        "\n    the asperities that the cutoff 3.5 nm leaves set it: radius ",
        " decide most, more than any other decade: ",
    ] {
        assert!(format!("\n{reasons}").contains(words), "{words}\n{reasons}");
    }
}

#[test]
fn explaining_tells_what_is_the_same() {
    let bench = Bench::new();
    let scene = "title = \"t\"\n[surface]\npsd = \"builtin:uncd-measured\"\n\
                 [material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\n\
                 [loads]\npressures = [\"1 MPa\", \"1000 kPa\"]\n\
                 [[curve]]\nmodel = \"hertz\"\ncutoffs = \"shortest\"\n\
                 [[curve]]\nmodel = \"hertz\"\nname = \"again\"\ncutoffs = \"shortest\"\n\
                 [[figure]]\nname = \"f\"\nshows = \"area-against-load\"\n\
                 loads = { from = \"1 MPa\", to = \"1 GPa\", points = 4 }\n";
    let explanation = bench.write("s.toml", scene).run(&["run", "s.toml", "--dry-run"]).ok();
    let told: Vec<&str> = explanation.lines().skip(3).map(str::trim).collect();
    assert_eq!(
        told,
        [
            "needed    moments for every cutoff, parseval: 1/π, which keeps the variance (asperities at the shortest alone)",
            "skipped   amplitudes: no curve and no figure uses them",
            "skipped   stacked model: no curve asks for it",
            "needed    statistical curve hertz at 2 loads, the shortest cutoff alone",
            "shared    statistical curve again at 2 loads, the shortest cutoff alone: the model of hertz",
            "skipped   persson model: no curve asks for it",
            "shared    load 1000 kPa: the pressure of 1 MPa",
            "needed    8 statistical states over loads (f)",
            "at most   5 statistical states, each once",
            "needed    16 final areas with other modelling choices, for the report (not with --no-report)",
            "skipped   self-affine fit: only `truearea fit` computes it",
            "needed    figure f",
        ]
    );
}

#[test]
fn a_curve_may_be_wanted_at_the_shortest_cutoff_alone() {
    let bench = Bench::new();
    let statistical = "[[curve]]\nmodel = \"ep-sphere\"\n";
    let whole = format!("{SMALL}\n{statistical}");
    let alone = whole.replace("[[curve]]", "[[curve]]\ncutoffs = \"shortest\"");
    bench.write("whole.toml", &whole).write("alone.toml", &alone);
    bench.run(&["run", "whole.toml"]).ok();
    let said = bench.run(&["run", "alone.toml"]).ok().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("elastic (Jackson-Streator): 0.0106 to 0.106 % of the area touches"), "{said}");
    assert!(
        said.contains(
            "Computed at the shortest wavelength only, so whether the area has settled is unknown."
        ),
        "{said}"
    );
    assert!(!said.contains("Upper bound") && !said.contains("not settled"), "{said}");
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
fn an_area_against_cutoff_cannot_be_drawn_of_a_curve_at_one_cutoff() {
    let bench = Bench::new();
    let refused = |scene: &str| bench.write("s.toml", scene).run(&["run", "s.toml"]).refused();
    let alone = SMALL.replacen("[[curve]]", "[[curve]]\ncutoffs = \"shortest\"", 1);
    let named = format!("{alone}\n[[figure]]\nname = \"f\"\nshows = \"area\"\ncurves = [\"elastic\"]\n");
    assert!(
        refused(&named).starts_with(
            "error: a figure of the area against cutoff cannot draw \"elastic\", whose cutoffs = \"shortest\"; take one of \
             them away"
        )
    );
    let none = SMALL.replace("[[curve]]", "[[curve]]\ncutoffs = \"shortest\"");
    let message = refused(&format!("{none}\n[[figure]]\nname = \"f\"\nshows = \"area\"\n"));
    assert!(message.contains("needs a [[curve]] without cutoffs = \"shortest\""), "{message}");
    let message = refused(&SMALL.replacen("[[curve]]", "[[curve]]\ncutoffs = \"longest\"", 1));
    assert!(message.contains("unknown value `longest`; it may be every, shortest"), "{message}");
}

#[test]
fn options_on_the_command_line_count_more_than_the_scene_s() {
    let bench = Bench::new();
    bench.write("s.toml", format!("{SMALL}\n[options]\nscales_per_decade = 20\n"));
    let summary = |more: &[&str]| bench.run(&[&["run", "s.toml"], more].concat()).ok();
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
    assert_eq!(support::numbers(&bench.read("s-results/elastic.csv"), "pressure_in_pa")[0], 54e6);
}

#[test]
fn a_bad_scene_is_refused_with_file_line_key_and_value_and_writes_nothing() {
    let bench = Bench::new();
    let refused = |from: &str, to: &str| {
        assert!(SMALL.contains(from));
        let message = bench.write("s.toml", SMALL.replacen(from, to, 1)).run(&["run", "s.toml"]).refused();
        assert_eq!(bench.files(), ["s.toml"]);
        message
    };
    assert_eq!(
        refused("\"463 GPa\"", "463e9"),
        "error: key material.youngs_modulus: '463000000000.0' has no unit; a modulus needs one of Pa, hPa, kPa, bar, MPa, \
         GPa, TPa, psi, ksi, as in '210 GPa'\n --> s.toml:6:18\n  |\n6 | youngs_modulus = 463e9\n  |                  ^^^^^\n"
    );
    assert!(
        refused("poisson_ratio = 0.2", "poison = 1")
            .starts_with("error: unknown key `poison`, did you mean `poisson_ratio`? the keys here are ")
    );
    assert!(
        refused("poisson_ratio = 0.2", "poisson_ratio = 0.6")
            .contains("Poisson's ratio is 0.6; it must be greater")
    );
    assert!(
        refused("\"5 um\"", "\"5 GPa\"")
            .contains("key material.strain_gradient_length: '5 GPa' has the unit 'GPa'")
    );
    assert!(
        refused("yield_strength = \"1.8 GPa\"", "")
            .contains("needs the yield strength: add yield_strength or indentation_hardness in [material]")
    );
    assert!(
        refused("strain_gradient_length = \"5 um\"", "")
            .contains("strain-gradient strength needs its length: add strain_gradient_length in [material]")
    );
    assert!(
        refused("54 MPa", "-54 MPa").contains("'-54 MPa' is out of range; a pressure must be greater than 0")
    );
    assert!(refused("\"hardening\"", "\"elastic\"").contains("two curves are called \"elastic\""));
    assert!(refused("\"hardening\"", "\"../up\"").contains("becomes the name of a file"));
    assert!(refused("model = \"elastic\"", "model = \"rigid\"").contains("unknown value `rigid`"));
    assert!(refused("[loads]", "[load]").contains("unknown key `load`, did you mean `loads`?"));
    assert!(refused("builtin:uncd-measured", "missing.csv").contains(" --> s.toml:4:7"));
    let figure = |figure: &str| refused("[[curve]]", &format!("[[figure]]\n{figure}\n[[curve]]"));
    assert!(
        figure("name = \"f\"\nshows = \"area\"\ncurves = [\"none\"]")
            .contains("there is no curve \"none\"; the curves are")
    );
    assert!(
        figure("name = \"elastic\"\nshows = \"area\"")
            .contains("another figure or curve is called \"elastic\"")
    );
    let message = bench.write("s.toml", b"title = \"\xb5m\"").run(&["run", "s.toml"]).refused();
    assert_eq!(message, "error: s.toml, line 1: not UTF-8 text; save the scene as UTF-8\n");
}

#[test]
fn a_hardness_in_place_of_a_strength_gives_the_same_areas_and_is_told_in_summary_report_and_tables() {
    let bench = Bench::new();
    bench.write("strength.toml", SMALL);
    bench.write(
        "hardness.toml",
        SMALL.replace("yield_strength = \"1.8 GPa\"", "indentation_hardness = \"5.4 GPa\""),
    );
    let by_strength = bench.run(&["run", "strength.toml"]).ok();
    let by_hardness = bench.run(&["run", "hardness.toml"]).ok();
    let told = "yield strength S₀, none given and H/3 assumed";
    let one_line = by_hardness.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        !by_strength.contains("assumed") && one_line.contains(&format!("{told} 1.8 GPa")),
        "{by_hardness}"
    );
    assert!(bench.read("hardness-results/report.html").contains(told));
    let [own, same] =
        ["strength", "hardness"].map(|name| bench.read(&format!("{name}-results/hardening.csv")));
    assert!(same.contains("# E = 463000000000 Pa") && same.contains("S0 = H/3 = 1800000000 Pa"), "{same}");
    let rows = |table: &str| -> Vec<String> {
        table.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
    };
    assert_eq!(rows(&own), rows(&same));
}

#[test]
fn f_a_10_files_that_are_not_of_this_run_are_named() {
    let bench = Bench::new();
    bench.write("s.toml", SMALL);
    assert!(!bench.run(&["run", "s.toml"]).ok().contains("not of this run"));
    bench.write("s.toml", SMALL.replace("\"hardening\"", "\"harder\""));
    let said = bench.run(&["run", "s.toml"]).ok();
    assert!(said.ends_with("not of this run, and left there: hardening.csv\n"), "{said}");
}

#[test]
fn f_a_18_and_19_idle_keys_and_doubts_are_told_and_the_scene_runs() {
    let bench = Bench::new();
    bench.write("s.toml", SMALL.replacen("[[curve]]", "[[curve]]\nstrain_gradient = true", 1));
    let ran = bench.run(&["run", "s.toml"]);
    assert!(
        ran.stderr.contains("note: line 13: curve.strain_gradient has no effect: the model does not yield\n"),
        "{}",
        ran.stderr
    );
    let doubt = "doubtful: elastic at 54 MPa has a real pressure of 9.42 H, above the hardness H = 5.4 GPa\n";
    assert!(ran.ok().contains(doubt));
    assert!(bench.read("s-results/report.html").contains("above the hardness H = 5.4 GPa"));
}

#[test]
fn a_spectrum_without_curves_or_figures_is_asked_what_for() {
    let message =
        Bench::new().run_with_input(&["run", "-"], "[surface]\npsd = \"builtin:uncd-measured\"\n").refused();
    assert!(
        message.starts_with("error: the scene asks for nothing; add a [[curve]] or a [[figure]]"),
        "{message}"
    );
}
