//! `statistical`: populations from a table and from a spectrum.

use crate::support::{Bench, DIAMOND, assert_names, column, numbers};

const HEADER: &str = "model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,strain_gradient_length_m,radius_m,\
                      density_per_m2,sigma_s_m,separation_m,pressure_pa,area_fraction";
const SPHERES: &str = "ep-sphere,463e9,0.2,1.8e9,,2.43843e-06,1.80165e+11,2.11632e-08,5.02477e-08,,";

fn table(rows: &[&str]) -> String {
    format!("{HEADER}\n{}\n", rows.join("\n"))
}

#[test]
fn the_empty_one_of_separation_and_pressure_is_filled_in_and_the_other_echoed() {
    let bench = Bench::new();
    let by_separation = bench.run_with_input(&["statistical", "--input", "-"], &table(&[SPHERES])).ok();
    assert_eq!(column(&by_separation, "separation_m"), ["5.02477e-08"]);
    let pressure = numbers(&by_separation, "pressure_pa")[0];
    assert!((pressure / 656_544.447_994_837_5 - 1.0).abs() < 1e-12);
    let row = SPHERES.replace("5.02477e-08,,", &format!(",{pressure},"));
    let by_pressure = bench.run_with_input(&["statistical", "--input", "-"], &table(&[&row])).ok();
    assert!((numbers(&by_pressure, "separation_m")[0] - 5.02477e-8).abs() < 1e-10 * 2.11632e-8);
    assert_eq!(column(&by_pressure, "pressure_pa"), [pressure.to_string()]);
    let areas = [&by_separation, &by_pressure].map(|table| numbers(table, "area_fraction")[0]);
    assert!((areas[0] / areas[1] - 1.0).abs() < 1e-10);
}

#[test]
fn a_filled_table_is_recomputed_from_the_column_that_is_named() {
    let bench = Bench::new();
    let filled = SPHERES.replace("5.02477e-08,,", "5.02477e-08,1e5,0.5");
    let ran = |given: &str| {
        let args = ["statistical", "--input", "-", "--given", given, "--format", "csv"];
        bench.run_with_input(&args, &table(&[&filled])).ok()
    };
    assert!((numbers(&ran("separation"), "pressure_pa")[0] / 656_544.447_994_837_5 - 1.0).abs() < 1e-12);
    let by_pressure = ran("pressure");
    assert_eq!(column(&by_pressure, "pressure_pa"), ["1e5"]);
    assert!(numbers(&by_pressure, "separation_m")[0] > 5.02477e-8);
}

#[test]
fn details_hold_error_evaluations_and_logarithms() {
    let bench = Bench::new();
    let far = SPHERES.replace("5.02477e-08", "1.2e-6");
    let out =
        bench.run_with_input(&["statistical", "--input", "-", "--details"], &table(&[SPHERES, &far])).ok();
    let details = "error_estimate,evaluations,out_of_range_load_share,ln_pressure_pa,ln_area_fraction,flattened_share,\
         contacts_per_m2,plasticity_index";
    assert!(out.lines().next().unwrap().ends_with(&format!("area_fraction,{details}")));
    let (pressures, logs) = (numbers(&out, "pressure_pa"), numbers(&out, "ln_pressure_pa"));
    assert!((pressures[0].ln() - logs[0]).abs() < 1e-13);
    // Beyond the smallest double, where only the logarithm is left.
    assert_eq!(pressures[1], 0.0);
    assert!(logs[1] < -1000.0);
    let loose = ["statistical", "--input", "-", "--details", "--tolerance", "1e-4"];
    let loose = bench.run_with_input(&loose, &table(&[SPHERES])).ok();
    assert!(numbers(&loose, "evaluations")[0] < numbers(&out, "evaluations")[0]);
}

