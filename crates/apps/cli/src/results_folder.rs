//! Record of the files in a folder of results, so that only those are replaced or removed that the program wrote itself.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::File;
use std::path::{Path, PathBuf};

use report::products::{ANSWER, SceneProducts};
use scene::Scene;
use sha2::{Digest, Sha256};
use study::figure::PictureFormat;
use tables::Format;
use tables::staging::{StagedFiles, resolve};

use crate::failure::Failure;
use crate::inputs::spare_inputs;
use crate::output::{make_folder, publish, stage};
use crate::picture::Picture;
use crate::place::Place;
use crate::targets::Targets;
use units::printable::{hexadecimal, printable};

/// Name of the record.
const RECORD: &str = ".truearea-files";

/// Name of the lines for inputs in the record; no file has it.
const INPUTS: &str = ".";

/// Its first line.
const HEADING: &str =
    "# SHA-256 of the inputs and of each file that truearea wrote here; it replaces no other file";

/// A folder of results, and the files that the program wrote there.
#[derive(Debug)]
pub(crate) struct ResultsFolder<'f> {
    pub folder: &'f Path,
    /// True if the file in place of the record is one.
    is_record: bool,
    /// SHA-256 of what tells results apart: a title, and the paths of inputs seen from the folder.
    identities: BTreeSet<String>,
    /// Identities of the results that the record lists.
    earlier: BTreeSet<String>,
    /// SHA-256 and name of each file as it was written.
    written: BTreeSet<(String, String)>,
}

impl<'f> ResultsFolder<'f> {
    /// Opens a folder, which need not exist, for results that each of these titles and inputs tells apart from others.
    pub fn open<'t>(folder: &'f Path, identities: impl IntoIterator<Item = (&'t str, Vec<PathBuf>)>) -> Self {
        let from = resolve(folder);
        let identity = |(title, paths): (&str, Vec<PathBuf>)| {
            let seen = paths.iter().map(|path| {
                let path = resolve(path);
                pathdiff::diff_paths(&path, &from).unwrap_or(path).to_string_lossy().into_owned()
            });
            digest(std::iter::once(title.to_owned()).chain(seen).collect::<Vec<_>>().join("\n").as_bytes())
        };
        let identities = identities.into_iter().map(identity).collect();
        let text = std::fs::read_to_string(folder.join(RECORD)).unwrap_or_default();
        let lines = text.lines().filter_map(|line| line.split_once("  "));
        let (earlier, written): (Vec<_>, Vec<_>) = lines.partition(|(_, name)| *name == INPUTS);
        ResultsFolder {
            folder,
            is_record: text.starts_with(HEADING),
            identities,
            earlier: earlier.into_iter().map(|(digest, _)| digest.to_owned()).collect(),
            written: written.into_iter().map(|(digest, name)| (digest.to_owned(), name.to_owned())).collect(),
        }
    }

    /// Files of earlier runs as they were written.
    pub fn own(&self) -> BTreeSet<&str> {
        let is_own = |(digest, name): &&(String, String)| self.digest_of(name).as_ref() == Some(digest);
        self.written.iter().filter(is_own).map(|(_, name)| name.as_str()).collect()
    }

    /// Refuses to replace or remove an input, a file that the program did not write or that has been edited, and results
    /// of other inputs.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file.
    pub fn refuse(&self, names: &[String]) -> Result<(), Failure> {
        let folder = self.folder.display();
        let _alone = self.alone();
        let now = ResultsFolder::open(self.folder, []);
        let own = now.own();
        let in_folder = |name| Place::File(self.folder.join(name));
        let names = names.iter().map(String::as_str).chain([RECORD]);
        let names = || names.clone().filter(|name| self.folder.join(name).exists());
        let is_record = |name: &str| name == RECORD && now.is_record;
        let touched = names().chain(own.iter().copied()).collect::<BTreeSet<_>>();
        spare_inputs(&Targets::named("--out", touched.into_iter().map(in_folder))?)?;
        if let Some(name) = names().find(|name| !own.contains(name) && !is_record(name)) {
            return Err(Failure::Input(format!(
                "--out {folder}: {name} there is not as truearea wrote it; rename it, or name another folder"
            )));
        }
        if !own.is_empty() && now.earlier.is_disjoint(&self.identities) {
            return Err(Failure::Input(format!(
                "--out {folder}: the results there are of other files; name another folder, or delete it"
            )));
        }
        Ok(())
    }

