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
    let instead = match nearest_files(path) {
        None => format!("there is no folder {} either", folder_of(path).display()),
        Some(names) => match &names[..] {
            [] => "its folder is empty".to_owned(),
            [(name, likeness), ..] if *likeness >= ALIKE => {
                format!("did you mean {}?", path.with_file_name(name).display())
            }
            names => {
                let names: Vec<&str> = names.iter().take(3).map(|(name, _)| name.as_str()).collect();
                format!("the names most alike there are {}", names.join(", "))
            }
        },
    };
    io::Error::new(error.kind(), format!("there is no such file; {instead}"))
}

/// Says what a word is that stands in the place of a file, and what to do.
fn no_file(word: &str) -> Option<String> {
    if word.starts_with("http://") || word.starts_with("https://") {
        return Some("this is an address; download the file first".to_owned());
    }
    let is_unit = format!("1 {word}").parse::<Pressure>().is_ok();
    is_unit.then(|| format!("a value with a space needs quotes, as \"10 {word}\""))
}

/// The files beside a missing one, the most alike first, with the likeness of their names; `None` without a folder.
fn nearest_files(path: &Path) -> Option<Vec<(String, f64)>> {
    let wanted = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
    let likeness = |name: String| {
        let likeness = strsim::jaro_winkler(&wanted, &name.to_lowercase());
        (name, likeness)
    };
    let mut names: Vec<_> = files_in(folder_of(path)).ok()?.into_iter().map(likeness).collect();
    names.sort_by(|a, b| b.1.total_cmp(&a.1));
    Some(names)
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