#[test]
fn elastic_models_need_no_strength_and_an_absent_column_counts_as_empty() {
    let bench = Bench::new();
    let input = "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,pressure_pa\n\
                 hertz,463e9,0.2,3.7e-5,1.07e9,4.29e-8,511\nelastic-sine,463e9,0.2,3.7e-5,1.07e9,4.29e-8,511\n";
    let out = bench.run_with_input(&["statistical", "--input", "-"], input).ok();
    assert!(out.starts_with(
        "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,pressure_pa,separation_m,"
    ));
    assert_eq!(numbers(&out, "area_fraction").len(), 2);
    let bem = bench.run_with_input(&["statistical", "--input", "-", "--interference-law", "bem"], input).ok();
    assert_eq!(numbers(&bem, "separation_m")[0], numbers(&out, "separation_m")[0]);
    assert_ne!(numbers(&bem, "separation_m")[1], numbers(&out, "separation_m")[1]);
}

#[test]
fn a_pressure_beyond_complete_contact_is_an_answer() {
    let bench = Bench::new();
    let row = "ep-sine,1.03947e+12,0.3348,5.14497e+09,,5.44878e-07,8.96886e+11,1.41043e-08,,1e13,";
    let ran = bench.run_with_input(&["statistical", "--input", "-"], &table(&[row]));
    let out = ran.ok_remarking(&["line 2: 10000000000000 Pa"]);
    assert_eq!((column(&out, "separation_m"), column(&out, "area_fraction")), (vec![""], vec!["1"]));
}

#[test]
fn rows_take_their_hardness_from_a_column_or_an_option() {
    let bench = Bench::new();
    let table = |column: &str, cell: &str| {
        format!(
            "model,youngs_modulus_pa,poisson_ratio,{column}radius_m,density_per_m2,sigma_s_m\n\
             ep-sphere,463e9,0.2,{cell}1e-6,1e11,2e-8\n"
        )
    };
    let area = |input: String, more: &[&str]| {
        let args = [&["statistical", "--input", "-"][..], more].concat();
        let ran = bench.run_with_input(&args, &input);
        assert_eq!(ran.stderr.contains("S0 = H/3"), !more.contains(&"--yield-strength"), "{}", ran.stderr);
        column(&ran.ok(), "area_fraction")[0].to_owned()
    };
    let own = area(table("", ""), &["--yield-strength", "1.8GPa", "--pressure", "1e-3H"]);
    assert_eq!(area(table("", ""), &["--indentation-hardness", "5.4GPa", "--pressure", "1e-3H"]), own);
    assert_eq!(area(table("indentation_hardness_pa,", "5.4e9,"), &["--pressure", "5.4MPa"]), own);
}

#[test]
fn a_spectrum_gives_a_row_per_cutoff_and_blocks_in_the_order_given() {
    let bench = Bench::new();
    let mut args = vec!["statistical", "builtin:uncd-measured", "--model", "ep-sphere"];
    args.extend(DIAMOND);
    args.extend(["--pressure", "1e-3 H", "--pressure", "1MPa", "--separation", "-2nm"]);
    let ran = bench.run(&args);
    let out = ran.ok_remarking(&["note: ", "longest wavelength"]);
    assert_eq!(
        out.lines().next().unwrap(),
        "wavelength_m,radius_m,density_per_m2,sigma_s_m,separation_m,pressure_pa,area_fraction"
    );
    assert_eq!(out.lines().nth(1).unwrap(), "0.000149392,,,,,,");
    let (separations, pressures) = (column(&out, "separation_m"), column(&out, "pressure_pa"));
    assert_eq!(separations.len(), 3 * 46);
    assert_eq!((pressures[1], pressures[47]), ("5400000", "1000000"));
    assert_eq!(separations[2 * 46 + 1], "-2e-9");
    let moments = bench.run(&["moments", "builtin:uncd-measured"]).ok();
    assert_eq!(column(&moments, "sigma_s_m")[1..], column(&out, "sigma_s_m")[1..46]);
}

