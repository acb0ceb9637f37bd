//! The page `docs/develop/status.md`, made from the tables of models and formats and the sources of the questions.
//! `cargo xtask docs` writes it, a test compares it.
//!
//! ```
//! assert!(tests::status::page().unwrap().contains("| `persson` |"));
//! ```

use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

use scans::{FormatCheck, ScanFormat};
use study::models::MODELS;

use crate::committed_file;

const HEAD: &str = "\
# Status

Made by `cargo xtask docs` from the tables and sources of the program; a test compares it. What results leave out is in
[limits](../guide/limits.md).

## Models

Curves, scenes and intervals take all of them; `truearea gap` and `law` take those with a gap ([gap.md](../guide/gap.md)).

| model | full name | command | gap |
|---|---|---|---|
";

const QUESTIONS: &str = "
## Questions

Each is a struct of the crate `questions`; the last columns say who uses it. All three run scenes and make reports.

| question | what it answers | command line | Python | browser |
|---|---|---|---|---|
";

/// Path of the page.
pub fn path() -> PathBuf {
    committed_file("docs/develop/status.md")
}

/// Writes the page from the program as it is.
///
/// # Errors
/// The sources of the questions or of a front end cannot be read.
pub fn page() -> io::Result<String> {
    let mut page = HEAD.to_owned();
    let yes = |is: bool| if is { "yes" } else { "-" };
    for model in MODELS.iter() {
        let (name, full, command) = (model.name, model.full_name, model.framework);
        let _ = writeln!(page, "| `{name}` | {full} | `{command}` | {} |", yes(command.has_gaps()));
    }
    page.push_str(QUESTIONS);
    let front_ends = [
        sources(&committed_file("crates/apps/cli/src"))?,
        sources(&committed_file("python/src"))?,
        sources(&committed_file("crates/apps/web/src"))?,
    ];
    for (name, answers) in questions(&sources(&folder_of_questions()?)?) {
        let [cli, python, web] = front_ends.each_ref().map(|text| yes(has_word(text, &name)));
        let _ = writeln!(page, "| `{name}` | {answers} | {cli} | {python} | {web} |");
    }
    let (mut on_real_files, mut on_made_files) = (Vec::new(), Vec::new());
    for format in ScanFormat::ALL {
        match format.check() {
            FormatCheck::RealFiles(readers) => on_real_files.push(format!("{format} ({readers})")),
            FormatCheck::MadeFiles(readers) => on_made_files.push(format!("{format} ({readers})")),
            FormatCheck::NoFile => {}
        }
    }
    let _ = write!(
        page,
        "\n## Formats of scans\n\n{} kinds of files, each also packed by gzip or ZIP.\n\n\
         {} were compared on real files with the programs in brackets: {}.\n\n\
         {} were compared on made files alone, which a note says: {}.\n\n\
         [instruments.md](../guide/instruments.md#the-formats) says what is read of each, and [formats.md](formats.md) \
         how it was tested.\n",
        on_real_files.len() + on_made_files.len(),
        on_real_files.len(),
        on_real_files.join(", "),
        on_made_files.len(),
        on_made_files.join(", ")
    );
    Ok(page)
}

/// Returns the folder with the sources of the questions, on whichever floor they are.
fn folder_of_questions() -> io::Result<PathBuf> {
    let floors = std::fs::read_dir(committed_file("crates"))?;
    let mut folders = floors.filter_map(Result::ok).map(|floor| floor.path().join("questions/src"));
    folders.find(|folder| folder.exists()).ok_or_else(|| io::ErrorKind::NotFound.into())
}

/// Returns the text of all sources in a folder and those below it, by name.
fn sources(folder: &Path) -> io::Result<String> {
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    paths.sort();
    let texts =
        paths.iter().map(|path| if path.is_dir() { sources(path) } else { std::fs::read_to_string(path) });
    texts.collect()
}

/// Returns true if a text has a name as a whole word.
fn has_word(text: &str, name: &str) -> bool {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name)
}

/// Returns the name of each public question, with the first sentence of its documentation.
fn questions(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut documentation = String::new();
    for line in text.lines() {
        if let Some(words) = line.strip_prefix("/// ") {
            documentation = format!("{documentation} {words}");
        } else if let Some(rest) = line.strip_prefix("pub struct ") {
            let name = rest.split([' ', '<', '(', ';']).next().unwrap_or_default();
            if name.ends_with("Question") {
                let sentence = documentation.split(". ").next().unwrap_or_default().trim();
                found.push((name.to_owned(), sentence.trim_end_matches('.').to_owned()));
            }
            documentation.clear();
        } else if !line.starts_with("#[") {
            documentation.clear();
        }
    }
    found.sort();
    found
}
