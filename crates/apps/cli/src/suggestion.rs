//! Suggestions for command lines that name no command.

use std::ffi::OsString;
use std::path::Path;

use scene::Template;

use clap::error::{ContextKind, ContextValue, ErrorKind};

/// The answer if nothing is typed behind the program's name.
pub(crate) const FIRST_WORDS: &str = "\
truearea computes how much of two rough surfaces touches. Type
  truearea report SCAN.txt --material \"steel 100Cr6\" --pressure 10MPa   scans or a spectrum to a report
  truearea scan SCAN.txt                                                what is in a scan
  truearea run SCENE.toml                                               a scene; `truearea scene new` writes one
  truearea --help                                                       all commands";

/// Returns the command for a file or folder typed in the place of a command.
pub(crate) fn for_file(error: &clap::Error, line: &[OsString]) -> Option<String> {
    let is_no_command = matches!(error.kind(), ErrorKind::InvalidSubcommand | ErrorKind::UnknownArgument);
    let [_, path, rest @ ..] = line else { return None };
    let file = Path::new(path);
    if !is_no_command || !file.exists() {
        return None;
    }
    if file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
        return Some(format!("a scene needs the command run; type `truearea run {}`", quoted(path)));
    }
    let has_option = |name: &str| {
        rest.iter().any(|word| word.to_str().is_some_and(|word| word.split('=').next() == Some(name)))
    };
    let missing = [("--material", "\"steel 100Cr6\""), ("--pressure", "10MPa")]
        .into_iter()
        .filter(|(option, _)| !has_option(option))
        .map(|(option, example)| format!(" {option} {example}"));
    let kind = if file.is_dir() { "a folder of scans" } else { "a file" };
    let given = std::iter::once(path).chain(rest).map(|word| format!(" {}", quoted(word)));
    let line: String = given.chain(missing).collect();
    Some(format!("{kind} needs a command; type `truearea report{line}`"))
}

/// Returns what to do in place of options that exist nowhere, or not together.
pub(crate) fn in_place_of(error: &clap::Error, line: &[OsString]) -> Option<String> {
    let named = |kind| match error.get(kind) {
        Some(ContextValue::String(name)) => name.split(' ').next(),
        Some(ContextValue::Strings(names)) => names.first()?.split(' ').next(),
        _ => None,
    };
    let (given, beside) = (named(ContextKind::InvalidArg)?, named(ContextKind::PriorArg));
    match error.kind() {
        ErrorKind::UnknownArgument if let Some(word) = long_with_one_dash(given, line) => {
            Some(format!("{word}: names of options have two dashes; type -{word}"))
        }
        ErrorKind::UnknownArgument => study::way_out(given).map(|instead| format!("{given}: {instead}")),
        ErrorKind::MissingRequiredArgument if given == "<TEMPLATE>" => {
            let names = Template::ALL.iter().map(Template::to_string).collect::<Vec<_>>().join(", ");
            Some(format!(
                "`scene` needs a template, one of {names}; type `truearea scene new > my-scene.toml`"
            ))
        }
        ErrorKind::ArgumentConflict => {
            let has = |name| [Some(given), beside].contains(&Some(name));
            let ball = has("--ball-radius") && (has("--work-of-adhesion") || has("--adhesion-range"));
            study::way_out("work_of_adhesion").filter(|_| ball).map(str::to_owned)
        }
        _ => None,
    }
}

/// The word that a letter behind a single dash begins.
fn long_with_one_dash<'l>(given: &str, line: &'l [OsString]) -> Option<&'l str> {
    let is_one = |word: &&str| word.starts_with(given) && word.len() > given.len() && !word.starts_with("--");
    line.iter()
        .filter_map(|word| word.to_str())
        .find(is_one)
        .filter(|_| given.len() == 2 && !given.ends_with(|c: char| c.is_ascii_digit()))
}

/// The word as a shell takes it if it has spaces.
fn quoted(word: &OsString) -> String {
    let word = word.to_string_lossy();
    if word.contains(' ') { format!("\"{word}\"") } else { word.into_owned() }
}