#[test]
fn a_table_of_many_blocks_is_read_and_written_in_its_order() {
    let bench = Bench::new();
    // Rows of three blocks, each told from the others, the last one beyond complete contact.
    let row = |at: usize| {
        format!(
            "ep-sine,1.03947e+12,0.3348,5.14497e+09,,5.44878e-07,8.96886e+11,1.41043e-08,,{},{at}",
            1000 + at
        )
    };
    let mut rows: Vec<String> = (0..10_000).map(row).collect();
    rows[9_999] = rows[9_999].replace(",10999,", ",1e13,");
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let input = format!("# made up\n{}# at its end\n", table(&rows));
    bench.write("in.csv", &input);
    let ran = bench.run(&["statistical", "--input", "in.csv", "--output", "out.csv", "--provenance"]);
    ran.ok_remarking(&["note: in.csv, line 10002: 10000000000000 Pa"]);
    let out = bench.read("out.csv");
    let comments = "# truearea 0.1.0: statistical --input in.csv --output out.csv --provenance\n# made up\n# at its end\n";
    assert!(out.starts_with(&format!("{comments}{HEADER}\n")), "{}", &out[..300]);
    assert_eq!(out.lines().filter(|line| line.starts_with("model")).count(), 1);
    let pressures = column(&out, "pressure_pa");
    assert!(pressures[..9_999].iter().enumerate().all(|(at, pressure)| *pressure == (1000 + at).to_string()));
    // A row is what it is by itself, and JSON holds the same.
    let alone = bench.run_with_input(&["statistical", "--input", "-"], &table(&[rows[5_000]])).ok();
    assert_eq!(out.lines().nth(3 + 1 + 5_000), alone.lines().nth(1));
    let json = bench.run(&["statistical", "--input", "in.csv", "--format", "json"]).ok();
    bench.write("in.json", &json);
    let again = bench.run(&["statistical", "--input", "in.json", "--given", "pressure"]).ok();
    assert_eq!(again.lines().collect::<Vec<_>>(), out.lines().skip(3).collect::<Vec<_>>());
}

#[test]
fn errors_far_down_a_table_are_found_before_anything_is_written() {
    let bench = Bench::new();
    let mut rows = vec![SPHERES; 9_000];
    let [strange, short] = [SPHERES.replace("463e9", "x"), SPHERES.replace("2.11632e-08", "-1")];
    rows[5_000] = &strange;
    rows.extend([short.as_str(); 12]);
    let ran = bench.run_with_input(&["statistical", "--input", "-"], &table(&rows));
    let message = ran.refused();
    assert!(
        message.starts_with("error: standard input, line 5002, column youngs_modulus_pa: \"x\" "),
        "{message}"
    );
    assert_names(&message, &["standard input, line 9002, column sigma_s_m: -1 "]);
    assert!(message.lines().last().unwrap().contains(" 3 "), "{message}");
}

#[test]
fn a_range_of_pressures_is_as_many_loads() {
    let bench = Bench::new();
    let run = |command: &[&str], pressed: &[&str]| {
        bench.run(&[command, &["builtin:uncd-measured"], pressed, &DIAMOND].concat()).ok()
    };
    let one_by_one = ["--pressure", "1kPa", "--pressure", "1MPa", "--pressure", "1GPa"];
    for command in [&["statistical", "--model", "ep-sphere"][..], &["stacked", "--model", "elastic-plastic"]]
    {
        let (range, expected) = (run(command, &["--pressures", "1kPa:1GPa:3"]), run(command, &one_by_one));
        let areas = [&range, &expected].map(|table| {
            column(table, "area_fraction")
                .into_iter()
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect::<Vec<f64>>()
        });
        assert_eq!(areas[0].len(), 3 * 46);
        for (found, expected) in areas[0].iter().zip(&areas[1]) {
            assert!(found.is_nan() && expected.is_nan() || (found / expected - 1.0).abs() < 1e-12);
        }
    }
    // Blocks of more rows than are in memory together, behind a single load.
    let statistical = ["statistical", "--model", "hertz"];
    let many = run(&statistical, &["--pressures", "1kPa:1GPa:1000", "--pressure", "1e-3H"]);
    let pressures = column(&many, "pressure_pa");
    assert_eq!((pressures.len(), pressures[1], pressures[47]), (1001 * 46, "5400000", "1000"));
    assert_eq!(pressures.last(), Some(&"1000000000"));
    let alone = run(&statistical, &["--pressure", "1GPa"]);
    assert_eq!(
        many.lines().skip(1 + 1000 * 46).collect::<Vec<_>>(),
        alone.lines().skip(1).collect::<Vec<_>>()
    );
}

