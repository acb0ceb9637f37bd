//! Files that are not there: what may be meant instead.

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

use tables::staging::folder_of;
use units::Pressure;

/// Least similarity of a file that may be meant, from 0 to 1.
const ALIKE: f64 = 0.9;

/// An error of reading a file, with what to do: to name a file in a folder, or one that is spelt alike.
pub(crate) fn explained(error: io::Error, path: &Path) -> io::Error {
    if path.is_dir() {
        return io::Error::new(error.kind(), "this is a folder; name a file in it");
    }
    if let Some(instead) = no_file(&path.to_string_lossy()) {
        return io::Error::new(error.kind(), instead);
    }
    if error.kind() != io::ErrorKind::NotFound {
        return error;
    }
    let instead = match (similar_file(path), files_in(folder_of(path))) {
        (Some(name), _) => format!("did you mean {name}?"),
        (None, Ok(names)) if names.is_empty() => "its folder is empty".to_owned(),
        (None, Ok(names)) => format!("its folder holds {}", first_of(&names)),
        (None, Err(_)) => format!("there is no folder {} either", folder_of(path).display()),
    };
    io::Error::new(error.kind(), format!("there is no such file; {instead}"))
}

/// The first names of a list.
fn first_of(names: &[String]) -> String {
    const SHOWN: usize = 5;
    let shown = names[..names.len().min(SHOWN)].join(", ");
    if names.len() > SHOWN { format!("{shown} and {} more", names.len() - SHOWN) } else { shown }
}

/// Says what a word is that stands in the place of a file, and what to do.
fn no_file(word: &str) -> Option<String> {
    if word.starts_with("http://") || word.starts_with("https://") {
        return Some("this is an address; download the file first".to_owned());
    }
    let is_unit = format!("1 {word}").parse::<Pressure>().is_ok();
    is_unit.then(|| format!("a value with a space needs quotes, as \"10 {word}\""))
}

/// The file beside a missing one that has the most similar name.
fn similar_file(path: &Path) -> Option<String> {
    let wanted = path.file_name()?.to_str()?.to_lowercase();
    let names = files_in(folder_of(path)).ok()?;
    let likeness = |name: &String| strsim::jaro_winkler(&wanted, &name.to_lowercase());
    let found = names.into_iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    (likeness(&found) >= ALIKE).then(|| path.with_file_name(found).display().to_string())
}

/// Returns the path of the one file whose name reads like this one where its bytes that are not UTF-8 are replaced, as
/// [`files_in`] lists it; else the path itself.
pub(crate) fn spelt_as_on_disk(path: &Path) -> PathBuf {
    let Some(name) = path.file_name().and_then(OsStr::to_str) else { return path.to_owned() };
    if !name.contains(char::REPLACEMENT_CHARACTER) || path.exists() {
        return path.to_owned();
    }
    let listed = std::fs::read_dir(folder_of(path));
    let mut alike =
        listed.into_iter().flatten().flatten().filter(|entry| entry.file_name().to_string_lossy() == name);
    match (alike.next(), alike.next()) {
        (Some(entry), None) => entry.path(),
        _ => path.to_owned(),
    }
}

/// The names of the files in a folder, sorted; hidden ones are left out.
pub(crate) fn files_in(folder: &Path) -> io::Result<Vec<String>> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_file() && !name.starts_with('.') {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}
