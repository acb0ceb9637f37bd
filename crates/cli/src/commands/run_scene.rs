//! `run`: everything a scene asks for.

use std::path::{Path, PathBuf};

use super::{Context, compute, say_notes};
use crate::answer::Answer;
use crate::args::RunArgs;
use crate::explain::explain;
use crate::failure::Failure;
use crate::output::{Place, utf8};
use crate::plan::PlanError;
use crate::products::{self, Findings};
use crate::scene::Scene;
use crate::summary::summary;
use crate::timings::Timings;

pub(super) fn run(args: &RunArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let scene = read(&args.scene, context)?;
    timings.lap("reading");
    say_notes(scene.surface.notes.iter().cloned());
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
    let written = products::write(&scene, &results, findings.as_ref(), context.shared.format, &folder)?;
    timings.lap("writing");
    let files = format!("\n{} files in {}: {}\n", written.len(), folder.display(), written.join(", "));
    let answer = findings.map_or_else(|| Answer::of(&scene, &results), |findings| findings.answer);
    print(&format!("{}{files}", summary(&scene, &results, &answer)), context)?;
    timings.report(context.shared.timings);
    Ok(())
}

fn read(place: &Place, context: &Context<'_>) -> Result<Scene, Failure> {
    let (name, folder) = match place {
        Place::Standard => ("standard input".to_owned(), Path::new("")),
        Place::File(path) => (path.display().to_string(), path.parent().unwrap_or(Path::new(""))),
    };
    let bytes = place.read()?;
    Scene::parse(utf8(&bytes, &name, "scene")?, &name, folder, &context.overrides()?)
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
