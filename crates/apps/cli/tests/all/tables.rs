//! Tables in and out: what is echoed, appended, recomputed, refused.

use crate::support::Bench;

const SPHERES: &str = "\
youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m
2.47149e+10,0.2799,7.7157e+08,5.3113e-07,4.43628e-11
6.43672E10,0.0923300,1.54985e+08,1.09411e-05,7.09842e-08
";

#[test]
fn cells_are_echoed_as_typed_and_results_appended() {
    let bench = Bench::new();
    let table = bench.write("in.csv", SPHERES).run(&["asperity", "sphere", "--input", "in.csv"]).ok();
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(
        lines[0],
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m,hertz_force_n,hertz_area_m2,\
         jackson_green_force_n,jackson_green_area_m2,jackson_green_force_cosine_hardness_n"
    );
    assert!(lines[2].starts_with("6.43672E10,0.0923300,1.54985e+08,1.09411e-05,7.09842e-08,0.0054149511515"));
    assert_eq!(lines.len(), 3);
}

#[test]
fn unknown_columns_pass_through_and_results_already_there_are_recomputed_in_place() {
    let bench = Bench::new();
    let input = "name,aspect_ratio,area_fraction_ep,pressure_pa,youngs_modulus_pa,poisson_ratio,yield_strength_pa\n\
                 \"a, b\",0.01,wrong,1e8,1e11,0.3,1e9\n";
    let table = bench.run_with_input(&["asperity", "sinusoid"], input).ok();
    let mut lines = table.lines();
    let header = lines.next().unwrap();
    assert!(header.starts_with("name,aspect_ratio,area_fraction_ep,pressure_pa,"));
    assert_eq!(header.matches("area_fraction_ep").count(), 1);
    let row = lines.next().unwrap();
    assert!(row.starts_with("\"a, b\",0.01,0."), "{row}");
    assert!(!row.contains("wrong"));
}

#[test]
fn json_goes_in_and_out_and_numbers_keep_their_digits() {
    let bench = Bench::new();
    let input = r#"[{"id":"007","youngs_modulus_pa":1.50e11,"poisson_ratio":0.30,"yield_strength_pa":1e9,
                     "wavelength_m":1e-6,"aspect_ratio":0.02,"interference_m":1e-9,"note":null}]"#;
    let args = ["asperity", "sinusoid-interference", "--format", "json"];
    let json = bench.run_with_input(&args, input).ok();
    assert!(
        json.starts_with("[\n{\"id\":\"007\",\"youngs_modulus_pa\":1.50e11,\"poisson_ratio\":0.30,"),
        "{json}"
    );
    assert!(json.contains("\"note\":null,\"pressure_elastic_pa\":"), "{json}");
    let rows: Vec<serde_json::Map<String, serde_json::Value>> = serde_json::from_str(&json).unwrap();
    assert_eq!(rows[0].len(), 12);
    let csv = bench.run_with_input(&args[..2], input).ok();
    assert!(csv.lines().nth(1).unwrap().starts_with("007,1.50e11,0.30,1e9,1e-6,0.02,1e-9,,"), "{csv}");
}

#[test]
fn csv_and_json_carry_the_same_doubles() {
    let bench = Bench::new();
    let csv = bench.run(&["amplitude", "builtin:uncd-measured"]).ok();
    let json = bench.run(&["amplitude", "builtin:uncd-measured", "--format", "json"]).ok();
    // The texts, since this parser of JSON rounds numbers twice unless told otherwise.
    let rows: Vec<std::collections::BTreeMap<String, Box<serde_json::value::RawValue>>> =
        serde_json::from_str(&json).unwrap();
    let from_json: Vec<f64> = rows.iter().map(|row| row["amplitude_m"].get().parse().unwrap()).collect();
    assert_eq!(crate::support::numbers(&csv, "amplitude_m"), from_json);
}

#[test]
fn the_output_may_be_the_input_and_keeps_its_comments() {
    let bench = Bench::new();
    bench.write("t.csv", format!("# measured by hand\n{SPHERES}"));
    let args = ["asperity", "sphere", "--input", "t.csv", "--output", "t.csv"];
    assert_eq!(bench.run(&args).ok(), "");
    let once = bench.read("t.csv");
    assert!(once.starts_with("# measured by hand\nyoungs_modulus_pa,"), "{once}");
    bench.run(&args).ok();
    assert_eq!(bench.read("t.csv"), once);
    assert_eq!(bench.files(), ["t.csv"]);
    bench.run(&[&args[..], &["--provenance"]].concat()).ok();
    let call = "# truearea 0.1.0: asperity sphere --input t.csv --output t.csv --provenance\n";
    assert_eq!(bench.read("t.csv"), format!("{call}{once}"));
}

