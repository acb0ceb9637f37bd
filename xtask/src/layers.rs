//! Who may know whom: the crates of the house and what stays out of them, checked over what cargo says of their manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::{Command, ExitCode};

use serde_json::Value;

/// A crate of the house, and the ones of the house that it may name.
type Layer = (&'static str, &'static [&'static str]);

/// From the ground up; what is not listed may name any of them.
const LAYERS: &[Layer] = &[
    ("truearea-units", &[]),
    ("truearea-parallel", &[]),
    ("truearea-staging", &[]),
    ("truearea-numerics", &[]),
    ("truearea-tables", &["truearea-units"]),
    ("truearea-scans", &["truearea-units"]),
    ("truearea-spectrum", &["truearea-units", "truearea-numerics"]),
    ("truearea-gaussian-surfaces", &["truearea-units", "truearea-spectrum"]),
    (
        "truearea-topography",
        &["truearea-units", "truearea-numerics", "truearea-parallel", "truearea-scans", "truearea-spectrum"],
    ),
    (
        "truearea-measurements",
        &[
            "truearea-units",
            "truearea-parallel",
            "truearea-tables",
            "truearea-scans",
            "truearea-spectrum",
            "truearea-topography",
        ],
    ),
    ("truearea-half-space", &["truearea-units", "truearea-parallel"]),
    (
        "truearea-elements",
        &[
            "truearea-units",
            "truearea-parallel",
            "truearea-tables",
            "truearea-gaussian-surfaces",
            "truearea-half-space",
        ],
    ),
    ("truearea-asperity", &["truearea-units", "truearea-numerics"]),
    ("truearea-stacked-contact", &["truearea-units", "truearea-numerics", "truearea-asperity"]),
    ("truearea-stat-contact", &["truearea-units", "truearea-numerics", "truearea-asperity"]),
    ("truearea-persson", &["truearea-units", "truearea-numerics"]),
    ("truearea-interface", &["truearea-units"]),
    ("truearea-contact-law", &["truearea-units"]),
    ("truearea-features", &["truearea-units", "truearea-spectrum", "truearea-stacked-contact"]),
    (
        "truearea-study",
        &[
            "truearea-contact-law",
            "truearea-features",
            "truearea-interface",
            "truearea-persson",
            "truearea-units",
            "truearea-numerics",
            "truearea-parallel",
            "truearea-tables",
            "truearea-scans",
            "truearea-spectrum",
            "truearea-topography",
            "truearea-measurements",
            "truearea-asperity",
            "truearea-stacked-contact",
            "truearea-stat-contact",
        ],
    ),
    (
        "truearea-rows",
        &[
            "truearea-persson",
            "truearea-units",
            "truearea-parallel",
            "truearea-tables",
            "truearea-asperity",
            "truearea-stat-contact",
            "truearea-study",
        ],
    ),
    (
        "truearea-answer",
        &[
            "truearea-features",
            "truearea-tables",
            "truearea-spectrum",
            "truearea-topography",
            "truearea-stacked-contact",
            "truearea-study",
        ],
    ),
    (
        "truearea-sensitivity",
        &[
            "truearea-units",
            "truearea-parallel",
            "truearea-tables",
            "truearea-spectrum",
            "truearea-asperity",
            "truearea-stat-contact",
            "truearea-study",
        ],
    ),
    (
        "truearea-judge",
        &[
            "truearea-units",
            "truearea-parallel",
            "truearea-tables",
            "truearea-spectrum",
            "truearea-gaussian-surfaces",
            "truearea-half-space",
            "truearea-topography",
            "truearea-measurements",
            "truearea-asperity",
            "truearea-stacked-contact",
            "truearea-persson",
            "truearea-study",
        ],
    ),
    (
        "truearea-uncertainty",
        &[
            "truearea-units",
            "truearea-numerics",
            "truearea-parallel",
            "truearea-tables",
            "truearea-spectrum",
            "truearea-topography",
            "truearea-measurements",
            "truearea-asperity",
            "truearea-study",
        ],
    ),
    (
        "truearea-report",
        &[
            "truearea-judge",
            "truearea-uncertainty",
            "truearea-interface",
            "truearea-persson",
            "truearea-elements",
            "truearea-gaussian-surfaces",
            "truearea-units",
            "truearea-rows",
            "truearea-answer",
            "truearea-sensitivity",
            "truearea-tables",
            "truearea-scans",
            "truearea-spectrum",
            "truearea-topography",
            "truearea-asperity",
            "truearea-stacked-contact",
            "truearea-stat-contact",
            "truearea-study",
        ],
    ),
];

/// What only the command line may know, however far down the tree; a pool of threads stands behind a feature.
const STRANGERS: [&str; 5] = ["annotate-snippets", "clap", "indicatif", "rayon", "tempfile"];

/// The crates that write files and are therefore no part of the core.
const OUTSIDE: &[&str] = &["truearea-staging"];

/// What a crate of bytes and values does not call.
const FORBIDDEN_CALLS: [&str; 9] = [
    "std::fs",
    "std::env",
    "std::time",
    "std::process",
    "std::thread",
    "println!",
    "print!(",
    "eprintln!",
    "include_dir!",
];

pub(crate) fn run() -> ExitCode {
    let found = match faults() {
        Ok(found) => found,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    for fault in &found {
        println!("{fault}");
    }
    if found.is_empty() {
        println!("the layers hold: {} crates", LAYERS.len());
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// What does not hold, a line each.
fn faults() -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let house = House::read()?;
    let mut faults = Vec::new();
    for (name, allowed) in LAYERS {
        let Some(member) = house.members.get(*name) else {
            faults.push(format!("{name} is no crate of the workspace"));
            continue;
        };
        for named in member.named.iter().filter(|named| house.members.contains_key(*named)) {
            if !allowed.contains(&named.as_str()) {
                faults.push(format!("{name} must not depend on {named}"));
            }
        }
        if !OUTSIDE.contains(name) {
            faults.extend(strangers(name)?);
            faults.extend(forbidden_calls(Path::new(&member.folder))?);
        }
    }
    Ok(faults)
}

/// The workspace as cargo knows it.
struct House {
    members: BTreeMap<String, Member>,
}

struct Member {
    /// Where its manifest lies.
    folder: String,
    /// The crates that it names as dependencies of its library.
    named: BTreeSet<String>,
}

impl House {
    fn read() -> Result<Self, Box<dyn std::error::Error>> {
        let text = cargo(&["metadata", "--format-version", "1", "--no-deps"])?;
        let metadata: Value = serde_json::from_str(&text)?;
        let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
        let member = |package: &Value| {
            let manifest = package["manifest_path"].as_str().unwrap_or_default();
            let named = package["dependencies"].as_array().into_iter().flatten();
            let named = named.filter(|dependency| dependency["kind"].is_null());
            let name = |value: &Value| value["name"].as_str().unwrap_or_default().to_owned();
            let folder = manifest.trim_end_matches("Cargo.toml").to_owned();
            (name(package), Member { folder, named: named.map(name).collect() })
        };
        Ok(House { members: packages.iter().map(member).collect() })
    }
}

/// The crates in the tree of this one, with its default features, that only the command line may know.
fn strangers(name: &str) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let tree =
        cargo(&["tree", "--package", name, "--edges", "normal", "--prefix", "none", "--format", "{p}"])?;
    let names: BTreeSet<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    let known = STRANGERS.iter().filter(|stranger| names.contains(*stranger));
    Ok(known.map(|stranger| format!("{name} must not have {stranger} in its tree")).collect())
}

/// Calls in a crate's sources, but for their tests, that only the command line may make.
fn forbidden_calls(folder: &Path) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut faults = Vec::new();
    let mut folders = vec![folder.join("src")];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path)?;
                let library = text.split("#[cfg(test)]").next().unwrap_or_default();
                let code =
                    library.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"));
                for (at, line) in code {
                    let called = FORBIDDEN_CALLS.iter().filter(|call| line.contains(*call));
                    faults
                        .extend(called.map(|call| format!("{}:{}: no {call} here", path.display(), at + 1)));
                }
            }
        }
    }
    Ok(faults)
}

fn cargo(arguments: &[&str]) -> Result<String, Box<dyn std::error::Error>> {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(program).args(arguments).output()?;
    if !output.status.success() {
        return Err(format!("cargo {}: {}", arguments[0], String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(String::from_utf8(output.stdout)?)
}
