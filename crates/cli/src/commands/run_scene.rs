//! `run`: everything a scene asks for.

use std::path::PathBuf;
use std::time::SystemTime;

use chrono::{DateTime, Utc};

use super::{Context, compute, say_surface};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, utf8};
use crate::timings::Timings;
use crate::{output, scene_errors};
use report::explain::explain;
use report::products::{Findings, Occasion};
use report::summary::summary;
use study::answer::Answer;
use study::plan::PlanError;
use study::scene::Scene;

pub(super) fn run(args: &RunArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let scene = read(&args.scene, context)?;
    timings.lap("reading");
    say_surface(&scene.surface);
    if args.explain {
        return print(&explain(&scene), context);
    }
    let blame = |error: &PlanError| Failure::Input(format!("{}: {error}", args.scene));
    let results = compute(&scene.plan()).map_err(|error| blame(&error))?;
    timings.lap("computing");
    let findings = match args.no_report {
        true => None,
        false => {
            let found = Findings::of(&scene, &results).map_err(|error| blame(&error))?;
            Some(found.on(Occasion { date: Some(now()), asked: Some(context.typed.to_owned()) }))
        }
    };
    timings.lap("judging");
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.scene));
    let written =
        output::write_products(&scene, &results, findings.as_ref(), context.shared.format, &folder)?;
    timings.lap("writing");
    let files = format!("\n{} files in {}: {}\n", written.len(), folder.display(), written.join(", "));
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

/// The date and time of day, in universal time.
fn now() -> String {
    DateTime::<Utc>::from(SystemTime::now()).format("%Y-%m-%d %H:%M UTC").to_string()
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
