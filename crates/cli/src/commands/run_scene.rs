//! `run`: everything a scene asks for.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use chrono::{DateTime, Utc};

use super::material_options::counterface;
use super::{Context, compute, refuse_idle_cutoff, say_notes, say_surface};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::interruption::{self, EarlyEnd};
use crate::output::{Place, make_folder, utf8};
use crate::progress::{Progress, UntilEnded};
use crate::targets::Targets;
use crate::timings::Timings;
use crate::{output, scene_errors};
use answer::Answer;
use judge::{JudgeError, JudgePlan, Judgement, Settings};
use report::explain::explain;
use report::occasion::Occasion;
use report::products::{self, Findings, Parts};
use report::reasons::reasons;
use report::scene_note_words;
use report::summary::summary;
use report::trust::Trust;
use report::uncertainty_words;
use study::models::{Choice, CurveModel};
use study::plan::{PlanError, Results};
use study::scene::{Overrides, Scene};
use uncertainty::{Uncertainty, UncertaintyPlan, scattering_groups};

pub(super) fn run(args: &RunArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.scene));
    let scene = read(args, &folder, context)?;
    timings.lap("reading");
    say_surface(&scene.surface);
    say_notes(scene.notes.iter().map(scene_note_words::line));
    if args.dry_run {
        return print(&explain(&scene), context);
    }
    let blame = |error| failed(args, error);
    let results = compute(&scene.plan()).map_err(blame)?;
    timings.lap("computing");
    if args.explain {
        let answer = Answer::of(&scene, &results);
        return print(&format!("{}\n{}", explain(&scene), reasons(&scene, &results, &answer)), context);
    }
    let findings = match args.no_report {
        true => None,
        false => {
            let found = Findings::of(&scene, &results).map_err(blame)?;
            Some(found.on(Occasion { date: Some(now()), asked: Some(context.typed.to_owned()) }))
        }
    };
    timings.lap("comparing");
    let judgement = judgement(args, &scene, &results)?;
    timings.lap("judging");
    let uncertainty = uncertainty(args, &scene, &results)?;
    if uncertainty.is_some() {
        timings.lap("drawing");
    }
    let trust = Trust { judgement: judgement.as_ref(), uncertainty: uncertainty.as_ref() };
    make_folder("--out", &folder)?;
    let written =
        output::write_products(&scene, &results, findings.as_ref(), trust, context.shared.format, &folder)?;
    timings.lap("writing");
    let mut files = format!("\n{} files in {}: {}\n", written.len(), folder.display(), written.join(", "));
    let others = output::other_files(&folder, &written)?;
    if !others.is_empty() {
        files += &format!("not of this run, and left there: {}\n", others.join(", "));
    }
    let answer = findings.map_or_else(|| Answer::of(&scene, &results), |findings| findings.answer);
    print(&format!("{}{files}", summary(&scene, &results, &answer, trust)), context)?;
    timings.report(context.shared.timings);
    match uncertainty.filter(|found| found.ended_early) {
        None => Ok(()),
        Some(found) => Err(Failure::EndedEarly(uncertainty_words::ended_early(&found))),
    }
}

/// A plan that was not carried out is the scene's fault, or nobody's.
fn failed(args: &RunArgs, error: PlanError) -> Failure {
    match error {
        PlanError::Cancelled => Failure::Interrupted,
        error => Failure::Input(format!("{}: {error}", args.scene)),
    }
}

/// Whether boundary elements are asked: a report has their verdict, and so has a scene that has a section for it.
fn is_judged(args: &RunArgs, scene: &Scene) -> bool {
    let off = scene.judge.as_ref().is_some_and(|choices| choices.off);
    !off && (!args.no_report || scene.judge.is_some())
}

/// What boundary elements say of the curves, where they are asked.
fn judgement(args: &RunArgs, scene: &Scene, results: &Results) -> Result<Option<Judgement>, Failure> {
    if !is_judged(args, scene) {
        return Ok(None);
    }
    let settings = Settings::of(scene.judge.as_ref());
    let blame = |error: JudgeError| Failure::Input(format!("{}: {error}", args.scene));
    let plan = JudgePlan::of(scene, results, &settings);
    let progress = Progress::towards(plan.solutions(), "surfaces pressed");
    let judgement = plan.carry_out(&progress).map_err(blame)?;
    if interruption::is_asked_for() {
        return Err(Failure::Interrupted);
    }
    Ok(Some(judgement))
}

