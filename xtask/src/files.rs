//! Files of instruments that are not in the repository, read again and compared with what another reader found in them.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use sha2::{Digest, Sha256};
use xtask::checkout;

/// The table of files: a row for each channel and reader.
const TABLE: &str = "docs/develop/compared_files.csv";
/// Relative difference of rms heights that their digits in the table explain.
const ROUNDING: f64 = 1e-6;

/// A row of the table, by the names of its columns.
type Row = HashMap<String, String>;

/// Reads every file of the table that is in a folder, by its digest.
pub(crate) fn run(folder: &Path) -> ExitCode {
    match compare(folder) {
        Ok(failures) if failures.is_empty() => ExitCode::SUCCESS,
        Ok(failures) => {
            failures.iter().for_each(|failure| eprintln!("{failure}"));
            ExitCode::FAILURE
        }
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn compare(folder: &Path) -> Result<Vec<String>, String> {
    let table = fs::read_to_string(checkout(TABLE)).map_err(|error| format!("{TABLE}: {error}"))?;
    let wanted = rows(&table);
    let mut found: HashMap<String, PathBuf> = HashMap::new();
    digests(folder, &wanted, &mut found)?;
    let mut read: HashMap<String, Vec<Row>> = HashMap::new();
    let (mut compared, mut failures) = (0, Vec::new());
    for row in wanted.iter().filter(|row| !row["rms_height_m"].is_empty()) {
        let Some(path) = found.get(&row["sha256"]) else { continue };
        let channels = match read.get(&row["sha256"]) {
            Some(channels) => channels,
            None => read.entry(row["sha256"].clone()).or_insert(scan(path)?),
        };
        compared += 1;
        failures.extend(difference(row, channels));
    }
    let missing = wanted.iter().filter(|row| !found.contains_key(&row["sha256"]));
    let mut absent: Vec<&str> = missing.map(|row| row["file"].as_str()).collect();
    absent.dedup();
    println!(
        "{} files, {compared} comparisons; not in {}: {}",
        found.len(),
        folder.display(),
        absent.join(", ")
    );
    if compared == 0 {
        return Err(format!("{}: holds no file of {TABLE}", folder.display()));
    }
    Ok(failures)
}

/// The rows of a table in which only the last column holds commas.
fn rows(table: &str) -> Vec<Row> {
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    lines
        .map(|line| {
            let cells = line.splitn(names.len(), ',').map(|cell| cell.trim_matches('"').to_owned());
            names.iter().map(|name| (*name).to_owned()).zip(cells).collect()
        })
        .collect()
}

/// Finds the files of the table below a folder.
fn digests(folder: &Path, wanted: &[Row], found: &mut HashMap<String, PathBuf>) -> Result<(), String> {
    let blame = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(blame)? {
        let path = entry.map_err(blame)?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if path.is_dir() {
            digests(&path, wanted, found)?;
        } else if wanted.iter().any(|row| row["file"] == name) {
            let bytes = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            let digest = Sha256::digest(bytes).iter().fold(String::new(), |mut digits, byte| {
                let _ = write!(digits, "{byte:02x}");
                digits
            });
            if wanted.iter().any(|row| row["sha256"] == digest) {
                found.insert(digest, path);
            }
        }
    }
    Ok(())
}

/// The channels of a file, as the program lists them.
fn scan(path: &Path) -> Result<Vec<Row>, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let run = ["run", "--quiet", "--bin", "truearea", "--", "scan", "--format", "csv"];
    let output = Command::new(cargo).args(run).arg(path).current_dir(checkout("")).output();
    let output = output.map_err(|error| format!("running truearea: {error}"))?;
    // A path may hold commas, and no column of it is compared.
    Ok(rows(&String::from_utf8_lossy(&output.stdout).replace(&path.display().to_string(), "")))
}

/// Compares a row of the table with the channel that it is about, and words the difference.
fn difference(wanted: &Row, channels: &[Row]) -> Option<String> {
    let told = |problem: String| Some(format!("{}, {}: {problem}", wanted["file"], wanted["channel"]));
    let is_it = |row: &&Row| wanted["channel"].is_empty() || row["channel"] == wanted["channel"];
    let Some(found) = channels.iter().find(is_it) else { return told("no such channel is read".to_owned()) };
    for column in ["points_x", "points_y", "gaps"] {
        if found[column] != wanted[column] {
            return told(format!("{column} is {}, it was {}", found[column], wanted[column]));
        }
    }
    let number = |row: &Row| row["rms_height_m"].parse::<f64>().unwrap_or(f64::NAN);
    let (now_m, then_m) = (number(found), number(wanted));
    let is_close = (now_m / then_m - 1.0).abs() <= ROUNDING;
    if is_close { None } else { told(format!("the rms height is {now_m:e} m, it was {then_m:e} m")) }
}