#[test]
fn provenance_is_the_same_in_files_and_pipes_and_off_unless_asked_for() {
    let bench = Bench::new();
    let args = ["amplitude", "builtin:uncd-measured"];
    let plain = bench.run(&args).ok();
    assert!(plain.starts_with("wavelength_m,"), "{plain}");
    bench.run(&[&args[..], &["--output", "t.csv"]].concat()).ok();
    assert_eq!(bench.read("t.csv"), plain);
    let told = bench.run(&[&args[..], &["--provenance"]].concat()).ok();
    let lines =
        "# truearea 0.1.0: amplitude builtin:uncd-measured --provenance\n# spectrum: builtin:uncd-measured\n";
    assert!(told.starts_with(lines) && told.ends_with(&plain), "{told}");
}

#[test]
fn bom_crlf_quotes_and_blank_lines_are_read() {
    let bench = Bench::new();
    let plain = bench.run_with_input(&["asperity", "sphere"], SPHERES).ok();
    let dressed =
        format!("\u{feff}# c\r\n{}\r\n", SPHERES.replace('\n', "\r\n").replace("0.2799", "\"0.2799\""));
    assert_eq!(bench.run_with_input(&["asperity", "sphere"], &dressed).ok(), format!("# c\n{plain}"));
}

#[test]
fn constants_stand_for_columns_that_are_not_there() {
    let bench = Bench::new();
    let input = "radius_m,interference_m\n5.3113e-07,4.43628e-11\n";
    let constants =
        ["--youngs-modulus", "24.7149GPa", "--poisson-ratio", "0.2799", "--yield-strength", "771.57MPa"];
    let args = [&["asperity", "sphere"][..], &constants].concat();
    let by_constants = bench.run_with_input(&args, input).ok();
    let by_columns = bench.run_with_input(&["asperity", "sphere"], SPHERES).ok();
    for name in ["hertz_force_n", "jackson_green_area_m2"] {
        assert_eq!(
            crate::support::column(&by_constants, name)[0],
            crate::support::column(&by_columns, name)[0]
        );
    }
    bench.run_with_input(&args, SPHERES).refused_naming(&["column youngs_modulus_pa ", "--youngs-modulus"]);
    bench.run_with_input(&args[..6], input).refused_naming(&["column yield_strength_pa "]);
}

#[test]
fn bodies_are_taken_by_name_in_every_command_and_the_softer_one_yields() {
    let bench = Bench::new();
    bench.write("in.csv", "radius_m,interference_m\n5.3113e-07,4.43628e-11\n");
    let run = |call: &str, options: &[&str]| {
        bench.run(&call.split(' ').chain(options.iter().copied()).collect::<Vec<_>>())
    };
    let spectrum = "builtin:uncd-measured";
    let both_ways =
        [["--material", "hard copper", "--on", "diamond"], ["--material", "diamond", "--on", "hard copper"]];
    for call in [
        format!("stacked {spectrum} --model elastic-plastic --pressure 10MPa"),
        format!("statistical {spectrum} --model ep-sphere --pressure 10MPa --cutoff 1um"),
        format!("persson {spectrum} --model elastic-plastic --pressure 10MPa"),
        format!("gap {spectrum} --model persson --pressure 10MPa"),
        format!("law {spectrum} --model persson --dialect csv --pressure-range 1MPa:10MPa"),
        format!("bem {spectrum} --shortest 500nm --grid 32 --realisations 1 --pressure 10MPa"),
        "asperity sphere --input in.csv".to_owned(),
    ] {
        // Comments repeat the call.
        let rows = |options: &[&str]| {
            let table = run(&call, options).ok();
            table.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect::<Vec<_>>()
        };
        let soft = rows(&both_ways[0]);
        if call.starts_with("asperity") {
            run(&call, &both_ways[1]).refused_naming(&["--material", "--on"]);
        } else {
            assert_eq!(soft, rows(&both_ways[1]), "{call}");
        }
        assert_ne!(soft, rows(&both_ways[0][..2]), "{call}: the counterface counts");
        let elastic = ["--youngs-modulus", "24.7149GPa", "--poisson-ratio", "0.2799"];
        let hard = ["--indentation-hardness", "3GPa"];
        let replaced = rows(&[&both_ways[0][..2], &elastic, &hard].concat());
        assert_eq!(replaced, rows(&[&elastic[..], &hard].concat()), "{call}: flags replace the table");
        run(&call, &["--material", "steel"]).refused_naming(&["--material", "steel 100Cr6", "steel C45"]);
        run(&call, &["--on", "unobtainium"]).refused_naming(&["--on", "unobtainium", "diamond"]);
    }
}

