//! `run`: everything a scene asks for.

use std::path::PathBuf;

use super::{Context, compute, say_notes};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, utf8};
use crate::timings::Timings;
use crate::{output, scene_errors};
use report::explain::explain;
use report::products::Findings;
use report::scene_note_words;
use report::summary::summary;
use study::answer::Answer;
use study::plan::PlanError;
use study::scene::Scene;

pub(super) fn run(args: &RunArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let scene = read(&args.scene, context)?;
    timings.lap("reading");
    say_notes(scene.surface.notes.iter().cloned());
    say_notes(scene.notes.iter().map(scene_note_words::line));
    if args.explain {
        return print(&explain(&scene), context);
    }
    let blame = |error: &PlanError| Failure::Input(format!("{}: {error}", args.scene));
    let results = compute(&scene.plan()).map_err(|error| blame(&error))?;
    timings.lap("computing");
    let findings = match args.no_report {
        true => None,
        false => Some(Findings::of(&scene, &results).map_err(|error| blame(&error))?),
    };
    timings.lap("judging");
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.scene));
    let written =
        output::write_products(&scene, &results, findings.as_ref(), context.shared.format, &folder)?;
    timings.lap("writing");
    let mut files = format!("\n{} files in {}: {}\n", written.len(), folder.display(), written.join(", "));
    let others = output::other_files(&folder, &written)?;
    if !others.is_empty() {
        files += &format!("not of this run, and left there: {}\n", others.join(", "));
    }
    let answer = findings.map_or_else(|| Answer::of(&scene, &results), |findings| findings.answer);
    print(&format!("{}{files}", summary(&scene, &results, &answer)), context)?;
    timings.report(context.shared.timings);
    Ok(())
}

fn read(place: &Place, context: &Context<'_>) -> Result<Scene, Failure> {
    let (name, files) = match place {
        Place::Standard => ("standard input".to_owned(), Folder::current()),
        Place::File(path) => (path.display().to_string(), Folder::of(path)),
    };
    let bytes = place.read()?;
    let text = utf8(&bytes, &name, "scene")?;
    Scene::parse(text, &files, &context.overrides()?)
        .map_err(|error| Failure::Input(scene_errors::drawn(&error, text, &name)))
}

fn default_folder(scene: &Place) -> PathBuf {
    let stem = match scene {
        Place::Standard => None,
        Place::File(path) => path.file_stem(),
    };
    PathBuf::from(format!("{}-results", stem.map_or("scene".into(), |stem| stem.to_string_lossy())))
}

fn print(text: &str, context: &Context<'_>) -> Result<(), Failure> {
    context.shared.output.write(|out| out.write_all(text.as_bytes()))
}
