//! Tables in and out: what is echoed, appended, recomputed, refused.

mod support;

use support::Bench;

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
    assert_eq!(support::numbers(&csv, "amplitude_m"), from_json);
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
fn a_bad_table_is_refused_with_line_column_value_and_bound_and_nothing_is_written() {
    let bench = Bench::new();
    let refused = |input: &str| {
        let message = bench.run_with_input(&["asperity", "sphere", "--output", "out.csv"], input).refused();
        assert!(!bench.path("out.csv").exists());
        message
    };
    assert_eq!(
        refused(&SPHERES.replace("0.2799", "0.9").replace("5.3113e-07", "-1").replace("7.7157e+08", "much")),
        "error: standard input, line 2, column poisson_ratio: 0.9 must be greater than -1 and at most 0.5\n       \
         standard input, line 2, column yield_strength_pa: \"much\" is not a number\n"
    );
    assert_eq!(
        refused(&SPHERES.replace("5.3113e-07", "nan")),
        "error: standard input, line 2, column radius_m: nan must be finite and greater than 0\n"
    );
    assert_eq!(
        refused(&SPHERES.replace("7.09842e-08", "")),
        "error: standard input, line 3, column interference_m: the cell is empty; a number is needed\n"
    );
    assert_eq!(
        refused(&SPHERES.replace("radius_m", "r")),
        "error: standard input: column radius_m is missing; the columns are youngs_modulus_pa, poisson_ratio, \
         yield_strength_pa, r, interference_m\n"
    );
    assert_eq!(
        refused(&SPHERES.replace("radius_m", "poisson_ratio")),
        "error: standard input: column \"poisson_ratio\" stands twice; keep one\n"
    );
    assert_eq!(
        refused(&SPHERES.replace(",4.43628e-11", "")),
        "error: standard input, line 2: 4 fields; the header has 5, and every row must have as many\n"
    );
    assert_eq!(refused(""), "error: standard input: no header row; the first line must name the columns\n");
    assert!(refused("[{\"a\":1},3]").starts_with("error: standard input: reading an array of row objects: "));
}

#[test]
fn at_most_ten_bad_cells_are_listed() {
    let bench = Bench::new();
    let rows = "x,0.3,1e9,1e-6,1e-9\n".repeat(13);
    let input = format!("{}\n{rows}", SPHERES.lines().next().unwrap());
    let message = bench.run_with_input(&["asperity", "sphere"], &input).refused();
    assert_eq!(message.lines().count(), 11);
    assert!(message.ends_with("\n       and 3 more\n"), "{message}");
}

#[test]
fn an_output_that_cannot_be_written_is_a_failure_of_the_system() {
    let bench = Bench::new();
    let ran = bench.run(&["amplitude", "builtin:uncd-measured", "--output", "no/such/folder.csv"]);
    assert_eq!(ran.status, 1);
    assert!(ran.stderr.starts_with("error: writing no/such/folder.csv: "), "{}", ran.stderr);
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
        assert_eq!(support::column(&by_constants, name)[0], support::column(&by_columns, name)[0]);
    }
    let message = bench.run_with_input(&args, SPHERES).refused();
    assert!(
        message.contains("column youngs_modulus_pa stands in the table")
            && message.contains("--youngs-modulus"),
        "{message}"
    );
    let message = bench.run_with_input(&args[..6], input).refused();
    assert!(message.contains("column yield_strength_pa is missing"), "{message}");
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
    let note = "note: 1 of 1 rows have a hardness and no yield strength: S0 = H/3 is used\n";
    assert_eq!(ran.stderr, note);
    let by_hardness = ran.ok();
    let by_strength = bench.run_with_input(&["asperity", "sphere"], SPHERES).ok();
    for name in ["hertz_force_n", "jackson_green_force_n", "jackson_green_area_m2"] {
        let [found, expected] =
            [&by_hardness, &by_strength].map(|table| support::column(table, name)[0].parse::<f64>().unwrap());
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
    let ran = bench.run_with_input(&["asperity", "sphere", "--output", "out.csv"], &input);
    assert_eq!(
        ran.refused(),
        "error: standard input, line 5002, column youngs_modulus_pa: 1e31 must be from 1e-30 to 1e30\n"
    );
    assert!(bench.files().is_empty());
}
