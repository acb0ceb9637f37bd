//! The names of public types: one meaning each in all crates below the front ends.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use tests::committed_file;

/// The floors below the front ends.
const FLOORS: [&str; 4] = ["base", "surface", "contact", "answer"];

/// Beginnings of the line of a public type, as rustfmt writes it.
const KINDS: [&str; 4] = ["pub struct ", "pub enum ", "pub trait ", "pub type "];

#[test]
fn no_public_type_has_the_name_of_another() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for floor in FLOORS {
        for file in sources(&committed_file("crates").join(floor)) {
            let text = std::fs::read_to_string(&file).unwrap();
            for name in public_types(&text) {
                places.entry(name.to_owned()).or_default().push(file.display().to_string());
            }
        }
    }
    assert!(places.len() > 300, "only {} types are found", places.len());
    places.retain(|_, files| files.len() > 1);
    assert!(places.is_empty(), "rename one type of each of these: {places:#?}");
}

#[test]
fn a_public_type_is_found_by_its_name() {
    let text = "pub struct One<'a> {\n    pub(crate) inner: Two,\n}\npub(crate) enum Two {}\n/// pub enum Three\npub type Four = f64;\n";
    assert_eq!(public_types(text).collect::<Vec<_>>(), ["One", "Four"]);
}

fn public_types(text: &str) -> impl Iterator<Item = &str> {
    let behind = |line| KINDS.iter().find_map(|kind| str::strip_prefix(line, kind));
    let name = |rest: &'_ str| rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    text.lines().filter_map(behind).map(move |rest| &rest[..name(rest)])
}

/// The Rust files in the folders `src` below a floor.
fn sources(floor: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![floor.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let in_sources = path.components().any(|part| part.as_os_str() == "src");
            if path.is_dir() {
                folders.push(path);
            } else if in_sources && path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found
}
