//! `flow`, and the flow through pressed surfaces of `bem`.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::support::{Bench, column, numbers};

const PRESSED: &str = "--youngs-modulus 200GPa --poisson-ratio 0.3 --unit um --size 48um";
const FACTORS: [&str; 2] = ["flow_factor_x", "flow_factor_y"];

/// Rows of numbers as text.
fn text(rows: usize, columns: usize, value: impl Fn(f64, f64) -> f64) -> String {
    let mut text = String::new();
    for row in 0..rows {
        let cells = (0..columns).map(|at| format!("{:.17e}", value(at as f64, row as f64)));
        let _ = writeln!(text, "{}", cells.collect::<Vec<_>>().join(" "));
    }
    text
}

/// A rough map that repeats itself on 48 points a side.
fn rough(x: f64, y: f64) -> f64 {
    let wave = |n: f64| {
        let (along, across) = ((5.0 * n % 9.0) - 4.0, (3.0 * n % 7.0) - 3.0);
        (TAU * (along * x + across * y) / 48.0 + n * n).sin() / (1.0 + along.hypot(across))
    };
    0.02 * (1..40).map(|n| wave(f64::from(n))).sum::<f64>()
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("rough.txt", text(48, 48, rough));
    bench.write("holed.txt", text(48, 48, |x, y| if x == y { f64::NAN } else { rough(x, y) }));
    bench.write("slot.txt", text(6, 8, |_, _| 2.0));
    bench.write("waves.txt", text(6, 8, |x, _| 1.0 + 0.1 * x));
    bench.write("closed.txt", text(6, 8, |_, _| -1.0));
    bench.write("mixed.txt", text(6, 8, |x, y| [1.0, 1e-7, 0.0, f64::NAN][(x * y) as usize % 4]));
    bench
}

#[track_caller]
fn run(bench: &Bench, words: &str) -> String {
    bench.run(&words.split_whitespace().collect::<Vec<_>>()).ok()
}

#[track_caller]
fn factors(table: &str) -> [f64; 2] {
    FACTORS.map(|name| numbers(table, name)[0])
}

#[track_caller]
fn assert_near(found: [f64; 2], expected: [f64; 2], relative: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < relative, "{found:e} is not {expected:e}");
    }
}

#[test]
fn gaps_with_a_closed_form_have_it_with_edges_of_every_kind() {
    let bench = bench();
    let gaps: Vec<f64> = (0..8).map(|x| 1.0 + 0.1 * f64::from(x)).collect();
    let mean = |of: fn(&f64) -> f64| gaps.iter().map(of).sum::<f64>() / 8.0;
    let cube = mean(|gap| *gap).powi(3);
    let expected = [1.0 / (mean(|gap| gap.powi(-3)) * cube), mean(|gap| gap.powi(3)) / cube];
    for edges in ["periodic", "reservoirs", "channel"] {
        let flow = |file: &str| run(&bench, &format!("flow {file} --unit um --size 8um --edges {edges}"));
        assert_near(factors(&flow("slot.txt")), [1.0; 2], 1e-12);
        // Along x reservoirs meet half an element at either end, as the periodic tie between the ends does.
        assert_near(factors(&flow("waves.txt")), expected, 1e-12);
        assert_eq!(factors(&flow("closed.txt")), [0.0; 2]);
        assert_eq!(column(&flow("closed.txt"), "open_along_x"), ["0"]);
    }
}

#[test]
fn a_pressed_gap_has_the_flow_of_its_file_and_paths_that_agree_with_it() {
    let bench = bench();
    for (boundary, own) in [("periodic", "periodic"), ("free", "channel")] {
        let press = |more: &str| {
            let loads = "--pressure 20MPa --pressure 3GPa";
            run(&bench, &format!("bem rough.txt {PRESSED} --boundary {boundary} {loads} {more}"))
        };
        let edges_of = [("", own), ("reservoirs", "reservoirs"), ("channel", "channel")];
        let without = press("");
        for (given, edges) in edges_of {
            let option = if given.is_empty() { String::new() } else { format!("--flow-edges {given}") };
            let pressed = press(&format!("--flow {option} --fields {boundary}{given}"));
            // The field of a pressed surface knows its own edges.
            let edge = if given.is_empty() { String::new() } else { format!("--edges {edges}") };
            let own = run(&bench, &format!("flow {boundary}{given}/load-1-surface-1.nc {edge}"));
            assert_near(factors(&pressed), factors(&own), 1e-12);
            assert!(numbers(&pressed, "flow_residual").iter().all(|residual| *residual < 1e-8));
            for error in ["flow_factor_x_error", "flow_factor_y_error"] {
                let [pressed, own] = [&pressed, &own].map(|table| numbers(table, error)[0]);
                assert!(
                    0.0 < pressed && pressed < 0.2 && (pressed / own - 1.0).abs() < 1e-9,
                    "{pressed} {own}"
                );
            }
            for (factor, open) in FACTORS.iter().zip(["open_along_x", "open_along_y"]) {
                let flows: Vec<bool> = numbers(&pressed, factor).iter().map(|factor| *factor > 0.0).collect();
                let is_open: Vec<bool> = numbers(&pressed, open).iter().map(|open| *open == 1.0).collect();
                assert_eq!(flows, is_open);
            }
            // From edge to edge the paths are those of a map without flow.
            if boundary == "free" && edges == "channel" || boundary == "periodic" && edges == "reservoirs" {
                for open in ["open_along_x", "open_along_y"] {
                    assert_eq!(column(&pressed, open), column(&without, open));
                }
            }
        }
        let field = bench.path(&format!("{boundary}/load-1-surface-1.nc"));
        let bytes = std::fs::read(field).unwrap();
        assert!(bytes.windows(14).any(|name| name == b"flow_along_y_x"));
        let files = std::fs::read_dir(bench.path(boundary)).unwrap();
        let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
        assert_eq!(names.filter(|name| name.contains("-flow-")).count(), 4);
    }
}

