//! Compares measured contacts with predictions: `cargo xtask nature`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::prelude::*;
use nature::joint::{ApertureMap, JointRow, read_closure};
use nature::table::{self, ResistanceRow, resistance_rows};
use nature::{page, resistance};
use serde::Serialize;
use tables::staging::write_file;

const HELP: &str = "\
cargo xtask nature --data FOLDER [--out FOLDER]
        predicts the measured contacts of a folder (tcr/tcr.csv, rock_joints/NAME_closure.csv with NAME_aperture_2um.npy) and
        rewrites docs/develop/nature/*.csv and the tables of docs/guide/nature.md; with --out writes both tables into that folder
        and prints those of the page, and docs stay as they are (minutes; the measurements are not part of the repository)
";

const CLOSURE: &str = "_closure.csv";

struct Options {
    data: PathBuf,
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    let outcome = match options() {
        Ok(Some(options)) => compare(&options),
        Ok(None) => {
            print!("{HELP}");
            Ok(())
        }
        Err(error) => {
            eprint!("error: {error}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn options() -> Result<Option<Options>, lexopt::Error> {
    let (mut parser, mut data, mut out) = (lexopt::Parser::from_env(), None, None);
    while let Some(argument) = parser.next()? {
        match argument {
            Long("data") => data = Some(parser.value()?.into()),
            Long("out") => out = Some(parser.value()?.into()),
            Long("help") | Short('h') => return Ok(None),
            other => return Err(other.unexpected()),
        }
    }
    let data = data.ok_or("say where the measurements are: --data FOLDER")?;
    Ok(Some(Options { data, out }))
}

fn compare(Options { data, out }: &Options) -> Result<(), Box<dyn Error>> {
    let resistances = resistances(&data.join("tcr/tcr.csv"))?;
    let joints = joints(&data.join("rock_joints"))?;
    if resistances.is_empty() && joints.is_empty() {
        return Err(format!("{} has neither tcr/tcr.csv nor rock_joints", data.display()).into());
    }
    if out.is_none() && (resistances.is_empty() || joints.is_empty()) {
        return Err("the page needs both resistances and joints; give --out FOLDER for one of them".into());
    }
    let tables = out.clone().unwrap_or_else(|| checkout("docs/develop/nature"));
    std::fs::create_dir_all(&tables)?;
    store(&resistances, &tables.join("resistances.csv"))?;
    store(&joints, &tables.join("joints.csv"))?;
    if out.is_some() {
        page::sections(&resistances, &joints).iter().for_each(|(name, text)| println!("\n{name}\n\n{text}"));
        return Ok(());
    }
    let path = checkout("docs/guide/nature.md");
    let page = page::written(&std::fs::read_to_string(&path)?, &resistances, &joints)?;
    write_file(&path, page)?;
    println!("rewrote docs/guide/nature.md; cargo xtask docs draws its pictures");
    Ok(())
}

/// Predicts the resistances of a file; none if it is missing.
fn resistances(path: &Path) -> Result<Vec<ResistanceRow>, Box<dyn Error>> {
    if !path.exists() {
        println!("no {}: no resistances", path.display());
        return Ok(Vec::new());
    }
    let (rows, doubtful) = resistance_rows(&resistance::read(std::fs::File::open(path)?)?)?;
    println!("predicted {} bare joints; the gas pressure of {doubtful} more is doubtful", rows.len());
    Ok(rows)
}

/// Presses the joints of a folder; none if it is missing.
fn joints(folder: &Path) -> Result<Vec<JointRow>, Box<dyn Error>> {
    let mut rows = Vec::new();
    if !folder.exists() {
        println!("no {}: no joints", folder.display());
        return Ok(rows);
    }
    let files = std::fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut files = files.collect::<std::io::Result<Vec<String>>>()?;
    files.sort();
    for name in files.iter().filter_map(|file| file.strip_suffix(CLOSURE)) {
        println!("pressing {name}");
        let closure = read_closure(std::fs::File::open(folder.join(format!("{name}{CLOSURE}")))?)?;
        let map = format!("{name}_aperture_2um.npy");
        rows.extend(ApertureMap::read(&std::fs::read(folder.join(&map))?, &map)?.press(name, &closure)?);
    }
    Ok(rows)
}

fn store<R: Serialize>(rows: &[R], csv: &Path) -> Result<(), Box<dyn Error>> {
    let mut table = Vec::new();
    table::write(rows, &mut table)?;
    Ok(write_file(csv, table)?)
}

/// Path of a file of this repository.
fn checkout(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(path)
}
