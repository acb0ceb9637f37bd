//! Relations between two ways to ask the program the same: JSON against CSV, and command against scene.

use std::collections::BTreeMap;

use crate::support::{Bench, DIAMOND, column};
use serde_json::value::RawValue;

/// A spectrum of two decades.
const SPECTRUM: [[f64; 2]; 5] = [[1e-5, 1e-20], [3e-6, 6e-22], [1e-6, 3e-23], [3e-7, 1.6e-24], [1e-7, 9e-26]];

/// A folder with the spectrum as CSV and as JSON.
fn bench() -> Bench {
    let bench = Bench::new();
    let csv = SPECTRUM.iter().map(|[x, y]| format!("{x:e},{y:e}\n")).collect::<String>();
    let json: Vec<String> =
        SPECTRUM.iter().map(|[x, y]| format!("{{\"wavelength_m\": {x:e}, \"C1D_m3\": {y:e}}}")).collect();
    bench.write("psd.csv", format!("wavelength_m,C1D_m3\n{csv}"));
    bench.write("psd.json", format!("[{}]", json.join(",")));
    bench
}

/// Asks a question about a spectrum, with the body and the loads of all.
fn question<'a>(words: &[&'a str], has_body: bool) -> Vec<&'a str> {
    let mut args = words.to_vec();
    if has_body {
        args.extend(DIAMOND);
        args.extend(["--pressure", "54MPa", "--pressure", "1GPa"]);
    }
    args
}

#[test]
fn tables_as_json_hold_the_cells_of_tables_as_csv() {
    let bench = bench();
    let questions: [(&[&str], bool); 7] = [
        (&["moments", "psd.csv"], false),
        (&["amplitude", "psd.csv"], false),
        (&["fit", "psd.csv"], false),
        (&["stacked", "psd.csv", "--model", "elastic-plastic", "--details"], true),
        (&["statistical", "psd.csv", "--model", "ep-sine"], true),
        (&["persson", "psd.csv", "--model", "elastic-plastic"], true),
        (&["gap", "psd.csv", "--model", "hertz"], true),
    ];
    for (words, has_body) in questions {
        let args = question(words, has_body);
        let csv = bench.run(&args).ok();
        let json = bench.run(&[&args[..], &["--format", "json"]].concat()).ok();
        let rows: Vec<BTreeMap<String, Box<RawValue>>> = serde_json::from_str(&json).unwrap();
        let names = csv.lines().find(|line| !line.starts_with('#')).unwrap();
        assert!(!rows.is_empty() && rows.iter().all(|row| row.len() == names.split(',').count()), "{names}");
        for name in names.split(',') {
            let cells: Vec<String> = rows
                .iter()
                .map(|row| match row[name].get() {
                    "null" => String::new(),
                    text => text.trim_matches('"').to_owned(),
                })
                .collect();
            assert_eq!(column(&csv, name), cells, "{words:?} {name}");
        }
        // The spectrum as JSON is the spectrum.
        let of_json: Vec<&str> =
            args.iter().map(|word| if *word == "psd.csv" { "psd.json" } else { word }).collect();
        assert_eq!(bench.run(&of_json).ok(), csv, "{words:?}");
    }
}

#[test]
fn scenes_and_commands_give_every_model_the_same_table() {
    let bench = bench();
    // The command, its name of each model, and that of scenes.
    let models: [(&str, &[[&str; 2]]); 3] = [
        ("stacked", &[["elastic"; 2], ["elastic-plastic"; 2]]),
        ("statistical", &[["hertz"; 2], ["ep-sphere"; 2], ["elastic-sine"; 2], ["ep-sine"; 2], ["bgt"; 2]]),
        ("persson", &[["elastic", "persson"], ["elastic-plastic", "persson-plastic"]]),
    ];
    let curves: String = models
        .iter()
        .flat_map(|(_, models)| models.iter())
        .map(|[_, model]| format!("[[curve]]\nname = \"{model}\"\nmodel = \"{model}\"\n"))
        .collect();
    let scene = format!(
        "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\n\
         yield_strength = \"1.8 GPa\"\n[loads]\npressures = [\"54 MPa\", \"1 GPa\"]\n[judge]\noff = true\n\
         [uncertainty]\noff = true\n{curves}"
    );
    bench.write("s.toml", scene).run(&["run", "s.toml", "--no-report"]).ok();
    for (command, models) in models {
        for [of_command, model] in models {
            let table = bench.run(&question(&[command, "psd.csv", "--model", of_command], true)).ok();
            let of_scene = bench.read(&format!("s-results/{model}.csv"));
            assert!(column(&table, "area_fraction").len() >= 2, "{table}");
            for name in table.lines().find(|line| !line.starts_with('#')).unwrap().split(',') {
                assert_eq!(column(&of_scene, name), column(&table, name), "{model} {name}");
            }
        }
    }
}
