//! `law --quantity heat` and `current`: conductance against pressure, and heat between two blocks in CalculiX.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::process::Command;

use crate::support::{Bench, Ran, column, numbers};

const UNCD: &str = "builtin:uncd-reconstructed";
const DIAMOND: [&str; 4] = ["--youngs-modulus", "463GPa", "--poisson-ratio", "0.2"];
const CONDUCTORS: [&str; 4] =
    ["--thermal-conductivity", "20 W/(m K)", "--counterface-thermal-conductivity", "60 W/(m K)"];
const RESISTORS: [&str; 4] = ["--resistivity", "2e-8 ohm m", "--counterface-resistivity", "6e-8 ohm m"];
const AIR: [&str; 4] = ["--gas-conductivity", "0.026 W/(m K)", "--gas-parameter", "0.4um"];

fn law(options: &[&[&str]]) -> Ran {
    let call = ["law", UNCD, "--pressure-range", "10kPa:10MPa"];
    // A correlation has no use for elastic constants.
    let is_correlation = options.concat().iter().any(|word| word.ends_with("yovanovich"));
    let body = if is_correlation { &DIAMOND[4..] } else { &DIAMOND[..] };
    Bench::new().run(&[&call[..], body, &options.concat()].concat())
}

/// A table in CSV without its comments.
fn table(options: &[&[&str]]) -> String {
    let text = law(&[&["--dialect", "csv"], &options.concat()[..]]).ok();
    text.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect()
}

/// Lines of numbers of a card, in the order of the columns.
fn card_rows(text: &str) -> Vec<[f64; 2]> {
    let lines = text.lines().filter(|line| !line.starts_with('*'));
    let row = |line: &str| {
        let (conductance, pressure) = line.split_once(", ").unwrap();
        [conductance, pressure].map(|cell| cell.parse().unwrap())
    };
    lines.map(row).collect()
}

fn state(model: &str, pressure_pa: f64, name: &str) -> f64 {
    let pressure = format!("{pressure_pa:e}Pa");
    let call = ["gap", UNCD, "--model", model, "--pressure", &pressure];
    numbers(&Bench::new().run(&[&call[..], &DIAMOND].concat()).ok(), name)[0]
}

#[test]
fn heat_and_current_follow_from_the_stiffness_by_barbers_analogy() {
    let modulus_pa = 463e9 / (1.0 - 0.04);
    for model in ["persson", "hertz"] {
        let heat = table(&[&["--model", model, "--quantity", "heat"], &CONDUCTORS]);
        let [pressures, found] = ["pressure_Pa", "conductance_W_per_m2_K"].map(|name| numbers(&heat, name));
        assert_eq!(numbers(&heat, "gas_W_per_m2_K"), vec![0.0; pressures.len()]);
        assert_eq!((pressures[0], found[0]), (0.0, 0.0));
        let current = table(&[&["--model", model, "--quantity", "current"], &RESISTORS]);
        assert_eq!(current.lines().next(), Some("pressure_Pa,conductance_S_per_m2"));
        let current = numbers(&current, "conductance_S_per_m2");
        for at in [1, pressures.len() / 2, pressures.len() - 1] {
            let stiffness = state(model, pressures[at], "stiffness_pa_per_m");
            // k_s is 30 W/(m K), and 2/(rho1 + rho2) is 2.5e7 S/m.
            assert!((found[at] / (30.0 * stiffness / modulus_pa) - 1.0).abs() < 1e-9, "{model}");
            assert!((current[at] / (2.5e7 * stiffness / modulus_pa) - 1.0).abs() < 1e-9, "{model}");
        }
    }
}

