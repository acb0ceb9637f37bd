//! Flags, columns, scene keys and names of the Python package are a contract: those listed in `tests/contract` stay accepted.
//! A name that is new to users is added to its list; none is ever taken out.

mod support;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use clap::{Command, CommandFactory};
use scene::{Overrides, Scene, SceneProblem};
use study::NoFiles;
use support::Bench;

fn listed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/contract").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_flag_is_accepted_with_every_value() {
    let mut command = cli::args::Args::command();
    command.build();
    let mut flags = BTreeMap::new();
    collect_flags(&command, "", &mut flags);
    for line in listed("flags.txt").lines() {
        let mut words: Vec<&str> = line.split(' ').collect();
        let values = if words[words.len() - 1].starts_with('-') { "" } else { words.pop().unwrap() };
        let known = flags.get(&words.join(" ")).unwrap_or_else(|| panic!("{line} is not accepted"));
        // Where no values are listed, the flag decides itself.
        for value in values.split('|').filter(|value| !value.is_empty() && !known.is_empty()) {
            assert!(known.contains(value), "{line}: {value} is not accepted");
        }
    }
}

/// The flags of a command and of those below it, hidden names among them, each with its values.
fn collect_flags(command: &Command, path: &str, flags: &mut BTreeMap<String, BTreeSet<String>>) {
    for name in std::iter::once(command.get_name()).chain(command.get_all_aliases()) {
        let path = format!("{path} {name}");
        let path = path.trim();
        for argument in command.get_arguments() {
            let values: BTreeSet<String> = argument
                .get_possible_values()
                .iter()
                .flat_map(|value| value.get_name_and_aliases().map(str::to_owned).collect::<Vec<_>>())
                .collect();
            let long =
                argument.get_long().into_iter().chain(argument.get_all_aliases().into_iter().flatten());
            let short = argument
                .get_short()
                .into_iter()
                .chain(argument.get_all_short_aliases().into_iter().flatten());
            let names = long.map(|name| format!("--{name}")).chain(short.map(|name| format!("-{name}")));
            flags.extend(names.map(|name| (format!("{path} {name}"), values.clone())));
        }
        command.get_subcommands().for_each(|below| collect_flags(below, path, flags));
    }
}

#[test]
fn every_column_is_written() {
    let bench = Bench::new();
    for file in ["scene.toml", "rows.csv", "map.txt"] {
        bench.write(file, listed(file));
    }
    for line in listed("columns.txt").lines() {
        // The line of `run` has no columns: its tables are files, on the lines below.
        let (source, columns) = line.split_once(": ").unwrap_or((line.trim_end_matches(':'), ""));
        let table = if source.ends_with(".csv") && !source.contains(' ') {
            bench.read(source)
        } else {
            bench.run(&source.split(' ').collect::<Vec<_>>()).ok()
        };
        let header = table.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
        let written: BTreeSet<&str> = header.split(',').collect();
        for column in columns.split(',').filter(|column| !column.is_empty()) {
            assert!(written.contains(column), "{source}: there is no column {column} in {header}");
        }
    }
}

#[test]
fn every_key_of_a_scene_is_known() {
    let is_known = |path: &str| {
        let (sections, key) = path.rsplit_once('.').unwrap_or(("", path));
        let inside = |content: String, section: &str| match section.strip_suffix("[]") {
            Some(list) => format!("{list} = [{{ {content} }}]"),
            None => format!("{section} = {{ {content} }}"),
        };
        let sections = sections.split('.').filter(|section| !section.is_empty());
        let text = sections.rev().fold(format!("{key} = 0"), inside);
        match Scene::parse(&text, &NoFiles, &Overrides::default()) {
            Err(error) => {
                !matches!(&error.problem, SceneProblem::UnknownKey { key: unknown, .. } if unknown == key)
            }
            Ok(_) => true,
        }
    };
    for path in listed("scene-keys.txt").lines() {
        assert!(is_known(path), "{path} is not known");
        let other = format!("{path}_");
        assert!(!is_known(&other), "{other} is taken for a key");
    }
}

