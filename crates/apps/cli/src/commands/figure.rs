//! `figure`: the figures of a scene as files for publication.

use std::path::{Path, PathBuf};

use questions::{RunOptions, run_scene};
use report::products;
use scene::{Overrides, Scene};
use study::figure::{Figure, PictureFormat};
use tables::Format;
use tables::staging::StagedFiles;

use super::Context;
use super::run_scene::{Watching, failed, read_scene};
use crate::args::FigureFilesArgs;
use crate::failure::Failure;
use crate::output::{make_folder, stage};
use crate::picture::Picture;
use crate::place::Place;
use crate::results_folder::ResultsFolder;
use crate::timings::Timings;

pub(super) fn run(args: &FigureFilesArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let path = scene_file(&args.scene)?;
    let mut scene = read_scene(&Place::File(path.clone()), &Overrides::default())?;
    scene
        .choose_figures(&args.choice())
        .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
    let files = files(&scene, args)?;
    let below = |file: &FigureFile| {
        file.path().strip_prefix(&args.out).map(|path| path.to_string_lossy().into_owned())
    };
    let names: Vec<String> = files.iter().flatten().filter_map(|file| below(file).ok()).collect();
    let results = ResultsFolder::open(&args.out, [("", vec![path])]);
    results.refuse(&names)?;
    timings.lap("reading");
    let watching = Watching::new(timings);
    let outcome = run_scene(&scene, options(&scene, args), &watching).map_err(failed)?;
    let mut timings = watching.into_timings();
    make_folder("--out", &args.out)?;
    let mut staged = StagedFiles::default();
    let mut names = Vec::new();
    let found = (outcome.evidence(&scene), &outcome.conclusions);
    let drawn = products::figure_documents(&scene, &outcome.results, Some(found));
    for (files, figure) in files.iter().zip(drawn) {
        let svg = figure.svg();
        for file in files {
            let bytes = match file {
                FigureFile::Script(_) => figure.script(Format::Csv).into_bytes(),
                FigureFile::Table(_) => {
                    let mut table = Vec::new();
                    figure
                        .write_table(Format::Csv, &mut table)
                        .map_err(|error| Failure::writing(&file.path().display().to_string(), &error))?;
                    table
                }
                FigureFile::Picture(picture) => picture.bytes(svg.clone()).map_err(Failure::input)?,
            };
            stage(&mut staged, file.path(), |out| out.write_all(&bytes))?;
            names.push(file.path().display().to_string());
        }
    }
    results.publish(staged)?;
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

/// A file of a figure.
enum FigureFile {
    Picture(Picture),
    /// A Python script that draws it.
    Script(PathBuf),
    /// The table that the script reads.
    Table(PathBuf),
}

impl FigureFile {
    fn path(&self) -> &Path {
        match self {
            FigureFile::Picture(picture) => &picture.path,
            FigureFile::Script(path) | FigureFile::Table(path) => path,
        }
    }
}

/// The files of each figure.
fn files(scene: &Scene, args: &FigureFilesArgs) -> Result<Vec<Vec<FigureFile>>, Failure> {
    let place = |name: &str, ending: &str| args.out.join(format!("{name}.{ending}"));
    let files = |name: &str, ending: &str| {
        let path = place(name, ending);
        if ending == PictureFormat::Script.extension() {
            let table = place(name, Format::Csv.extension());
            return Ok(vec![FigureFile::Script(path), FigureFile::Table(table)]);
        }
        let picture = path.to_string_lossy().parse().map_err(Failure::input)?;
        Ok(vec![FigureFile::Picture(picture)])
    };
    let files_of = |figure: &Figure| {
        let own = figure.formats.iter().map(|format| format.extension()).collect::<Vec<_>>();
        let chosen: Vec<&str> = args.picture.iter().map(String::as_str).collect();
        let endings = if chosen.is_empty() { own } else { chosen };
        let files: Result<Vec<_>, Failure> =
            endings.into_iter().map(|ending| files(&figure.name, ending)).collect();
        Ok(files?.into_iter().flatten().collect())
    };
    scene.figures.iter().map(files_of).collect()
}

/// Figures that show areas show boundary elements and intervals, as those of `run` do.
fn options(scene: &Scene, args: &FigureFilesArgs) -> RunOptions {
    let of_run = RunOptions { report: true, judge: args.no_judge.then_some(false), uncertainty: None };
    let has_areas = scene.figures.iter().any(|figure| figure.shows.draws_areas());
    RunOptions {
        report: false,
        judge: Some(has_areas && of_run.is_judged(scene)),
        uncertainty: Some(has_areas && of_run.is_drawn(scene)),
    }
}
