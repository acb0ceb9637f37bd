//! `report`: one command from scans to a verdict, the same facts in its summary, its page and its answer.

use crate::support::Bench;
use serde_json::Value;

/// Ten lines of a rough trace: abscissa and height in micrometres.
fn trace() -> String {
    trace_of(0.4)
}

/// The trace with heights of this factor.
fn trace_of(factor: f64) -> String {
    let height = |at: f64| (0.7 * at).sin() + 0.3 * (5.1 * at + 1.0).sin() + 0.1 * (23.0 * at).sin();
    (0..2000)
        .map(|at| format!("{} {}\n", 0.1 * f64::from(at), factor * height(0.1 * f64::from(at))))
        .collect()
}

fn answer(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{folder}/answer.json"))).unwrap()
}

#[test]
fn a_trace_becomes_a_report_that_its_scene_repeats() {
    let bench = Bench::new();
    bench.write("flange.txt", trace());
    let call = [
        "report",
        "flange.txt:unit=um,shortest=1um",
        "--material",
        "100Cr6",
        "--on",
        "100Cr6",
        "--pressure",
        "10MPa",
        "--seal",
    ];
    let summary = bench.run(&call).ok();
    assert!(summary.lines().count() <= 12, "{summary}");
    for folder in ["flange-report", "flange-report/figures", "flange-report/data"] {
        assert!(bench.path(folder).is_dir());
    }
    assert_eq!(bench.read("flange-report/summary.txt"), summary);
    let own = answer(&bench, "flange-report");
    let load = &own["loads"][0];
    let [area, low, high] = ["area_fraction", "low", "high"].map(|key| load["area"][key].as_f64().unwrap());
    assert!(low < area && area < high, "{load}");
    assert!(load["seal"]["verdict"].is_string());
    bench.run(&["run", "flange-report/scene.toml", "--out", "again"]).ok();
    assert_eq!(answer(&bench, "again"), own);
}

#[cfg(unix)]
#[test]
fn a_terminal_is_asked_for_what_is_missing_and_again_for_what_cannot_be_read() {
    let bench = Bench::new();
    bench.write("flange.txt", trace());
    // A material that is none, a steel, the suggested pressure, a unit that is none, and micrometres.
    let ran = bench.run_on_terminal(&["report", "flange.txt"], "unobtainium\n100Cr6\n\nfurlong\num\n\n");
    assert_eq!(ran.status, 0, "{ran:?}");
    for (question, times) in [
        ("material of the rough body? [steel 100Cr6]", 2),
        ("nominal pressure? [10 MPa]", 1),
        ("unit of lengths in flange.txt? [um]", 2),
        ("unit of heights in flange.txt? [um]", 1),
    ] {
        assert_eq!(ran.stderr.matches(question).count(), times, "{question}: {}", ran.stderr);
    }
    let scene = bench.read("flange-report/scene.toml");
    for answer in ["100Cr6\"", "\"10 MPa\"", "unit = \"µm\""] {
        assert!(scene.contains(answer), "{answer}: {scene}");
    }
}

