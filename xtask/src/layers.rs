//! The layers of the house: folder order is layer order, checked over the manifests of all crates and their sources.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use serde_json::Value;

use xtask::checkout;

use crate::budgets;

/// The floors from the ground up: folders of `crates/`. A crate may use any crate of a lower floor, and of its own
/// floor what its manifest lists.
const FLOORS: [&str; 6] = ["base", "surface", "contact", "answer", "apps", "evidence"];

/// The floors whose crates are fit for a browser: bytes in, values out.
const CORE_FLOORS: usize = 4;

/// Crate of the folder `data`, which users edit and which therefore stands beside `crates/`.
const SHIPPED_DATA: &str = "truearea-data";

/// Crates of contact that know spectra or scans; all others take numbers.
const JOINS_SURFACE_AND_CONTACT: [&str; 1] = ["truearea-elements"];

/// Crates for the command line only, however far down the tree; a thread pool is behind a feature.
const STRANGERS: [&str; 5] = ["annotate-snippets", "clap", "indicatif", "rayon", "tempfile"];

/// Module that writes files, behind a feature, and is therefore outside of the core.
const OUTSIDE: &str = "crates/base/tables/src/staging";

/// Calls that crates of bytes and values must not make.
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
    let checked = House::read().and_then(|house| Ok((faults(&house)?, house.members.len())));
    let (found, crates) = match checked {
        Ok(checked) => checked,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    for fault in &found {
        println!("{fault}");
    }
    if found.is_empty() {
        println!("the floors hold: {crates} crates");
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Violated rules, a line each.
fn faults(house: &House) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut faults = Vec::new();
    for (name, member) in &house.members {
        let Some(floor) = member.floor else { continue };
        if *name != format!("truearea-{}", member.folder_name()) {
            faults.push(format!("{}: the package is {name}, not truearea-{0}", member.folder_name()));
        }
        for named in &member.named {
            let Some(other) = house.members.get(named) else { continue };
            match other.floor {
                None => {
                    faults.push(format!("{name} must not depend on {named}, which stands outside crates/"))
                }
                Some(above) if above > floor => faults.push(format!(
                    "{name} ({}) must not depend on {named} ({}): the arrow runs up",
                    FLOORS[floor], FLOORS[above]
                )),
                Some(below)
                    if FLOORS[floor] == "contact"
                        && FLOORS[below] == "surface"
                        && !JOINS_SURFACE_AND_CONTACT.contains(&name.as_str()) =>
                {
                    faults.push(format!("{name} must not depend on {named}: it takes numbers, not surfaces"));
                }
                Some(_) => {}
            }
        }
        if floor < CORE_FLOORS {
            faults.extend(strangers(name)?);
            faults.extend(forbidden_calls(&member.folder)?);
        }
    }
    for folder in crates_on_disk()? {
        if !house.members.values().any(|member| member.folder == folder) {
            faults.push(format!("{} is not a crate of the workspace", folder.display()));
        }
    }
    let crates = house.members.iter().filter(|(_, member)| member.floor.is_some());
    faults.extend(budgets::faults(
        &crates.map(|(name, member)| (name.clone(), member.folder.clone())).collect(),
    )?);
    faults.extend(house.cycle().map(|cycle| format!("a cycle of crates: {}", cycle.join(" -> "))));
    Ok(faults)
}

/// Folders below `crates/<floor>/` that hold a manifest.
fn crates_on_disk() -> Result<Vec<PathBuf>, Box<dyn std::error::Error>> {
    let root = &checkout("");
    let mut found = Vec::new();
    for floor in std::fs::read_dir(root.join("crates"))? {
        let floor = floor?.path();
        if floor.is_dir() {
            let folders = std::fs::read_dir(floor)?.map(|entry| entry.map(|entry| entry.path()));
            for folder in folders.collect::<Result<Vec<_>, _>>()? {
                if folder.join("Cargo.toml").exists() {
                    found.push(folder);
                }
            }
        }
    }
    Ok(found)
}

/// The workspace as reported by cargo.
struct House {
    members: BTreeMap<String, Member>,
}

struct Member {
    /// Folder of its manifest.
    folder: PathBuf,
    /// Floor, counted from the ground; `None` outside of `crates/`.
    floor: Option<usize>,
    /// Crates that its library names.
    named: BTreeSet<String>,
}

impl Member {
    fn folder_name(&self) -> &str {
        self.folder.file_name().and_then(|name| name.to_str()).unwrap_or_default()
    }
}

impl House {
    fn read() -> Result<Self, Box<dyn std::error::Error>> {
        let text = cargo(&["metadata", "--format-version", "1", "--no-deps"])?;
        let metadata: Value = serde_json::from_str(&text)?;
        let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
        Ok(House { members: packages.iter().map(member).collect() })
    }

    /// Crates whose libraries name each other in a circle, of any length.
    fn cycle(&self) -> Option<Vec<&str>> {
        let mut done = BTreeSet::new();
        self.members.keys().find_map(|name| self.cycle_through(name, &mut Vec::new(), &mut done))
    }

    fn cycle_through<'h>(
        &'h self,
        name: &'h str,
        path: &mut Vec<&'h str>,
        done: &mut BTreeSet<&'h str>,
    ) -> Option<Vec<&'h str>> {
        if let Some(begin) = path.iter().position(|passed| *passed == name) {
            return Some([&path[begin..], &[name]].concat());
        }
        if done.contains(name) {
            return None;
        }
        path.push(name);
        let named = self.members.get(name).into_iter().flat_map(|member| &member.named);
        for next in named.filter(|next| self.members.contains_key(*next)) {
            if let Some(cycle) = self.cycle_through(next, path, done) {
                return Some(cycle);
            }
        }
        path.pop();
        done.insert(name);
        None
    }
}