    /// Publishes files in the folder, the record of them first, so that an end in between leaves no file unknown.
    ///
    /// # Errors
    /// Errors of [`stage`] and [`publish`].
    pub fn publish(&self, mut files: StagedFiles) -> Result<(), Failure> {
        let from = resolve(self.folder);
        let _alone = self.alone();
        // Another run may have written here in the meantime.
        let now = ResultsFolder::open(self.folder, []);
        let mut known: BTreeSet<(String, String)> =
            now.written.iter().filter(|(_, name)| now.own().contains(name.as_str())).cloned().collect();
        for (target, aside) in files.targets() {
            if let Ok(name) = target.strip_prefix(&from) {
                let bytes = std::fs::read(aside)
                    .map_err(|error| Failure::writing(&target.display().to_string(), &error))?;
                known.insert((digest(&bytes), name.to_string_lossy().into_owned()));
            }
        }
        let inputs = self.identities.iter().map(|identity| (identity.as_str(), INPUTS));
        let own = known.iter().map(|(digest, name)| (digest.as_str(), name.as_str()));
        let lines: String = inputs.chain(own).map(|(digest, name)| format!("{digest}  {name}\n")).collect();
        let record = self.folder.join(RECORD);
        stage(&mut files, &record, |out| out.write_all(format!("{HEADING}\n{lines}").as_bytes()))?;
        files.last_first();
        publish(files)
    }

    /// Locks the folder until the value is dropped, where the system locks folders, so that record and files belong together.
    fn alone(&self) -> Option<File> {
        let folder = File::open(self.folder).ok()?;
        folder.lock().ok().map(|()| folder)
    }

    fn digest_of(&self, name: &str) -> Option<String> {
        std::fs::read(self.folder.join(name)).ok().map(|bytes| digest(&bytes))
    }
}

fn digest(bytes: &[u8]) -> String {
    hexadecimal(Sha256::digest(bytes))
}

/// The folders that the files of a scene go to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Layout {
    /// All in one folder, as `run` has them.
    Flat,
    /// The report, the scene and the summary above the folders `figures` and `data`.
    Folders,
}

impl Layout {
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

/// The names of all files of a scene below its folder.
pub(crate) fn file_names(products: &[String], layout: Layout) -> Vec<String> {
    let texts = TEXTS.iter().filter(|_| layout == Layout::Folders).map(|name| (*name).to_owned());
    products.iter().map(|name| layout.place(name)).chain(texts).collect()
}

/// The texts beside the report of a scene in folders.
const TEXTS: [&str; 2] = ["summary.txt", "scene.toml"];

/// Writes every file of a scene into a folder, all of them or none; yields their names.
///
/// # Errors
/// [`Failure::System`] that names the path.
pub(crate) fn write_products(
    products: &SceneProducts<'_>,
    summary: &str,
    format: Format,
    results: &ResultsFolder<'_>,
    layout: Layout,
) -> Result<Vec<String>, Failure> {
    let folder = results.folder;
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
        for (name, text) in
            TEXTS.into_iter().zip([&printable(summary), products.evidence.scene.text.as_str()])
        {
            stage(&mut files, &folder.join(name), |out| out.write_all(text.as_bytes()))?;
            names.push(name.to_owned());
        }
    }
    results.publish(files)?;
    Ok(names)
}

/// The files of a figure of a scene that are made from its SVG document.
fn pictures_of(scene: &Scene, name: &str) -> Vec<String> {
    let figure = scene.figures.iter().find(|figure| figure.name == name);
    let formats = figure.map_or(&[PictureFormat::Svg][..], |figure| &figure.formats);
    let drawn = formats.iter().filter(|format| **format != PictureFormat::Script);
    drawn.map(|format| format!("{name}.{}", format.extension())).collect()
}

/// Removes the files of earlier runs that are none of those just written; returns their names.
///
/// # Errors
/// [`Failure::System`] that names the file.
pub(crate) fn remove_earlier(
    folder: &Path,
    earlier: &BTreeSet<String>,
    written: &[String],
) -> Result<Vec<String>, Failure> {
    let stale: Vec<String> = earlier.iter().filter(|name| !written.contains(name)).cloned().collect();
    for name in &stale {
        let path = folder.join(name);
        std::fs::remove_file(&path)
            .map_err(|error| Failure::System(format!("removing {}: {error}", path.display())))?;
    }
    Ok(stale)
}