#[test]
fn no_file_that_is_read_or_that_somebody_else_wrote_is_replaced_or_removed() {
    let bench = Bench::new();
    let scene = |psd: &str, figure: &str| {
        format!(
            "title = \"s\"\nsurface = {{ psd = \"{psd}\" }}\n[[figure]]\nname = \"{figure}\"\nshows = \"psd\"\n"
        )
    };
    bench.write("s.toml", scene("builtin:uncd-measured", "spectrum")).run(&["run", "s.toml"]).ok();
    let table = bench.read("s-results/spectrum.csv");
    // A table of an earlier run is an input of the next, which would remove it.
    bench.write("s.toml", scene("s-results/spectrum.csv", "other"));
    bench.run(&["run", "s.toml"]).refused_naming(&["s-results/spectrum.csv", "--out"]);
    assert_eq!(bench.read("s-results/spectrum.csv"), table);
    let report = |file: &str, out: &str| {
        bench.run(&[
            "report",
            file,
            "--material",
            "100Cr6",
            "--pressure",
            "1MPa",
            "--title",
            "s",
            "--out",
            out,
        ])
    };
    std::fs::create_dir_all(bench.path("r/data")).unwrap();
    bench.write("r/data/elastic.csv", table.clone());
    report("r/data/elastic.csv", "r").refused_naming(&["r/data/elastic.csv", "--out"]);
    assert_eq!(bench.read("r/data/elastic.csv"), table);
    std::fs::remove_file(bench.path("r/data/elastic.csv")).unwrap();
    // A table that no report writes or wrote.
    bench.write("r/data/spectrum.csv", table.clone());
    report("r/data/spectrum.csv", "r").ok();
    assert_eq!(bench.read("r/data/spectrum.csv"), table);
    std::fs::create_dir(bench.path("own")).unwrap();
    bench.write("own/scene.toml", "mine");
    report("builtin:uncd-measured", "own").refused_naming(&["own", "scene.toml"]);
    assert_eq!(bench.read("own/scene.toml"), "mine");
}

#[test]
fn a_report_replaces_its_own_files_alone_and_as_it_wrote_them() {
    let bench = Bench::new();
    for folder in ["a", "b", "mine"] {
        std::fs::create_dir(bench.path(folder)).unwrap();
    }
    let trace = trace();
    bench.write("a/trace.txt", &trace).write("b/trace.txt", trace_of(0.5));
    let report = |file: &str, more: &[&str]| {
        let call = ["report", file, "--unit", "um", "--material", "gold", "--pressure", "1MPa"];
        bench.run(&[&call[..], more].concat())
    };
    report("a/trace.txt", &[]).ok();
    report("a/trace.txt", &[]).ok_remarking(&["replaced", "trace-report"]);
    let answer = bench.read("trace-report/answer.json");
    report("b/trace.txt", &[]).refused_naming(&["trace-report", "other files", "--out"]);
    assert_eq!(bench.read("trace-report/answer.json"), answer);
    for edited in [
        "scene.toml",
        "summary.txt",
        "report.html",
        "answer.json",
        "data/elastic.csv",
        "figures/area-fraction.py",
    ] {
        let path = format!("trace-report/{edited}");
        let own = bench.read(&path);
        let text = format!("{own}\n# my notes");
        bench.write(&path, &text);
        report("a/trace.txt", &[]).refused_naming(&[edited]);
        assert_eq!(bench.read(&path), text);
        bench.write(&path, own);
        let foreign = format!("mine/{edited}");
        std::fs::create_dir_all(bench.path(&foreign).parent().unwrap()).unwrap();
        bench.write(&foreign, "mine");
        report("a/trace.txt", &["--out", "mine"]).refused_naming(&[edited]);
        assert_eq!(bench.read(&foreign), "mine");
        std::fs::remove_file(bench.path(&foreign)).unwrap();
    }
    report("a/trace.txt", &[]).ok();
}

#[test]
fn no_file_of_a_report_but_its_scene_names_a_folder_of_its_scans() {
    let bench = Bench::new();
    for (folder, factor) in [("secret/a", 0.4), ("secret/b", 0.5)] {
        std::fs::create_dir_all(bench.path(folder)).unwrap();
        bench.write(&format!("{folder}/trace.txt"), trace_of(factor));
        bench.write(&format!("{folder}/other.txt"), trace_of(2.0 * factor));
    }
    let absolute = bench.path("secret/a/other.txt").display().to_string();
    let call = [
        "report",
        "secret/a/trace.txt",
        "secret/b/trace.txt",
        &absolute,
        "--unit",
        "um",
        "--material",
        "gold",
    ];
    bench.run(&[&call[..], &["--pressure", "1MPa", "--out", "out"]].concat()).ok();
    let mut folders = vec![bench.path("out")];
    let mut read = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned();
            read += 1;
            assert!(path.ends_with("scene.toml") || !text.contains("secret"), "{path:?}");
        }
    }
    assert!(read > 10);
    // Names that two files share have as many folders as tell them apart.
    let page = bench.read("out/report.html");
    assert!(page.contains("a/trace.txt") && page.contains("b/trace.txt") && !page.contains("a/other.txt"));
}