#[test]
fn many_cutoffs_at_one_load_are_the_same_whatever_is_computed_together() {
    let bench = Bench::new();
    let dense = ["statistical", "builtin:uncd-measured", "--model", "hertz", "--scales-per-decade", "4000"];
    let run = |pressed: &[&str]| bench.run(&[&dense, pressed, &DIAMOND].concat()).ok();
    let (two, one) = (run(&["--pressure", "1MPa", "--pressure", "2MPa"]), run(&["--pressure", "2MPa"]));
    let rows = one.lines().count() - 1;
    assert!(rows > 1 << 14);
    assert_eq!(two.lines().skip(1 + rows).collect::<Vec<_>>(), one.lines().skip(1).collect::<Vec<_>>());
    let areas = numbers(
        &one.lines().filter(|line| !line.contains(",,")).collect::<Vec<_>>().join("\n"),
        "area_fraction",
    );
    assert_eq!(areas.len(), rows - 1);
}

/// A row of `moments` without asperities, and one with them.
const MOMENTS: &str =
    "wavelength_m,radius_m,density_per_m2,sigma_s_m\n1e-4,,,\n1e-5,2.43843e-06,1.80165e+11,2.11632e-08\n";

const CONSTANTS: [&str; 10] = [
    "--model",
    "ep-sphere",
    "--pressure",
    "1MPa",
    "--youngs-modulus",
    "463GPa",
    "--poisson-ratio",
    "0.2",
    "--yield-strength",
    "1.8GPa",
];

fn with_constants(bench: &Bench, table: &str) -> crate::support::Ran {
    bench.run_with_input(&[&["statistical", "--input", "-"][..], &CONSTANTS].concat(), table)
}

#[test]
fn moments_chain_into_statistical_with_the_constants_given_once() {
    let bench = Bench::new();
    let moments = bench.run(&["moments", "builtin:uncd-measured"]).ok();
    let ran = with_constants(&bench, &moments);
    let chained = ran.ok_remarking(&["note: 1 of 46 rows"]);
    let mut args = vec!["statistical", "builtin:uncd-measured"];
    args.extend(CONSTANTS);
    let at_once = bench.run(&args).ok();
    for name in ["separation_m", "pressure_pa", "area_fraction"] {
        let (found, expected) = (column(&chained, name), column(&at_once, name));
        assert_eq!((found.len(), found[0]), (46, ""), "{name}");
        for (found, expected) in found[1..].iter().zip(&expected[1..]) {
            let (found, expected): (f64, f64) = (found.parse().unwrap(), expected.parse().unwrap());
            assert!((found / expected - 1.0).abs() < 1e-9, "{name}: {found} {expected}");
        }
    }
}

#[test]
fn constants_and_columns_give_the_same_digits() {
    let bench = Bench::new();
    let row = "ep-sphere,463e9,0.2,1.8e9,,2.43843e-06,1.80165e+11,2.11632e-08,,1e6,";
    let by_columns = bench.run_with_input(&["statistical", "--input", "-"], &table(&[row])).ok();
    let by_constants = with_constants(&bench, MOMENTS).ok();
    for name in ["separation_m", "area_fraction"] {
        assert_eq!(column(&by_columns, name)[0], column(&by_constants, name)[1], "{name}");
    }
    let in_hardnesses: Vec<&str> =
        CONSTANTS.iter().map(|arg| if *arg == "1MPa" { "1e-3H" } else { arg }).collect();
    let args = [&["statistical", "--input", "-"][..], &in_hardnesses].concat();
    assert_eq!(column(&bench.run_with_input(&args, MOMENTS).ok(), "pressure_pa"), ["", "5400000"]);
    bench.run_with_input(&args[..11], MOMENTS).refused_naming(&["--pressure 1e-3H", "--yield-strength"]);
}

const SUMMITS_HEADER: &str =
    "model,youngs_modulus_pa,poisson_ratio,m0_m2,m2,m4_per_m2,separation_m,pressure_pa";

/// A row of tests/reference/bgt.csv, alpha = 10 and d = 2 sqrt(m0), in metres and pascals: E* = 1e11 Pa.
const SUMMITS: &str = "bgt,1e11,0,1e-16,0.04,1.6e14,2e-8,";

