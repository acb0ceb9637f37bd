//! Sources of input and destinations of results: standard streams, or files that appear whole or not at all.

use std::ffi::OsStr;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tables::staging::StagedFiles;

use crate::failure::Failure;
use crate::interruption;
use crate::missing_file::explained;
use crate::picture::Picture;
use crate::stderr::say;
use crate::terminal::standard_output;
use report::products::{ANSWER, SceneProducts};
use scene::Scene;
use study::figure::PictureFormat;
use study::plan::PlanError;
use tables::staging::reading::{bytes_of, bytes_of_stream};
use tables::{Format, TableError};

/// A path, or `-` for stdin or stdout.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// stdin or stdout.
    Standard,
    /// A file.
    File(PathBuf),
}

impl From<&str> for Place {
    fn from(text: &str) -> Self {
        if text == "-" { Place::Standard } else { Place::File(PathBuf::from(text)) }
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Place::Standard => write!(f, "-"),
            Place::File(path) => write!(f, "{}", path.display()),
        }
    }
}

impl Place {
    /// All bytes that stand there.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the place.
    pub fn read(&self) -> Result<Vec<u8>, Failure> {
        match self {
            Place::Standard => bytes_of_stream(&mut io::stdin().lock())
                .map_err(|error| Failure::reading("standard input", &error)),
            Place::File(path) if path.is_dir() => {
                let folder = path.display();
                Err(Failure::Input(format!(
                    "{folder}: this is a folder; name a scene in it, or try `truearea report {folder}`"
                )))
            }
            Place::File(path) => bytes_of(path)
                .map_err(|error| Failure::reading(&path.display().to_string(), &explained(error, path))),
        }
    }

    /// Writes there; a file is replaced only once `write` has succeeded.
    ///
    /// # Errors
    /// Errors of [`stage`](Self::stage) and [`publish`].
    pub fn write<E: Into<Stopped>>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        let mut files = StagedFiles::default();
        self.stage(&mut files, write)?;
        publish(files)
    }

    /// Writes a file aside, to be published with others; standard output gets it at once.
    ///
    /// # Errors
    /// [`Failure::System`] that names the place; [`Failure::ClosedPipe`] where nobody reads stdout any more; what else
    /// stopped `write`.
    pub fn stage<E: Into<Stopped>>(
        &self,
        files: &mut StagedFiles,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        match self {
            Place::Standard => {
                let mut stdout = BufWriter::new(standard_output());
                written(write, &mut stdout).map_err(|stopped| stopped.writing("standard output"))
            }
            Place::File(path) => stage(files, path, write),
        }
    }
}

/// Puts every staged file into its place, or none.
///
/// # Errors
/// [`Failure::System`] that names the path; [`Failure::Interrupted`] where the program has been asked to end.
pub fn publish(files: StagedFiles) -> Result<(), Failure> {
    if interruption::is_asked_for() {
        return Err(Failure::Interrupted);
    }
    for folder in files.publish()?.unfinished {
        say(&format!(
            "note: {}: an earlier run was killed while it replaced files here; those that this run has not written may be of \
             another run",
            folder.display()
        ));
    }
    Ok(())
}

/// Reason that something was not written.
#[derive(Debug)]
pub enum Stopped {
    /// The output could not be written.
    Writing(io::Error),
    /// The command failed, so that there was nothing to write.
    Failed(Failure),
}

impl From<io::Error> for Stopped {
    fn from(error: io::Error) -> Self {
        Stopped::Writing(error)
    }
}

impl From<Failure> for Stopped {
    fn from(failure: Failure) -> Self {
        Stopped::Failed(failure)
    }
}

impl From<TableError> for Stopped {
    fn from(error: TableError) -> Self {
        Stopped::Failed(Failure::input(error))
    }
}

impl From<PlanError> for Stopped {
    fn from(error: PlanError) -> Self {
        Stopped::Failed(error.into())
    }
}

impl Stopped {
    fn writing(self, what: &str) -> Failure {
        match self {
            Stopped::Writing(error) => Failure::writing(what, &error),
            Stopped::Failed(failure) => failure,
        }
    }
}