#[cfg(unix)]
#[test]
fn a_report_reads_a_stream_once_and_refuses_its_own_folder() {
    let bench = Bench::new();
    let options = ["--unit", "um", "--material", "gold", "--pressure", "1MPa", "--out"];
    let call = |file: &'static str| [&["report", file][..], &options, &["out"]].concat();
    for file in ["-", "/dev/stdin"] {
        bench.run_with_input(&call(file), &trace()).ok();
        std::fs::remove_dir_all(bench.path("out")).unwrap();
    }
    std::fs::create_dir(bench.path("d")).unwrap();
    bench.write("d/trace.txt", trace());
    for out in ["d", "./d", "d/../d"] {
        bench.run(&[&["report", "d"][..], &options, &[out]].concat()).refused_naming(&["--out", "d"]);
    }
    // A folder may be spelled through its parent.
    std::fs::create_dir(bench.path("e")).unwrap();
    bench.run(&[&["report", "d"][..], &options, &["e/../out"]].concat()).ok();
    std::fs::remove_dir_all(bench.path("out")).unwrap();
    let fifo = bench.path("fifo");
    assert!(std::process::Command::new("mkfifo").arg(&fifo).status().unwrap().success());
    let writer = std::thread::spawn(move || std::fs::write(fifo, trace()).unwrap());
    bench.run(&call("fifo")).ok();
    writer.join().unwrap();
}

#[test]
fn a_scene_without_curves_runs_every_model_and_the_judge_may_add_the_others() {
    let bench = Bench::new();
    let scene = "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nname = \"100Cr6\"\n[loads]\npressures = [\"10 MPa\"]\n";
    bench.write("all.toml", scene).run(&["run", "all.toml"]).ok();
    let curves = |name: &str| answer(&bench, name)["curves"].as_array().unwrap().len();
    assert!(curves("all-results") >= 9);
    bench.write("one.toml", format!("{scene}[[curve]]\nmodel = \"hertz\"\n")).run(&["run", "one.toml"]).ok();
    bench
        .write("more.toml", format!("{scene}[[curve]]\nmodel = \"hertz\"\n[judge]\nall_models = true\n"))
        .run(&["run", "more.toml"])
        .ok();
    assert_eq!((curves("one-results"), curves("more-results")), (1, curves("all-results")));
    // The number does not depend on the models that are listed.
    let area = |name: &str| answer(&bench, name)["loads"][0]["area"]["area_fraction"].as_f64().unwrap();
    assert!(
        (area("one-results") / area("all-results") - 1.0).abs() < 0.2,
        "{} {}",
        area("one-results"),
        area("all-results")
    );
}

