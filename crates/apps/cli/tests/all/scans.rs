//! Scans from file to spectrum to area, as scripts use them.

use crate::support::{Bench, DIAMOND, numbers};

/// A line of `points` heights in nm every 5 nm: a sinusoid of amplitude 3 nm and wavelength 160 nm, and some roughness.
fn line(points: usize, spacing_nm: f64) -> String {
    let height = |i: usize| {
        let x_nm = spacing_nm * i as f64;
        let rough = ((i * 7919) % 101) as f64 / 101.0 - 0.5;
        format!("{x_nm:.3} {:.6}", 3.0 * (std::f64::consts::TAU * x_nm / 160.0).sin() + 0.02 * rough)
    };
    (0..points).map(height).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_composite_is_a_spectrum_that_every_command_takes() {
    let bench = Bench::new();
    bench.write("coarse.txt", line(1024, 20.0)).write("fine.txt", line(1024, 5.0));
    let run = bench.run(&["psd", "coarse.txt:unit=nm", "fine.txt", "--unit", "nm", "--out", "psd.csv"]);
    let row = run.stderr.lines().find(|line| line.starts_with("  coarse.txt")).unwrap();
    let cells: Vec<&str> = row.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
    assert_eq!(cells[..4], ["coarse.txt", "10.2 µm", "40 nm", "2 pixels; no tip radius given"], "{row}");
    assert_eq!(cells[5..], ["-", "doubtful"], "{row}");
    run.ok_remarking(&["coarse.txt over fine.txt: "]);
    let table = bench.read("psd.csv");
    assert!(table.starts_with("# truearea 0.1.0: psd coarse.txt:unit=nm fine.txt --unit nm --out psd.csv\n"));
    assert!(table.contains("# composite of 2 scans; detrend: as fits the scan"), "{table}");
    assert!(table.contains("# scan: fine.txt (text), SHA-256 "), "{table}");
    assert!(
        table.contains(
            "\nwavelength_m,wavevector_rad_per_m,C1D_m3,C1D_se_m3,measurements,degrees_of_freedom\n"
        ),
        "{table}"
    );
    // The sinusoid is the highest bin in terms of variance; it is a tenth of a decade wide.
    let (wavelengths, values) = (numbers(&table, "wavelength_m"), numbers(&table, "C1D_m3"));
    let peak = (0..values.len())
        .max_by(|&a, &b| (values[a] / wavelengths[a]).total_cmp(&(values[b] / wavelengths[b])));
    assert!((wavelengths[peak.unwrap()] / 160e-9).log10().abs() < 0.1);
    assert!(bench.run(&["moments", "psd.csv"]).ok().lines().count() > 20);
    let mut args = vec!["stacked", "psd.csv", "--model", "elastic-plastic", "--pressure", "1e-3H"];
    args.extend(DIAMOND);
    bench.run(&args).ok();
}

#[test]
fn a_periodic_sinusoid_has_its_variance() {
    let bench = Bench::new();
    let heights = |i: usize| {
        let x_nm = 2.5 * i as f64;
        format!("{x_nm} {:.12}", 3.0 * (std::f64::consts::TAU * x_nm / 160.0).sin())
    };
    bench.write("sine.txt", (0..256).map(heights).collect::<Vec<_>>().join("\n"));
    // A sinusoid is none of the Gaussian surfaces that logarithms are freed from their bias for.
    let average = ["--average", "log"];
    let args = ["psd", "sine.txt", "--unit", "nm", "--detrend", "mean", "--window", "none", "--per-scan"];
    let table = bench.run(&[&args[..], &average].concat()).ok();
    assert!(table.contains("\nseries,wavelength_m,wavevector_rad_per_m,C1D_m3,C1D_se_m3\nsine.txt,"));
    // sigma^2 = (1/pi) C dq of the one bin, dq = 2 pi/L.
    let highest = numbers(&table, "C1D_m3").into_iter().fold(0.0, f64::max);
    assert!((highest * 2.0 / 640e-9 / 4.5e-18 - 1.0).abs() < 1e-9, "{highest:e}");
}

#[test]
fn metadata_beside_a_file_give_its_unit_and_size() {
    let bench = Bench::new();
    bench.write("line.txt", line(256, 5.0));
    let meta = "surfaces:\n- topographies:\n  - name: my line\n    datafile:\n      original: line.txt\n    \
                size: !!python/tuple [1280.0]\n    unit: nm\n    height_scale: 2.0\n";
    let plain = bench.run(&["psd", "line.txt", "--unit", "nm"]).ok();
    bench.write("meta.yml", meta);
    let scaled = bench.run(&["psd", "line.txt", "--unit", "um"]).ok_remarking(&[
        "my line: ",
        "unit µm",
        "lengths",
        "in nm",
    ]);
    for (plain, scaled) in numbers(&plain, "C1D_m3").iter().zip(numbers(&scaled, "C1D_m3")) {
        assert!((scaled / plain / 4.0 - 1.0).abs() < 1e-9);
    }
}

#[test]
fn what_is_given_fills_gaps_and_overrules_nothing() {
    let bench = Bench::new();
    let heights: Vec<String> =
        line(256, 5.0).lines().map(|row| row.split(' ').nth(1).unwrap().to_owned()).collect();
    bench.write("column.txt", heights.join("\n"));
    // The first line is the call.
    let below_call = |table: String| table.split_once('\n').unwrap().1.to_owned();
    let of_column = bench.run(&["psd", "column.txt:unit=nm,size=1280nm"]).ok();
    let by_options = bench.run(&["psd", "column.txt", "--unit", "nm", "--size", "1.28um"]).ok();
    assert_eq!(below_call(of_column), below_call(by_options));
    bench.write("half.txt", format!("x_um h\n{}", line(256, 0.005)));
    bench.write("whole.txt", line(256, 5.0));
    let (half, whole) = (
        bench.run(&["psd", "half.txt", "--unit", "nm"]).ok(),
        bench.run(&["psd", "whole.txt", "--unit", "nm"]).ok(),
    );
    let (half, whole) = (numbers(&half, "wavelength_m"), numbers(&whole, "wavelength_m"));
    assert!((half[0] / whole[0] - 1.0).abs() < 1e-9, "{} {}", half[0], whole[0]);
}

#[test]
fn a_map_in_two_dimensions_is_read_back_by_the_exact_conversion() {
    let bench = Bench::new();
    let row = |y: usize| {
        let height =
            |x: usize| format!("{:.6}", (((x * 7919 + y * 104_729) % 1009) as f64 / 1009.0) + 0.1 * x as f64);
        (0..64).map(height).collect::<Vec<_>>().join("\t")
    };
    let rows: Vec<String> = (0..64).map(row).collect();
    bench.write(
        "map.txt",
        format!(
            "# Channel: Height\n# Width: 640 nm\n# Height: 640 nm\n# Value units: nm\n{}",
            rows.join("\n")
        ),
    );
    bench.run(&["psd", "map.txt", "--areal", "--out", "ciso.csv"]).ok();
    let table = bench.read("ciso.csv");
    assert!(table.contains("\nwavelength_m,wavevector_rad_per_m,Ciso_m4,modes\n"), "{table}");
    bench.run(&["moments", "ciso.csv"]).ok_remarking(&["Abel"]);
}

#[test]
fn a_scene_takes_scans_and_a_rough_counterface() {
    let bench = Bench::new();
    bench.write("a.txt", line(512, 5.0)).write("b.txt", line(512, 20.0));
    let scene = "[surface]\nscans = [{ file = \"a.txt\", unit = \"nm\", shortest_wavelength = \"20 nm\" }, \
                 { file = \"b.txt\", unit = \"nm\" }]\naverage = \"arithmetic\"\n[material]\nyoungs_modulus = \"1 GPa\"\n\
                 poisson_ratio = 0.3\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n\
                 [[figure]]\nname = \"psd\"\nshows = \"psd\"\n";
    bench.write("s.toml", scene);
    bench.run(&["run", "s.toml"]).ok();
    let header = bench.read("s-results/psd.csv");
    assert!(header.contains("\nwavevector_rad_per_m,c1d_m3 of a.txt,c1d_m3 of b.txt,c1d_m3\n"), "{header}");
    bench.write("both.toml", format!("{scene}[counterface.surface]\npsd = \"builtin:uncd-measured\"\n"));
    bench.run(&["run", "both.toml", "-v"]).ok_remarking(&["both surfaces"]);
}

#[test]
fn doubtful_scans_are_warned_of() {
    let bench = Bench::new();
    let gap: Vec<String> = line(400, 5.0)
        .lines()
        .enumerate()
        .filter(|(i, _)| !(100..160).contains(i))
        .map(|(_, row)| row.to_owned())
        .collect();
    bench.write("gap.txt", gap.join("\n"));
    bench.run(&["psd", "gap.txt", "--unit", "nm"]).ok_remarking(&["warning: gap.txt: ", "61 times"]);
    let tenfold = |row: &str| {
        let (x, height) = row.split_once(' ').unwrap();
        format!("{x} {}", 10.0 * height.parse::<f64>().unwrap())
    };
    let b: Vec<String> = line(512, 20.0).lines().map(tenfold).collect();
    bench.write("a.txt", line(512, 5.0)).write("b.txt", b.join("\n"));
    bench.run(&["psd", "a.txt:unit=nm", "b.txt:unit=nm"]).ok_remarking(&["warning: a.txt over b.txt"]);
    // Another program's index.json is none of ours.
    bench.write("index.json", "{\"name\": \"my web page\"}");
    bench.run(&["psd", "a.txt", "--unit", "nm"]).ok();
}

#[test]
fn instruments_that_show_different_surfaces_are_the_first_caution() {
    let bench = Bench::new();
    let scene = |unit: &str| {
        format!(
            "title = \"t\"\n[surface]\n\
             scans = [{{ file = \"coarse.txt\", unit = \"nm\" }}, {{ file = \"fine.txt\", unit = \"{unit}\", \
             size = \"5.12 um\" }}]\n\
             [material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.4\n\
             [loads]\npressures = [\"1 kPa\"]\n[[curve]]\nmodel = \"elastic\"\n"
        )
    };
    // Heights alone: their unit is that of the heights, and the spacing comes from the size.
    let heights: Vec<String> =
        line(1024, 5.0).lines().map(|row| row.split(' ').nth(1).unwrap().to_owned()).collect();
    bench.write("coarse.txt", line(1024, 10.0)).write("fine.txt", heights.join("\n"));
    for (unit, doubted) in [("nm", false), ("um", true)] {
        bench.write("s.toml", scene(unit));
        let summary = bench.run(&["run", "s.toml"]).ok();
        assert_eq!(summary.contains("coarse.txt and fine.txt do not show"), doubted, "{unit}: {summary}");
        let scales = bench.read("s-results/report-scales.csv");
        assert!(!doubted || scales.contains(",no,"), "{scales}");
    }
}

#[test]
fn the_same_digits_come_out_on_any_number_of_threads() {
    let bench = Bench::new();
    let row = |y: usize| {
        let height = |x: usize| format!("{:.4}", ((x * 31 + y * y * 17) % 257) as f64 / 257.0);
        (0..96).map(height).collect::<Vec<_>>().join(" ")
    };
    let rows: Vec<String> = (0..300).map(row).collect();
    bench.write("map.txt", format!("# Width: 1 um\n# Height: 3 um\n# Value units: nm\n{}", rows.join("\n")));
    let with = |threads: &str| bench.run_with_env(&["psd", "map.txt"], "RAYON_NUM_THREADS", threads).ok();
    assert_eq!(with("1"), with("7"));
}