#[test]
fn lines_are_within_the_error_of_the_conductance() {
    for (error, within) in [("0.01", 0.01), ("1e-4", 1e-4)] {
        let text = law(&[
            &[
                "--model",
                "hertz",
                "--quantity",
                "heat",
                "--error",
                error,
                "--dialect",
                "calculix",
                "--units",
                "N-mm",
            ],
            &CONDUCTORS,
        ])
        .ok();
        let rows = card_rows(&text);
        assert!(text.contains("*GAP CONDUCTANCE\n0., 0.\n") && rows.len() <= 200, "{}", rows.len());
        for pair in rows.windows(2).skip(1) {
            let ([low, from], [high, to]) = (pair[0], pair[1]);
            let middle = 0.5 * (from + to);
            let stiffness = state("hertz", 1e6 * middle, "stiffness_pa_per_m");
            let exact = 1e-3 * 30.0 * stiffness / (463e9 / 0.96);
            assert!((0.5 * (low + high) / exact - 1.0).abs() <= within, "{middle}");
        }
    }
}

#[test]
fn gas_conducts_beside_the_spots_and_alone_without_pressure() {
    let options = ["--model", "persson", "--quantity", "heat"];
    let (vacuum, air) = (table(&[&options, &CONDUCTORS]), table(&[&options, &CONDUCTORS, &AIR]));
    let [pressures, total, contact, gas] =
        ["pressure_Pa", "conductance_W_per_m2_K", "contact_W_per_m2_K", "gas_W_per_m2_K"]
            .map(|name| numbers(&air, name));
    assert_eq!((pressures[0], contact[0], gas[0], total[0]), (0.0, 0.0, gas[1], gas[1]));
    assert_eq!(contact[1], numbers(&vacuum, "conductance_W_per_m2_K")[1]);
    let mean_gap_m = state("persson", pressures[1], "mean_gap_m");
    // Gaps of some tens of nanometres are short beside M = 400 nm.
    let simple = 0.026 / (mean_gap_m + 0.4e-6);
    assert!(gas[1] > simple && gas[1] < 1.01 * simple, "{} {simple}", gas[1]);
    for at in 0..total.len() {
        assert!((total[at] / (contact[at] + gas[at]) - 1.0).abs() < 1e-15);
    }
    // Gas parameter of air: 2 (1.14/0.86) (2.8/(0.71 2.4)) 64 nm, and twice that at half of the pressure; 26.2 mW/(m K) at 300 K.
    let half = ["--gas", "air", "--gas-temperature", "300K", "--gas-pressure", "50662.5Pa"];
    let parameter =
        format!("{}nm", 2.0 * (2.0 * 1.14 / 0.86 * (2.8 / (0.71 * 2.4)) * 64.0) * (300.0 / 288.15));
    let direct = ["--gas-conductivity", "0.0262 W/(m K)", "--gas-parameter", &parameter];
    let gas = |given: &[&str]| numbers(&table(&[&options, &CONDUCTORS, given]), "gas_W_per_m2_K")[0];
    assert!((gas(&half) / gas(&direct) - 1.0).abs() < 1e-12);
}

#[test]
fn correlations_take_the_slope_down_to_a_cutoff() {
    let hard = ["--indentation-hardness", "10GPa"];
    let moments = Bench::new().run(&["moments", UNCD]).ok();
    let wavelengths = numbers(&moments, "wavelength_m");
    let moment = |name: &str, at: usize| column(&moments, name)[at].parse::<f64>().unwrap();
    for (model, factor, power) in [("yovanovich", 1.25, 0.95), ("cooper-mikic-yovanovich", 1.45, 0.985)] {
        for at in [wavelengths.len() - 1, wavelengths.len() / 2] {
            let cutoff = format!("{:e}m", wavelengths[at]);
            let cutoff = if at == wavelengths.len() - 1 { vec![] } else { vec!["--cutoff", &cutoff] };
            let options =
                [&["--model", model, "--quantity", "heat"], &hard[..], &CONDUCTORS, &cutoff].concat();
            let heat = table(&[&options]);
            let slope = (2.0 / PI * moment("m2", at)).sqrt();
            let [pressures, found] =
                ["pressure_Pa", "conductance_W_per_m2_K"].map(|name| numbers(&heat, name));
            for row in [1, pressures.len() - 1] {
                let exact =
                    factor * 30.0 * slope / moment("m0_m2", at).sqrt() * (pressures[row] / 10e9).powf(power);
                assert!((found[row] / exact - 1.0).abs() < 1e-9, "{model}: {} {exact}", found[row]);
            }
        }
    }
    // With 2/(rho1 + rho2) in place of k_s for currents.
    let both = |quantity: &str, bodies: &[&str], name: &str| {
        numbers(&table(&[&["--model", "yovanovich", "--quantity", quantity], &hard, bodies]), name)[1]
    };
    let heat = both("heat", &CONDUCTORS, "conductance_W_per_m2_K");
    let current = both("current", &RESISTORS, "conductance_S_per_m2");
    assert!((current / heat / (2.5e7 / 30.0) - 1.0).abs() < 1e-12);
    let text =
        law(&[&["--model", "yovanovich", "--quantity", "heat", "--dialect", "abaqus"], &hard, &CONDUCTORS]);
    crate::support::assert_names(&text.ok(), &["5.65 nm", "--cutoff", "p/H", "Yovanovich"]);
}