fn member(package: &Value) -> (String, Member) {
    let name = |value: &Value| value["name"].as_str().unwrap_or_default().to_owned();
    let manifest = package["manifest_path"].as_str().unwrap_or_default();
    let folder = Path::new(manifest).parent().unwrap_or(Path::new("")).to_owned();
    let on_floor = folder
        .parent()
        .and_then(|floor| FLOORS.iter().position(|name| floor.ends_with(Path::new("crates").join(name))));
    // The text of the files in `data` stands on the ground floor.
    let floor = on_floor.or_else(|| (name(package) == SHIPPED_DATA).then_some(0));
    let dependencies = || package["dependencies"].as_array().into_iter().flatten();
    let by_library = dependencies().filter(|dependency| dependency["kind"].is_null());
    let member = Member { folder, floor, named: by_library.map(name).collect() };
    (name(package), member)
}

/// Crates in the dependency tree of this one, with its default features, that are for the command line only.
fn strangers(name: &str) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let tree =
        cargo(&["tree", "--package", name, "--edges", "normal", "--prefix", "none", "--format", "{p}"])?;
    let names: BTreeSet<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    let known = STRANGERS.iter().filter(|stranger| names.contains(*stranger));
    Ok(known.map(|stranger| format!("{name} must not have {stranger} in its tree")).collect())
}

/// Calls in a crate's sources, except in tests, that are for the command line only.
fn forbidden_calls(folder: &Path) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut faults = Vec::new();
    let mut folders = vec![folder.join("src")];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next)? {
            let path = entry?.path();
            if path.is_dir() && !path.ends_with(OUTSIDE) {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path)?;
                for (at, line) in library_lines(&text) {
                    let called = FORBIDDEN_CALLS.iter().filter(|call| line.contains(*call));
                    faults
                        .extend(called.map(|call| format!("{}:{}: no {call} here", path.display(), at + 1)));
                }
            }
        }
    }
    Ok(faults)
}

/// Lines of a source with their numbers from 0, without comments and test-only items.
fn library_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    // As formatted by rustfmt, an item ends with a semicolon, or with a closing brace at its own indentation.
    let mut test_item: Option<usize> = None;
    text.lines().enumerate().filter(move |(_, line)| {
        let code = line.trim_start();
        let indentation = line.len() - code.len();
        match test_item {
            None if code.starts_with("#[cfg(test)]") => test_item = Some(indentation),
            None => return !code.starts_with("//"),
            Some(begin) => {
                let ends = code.ends_with(';') || code.ends_with('}');
                if indentation == begin && ends {
                    test_item = None;
                }
            }
        }
        false
    })
}

fn cargo(arguments: &[&str]) -> Result<String, Box<dyn std::error::Error>> {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(program).args(arguments).output()?;
    if !output.status.success() {
        return Err(format!("cargo {}: {}", arguments[0], String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(String::from_utf8(output.stdout)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn library_code_behind_a_test_item_is_read() {
        let text = "fn a() {}\n#[cfg(test)]\nmod tests {\n    fn t() {\n    }\n}\nfn b() {}\n#[cfg(test)]\nuse x;\n// c\nfn d() {}\n";
        let lines: Vec<&str> = library_lines(text).map(|(_, line)| line).collect();
        assert_eq!(lines, ["fn a() {}", "fn b() {}", "fn d() {}"]);
    }

    #[test]
    fn a_cycle_of_three_crates_is_found() {
        let member = |named: &str| Member {
            folder: PathBuf::new(),
            floor: None,
            named: BTreeSet::from([named.to_owned()]),
        };
        let members = [("a", "b"), ("b", "c"), ("c", "a")];
        let house = House { members: members.map(|(name, named)| (name.to_owned(), member(named))).into() };
        assert_eq!(house.cycle().unwrap(), ["a", "b", "c", "a"]);
    }
}
