//! The columns of tables that go through a command row by row, and of spectra.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use questions::rows::INPUT_COLUMNS;

use crate::support::Bench;

use super::walk::{Folder, Outcome, in_every, split};

/// Commands on a table, with its columns and a row.
const TABLES: &[(&str, &str, &str)] = &[
    (
        "asperity sphere",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m",
        "2e11,0.3,1e8,1e-6,1e-8",
    ),
    (
        "asperity sphere",
        "youngs_modulus_pa,poisson_ratio,indentation_hardness_pa,radius_m,interference_m",
        "2e11,0.3,3e8,1e-6,1e-8",
    ),
    (
        "asperity sinusoid",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,aspect_ratio,pressure_pa",
        "2e11,0.3,1e8,0.01,1e7",
    ),
    (
        "asperity sinusoid-interference",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,wavelength_m,aspect_ratio,interference_m",
        "2e11,0.3,1e8,1e-6,0.01,1e-9",
    ),
    (
        "statistical",
        "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,separation_m",
        "hertz,2e11,0.3,1e-6,1e12,1e-8,1e-8",
    ),
    (
        "statistical",
        "model,youngs_modulus_pa,poisson_ratio,m0_m2,m2,m4_per_m2,pressure_pa",
        "bgt,2e11,0.3,1e-15,1e-3,1e10,1e7",
    ),
    (
        "statistical",
        "model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,density_per_m2,sigma_s_m,pressure_pa",
        "ep-sphere,2e11,0.3,1e8,1e-6,1e12,1e-8,1e7",
    ),
    (
        "statistical --given separation",
        "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,separation_m,pressure_pa",
        "elastic-sine,2e11,0.3,1e-6,1e12,1e-8,1e-8,1e7",
    ),
    (
        "statistical --given pressure --model hertz",
        "youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,separation_m,pressure_pa",
        "2e11,0.3,1e-6,1e12,1e-8,1e-8,1e7",
    ),
    ("persson", "pressure_pa,rms_pressure_pa", "1e7,1e9"),
    ("persson", "pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth", "1e7,1e9,3e8,0.1"),
    ("persson --model elastic", "pressure_pa,rms_pressure_pa", "1e7,1e9"),
    ("persson --model elastic-plastic", "pressure_pa,rms_pressure_pa,hardness_pa", "1e7,1e9,3e8"),
];

/// Columns that the help of a command names and that change nothing by right: the command, the column and the reason.
const LABELS: &[(&str, &str, &str)] = &[
    ("asperity", "model", "an option of other commands"),
    ("persson", "model", "the option, which takes the place of no column"),
    ("statistical", "wavelength_m", "a result beside a spectrum, and in a table of rows a label"),
    ("persson", "wavelength_m", "likewise"),
];

/// Values of a column that matter.
fn values(column: &str) -> [&'static str; 2] {
    match column {
        "model" => ["hertz", "elastic-sine"],
        "youngs_modulus_pa" => ["1e11", "3e11"],
        "yield_strength_pa" => ["5e7", "9e7"],
        "indentation_hardness_pa" => ["2e8", "2.5e8"],
        "hardness_pa" => ["4e8", "5e8"],
        "pressure_pa" => ["2e7", "3e7"],
        "rms_pressure_pa" => ["2e9", "3e9"],
        "hardness_growth" => ["0.05", "0.2"],
        "poisson_ratio" => ["0.2", "0.4"],
        "aspect_ratio" => ["0.02", "0.03"],
        "density_per_m2" => ["2e12", "3e12"],
        "m0_m2" => ["2e-15", "3e-15"],
        "m2" => ["8e-4", "9e-4"],
        "m4_per_m2" => ["2e10", "3e10"],
        "radius_m" | "wavelength_m" | "strain_gradient_length_m" => ["2e-6", "3e-6"],
        "sigma_s_m" | "separation_m" | "interference_m" => ["2e-8", "3e-8"],
        _ => panic!("give two values of {column} that matter"),
    }
}