#[test]
fn rows_of_bgt_take_moments_and_are_computed_either_way() {
    let bench = Bench::new();
    let table = format!("{SUMMITS_HEADER}\n{SUMMITS}\n");
    let there = bench.run_with_input(&["statistical", "--input", "-", "--details"], &table).ok();
    let (area, pressure) = (numbers(&there, "area_fraction")[0], numbers(&there, "pressure_pa")[0]);
    assert!((area / 8.2691519084e-3 - 1.0).abs() < 1e-10, "{area}");
    assert!((pressure / (6.3176910226e-3 * 1e11 * 0.2) - 1.0).abs() < 1e-10, "{pressure}");
    assert!(numbers(&there, "error_estimate")[0] < 1e-11 && numbers(&there, "evaluations")[0] < 200.0);
    let back = table.replace("2e-8,", &format!(",{pressure}"));
    let back = bench.run_with_input(&["statistical", "--input", "-"], &back).ok();
    assert!((numbers(&back, "separation_m")[0] / 2e-8 - 1.0).abs() < 1e-12);
}

#[test]
fn rows_without_summits_stay_empty_and_are_noted_once() {
    let bench = Bench::new();
    // alpha is m4/1.6e13; the last row but one has 1.5, the last one no moments at all.
    let with_m4 = |m4: &str| SUMMITS.replace("1.6e14", m4);
    let rows = ["1.6e14", "2.3e13", "1.7e13", "2.4e13"].map(with_m4).join("\n") + "\nbgt,1e11,0,,,,2e-8,";
    let ran = bench.run_with_input(&["statistical", "--input", "-"], &format!("{SUMMITS_HEADER}\n{rows}\n"));
    assert_eq!(ran.remarks(&["alpha"]).len(), 1, "{}", ran.stderr);
    assert_eq!(
        ran.remarks(&["note: 2 of 5 rows: alpha = ", "1.062 to 1.437", "1.5"]).len(),
        1,
        "{}",
        ran.stderr
    );
    let out = ran.ok_remarking(&["note: 1 of 5 rows"]);
    let areas = column(&out, "area_fraction");
    assert!(areas[0].starts_with("0.008269") && areas[3].starts_with("0.010"), "{areas:?}");
    assert_eq!([areas[1], areas[2], areas[4]], [""; 3]);
    // The given separation stays where the row was asked for something.
    assert_eq!(column(&out, "separation_m")[1], "2e-8");
}

/// A polishing pad: E* 1 GPa, R 5 um, eta 2e8 per m^2, sigma 0.3 um. Exponential summits have one real pressure, E* sqrt(sigma/(pi R)).
#[test]
fn exponential_summits_contacts_and_plasticity_index_are_those_of_the_paper() {
    let bench = Bench::new();
    let rows = "radius_m,density_per_m2,sigma_s_m,pressure_pa,indentation_hardness_pa\n5e-6,2e8,0.3e-6,7e3,7e9\n5e-6,2e8,0.3e-6,96e3,0.2e9\n";
    let words = "statistical --input - --model hertz --youngs-modulus 1GPa --poisson-ratio 0 --details --summit-heights";
    let ran = |heights: &str| {
        let words = format!("{words} {heights}");
        bench.run_with_input(&words.split(' ').collect::<Vec<_>>(), rows).ok()
    };
    let found = ran("exponential");
    let [areas, separations, contacts, index] =
        ["area_fraction", "separation_m", "contacts_per_m2", "plasticity_index"]
            .map(|name| numbers(&found, name));
    for (area, pressure_pa) in areas.iter().zip([7e3, 96e3]) {
        assert!((pressure_pa / area / 138.2e6 - 1.0).abs() < 1e-4);
    }
    for (contacts, separation_m) in contacts.iter().zip(&separations) {
        assert!((contacts / (2e8 * (-separation_m / 0.3e-6).exp()) - 1.0).abs() < 1e-12);
    }
    assert!((index[0] - 0.035).abs() < 1e-4 && (index[1] - 1.22).abs() < 0.01, "{index:?}");
    let gaussian = numbers(&ran("gaussian"), "contacts_per_m2");
    assert!(gaussian.iter().zip(&contacts).all(|(gaussian, other)| gaussian != other && *gaussian < 2e8));
    let sphere = table(&[SPHERES]);
    let words = ["statistical", "--input", "-", "--summit-heights", "exponential"];
    bench.run_with_input(&words, &sphere).refused_naming(&["--summit-heights"]);
}

