//! Holes and doubts of scans are named wherever their spectrum is used.

use crate::support::{Bench, lines_with, numbers};

/// A line of rough heights in nm.
fn line(points: usize, spacing_nm: f64) -> String {
    let height = |i: usize| {
        let rough = ((i * 7919) % 101) as f64 / 101.0 - 0.5;
        format!("{:.3} {:.6}", spacing_nm * i as f64, rough)
    };
    (0..points).map(height).collect::<Vec<_>>().join("\n")
}

/// A map of rough rows, each of them shifted up or down by as much as `offset` nm.
fn map(offset: f64) -> String {
    let row = |y: usize| {
        let shift = offset * (((y * 6007) % 97) as f64 / 97.0 - 0.5);
        let height = |x: usize| {
            // Bits of a product, so that the heights have no lines as those of a remainder do.
            let bits = ((x + 64 * y + 1) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let bits = (bits ^ (bits >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            format!("{:.6}", (bits >> 40) as f64 / 16_777_216.0 + shift)
        };
        (0..64).map(height).collect::<Vec<_>>().join("\t")
    };
    let rows: Vec<String> = (0..64).map(row).collect();
    format!("# Width: 640 nm\n# Height: 640 nm\n# Value units: nm\n{}", rows.join("\n"))
}

#[test]
fn a_hole_in_a_composite_is_told_in_table_summary_report_and_figure() {
    let bench = Bench::new();
    bench.write("coarse.txt", line(256, 200.0)).write("fine.txt", line(256, 0.5));
    let scans =
        ["psd", "coarse.txt:unit=nm,shortest=2um", "fine.txt:unit=nm,shortest=1nm", "--out", "psd.csv"];
    let run = bench.run(&scans);
    // The ends of the hole.
    let hole = ["warning: ", "between 2.", "nm"];
    assert_eq!(run.remarks(&hole).len(), 1, "{}", run.stderr);
    run.ok();
    assert_eq!(lines_with(&bench.read("psd.csv"), &hole[1..]).len(), 1);

    let told_of = |surface: &str| {
        let scene = format!(
            "[surface]\n{surface}\n[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n\
             [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n[[figure]]\nname = \"psd\"\nshows = \"psd\"\n"
        );
        let run = bench.write("s.toml", scene).run(&["run", "s.toml", "-v"]);
        assert_eq!(run.remarks(&hole).len(), 1, "{}", run.stderr);
        let summary = run.ok();
        assert!(!lines_with(&summary, &["nothing measured", "nm"]).is_empty(), "{summary}");
        let report = bench.read("s-results/report.html");
        assert!(!lines_with(&report, &["not measured"]).is_empty(), "{summary}");
        let decades = bench.read("s-results/report-decades.csv");
        assert_eq!(decades.lines().filter(|row| row.ends_with(",no")).count(), 1, "{decades}");
        bench.read("s-results/psd.svg")
    };
    told_of(
        "scans = [{ file = \"coarse.txt\", unit = \"nm\", shortest_wavelength = \"2 um\" }, { file = \"fine.txt\", \
         unit = \"nm\", shortest_wavelength = \"1 nm\" }]",
    );
    // The line of a spectrum without a hole is in one piece.
    let lines = |svg: &str| svg.matches("<path").count() + svg.matches("<polyline").count();
    let broken = lines(&told_of("psd = \"psd.csv\""));
    let table = bench.read("psd.csv");
    let is_fine =
        |row: &&str| row.split(',').next().unwrap().parse::<f64>().is_ok_and(|length_m| length_m < 1e-6);
    let fine: Vec<&str> = table.lines().filter(is_fine).collect();
    bench.write(
        "whole.csv",
        format!(
            "wavelength_m,wavevector_rad_per_m,C1D_m3,C1D_se_m3,measurements,degrees_of_freedom\n{}",
            fine.join("\n")
        ),
    );
    bench.write("w.toml", "[surface]\npsd = \"whole.csv\"\n[[figure]]\nname = \"psd\"\nshows = \"psd\"\n");
    let run = bench.run(&["run", "w.toml"]);
    assert!(run.remarks(&hole).is_empty(), "{}", run.stderr);
    run.ok();
    assert_eq!(broken, lines(&bench.read("w-results/psd.svg")) + 1);
}

#[test]
fn a_scan_without_tip_radius_is_told_once_with_what_was_assumed() {
    let bench = Bench::new();
    bench.write("map.txt", map(0.0)).write("line.txt", line(256, 5.0));
    let run = bench.run(&["psd", "map.txt", "line.txt:unit=nm"]);
    let assumed = ["warning: ", ":tip-radius=", "tip radius"];
    assert_eq!(run.remarks(&assumed).len(), 2, "{}", run.stderr);
    for words in [["map.txt: ", "20 nm"], ["line.txt: ", "10 nm"]] {
        assert_eq!(run.remarks(&[&assumed[..], &words].concat()).len(), 1, "{}", run.stderr);
    }
    for known in ["map.txt:tip-radius=1pm", "map.txt:shortest=30nm"] {
        let run = bench.run(&["psd", known]);
        assert!(run.remarks(&assumed).is_empty(), "{}", run.stderr);
        run.ok();
    }
    bench.run(&["psd", "map.txt", "--areal"]).ok_remarking(&assumed);
}

#[test]
fn slopes_along_and_across_the_lines_of_a_map_are_both_told() {
    let bench = Bench::new();
    bench.write("even.txt", map(0.0)).write("offset.txt", map(4.0));
    let verdict = |file: &str| {
        let run = bench.run(&["psd", &format!("{file}:shortest=20nm")]);
        let row = run.remarks(&[file])[0].to_owned();
        let cells: Vec<String> =
            row.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_owned).collect();
        let slopes = [4, 5].map(|at: usize| cells[at].parse::<f64>().unwrap());
        let warned = !run.remarks(&["1.5x"]).is_empty();
        run.ok();
        (slopes[1] / slopes[0], warned, cells[6].clone())
    };
    let (ratio, warned, told) = verdict("even.txt");
    assert!((0.6..1.5).contains(&ratio) && !warned && told == "ok", "{ratio} {told}");
    let (ratio, warned, told) = verdict("offset.txt");
    assert!(ratio >= 1.5 && warned && told == "doubtful", "{ratio} {told}");
}

#[test]
fn the_same_scan_twice_has_no_standard_error() {
    let bench = Bench::new();
    bench.write("a.txt", line(256, 5.0));
    let run = bench.run(&["psd", "a.txt", "a.txt", "--unit", "nm"]);
    let table = run.ok_remarking(&["warning: ", "a.txt and a.txt (2) hold"]);
    assert!(!numbers(&table, "wavelength_m").is_empty());
    let mut rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    assert!(rows.all(|row| row.split(',').nth(3) == Some("")), "{table}");
}

#[test]
fn a_flat_scan_is_refused() {
    let bench = Bench::new();
    let ramp: Vec<String> = (0..64).map(|i| format!("{} {:.3}", 5 * i, 0.125 * f64::from(i))).collect();
    bench.write("ramp.txt", format!("x h\n{}", ramp.join("\n")));
    let refused = bench.run(&["psd", "ramp.txt", "--unit", "nm"]).refused();
    assert!(refused.contains("ramp.txt: ") && !refused.contains("inf"), "{refused}");
    // With only its mean subtracted a ramp has a slope and no curvature to compare with.
    let kept = bench.run(&["psd", "ramp.txt", "--unit", "nm", "--detrend", "mean"]);
    assert!(!kept.stderr.contains("inf"), "{}", kept.stderr);
    kept.ok();
}

#[test]
fn a_list_of_scans_says_what_options_after_a_file_say() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("data")).unwrap();
    bench.write("data/a.txt", line(256, 5.0)).write("data/b.txt", line(256, 20.0));
    bench.write("data/scans.csv", "file,unit,shortest\na.txt,nm,12 nm\nb.txt,,\n");
    // What was typed, in the first line, differs.
    let said = |args: &[&str]| bench.run(args).ok().split_once('\n').unwrap().1.to_owned();
    let listed = said(&["psd", "--list", "data/scans.csv", "--unit", "nm"]);
    assert_eq!(listed, said(&["psd", "data/a.txt:unit=nm,shortest=12nm", "data/b.txt", "--unit", "nm"]));
}