/// Writes one file aside; a failure names it.
pub(crate) fn stage<E: Into<Stopped>>(
    files: &mut StagedFiles,
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), Failure> {
    files
        .stage(path, |out| write(out).map_err(Into::<Stopped>::into))
        .map_err(|stopped| stopped.writing(&path.display().to_string()))
}

fn written<E: Into<Stopped>>(
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    out: &mut impl Write,
) -> Result<(), Stopped> {
    write(out).map_err(Into::into)?;
    out.flush().map_err(Into::into)
}

/// Returns the bytes read from `source` as text, without a byte-order mark; `what` names the expected content.
///
/// # Errors
/// [`Failure::Input`] that names the first line that is not UTF-8.
pub fn utf8<'b>(bytes: &'b [u8], source: &str, what: &str) -> Result<&'b str, Failure> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
        Failure::Input(format!("{source}, line {line}: not UTF-8 text; save the {what} as UTF-8"))
    })?;
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

/// Makes the folder that `option` names, where there is none.
///
/// # Errors
/// [`Failure::Input`] where a file has its name; [`Failure::System`] that names the folder.
pub fn make_folder(option: &str, folder: &Path) -> Result<(), Failure> {
    if folder.is_file() {
        return Err(Failure::Input(format!(
            "{option} {}: results go into a folder, and this is a file; name a folder",
            folder.display()
        )));
    }
    std::fs::create_dir_all(folder).map_err(|error| Failure::writing(&folder.display().to_string(), &error))
}

/// Refuses a folder that could not be made or written to, before anything is computed for it.
///
/// # Errors
/// [`Failure::System`] that names the folder.
pub fn check_writable(folder: &Path) -> Result<(), Failure> {
    let there = folder.ancestors().find(|ancestor| ancestor.exists() && !ancestor.as_os_str().is_empty());
    tempfile::tempfile_in(there.unwrap_or(Path::new(".")))
        .map(drop)
        .map_err(|error| Failure::writing(&folder.display().to_string(), &error))
}

/// The folders that the files of a scene go to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// All in one folder, as `run` has them.
    Flat,
    /// The report, the scene and the summary above the folders `figures` and `data`.
    Folders,
}

impl Layout {
    /// The folder of tables.
    fn tables(self) -> &'static str {
        match self {
            Layout::Flat => "",
            Layout::Folders => "data",
        }
    }

    /// The place of a file by its name.
    fn place(self, name: &str) -> String {
        let folder = match Path::new(name).extension().and_then(OsStr::to_str) {
            Some("svg" | "png" | "pdf" | "py") => "figures/",
            Some("csv" | "json") if name != ANSWER => "data/",
            _ => "",
        };
        match self {
            Layout::Flat => name.to_owned(),
            Layout::Folders => format!("{folder}{name}"),
        }
    }
}