/// Contacts and plasticity index over cutoffs follow from the other columns of the row.
#[test]
fn over_cutoffs_details_count_contacts() {
    let bench = Bench::new();
    let words = "statistical builtin:uncd-measured --model hertz --summit-heights exponential --pressure 1MPa --details";
    let args: Vec<&str> = words.split(' ').chain(DIAMOND).collect();
    let found = bench.run(&args).ok();
    let names =
        ["density_per_m2", "sigma_s_m", "radius_m", "separation_m", "contacts_per_m2", "plasticity_index"];
    let last = names.map(|name| column(&found, name).last().unwrap().parse::<f64>().unwrap());
    let [density, sigma_m, radius_m, separation_m, contacts, index] = last;
    assert!((contacts / (density * (-separation_m / sigma_m).exp()) - 1.0).abs() < 1e-12);
    assert!((index / (463e9 / 0.96 / 5.4e9 * (sigma_m / radius_m).sqrt()) - 1.0).abs() < 1e-12);
    let bgt = words.replace("hertz --summit-heights exponential", "bgt");
    let found = bench.run(&bgt.split(' ').chain(DIAMOND).collect::<Vec<_>>()).ok();
    assert!(column(&found, "contacts_per_m2").iter().all(|cell| cell.is_empty()));
}

#[test]
fn over_cutoffs_bgt_has_the_states_of_the_moments() {
    let bench = Bench::new();
    let args = ["statistical", "builtin:uncd-measured", "--model", "bgt", "--pressure", "1MPa"];
    let ran = bench.run(&[&args, &DIAMOND[..4]].concat());
    let over_cutoffs = ran.ok_remarking(&["note: 6 of 45 rows: alpha = ", "1.048 to 1.467", "1.5"]);
    let moments = bench.run(&["moments", "builtin:uncd-measured"]).ok();
    let args = ["statistical", "--input", "-", "--model", "bgt", "--pressure", "1MPa"];
    let row_by_row = bench.run_with_input(&[&args, &DIAMOND[..4]].concat(), &moments).ok();
    for name in ["separation_m", "pressure_pa", "area_fraction"] {
        let [of_cutoffs, of_rows] = [&over_cutoffs, &row_by_row].map(|table| column(table, name));
        // A row that holds nothing to press keeps what it was asked at.
        let differing = of_cutoffs.iter().zip(&of_rows).filter(|(a, b)| a != b && !a.is_empty()).count();
        assert_eq!((of_cutoffs.len(), differing), (46, 0), "{name}");
    }
    let alphas = column(&moments, "nayak_alpha");
    let areas = column(&over_cutoffs, "area_fraction");
    for (alpha, area) in alphas.iter().zip(areas).skip(1) {
        assert_eq!(area.is_empty(), alpha.parse::<f64>().unwrap() < 1.5, "{alpha}: {area}");
    }
}

#[test]
fn elastic_areas_of_a_scene_have_the_linear_laws_beside_them() {
    let bench = Bench::new();
    bench.write(
        "scene.toml",
        "title = \"t\"\n[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"463 GPa\"\n\
         poisson_ratio = 0.2\nyield_strength = \"1.8 GPa\"\n[loads]\npressures = [\"1 MPa\"]\n\
         [[curve]]\nmodel = \"bgt\"\n[[curve]]\nmodel = \"ep-sphere\"\n",
    );
    bench.run(&["run", "scene.toml"]).ok();
    // kappa p/(E* h'), E* = 482.29 GPa and h' = sqrt(2 m2) = 0.55028 at the last cutoff.
    let report = bench.read("scene-results/report.html");
    assert!(report.matches("linear laws</text>").count() >= 1);
    assert!(!bench.read("scene-results/bgt.csv").contains("linear"));
    assert!(bench.read("scene-results/area-fraction.csv").contains(",linear laws at 1 MPa low,"));
}