#[test]
fn surfaces_of_a_spectrum_have_mean_factors_and_their_scatter() {
    let bench = Bench::new();
    let row = |length_m: f64| format!("{length_m:e},{:e}\n", 1e-20 * (length_m / 1e-5).powf(2.6));
    bench.write("psd.csv", format!("wavelength_m,C1D_m3\n{}{}{}", row(1e-5), row(4e-6), row(1e-6)));
    let call = "bem psd.csv --grid 48 --shortest 2um --realisations 3 --youngs-modulus 200GPa --poisson-ratio 0.3 --pressure 20MPa --flow";
    let (means, each) = (run(&bench, call), run(&bench, &format!("{call} --per-realisation")));
    for name in FACTORS {
        let of_each = numbers(&each, name);
        let mean = of_each.iter().sum::<f64>() / 3.0;
        let deviation = (of_each.iter().map(|factor| (factor - mean).powi(2)).sum::<f64>() / 2.0).sqrt();
        assert_near(
            [numbers(&means, name)[0], numbers(&means, &format!("{name}_sd"))[0]],
            [mean, deviation],
            1e-9,
        );
        assert!(of_each.iter().all(|factor| *factor > 0.0) && !each.contains("_sd"));
    }
}

#[test]
fn what_counts_as_contact_and_what_is_assumed_is_said() {
    let bench = bench();
    let flow = |words: &str| {
        let words = format!("flow mixed.txt --unit um --size 8um {words}");
        bench.run(&words.split_whitespace().collect::<Vec<_>>())
    };
    assert_eq!(flow("").remarks(&["--edges channel"]).len(), 1);
    assert!(flow("--edges periodic").remarks(&["--edges"]).is_empty());
    assert_eq!(flow("").remarks(&["of 48 points", "missing"]).len(), 1);
    assert_eq!(flow("").remarks(&["closed", "1e-5 of the mean gap"]).len(), 1);
    let heights = ["flow", "rough.txt", "--unit", "um", "--size", "48um"];
    assert_eq!(bench.run(&heights).remarks(&["below 0", "heights"]).len(), 1);
    assert!(flow("").remarks(&["below 0"]).is_empty());
    let pressed = format!("bem rough.txt {PRESSED} --pressure 20MPa --flow");
    let ran = bench.run(&pressed.split_whitespace().collect::<Vec<_>>());
    assert_eq!(ran.remarks(&["walls", "--flow-edges reservoirs"]).len(), 1);
}

#[test]
fn a_picture_of_each_direction_is_drawn() {
    let bench = bench();
    run(&bench, "flow slot.txt --unit um --size 8um --figure flow.svg");
    for (file, axis) in [("flow.svg", "along x"), ("flow-y.svg", "along y")] {
        let svg = bench.read(file);
        assert!(svg.contains(axis) && svg.contains("contact") && roxmltree::Document::parse(&svg).is_ok());
    }
    bench.write("gap-y.svg", text(6, 8, |_, _| 1.0));
    // Points have no PDF, which is said before the flow is solved.
    let pdf = ["flow", "slot.txt", "--unit", "um", "--size", "8um", "--figure", "flow.pdf"];
    bench.run(&pdf).refused_naming(&["flow.pdf", ".svg"]);
    let replaced = ["flow", "gap-y.svg", "--unit", "um", "--size", "8um", "--figure", "gap.svg"];
    bench.run(&replaced).refused_naming(&["--figure", "gap-y.svg"]);
}

#[test]
fn gaps_that_are_unknown_or_no_gaps_are_refused() {
    let bench = bench();
    let refused = |words: &str, names: &[&str]| {
        bench.run(&words.split_whitespace().collect::<Vec<_>>()).refused_naming(names);
    };
    refused(
        &format!("bem holed.txt {PRESSED} --pressure 20MPa --gaps keep --flow"),
        &["48 points", "no height"],
    );
    refused("flow nothing.nc", &["nothing.nc"]);
    refused("flow slot.txt", &["slot.txt", "unit"]);
    refused("flow slot.txt:unit=um,size=8um,gaps=keep", &["slot.txt", "gaps"]);
    bench.write("uneven.txt", "0 1\n1 2\n3 1\n4 2\n");
    refused("flow uneven.txt --unit um", &["uneven.txt", "unevenly"]);
    bench.write("psd.csv", "wavelength_m,C1D_m3\n1e-4,1e-18\n1e-5,1e-20\n1e-6,1e-22\n");
    refused("flow psd.csv", &["psd.csv", "spectrum"]);
    bench.write("huge.txt", text(6, 8, |_, _| 1e300));
    refused("flow huge.txt --unit m --size 1m", &["huge.txt", "row 1"]);
    refused(&format!("bem rough.txt {PRESSED} --pressure 20MPa --flow-edges channel"), &["--flow"]);
    refused(&format!("bem rough.txt {PRESSED} --ball-radius 1mm --force 1N --flow"), &["--flow"]);
}

#[test]
fn a_line_is_a_gap_that_does_not_change_across() {
    let bench = bench();
    bench.write("line.txt", "1\n1.1\n1.2\n1.3\n1.4\n1.5\n1.6\n1.7\n");
    let [line, map] = ["line.txt", "waves.txt"]
        .map(|file| factors(&run(&bench, &format!("flow {file} --unit um --size 8um"))));
    assert_near(line, map, 1e-12);
}