/// The files in a folder that a run replaces or removes: those of its products, and tables and figures of earlier runs.
/// None of them may be an input.
///
/// # Errors
/// [`Failure::System`] if the folder cannot be read.
pub fn replaced_files(products: &[String], folder: &Path, layout: Layout) -> Result<Vec<PathBuf>, Failure> {
    let mut names: Vec<String> = products.iter().map(|name| layout.place(name)).collect();
    if layout == Layout::Folders {
        names.extend(TEXTS.map(str::to_owned));
    }
    for (table, _) in stale_tables(folder, layout, &names)? {
        for name in with_figure(&table, layout) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    Ok(names.iter().map(|name| folder.join(name)).filter(|path| path.exists()).collect())
}

/// The texts beside the report of a scene in folders.
const TEXTS: [&str; 2] = ["summary.txt", "scene.toml"];

/// The places of a table and of the figures of its name. A script may be the user's own, except in a folder for figures.
fn with_figure(table: &str, layout: Layout) -> Vec<String> {
    let of_layout: &[&str] = if layout == Layout::Folders { &["py"] } else { &[] };
    let endings = ["csv", "svg", "png", "pdf"].iter().chain(of_layout);
    let names = endings.map(|ending| Path::new(table).with_extension(ending));
    names.map(|name| layout.place(&name.to_string_lossy())).collect()
}

/// Writes every file of a scene into a folder, all of them or none; yields their names.
///
/// # Errors
/// [`Failure::System`] that names the path.
pub fn write_products(
    products: &SceneProducts<'_>,
    summary: &str,
    format: Format,
    folder: &Path,
    layout: Layout,
) -> Result<Vec<String>, Failure> {
    let mut files = StagedFiles::default();
    if layout == Layout::Folders {
        for inner in ["figures", "data"] {
            make_folder("--out", &folder.join(inner))?;
        }
    }
    let place = |name: &str| folder.join(layout.place(name));
    let mut svgs: Vec<(String, Vec<u8>)> = Vec::new();
    let mut names = products.each_file(format, |name, content| {
        if let Some(figure) = name.strip_suffix(".svg") {
            let mut svg = Vec::new();
            content(&mut svg).map_err(|error| Failure::writing(name, &error))?;
            svgs.push((figure.to_owned(), svg));
            return Ok(());
        }
        stage(&mut files, &place(name), |out| content(out))
    })?;
    for (figure, svg) in &svgs {
        for name in pictures_of(products.evidence.scene, figure) {
            let picture = place(&name).to_string_lossy().parse::<Picture>().map_err(Failure::input)?;
            let svg = String::from_utf8_lossy(svg).into_owned();
            let bytes = picture.bytes(svg).map_err(Failure::input)?;
            stage(&mut files, &picture.path, |out| out.write_all(&bytes))?;
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    let mut names: Vec<String> = names.iter().map(|name| layout.place(name)).collect();
    if layout == Layout::Folders {
        for (name, text) in TEXTS.into_iter().zip([summary, products.evidence.scene.text.as_str()]) {
            stage(&mut files, &folder.join(name), |out| out.write_all(text.as_bytes()))?;
            names.push(name.to_owned());
        }
    }
    publish(files)?;
    Ok(names)
}

/// The files of a figure of a scene that are made from its SVG document.
fn pictures_of(scene: &Scene, name: &str) -> Vec<String> {
    let figure = scene.figures.iter().find(|figure| figure.name == name);
    let formats = figure.map_or(&[PictureFormat::Svg][..], |figure| &figure.formats);
    let drawn = formats.iter().filter(|format| **format != PictureFormat::Script);
    drawn.map(|format| format!("{name}.{}", format.extension())).collect()
}

/// Tables in a folder of results that a run does not replace, with the title of the scene that each is of. Figures go
/// with their tables.
fn stale_tables(folder: &Path, layout: Layout, written: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let reading = |error: io::Error| Failure::System(format!("reading {}: {error}", folder.display()));
    let mut tables = Vec::new();
    let of_tables = folder.join(layout.tables());
    if !of_tables.is_dir() {
        return Ok(tables);
    }
    for entry in std::fs::read_dir(of_tables).map_err(reading)? {
        let name = entry.map_err(reading)?.file_name().to_string_lossy().into_owned();
        let place = layout.place(&name);
        if name.ends_with(".csv") && !written.contains(&place) {
            let mut start = Vec::new();
            let file = std::fs::File::open(folder.join(place)).map_err(reading)?;
            io::Read::read_to_end(&mut io::Read::take(file, 1024), &mut start).map_err(reading)?;
            tables.extend(
                scene_of_table(&String::from_utf8_lossy(&start)).map(|title| (name, title.to_owned())),
            );
        }
    }
    tables.sort();
    Ok(tables)
}

/// The title of the scene that a table is of, by the line that begins its provenance.
fn scene_of_table(text: &str) -> Option<&str> {
    let line = text.lines().next()?.strip_prefix("# truearea ")?;
    let (_, rest) = line.split_once(": scene \"")?;
    [", curve ", ", figure ", ", table "]
        .iter()
        .find_map(|kind| rest.split_once(&format!("\"{kind}")))
        .map(|(title, _)| title)
}

/// Refuses a folder with tables of another scene that a run of this one would leave beside its own.
///
/// # Errors
/// [`Failure::Input`] that names one of them.
pub fn refuse_other_scenes(folder: &Path, written: &[String], title: &str) -> Result<(), Failure> {
    let stale = stale_tables(folder, Layout::Flat, written)?;
    match stale.iter().find(|(_, other)| other != title) {
        None => Ok(()),
        Some((table, other)) => Err(Failure::Input(format!(
            "--out {}: {table} is of another scene, \"{other}\"; name another folder, or delete it",
            folder.display()
        ))),
    }
}

/// Removes the tables and figures of earlier runs that are none of those just written, of the scene with this title or
/// of any; yields their names.
///
/// # Errors
/// [`Failure::System`] that names the folder.
pub fn clear_earlier_runs(
    folder: &Path,
    layout: Layout,
    written: &[String],
    title: Option<&str>,
) -> Result<Vec<String>, Failure> {
    let mut removed = Vec::new();
    for (table, _) in stale_tables(folder, layout, written)?
        .into_iter()
        .filter(|(_, other)| title.is_none_or(|title| other == title))
    {
        for name in with_figure(&table, layout) {
            if !written.contains(&name) && std::fs::remove_file(folder.join(&name)).is_ok() {
                removed.push(name);
            }
        }
    }
    Ok(removed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.csv");
        std::fs::write(&path, "old").unwrap();
        let place = Place::File(path.clone());
        let failed = place.write(|out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(matches!(failed, Err(Failure::System(message)) if message.ends_with("table.csv: no more")));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        place.write(|out| out.write_all(b"new")).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "new");
    }

    #[test]
    fn tables_of_other_scenes_are_refused_and_those_of_earlier_runs_removed() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        write("old.csv", "# truearea 0.1.0: scene \"a, \"b\"\", curve old\nx\n1\n");
        write("old.svg", "<svg/>");
        write("old.py", "mine");
        write("kept.csv", "# truearea 0.1.0: scene \"other\", table kept\n");
        write("mine.csv", "x\n1\n");
        let written = ["kept.csv".to_owned()];
        assert!(refuse_other_scenes(folder.path(), &written, "a, \"b\"").is_ok());
        assert!(matches!(refuse_other_scenes(folder.path(), &written, "c"), Err(Failure::Input(_))));
        assert!(matches!(refuse_other_scenes(folder.path(), &[], "a, \"b\""), Err(Failure::Input(_))));
        let removed = clear_earlier_runs(folder.path(), Layout::Flat, &written, Some("a, \"b\"")).unwrap();
        assert_eq!(removed, ["old.csv", "old.svg"]);
        assert!(["kept.csv", "mine.csv", "old.py"].iter().all(|name| folder.path().join(name).is_file()));
        for inner in ["data", "figures"] {
            std::fs::create_dir(folder.path().join(inner)).unwrap();
        }
        write("data/old.csv", "# truearea 0.1.0: scene \"a\", curve old\n");
        write("figures/old.svg", "<svg/>");
        write("figures/old.py", "nan");
        let removed = clear_earlier_runs(folder.path(), Layout::Folders, &written, None).unwrap();
        assert_eq!(removed, ["data/old.csv", "figures/old.svg", "figures/old.py"]);
        assert!(folder.path().join("kept.csv").is_file());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_permissions_are_those_of_new_files() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real.csv"), folder.path().join("link.csv"));
        std::fs::write(&real, "old").unwrap();
        std::os::unix::fs::symlink(&real, &link).unwrap();
        Place::File(link.clone()).write(|out| out.write_all(b"new")).unwrap();
        assert_eq!(std::fs::read_to_string(&real).unwrap(), "new");
        assert!(link.is_symlink());
        let plain = folder.path().join("plain");
        std::fs::write(&plain, "").unwrap();
        let mode = |path: &Path| path.metadata().unwrap().permissions().mode();
        assert_eq!(mode(&real), mode(&plain));
    }
}
