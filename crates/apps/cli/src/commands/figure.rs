//! `figure`: the figures of a scene as files for publication.

use std::path::{Path, PathBuf};

use questions::{RunOptions, run_scene};
use report::products;
use scene::{Overrides, Scene};
use study::figure::{Figure, PictureFormat, Shows};
use tables::staging::StagedFiles;

use super::Context;
use super::run_scene::{Watching, failed};
use crate::args::FigureFilesArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, make_folder, publish, stage, utf8};
use crate::picture::Picture;
use crate::targets::Targets;
use crate::timings::Timings;

pub(super) fn run(args: &FigureFilesArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let path = scene_file(&args.scene)?;
    let folder = Folder::of(&path, Targets::default());
    let mut scene = read(&path, &folder)?;
    scene
        .choose_figures(&args.choice())
        .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
    let files = files(&scene, args)?;
    let targets = files.iter().flatten().try_fold(Targets::default(), |targets, file| {
        // A folder that is still to be made holds nothing to spare.
        if args.out.is_dir() { targets.with_file("--out", file.path()) } else { Ok(targets) }
    })?;
    targets.spare_place(&Place::File(path))?;
    folder.spare_from(&targets)?;
    timings.lap("reading");
    let watching = Watching::new(timings);
    let outcome = run_scene(&scene, options(&scene), &watching).map_err(failed)?;
    let mut timings = watching.into_timings();
    make_folder("--out", &args.out)?;
    let mut staged = StagedFiles::default();
    let mut names = Vec::new();
    let drawn = products::figure_documents(&scene, &outcome.results, outcome.uncertainty.as_ref());
    for (files, figure) in files.iter().zip(drawn) {
        let svg = figure.svg();
        for file in files {
            let bytes = match file {
                FigureFile::Script(_) => figure.script().into_bytes(),
                FigureFile::Picture(picture) => picture.bytes(svg.clone()).map_err(Failure::input)?,
            };
            stage(&mut staged, file.path(), |out| out.write_all(&bytes))?;
            names.push(file.path().display().to_string());
        }
    }
    publish(staged)?;
    timings.lap("writing");
    context.shared.output.write(|out| writeln!(out, "{}", names.join("\n")))?;
    timings.report(context.shared.timings);
    Ok(())
}

/// The scene of a folder that `report` made, or the scene itself.
fn scene_file(given: &Path) -> Result<PathBuf, Failure> {
    let inside = given.join("scene.toml");
    match given.is_dir() {
        true if inside.is_file() => Ok(inside),
        true => Err(Failure::Input(format!("{}: no scene.toml here; name the scene file", given.display()))),
        false => Ok(given.to_owned()),
    }
}

fn read(path: &Path, folder: &Folder) -> Result<Scene, Failure> {
    let name = path.display().to_string();
    let bytes = Place::File(path.to_owned()).read()?;
    let text = utf8(&bytes, &name, "scene")?;
    Scene::parse(text, folder, &Overrides::default())
        .map_err(|error| Failure::Input(report::scene_errors::drawn(&error, text, &name)))
}

/// A file of a figure.
enum FigureFile {
    Picture(Picture),
    /// A Python script that draws it.
    Script(PathBuf),
}

impl FigureFile {
    fn path(&self) -> &Path {
        match self {
            FigureFile::Picture(picture) => &picture.path,
            FigureFile::Script(path) => path,
        }
    }
}

/// The files of each figure.
fn files(scene: &Scene, args: &FigureFilesArgs) -> Result<Vec<Vec<FigureFile>>, Failure> {
    let file = |name: &str, ending: &str| {
        let path = args.out.join(format!("{name}.{ending}"));
        if ending == PictureFormat::Script.extension() {
            return Ok(FigureFile::Script(path));
        }
        path.to_string_lossy().parse().map(FigureFile::Picture).map_err(Failure::input)
    };
    let files_of = |figure: &Figure| match args.picture.is_empty() {
        true => figure.formats.iter().map(|format| file(&figure.name, format.extension())).collect(),
        false => args.picture.iter().map(|ending| file(&figure.name, ending)).collect(),
    };
    scene.figures.iter().map(files_of).collect()
}

/// Figures show no verdicts. They show intervals if they show areas, as those of `run` do.
fn options(scene: &Scene) -> RunOptions {
    let shows_areas = |shows| matches!(shows, Shows::Area | Shows::AreaAgainstLoad);
    let of_run = RunOptions { report: true, judge: None, uncertainty: None };
    let is_drawn = of_run.is_drawn(scene) && scene.figures.iter().any(|figure| shows_areas(figure.shows));
    RunOptions { report: false, judge: Some(false), uncertainty: Some(is_drawn) }
}