#[test]
fn properties_come_from_the_table_of_materials_unless_they_are_given() {
    let bodies = ["--material", "annealed copper", "--on", "hard copper"];
    let run = |quantity: &str, given: &[&str]| {
        let call =
            ["law", UNCD, "--pressure-range", "10kPa:10MPa", "--model", "persson", "--dialect", "abaqus"];
        Bench::new().run(&[&call[..], &["--quantity", quantity], &bodies, given].concat()).ok()
    };
    assert!(run("heat", &[]).contains("k_s = 401 W/(m K)"));
    assert!(run("current", &[]).contains("*GAP ELECTRICAL CONDUCTANCE, PRESSURE\n0., 0.\n"));
    // 2 x 401 x 100/501.
    assert!(run("heat", &["--thermal-conductivity", "100 W/(m K)"]).contains("k_s = 160 W/(m K)"));
    assert!(run("pressure", &[]).contains("TABULAR"));
}

#[test]
fn a_table_may_have_more_rows_than_calculix_has_room_for() {
    let fine = ["--quantity", "heat", "--error", "1e-5", "--model", "hertz", "--dialect"];
    law(&[&fine, &["calculix"], &CONDUCTORS]).refused_naming(&["200", "rows"]);
    assert!(card_rows(&law(&[&fine, &["abaqus"], &CONDUCTORS]).ok()).len() > 200);
}

#[test]
fn a_yielding_model_and_a_fit_beyond_its_range_are_stated() {
    let hard = ["--indentation-hardness", "10GPa"];
    let text = |model: &str| {
        law(&[&["--model", model, "--quantity", "heat", "--dialect", "abaqus"], &hard, &CONDUCTORS]).ok()
    };
    assert!(text("ep-sphere").contains("model yields") && !text("persson").contains("model yields"));
    assert!(!text("yovanovich").contains("beyond:") && text("yovanovich").contains("was fitted"));
}