#[test]
fn a_hardness_that_grows_has_a_range_alone_in_summary_page_table_and_answer() {
    let bench = Bench::new();
    let row = |at: u32| {
        let wavelength = 10f64.powf(-f64::from(at) / 20.0);
        format!("{:e},{:e}\n", 1e-7 * wavelength, 1e-26 * wavelength.powf(2.6))
    };
    let rows: String = (0..=20).map(row).collect();
    bench.write("s.csv", format!("wavelength_m,C1D_m3\n{rows}"));
    let scene = "[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n\
                 yield_strength = \"300 MPa\"\nstrain_gradient_length = \"1 nm\"\n[loads]\npressures = [\"100 MPa\"]\n";
    let summary = bench.write("g.toml", scene).run(&["run", "g.toml"]).ok();
    let touches = summary.lines().find(|line| line.contains("Touches")).unwrap();
    let words = "the range from a hardness that grows at small scales to a constant one";
    assert!(touches.contains(" to ") && touches.contains(words), "{summary}");
    assert!(summary.contains("Next      measure the hardness by indentation"), "{summary}");
    let page = bench.read("g-results/report.html");
    assert!(page.contains("✓ Range") && page.contains(words) && !page.contains("✓ Best estimate"));
    let answer = answer(&bench, "g-results");
    let load = &answer["loads"][0];
    assert!(load["area"]["area_fraction"].is_null() && load["best_model"].is_null(), "{load}");
    let group = &load["references"][0];
    assert_eq!(
        (&group["range"]["low"], &group["range"]["high"]),
        (&load["area"]["low"], &load["area"]["high"])
    );
    let models = group["models"].as_array().unwrap();
    assert!(!models.is_empty() && models.iter().all(|model| model["ratio"].is_null()), "{group}");
    // The load over three times the strength is the least area with the constant hardness.
    let [low, high] = ["low", "high"].map(|end| group["range"][end].as_f64().unwrap());
    assert!(low < 100.0 / 900.0 && 100.0 / 900.0 <= high, "{group}");
    let table = bench.read("g-results/report-models.csv");
    let growing: Vec<&str> = table.lines().filter(|line| line.contains(",growing,")).collect();
    assert_eq!(growing.len(), models.len());
    for line in growing {
        let cells: Vec<&str> = line.split(',').collect();
        assert!(
            (cells[3].parse::<f64>().unwrap() / low - 1.0).abs() < 1e-12 && cells[5].is_empty(),
            "{line}"
        );
    }
}

#[test]
fn summary_page_and_answer_agree_on_every_shipped_scene() {
    let bench = Bench::new();
    for name in ["uncd-measured", "gasket", "electrical-contact", "bolted-joint", "contact-challenge"] {
        let scene = bench.run(&["scene", name]).ok();
        let summary = bench.run_with_input(&["run", "-", "--out", name], &scene).ok();
        assert!(summary.lines().count() <= 12, "{summary}");
        let (answer, page) = (answer(&bench, name), bench.read(&format!("{name}/report.html")));
        assert!(summary.contains(&format!("Trust     {}", answer["trust"].as_str().unwrap())));
        assert!(page.contains(&format!("trust: {}", answer["trust"].as_str().unwrap())));
        for load in answer["loads"].as_array().unwrap() {
            let models = || {
                load["references"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .flat_map(|group| group["models"].as_array().unwrap())
            };
            let agreeing = models().filter(|model| model["verdict"] == "agrees").count();
            assert_eq!(load["tally"]["agree"].as_u64(), Some(agreeing as u64));
            // The verdict on a number is that of its ratio to the elements of its group.
            for model in models().filter(|model| model["ratio"].is_number()) {
                let ratio = model["ratio"].as_f64().unwrap();
                match model["verdict"].as_str().unwrap() {
                    "too-large" => assert!(ratio > 1.0, "{model}"),
                    "too-small" => assert!(ratio < 1.0, "{model}"),
                    "agrees" => assert!((0.75..=4.0 / 3.0).contains(&ratio), "{model}"),
                    _ => {}
                }
            }
            if let Some(best) = load["best_model"].as_object() {
                assert_eq!(best["verdict"], "agrees");
            }
        }
        let Some(closes) = answer["seal"]["closes"].as_object() else { continue };
        let [best_pa, low_pa, high_pa] =
            ["nominal_pressure_pa", "low", "high"].map(|key| closes[key].as_f64().unwrap());
        assert!(low_pa <= best_pa && best_pa <= high_pa);
        for load in answer["loads"].as_array().unwrap() {
            let pressure_pa = load["nominal_pressure_pa"].as_f64().unwrap();
            match load["seal"]["verdict"].as_str().unwrap() {
                "tight" => assert!(pressure_pa >= high_pa),
                "likely-tight" => assert!((best_pa..high_pa).contains(&pressure_pa)),
                "likely-open" => assert!((low_pa..best_pa).contains(&pressure_pa)),
                _ => {}
            }
        }
    }
}