#[test]
fn every_name_of_the_python_package_is_there() {
    let names = python_names(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../python/package/truearea"));
    let lost: Vec<String> =
        listed("python-names.txt").lines().filter(|name| !names.contains(*name)).map(str::to_owned).collect();
    assert!(lost.is_empty(), "the Python package has no {}", lost.join(", "));
}

/// A class or function of the sources of the package: what it derives from, and its parameters by member. The members of a
/// function are its own under no name.
#[derive(Default)]
struct Definition {
    bases: Vec<String>,
    members: BTreeMap<String, BTreeSet<String>>,
}

/// The exported names of a package, their members and the parameters of both, as `name`, `name.member` and
/// `name.member(parameter)`.
fn python_names(package: &Path) -> BTreeSet<String> {
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(package).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "py"));
    let mut definitions = BTreeMap::new();
    for file in files {
        read_definitions(&std::fs::read_to_string(file).unwrap(), &mut definitions);
    }
    let init = std::fs::read_to_string(package.join("__init__.py")).unwrap();
    let exported = init.split_once("__all__ = [").unwrap().1.split_once(']').unwrap().0;
    let mut names = BTreeSet::new();
    for name in exported.split('"').skip(1).step_by(2) {
        names.insert(name.to_owned());
        add_members(name, name, &definitions, &mut names);
    }
    names
}

fn add_members(
    name: &str,
    of: &str,
    definitions: &BTreeMap<String, Definition>,
    names: &mut BTreeSet<String>,
) {
    let Some(definition) = definitions.get(of) else { return };
    for (member, parameters) in &definition.members {
        let path = if member.is_empty() { name.to_owned() } else { format!("{name}.{member}") };
        names.extend(parameters.iter().map(|parameter| format!("{path}({parameter})")));
        names.insert(path);
    }
    definition.bases.iter().for_each(|base| add_members(name, base, definitions, names));
}

/// Reads the classes and functions of a module, by indentation.
fn read_definitions(text: &str, definitions: &mut BTreeMap<String, Definition>) {
    let mut of = String::new();
    // Former names of the parameters of the next function, which it still accepts.
    let mut former = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let code = line.trim_start();
        let is_member = line.len() - code.len() == 4 && !of.is_empty();
        if let Some(names) = line.strip_prefix("@formerly(") {
            former = parameters(names);
        } else if let Some(class) = line.strip_prefix("class ") {
            let (name, bases) = class.split_once(['(', ':']).unwrap();
            of = name.to_owned();
            let bases = bases.split([',', ')', '[', ']']).map(|base| base.trim().to_owned()).collect();
            definitions.insert(of.clone(), Definition { bases, ..Definition::default() });
        } else if let Some(function) = code.strip_prefix("def ").filter(|_| is_member || line == code) {
            let mut signature = function.to_owned();
            while signature.matches('(').count() > signature.matches(')').count() {
                signature.push_str(lines.next().unwrap());
            }
            let (name, rest) = signature.split_once('(').unwrap();
            if !is_member {
                of.clear();
            }
            if is_member && name.starts_with('_') && name != "__init__" {
                continue;
            }
            let (class, member) = if is_member { (of.as_str(), name) } else { (name, "") };
            let definition = definitions.entry(class.to_owned()).or_default();
            let known = definition.members.entry(member.to_owned()).or_default();
            known.extend(parameters(rest).into_iter().chain(former.drain(..)));
        } else if is_member {
            let name = code.split([':', ' ']).next().unwrap();
            let is_field = code[name.len()..].starts_with(": ") || code[name.len()..].starts_with(" = ");
            if is_field && !name.starts_with('_') && name.chars().all(|c| c.is_alphanumeric() || c == '_') {
                definitions.entry(of.clone()).or_default().members.entry(name.to_owned()).or_default();
            }
        } else if line == code && !code.is_empty() && !code.starts_with([')', '#', '@']) {
            of.clear();
        }
    }
}

/// The names of the parameters up to the bracket that closes a signature.
fn parameters(signature: &str) -> Vec<String> {
    let (mut depth, mut found) = (0, vec![String::new()]);
    for c in signature.chars() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' if depth == 0 => break,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => found.push(String::new()),
            _ => {}
        }
        found.last_mut().unwrap().push(c);
    }
    let name = |text: String| {
        text.trim_start_matches([',', ' ']).split([':', '=']).next().unwrap().trim().to_owned()
    };
    let names = found.into_iter().map(name);
    names
        .filter(|name| !matches!(name.as_str(), "" | "self" | "cls" | "*" | "/") && !name.starts_with('*'))
        .collect()
}