/// Two blocks of 1 mm with a rough surface between them, whose mechanical law and conductance are those of two commands.
#[test]
#[ignore = "needs CalculiX"]
fn calculix_conducts_heat_as_the_table_says() {
    let bench = Bench::new();
    // C1D of a surface with an rms height of 6 um: u0 = 2.84 um and p00 = 0.084 E*.
    let row = |q: f64| format!("{:e},{:e}\n", TAU / q, PI * PI * 0.000_023_041_816_986_325_86 * q.powf(-2.6));
    bench.write("psd.csv", format!("lambda_m,C1D_m3\n{}{}", row(1e4), row(1e6)));
    let common = [
        "law",
        "psd.csv",
        "--model",
        "persson",
        "--band",
        "1d",
        "--dialect",
        "calculix",
        "--units",
        "N-mm",
        "--pressure-range",
        "500kPa:60MPa",
        "--youngs-modulus",
        "1GPa",
        "--poisson-ratio",
        "0",
    ];
    let run = |options: &[&str]| bench.run(&[&common[..], options].concat()).ok();
    // So little that the temperatures on both sides of the interface differ in their printed digits.
    let conductors =
        ["--thermal-conductivity", "5 W/(m K)", "--counterface-thermal-conductivity", "5 W/(m K)"];
    let heat = run(&[&["--quantity", "heat"], &conductors[..], &AIR].concat());
    let table = card_rows(&heat);
    let interaction = run(&["--form", "exponential"]) + &heat;
    // The clearance at first touch is c0 = ln(100) u0 = 13.1 um.
    let (clearance_mm, pressed_mm) = (0.011, 0.0105);
    let mut nodes = String::new();
    let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
    let places = [-1.0, 0.0, clearance_mm, clearance_mm + 1.0].into_iter();
    let places = places.flat_map(|z| corners.iter().map(move |(x, y)| (x, y, z)));
    for (at, (x, y, z)) in places.enumerate() {
        writeln!(nodes, "{}, {x}., {y}., {z:.12}", at + 1).unwrap();
    }
    let deck = format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=BLOCKS\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         2, 9, 10, 11, 12, 13, 14, 15, 16\n*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.\n*CONDUCTIVITY\n50.\n\
         *SOLID SECTION, ELSET=BLOCKS, MATERIAL=STEEL\n*NSET, NSET=BOTTOM\n1, 2, 3, 4\n*NSET, NSET=TOP\n13, 14, 15, 16\n\
         *SURFACE, NAME=MASTER, TYPE=ELEMENT\n1, S2\n*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n2, S1\n\
         {interaction}*CONTACT PAIR, INTERACTION=ROUGH, TYPE=NODE TO SURFACE\nSLAVE, MASTER\n\
         *INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 0.\n*BOUNDARY\nALL, 1, 2\nBOTTOM, 3, 3\n*STEP, NLGEOM, INC=1000\n\
         *COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE\n0.1, 1., 1.E-6, 0.1\n*CONTROLS, PARAMETERS=FIELD\n1.E-9, 1.E-9\n\
         *BOUNDARY\nBOTTOM, 11, 11, 0.\nTOP, 11, 11, 100.\nTOP, 3, 3, {:.12}\n*NODE PRINT, NSET=ALL\nNT\n\
         *NODE PRINT, NSET=BOTTOM, TOTALS=ONLY\nRF\n*END STEP\n",
        -pressed_mm
    );
    bench.write("heat.inp", deck);
    let output = Command::new("ccx").arg("heat").current_dir(bench.path("")).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("Job finished"), "{said}");
    let results = std::fs::read_to_string(bench.path("heat.dat")).unwrap();
    let cells =
        |line: &str| -> Vec<f64> { line.split_whitespace().filter_map(|cell| cell.parse().ok()).collect() };
    let mut seen = 0;
    for block in results.split("temperatures for").skip(1) {
        let (temperatures, forces) = block.split_once("total force").expect(block);
        let temperatures = temperatures.lines().skip(1).map(cells).filter(|row| row.len() == 2);
        let temperatures: Vec<f64> = temperatures.map(|row| row[1]).collect();
        let force = forces.lines().skip(1).map(cells).find(|row| row.len() == 3).unwrap();
        let pressure_mpa = force[2].abs();
        let flux_mw_per_mm2 = 50.0 * (temperatures[4] - temperatures[0]);
        let conductance = flux_mw_per_mm2 / (temperatures[8] - temperatures[4]);
        let above = table.partition_point(|row| row[1] < pressure_mpa);
        let ([low, from], [high, to]) = (table[above - 1], table[above]);
        let expected = low + (high - low) * (pressure_mpa - from) / (to - from);
        println!("{pressure_mpa} MPa: {conductance} mW/(mm^2 K), table {expected}");
        assert!((conductance / expected - 1.0).abs() < 1e-6, "{pressure_mpa}: {conductance} {expected}");
        seen += 1;
    }
    assert!(seen >= 8, "{results}");
}