/// Whether draws are made: a report has intervals where something of the scene scatters, and so has a scene that has a section
/// for them.
fn is_drawn(args: &RunArgs, scene: &Scene) -> bool {
    let off = scene.uncertainty.as_ref().is_some_and(|choices| choices.off);
    !off && (!args.no_report || scene.uncertainty.is_some()) && !scattering_groups(scene).is_empty()
}

/// What draws say of the areas, where some are made. From here on the first Ctrl-C ends no more than them.
fn uncertainty(args: &RunArgs, scene: &Scene, results: &Results) -> Result<Option<Uncertainty>, Failure> {
    if !is_drawn(args, scene) {
        return Ok(None);
    }
    let settings = uncertainty::Settings::of(scene.uncertainty.as_ref());
    let Some(plan) = UncertaintyPlan::of(scene, results, &settings) else { return Ok(None) };
    let early_end = EarlyEnd::allow();
    let progress = UntilEnded { progress: Progress::towards(plan.steps(), "draws"), early_end: &early_end };
    plan.carry_out(&progress).map(Some).map_err(|error| failed(args, error))
}

/// Reads the scene and its files, and refuses what is wrong with the call: results that would replace one of them, and
/// options that say nothing.
fn read(args: &RunArgs, folder: &Path, context: &Context<'_>) -> Result<Scene, Failure> {
    let targets = context.targets(None)?;
    let writes_files = !args.dry_run && !args.explain;
    if writes_files && folder.is_file() {
        make_folder("--out", folder)?;
    }
    targets.spare_place(&args.scene)?;
    let (name, files) = match &args.scene {
        Place::Standard => ("standard input".to_owned(), Folder::current(targets)),
        Place::File(path) => (path.display().to_string(), Folder::of(path, targets)),
    };
    let bytes = args.scene.read()?;
    let text = utf8(&bytes, &name, "scene")?;
    let scene = Scene::parse(text, &files, &overrides(args)?)
        .map_err(|error| Failure::Input(scene_errors::drawn(&error, text, &name)))?;
    if writes_files && folder.is_dir() {
        let mut results = Targets::default();
        let (judgement, uncertainty) = (is_judged(args, &scene), is_drawn(args, &scene));
        let parts = Parts { report: !args.no_report, judgement, uncertainty };
        for name in products::file_names(&scene, parts, context.shared.format) {
            results = results.with_file("--out", &folder.join(name))?;
        }
        results.spare_place(&args.scene)?;
        files.spare_from(&results)?;
    }
    refuse_idle_options(args, &scene)?;
    Ok(scene)
}

fn overrides(args: &RunArgs) -> Result<Overrides, Failure> {
    Ok(Overrides {
        normalisation: args.normalisation.normalisation,
        amplitude: args.amplitude.amplitude,
        scales_per_decade: args.sampling.scales_per_decade,
        hardness: args.hardness.hardness,
        strength_cap: args.strength_cap.strength_cap,
        cutoff: args.sampling.cutoff,
        counterface: counterface(&args.counterface)?,
        no_judge: args.no_judge,
        no_uncertainty: args.no_uncertainty,
    })
}

/// Refuses options that nothing in the scene has a use for.
fn refuse_idle_options(args: &RunArgs, scene: &Scene) -> Result<(), Failure> {
    refuse_idle_cutoff(args.sampling.cutoff.map(|cutoff| cutoff.m), &scene.surface)?;
    let any_curve = |has: fn(&CurveModel) -> bool| scene.needs.curves.iter().any(|curve| has(&curve.model));
    let idle = [
        ("--normalisation", args.normalisation.normalisation.is_some(), scene.needs.moments.is_some()),
        ("--amplitude", args.amplitude.amplitude.is_some(), scene.needs.amplitudes.is_some()),
        ("--hardness", args.hardness.hardness.is_some(), any_curve(has_spheres_that_yield)),
        ("--strength-cap", args.strength_cap.strength_cap.is_some(), any_curve(has_growing_strength)),
    ];
    match idle.iter().find(|(_, given, used)| *given && !used) {
        None => Ok(()),
        Some((option, ..)) => Err(Failure::Input(format!(
            "{option} has no bearing on {}: none of its curves and figures depends on it; leave it out",
            args.scene
        ))),
    }
}

fn has_spheres_that_yield(model: &CurveModel) -> bool {
    model.entry().has(Choice::Hardness)
}

fn has_growing_strength(model: &CurveModel) -> bool {
    model.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some())
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
