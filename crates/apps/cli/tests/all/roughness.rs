//! `roughness`: tables of parameters, their conventions, and what is refused.

use std::f64::consts::TAU;

use crate::support::{Bench, assert_names, column, numbers};
use approx::assert_relative_eq;

/// A profile of 1 um spacing: a wave of 100 um with 1 um amplitude on one of 10 mm with 20 um.
fn profile() -> String {
    let height = |i: i32| (TAU * f64::from(i) / 100.0).cos() + 20.0 * (TAU * f64::from(i) / 10_000.0).cos();
    (0..10_000).map(|i| format!("{i} {}\n", height(i))).collect()
}

fn value(table: &str, parameter: &str) -> f64 {
    let at = column(table, "parameter").iter().position(|name| *name == parameter).unwrap();
    numbers(table, "value")[at]
}

#[test]
fn a_filter_leaves_the_roughness_of_a_wavy_profile() {
    let bench = Bench::new();
    bench.write("wave.txt", profile());
    let whole = bench.run(&["roughness", "wave.txt:unit=um"]).ok();
    assert!(value(&whole, "Rq") > 10.0);
    let filtered = bench.run(&["roughness", "wave.txt:unit=um", "--filter", "0.8mm"]).ok();
    // 2^-(100/800)^-2 of the short wave is taken for the long one; what is left of that is 2^-64 and 0.4 % of 20 um.
    assert_relative_eq!(value(&filtered, "Rq"), 0.5f64.sqrt(), max_relative = 0.01);
    assert_relative_eq!(value(&filtered, "Rdq"), TAU / 100.0 / 2f64.sqrt(), max_relative = 0.01);
    let short = ["roughness", "wave.txt:unit=um", "--filter", "0.8mm", "--short-filter", "100um"];
    assert_relative_eq!(value(&bench.run(&short).ok(), "Rq"), 0.5 * 0.5f64.sqrt(), max_relative = 0.02);
}

#[test]
fn every_parameter_has_one_row_and_further_conventions_on_request() {
    let bench = Bench::new();
    let rough = |i: u64| (i * i * 37 + i * 11) % 1009;
    let rows: Vec<String> = (0..40u64)
        .map(|row| (0..60).map(|column| rough(row * 60 + column).to_string()).collect::<Vec<_>>().join(" "))
        .collect();
    bench.write("map.txt", rows.join("\n")).write("wave.txt", profile());
    let args = ["roughness", "map.txt:unit=nm,size=60um", "wave.txt:unit=um"];
    let usual = bench.run(&args).ok();
    let rows = |table: &str| -> Vec<(String, String)> {
        let [files, names] = ["file", "parameter"].map(|name| column(table, name));
        files.iter().zip(names).map(|(file, name)| ((*file).to_owned(), name.to_owned())).collect()
    };
    let mut once = rows(&usual);
    assert_eq!(once.len(), 21 + 15);
    once.sort();
    once.dedup();
    assert_eq!(once.len(), 21 + 15, "{usual}");
    let all = bench.run(&[&args[..], &["--convention", "all"]].concat()).ok();
    assert_eq!(rows(&all).len(), 21 + 15 + 5 + 4);
    for row in usual.lines() {
        assert!(all.lines().any(|other| other == row), "{row}");
    }
    let json = bench.run(&[&args[..], &["--format", "json"]].concat()).ok();
    assert_eq!(json.matches("\"parameter\"").count(), 21 + 15);
}

#[test]
fn missing_points_are_left_out_and_files_that_cannot_be_evaluated_do_not_hide_others() {
    let bench = Bench::new();
    bench.write("wave.txt", profile()).write("uneven.txt", "0 1\n1 2\n3 1\n4 5\n6 2\n");
    let holed: String = profile()
        .lines()
        .enumerate()
        .map(|(i, row)| if i % 50 == 3 { format!("{i} nan\n") } else { format!("{row}\n") })
        .collect();
    bench.write("holed.txt", holed);
    let [whole, less] = ["wave.txt", "holed.txt"].map(|file| {
        let run = bench.run(&["roughness", &format!("{file}:unit=um"), "--filter", "0.8mm"]);
        assert_eq!(run.remarks(&["without a height left out"]).len(), usize::from(file == "holed.txt"));
        value(&run.ok(), "Rq")
    });
    assert_relative_eq!(whole, less, max_relative = 0.01);
    let both = ["roughness", "uneven.txt:unit=um", "wave.txt:unit=um", "--filter", "0.8mm"];
    let run = bench.run(&both);
    assert!(run.stdout.contains("wave.txt,,Ra,"), "{}", run.stdout);
    assert_eq!(run.status, 2);
    assert_names(&run.stderr, &["uneven.txt", "unevenly spaced"]);
}

#[test]
fn scales_have_a_row_for_each_wavelength_from_the_spectrum_and_from_heights() {
    let bench = Bench::new();
    bench.write("wave.txt", profile());
    let scales = ["roughness", "wave.txt:unit=um", "--filter", "0.8mm", "--scales"];
    let table = bench.run(&scales).ok();
    let wavelengths_m = numbers(&table, "wavelength_m");
    assert!(wavelengths_m.windows(2).all(|pair| pair[1] < pair[0]));
    // The wave of 100 um has this slope. Above its length there is none; differences far below it see all of it.
    let slope = TAU / 100.0 / 2f64.sqrt();
    for column in ["rms_gradient_spectrum", "rms_gradient_heights"] {
        let gradients = numbers(&table, column);
        for (wavelength_m, gradient) in wavelengths_m.iter().zip(gradients) {
            if *wavelength_m < 20e-6 {
                assert_relative_eq!(gradient, slope, max_relative = 0.05);
            } else if *wavelength_m > 400e-6 {
                assert!(gradient < 0.35 * slope, "{column} {wavelength_m} {gradient}");
            }
        }
    }
    let curvature_per_m = numbers(&table, "rms_curvature_heights_per_m").pop().unwrap();
    assert_relative_eq!(curvature_per_m, slope * TAU / 100e-6, max_relative = 0.05);
    let ratio = bench.run(&[&scales[..], &["--ratio-height", "1um"]].concat());
    ratio.refused_naming(&["--scales", "--ratio-height"]);
}