/// Runs a command on a table. What it prints is without the cells of one column.
fn run(folder: &mut Folder, command: &str, table: &[(String, String)], without: &str) -> Outcome {
    let line = |of: fn(&(String, String)) -> &str| table.iter().map(of).collect::<Vec<_>>().join(",");
    folder.write("rows.csv", &format!("{}\n{}\n", line(|cell| &cell.0), line(|cell| &cell.1)));
    let mut found = folder.run(&split(&format!("{command} --input rows.csv")));
    let header: Vec<_> =
        found.printed.lines().take(1).flat_map(|line| line.split(',').map(str::to_owned)).collect();
    let others = |line: &str| -> String {
        let cells = header.iter().zip(line.split(','));
        cells.filter(|(name, _)| *name != without).map(|(_, cell)| format!("{cell},")).collect()
    };
    found.printed = found.printed.lines().map(others).collect();
    found
}

#[test]
fn columns_of_rows_change_something_or_are_named() {
    let walked = AtomicUsize::new(0);
    let silent = in_every(TABLES, |folder, (command, columns, cells)| {
        let table: Vec<(String, String)> = columns
            .split(',')
            .zip(cells.split(','))
            .map(|(name, cell)| (name.to_owned(), cell.to_owned()))
            .collect();
        let mut silent = Vec::new();
        // Columns of other kinds of tables pass as labels: one table goes through several commands.
        let words = split(&format!("{command} --help"));
        let help = folder.bench.run(&words.iter().map(String::as_str).collect::<Vec<_>>()).ok();
        let listed: BTreeSet<&str> = help.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
        let strengths = ["yield_strength_pa", "indentation_hardness_pa", "strain_gradient_length_m"];
        let is_strength = |column: &str| strengths.contains(&column) && !command.starts_with("persson");
        let is_label =
            |column: &str| LABELS.iter().any(|(of, label, _)| command.starts_with(of) && *label == column);
        let is_walked = |column: &&str| (listed.contains(column) || is_strength(column)) && !is_label(column);
        for column in INPUT_COLUMNS.into_iter().filter(is_walked) {
            walked.fetch_add(1, Ordering::Relaxed);
            let usual = run(folder, command, &table, column);
            assert_eq!(usual.status, 0, "{command} of {columns}: {}", usual.said);
            let found = values(column).map(|value| {
                let mut table = table.clone();
                match table.iter_mut().find(|(name, _)| name == column) {
                    Some(cell) => value.clone_into(&mut cell.1),
                    None => table.push((column.to_owned(), value.to_owned())),
                }
                run(folder, command, &table, column)
            });
            let of = format!("{column} of {command} with {columns}");
            if found.iter().all(|found| found.status != 0 && !found.said.contains(column)) {
                silent.push(format!("UNNAMED {of}: {}", found[0].said));
            }
            // A column that was without effect before is named before.
            let is_named = found.iter().all(|found| found.said.contains(column));
            if found.iter().all(|found| *found == usual) && !is_named {
                silent.push(format!("SILENT {of}"));
            }
        }
        silent
    });
    assert!(silent.is_empty(), "{}", silent.join("\n"));
    let walked = walked.into_inner();
    assert!(walked > 80, "{walked} columns");
}

#[test]
fn the_input_columns_are_those_that_the_help_lists() {
    let bench = Bench::new();
    let help = |words: &[&str]| bench.run(&[words, &["--help"]].concat()).ok();
    let commands = [
        &["asperity", "sphere"][..],
        &["asperity", "sinusoid"],
        &["asperity", "sinusoid-interference"],
        &["statistical"],
        &["persson"],
    ];
    let help = commands.map(help).concat();
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let listed: BTreeSet<&str> = help.split(|c: char| !is_part(c)).collect();
    let missing: Vec<_> = INPUT_COLUMNS.iter().filter(|column| !listed.contains(*column)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