#[test]
fn whose_hardness_was_used_is_on_the_screen() {
    let bench = Bench::new();
    let bodies = "--material silver --on gold --pressure 50MPa";
    for call in [
        "stacked builtin:uncd-measured --model elastic-plastic",
        "gap builtin:uncd-measured --model persson",
        "bem builtin:uncd-measured --shortest 5um --grid 32 --realisations 1",
    ] {
        let said = bench.run(&format!("{call} {bodies}").split(' ').collect::<Vec<_>>()).stderr;
        crate::support::assert_names(&said, &["the counterface flows", "216 MPa", "251 MPa"]);
    }
    let scene = bench.run(&[
        "report",
        "builtin:uncd-measured",
        "--material",
        "silver",
        "--on",
        "gold",
        "--pressure",
        "50MPa",
    ]);
    crate::support::assert_names(&scene.ok(), &["216 MPa", "hardness of gold"]);
}

#[test]
fn texts_that_a_spreadsheet_would_run_are_quoted_in_csv_alone() {
    let bench = Bench::new();
    let rows = SPHERES
        .replace("youngs_modulus_pa", "=cmd(),youngs_modulus_pa")
        .replace("2.47149e+10", "@A1,2.47149e+10");
    let rows = rows.replace("6.43672E10", "+1,6.43672E10");
    let csv = bench.run_with_input(&["asperity", "sphere"], &rows).ok();
    let first: Vec<&str> = csv.lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(first, ["'=cmd()", "'@A1", "+1"]);
    assert_eq!(bench.run_with_input(&["asperity", "sphere"], &csv).ok(), csv);
    let json = bench.run_with_input(&["asperity", "sphere", "--format", "json"], &rows).ok();
    crate::support::assert_names(&json, &["\"=cmd()\":\"@A1\""]);
}

#[test]
fn a_third_of_the_hardness_stands_for_the_strength_and_that_is_said() {
    let bench = Bench::new();
    // A strength and the hardness of another row, in one table.
    let mixed = SPHERES.replace("yield_strength_pa", "yield_strength_pa,indentation_hardness_pa");
    let third: String = mixed.replace("7.7157e+08,", ",2.31471e9,");
    let lines: Vec<&str> = third.lines().collect();
    let table = [lines[0], lines[1]].join("\n");
    let ran = bench.run_with_input(&["asperity", "sphere"], &table);
    assert_eq!(ran.stderr.lines().count(), 1, "{}", ran.stderr);
    let by_hardness = ran.ok_remarking(&["note: 1 of 1 rows", "S0 = H/3"]);
    let by_strength = bench.run_with_input(&["asperity", "sphere"], SPHERES).ok();
    for name in ["hertz_force_n", "jackson_green_force_n", "jackson_green_area_m2"] {
        let [found, expected] = [&by_hardness, &by_strength]
            .map(|table| crate::support::column(table, name)[0].parse::<f64>().unwrap());
        assert!((found / expected - 1.0).abs() < 1e-14, "{name}");
    }
}

#[test]
fn a_material_that_no_law_takes_is_refused_with_its_line_before_anything_is_written() {
    let bench = Bench::new();
    let row = SPHERES.lines().nth(1).unwrap();
    let rows = format!("{row}\n").repeat(5_000);
    let input =
        format!("{}\n{rows}{}\n", SPHERES.lines().next().unwrap(), row.replace("2.47149e+10", "1e31"));
    bench
        .run_with_input(&["asperity", "sphere", "--output", "out.csv"], &input)
        .refused_naming(&["line 5002, column youngs_modulus_pa: 1e31 ", "1e-30 to 1e30"]);
    assert!(bench.files().is_empty());
}
