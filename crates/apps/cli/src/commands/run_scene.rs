//! `run`: everything a scene asks for.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use chrono::DateTime;

use super::{Context, say_all, say_notes};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::flags::Flags;
use crate::inputs::announce;
use crate::interruption::EarlyEnd;
use crate::output::{make_folder, utf8};
use crate::place::Place;
use crate::progress::{Progress, Unseen, UntilEnded};
use crate::results_folder::{Layout, ResultsFolder, remove_earlier, write_products};
use crate::targets::check_writable;
use crate::timings::Timings;
use questions::{Phase, RunError, RunOptions, Watch, run_scene};
use report::conclusion_words::{SummaryEnd, short_summary};
use report::details::details;
use report::dry_run::dry_run;
use report::products::{self, SceneProducts};
use report::run_stamp::RunStamp;
use report::uncertainty_words;
use scene::{FileContent, Overrides, Scene, SceneError, SceneProblem};
use units::{Remark, RemarkCode, RemarkLevel};

pub(super) fn run(args: &RunArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.scene));
    let scene = read(args, &folder, context)?;
    timings.lap("reading");
    if args.dry_run {
        say_scene(&scene, true);
        return context.print(&dry_run(&scene));
    }
    let scene_run = SceneRun {
        scene: &scene,
        results: results_folder(args, &scene, &folder),
        layout: Layout::Flat,
        options: options(args),
        verbose: args.verbose,
    };
    scene_run.run(timings, context).map_err(|error| match error {
        Failure::Input(message) => Failure::Input(format!("{}: {message}", args.scene)),
        error => error,
    })
}

/// Says the notes on a scene before anything of it is computed: all, or those on keys without effect alone.
fn say_scene(scene: &Scene, all: bool) {
    for note in
        scene.surface.notes.iter().chain(&scene.notes).filter(|note| all || note.code.is_on_idle_input())
    {
        say_all(std::slice::from_ref(note), &Flags);
    }
}

/// A scene that is run into a folder.
pub(super) struct SceneRun<'a> {
    pub scene: &'a Scene,
    pub results: ResultsFolder<'a>,
    pub layout: Layout,
    pub options: RunOptions,
    /// True to print what the summary leaves out.
    pub verbose: bool,
}

impl SceneRun<'_> {
    /// Runs the scene, writes its files, and prints the summary.
    pub fn run(&self, timings: Timings, context: &Context<'_>) -> Result<(), Failure> {
        let SceneRun { scene, ref results, layout, options, verbose } = *self;
        let folder = results.folder;
        say_scene(scene, verbose);
        let watching = Watching::new(timings);
        let outcome = run_scene(scene, options, &watching).map_err(failed)?;
        let mut timings = watching.into_timings();
        let run_stamp = RunStamp { date: Some(date()), command: Some(context.typed.to_owned()) };
        make_folder("--out", folder)?;
        let (evidence, conclusions) = (outcome.evidence(scene), &outcome.conclusions);
        let sensitivities = outcome.sensitivities.as_deref();
        let products = SceneProducts { evidence, conclusions, sensitivities, run_stamp: &run_stamp };
        let earlier: BTreeSet<String> = results.own().into_iter().map(str::to_owned).collect();
        let report = folder.join(products::REPORT);
        let report = options.report.then(|| report.display().to_string());
        let left_out = || scene.surface.notes.iter().filter(|note| !note.code.is_on_idle_input());
        let noted = [RemarkLevel::Caution, RemarkLevel::Note]
            .map(|level| left_out().filter(|note| note.level == level).count());
        let end = SummaryEnd {
            report: report.as_deref(),
            warnings: noted[0],
            notes: noted[1],
            verbose_option: "-v",
        };
        let short = short_summary(conclusions, scene, &end);
        // The summary beside the report tells of no folder of the machine.
        let name = folder.file_name().map_or_else(PathBuf::new, PathBuf::from);
        let beside = name.join(products::REPORT).display().to_string();
        let beside = SummaryEnd { report: end.report.map(|_| beside.as_str()), ..end };
        let beside = short_summary(conclusions, scene, &beside);
        let written = write_products(&products, &beside, context.shared.format(), results, layout)?;
        timings.lap("writing");
        let mut text = short;
        if verbose {
            text += &format!(
                "\n{}\n{} files in {}: {}\n",
                details(&evidence, conclusions),
                written.len(),
                folder.display(),
                written.join(", ")
            );
        }
        if earlier.iter().any(|name| written.contains(name)) {
            say_notes([format!("replaced the results of an earlier run in {}", folder.display())]);
        }
        let removed = remove_earlier(folder, &earlier, &written)?;
        if !removed.is_empty() {
            say_notes([format!(
                "removed from {}, of an earlier run: {}",
                folder.display(),
                removed.join(", ")
            )]);
        }
        context.print(&text)?;
        timings.report(context.shared.timings);
        match outcome.uncertainty.as_ref().filter(|found| found.ended_early) {
            None => Ok(()),
            Some(found) => Err(Failure::EndedEarly(uncertainty_words::ended_early(found))),
        }
    }
}

/// Converts the error of a run: an interruption, or an error in the scene.
pub(super) fn failed(error: RunError) -> Failure {
    match error {
        RunError::Cancelled => Failure::Interrupted,
        error => Failure::Input(error.to_string()),
    }
}

/// Returns the options of the run.
fn options(args: &RunArgs) -> RunOptions {
    RunOptions { report: !args.no_report, judge: None, uncertainty: None }
}

/// Progress bars, and the time that each phase takes. While draws are made, the first Ctrl-C ends no more than them.
pub(super) struct Watching {
    timings: RefCell<Timings>,
}

impl Watching {
    /// Watches the phases of a run from now on.
    pub fn new(timings: Timings) -> Self {
        Watching { timings: RefCell::new(timings) }
    }

    /// Returns the times so far.
    pub fn into_timings(self) -> Timings {
        self.timings.into_inner()
    }
}

impl Watch for Watching {
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn numerics::parallel::Progress + '_> {
        match phase {
            Phase::Computing | Phase::Judging => Box::new(Progress::towards(steps, phase.steps())),
            Phase::Comparing => Box::new(Unseen),
            Phase::Drawing => Box::new(UntilEnded {
                progress: Progress::towards(steps, phase.steps()),
                early_end: EarlyEnd::allow(),
            }),
        }
    }

    fn end(&self, phase: Phase) {
        self.timings.borrow_mut().lap(match phase {
            Phase::Computing => "computing",
            Phase::Comparing => "comparing",
            Phase::Judging => "judging",
            Phase::Drawing => "drawing",
        });
    }
}

/// Reads the scene and its files, and refuses what is wrong with the call: results that would replace one of them, and
/// options that say nothing.
fn read(args: &RunArgs, folder: &Path, context: &Context<'_>) -> Result<Scene, Failure> {
    let writes_files = !args.dry_run;
    if writes_files && folder.is_file() {
        make_folder("--out", folder)?;
    }
    if writes_files {
        check_writable(folder)?;
    }
    let mut scene = read_scene(&args.scene, &overrides(args)?)?;
    skip(args, &mut scene);
    if writes_files && folder.is_dir() {
        let written = products::file_names(&scene, options(args), context.shared.format());
        announce("--out", written.iter().map(|name| Place::File(folder.join(name))))?;
        results_folder(args, &scene, folder).refuse(&written)?;
    }
    refuse_idle_options(args, &scene)?;
    Ok(scene)
}

/// Reads a scene, and the files beside it.
pub(super) fn read_scene(place: &Place, overrides: &Overrides) -> Result<Scene, Failure> {
    let name = place.name();
    let files = match place {
        Place::Standard => Folder::current(),
        Place::File(path) => Folder::of(path),
    };
    let bytes = place.read()?;
    let text =
        utf8(&bytes, &name, "scene").map_err(|failure| not_a_scene(&bytes, &name).unwrap_or(failure))?;
    Scene::parse(text, &files, overrides)
        .map_err(|error| Failure::Input(report::scene_errors::drawn(&error, text, &name)))
}

/// Turns off the analyses that options skip, and names an option that finds nothing to skip.
fn skip(args: &RunArgs, scene: &mut Scene) {
    let is_drawn = if scene.scatters() { RemarkCode::UncertaintyIsOff } else { RemarkCode::NothingScatters };
    let skipped = [
        ("no_judge", args.no_judge, options(args).is_judged(scene), RemarkCode::JudgeIsOff),
        ("no_uncertainty", args.no_uncertainty, options(args).is_drawn(scene), is_drawn),
    ];
    for (option, _, _, code) in skipped.into_iter().filter(|(_, given, wanted, _)| *given && !wanted) {
        say_all(&[Remark::new(code).on(option)], &Flags);
    }
    if args.no_judge {
        scene.judge.get_or_insert_default().off = true;
    }
    if args.no_uncertainty {
        scene.uncertainty.get_or_insert_default().off = true;
    }
}

/// The folder of results of a scene, known by its file, or by its title and the files behind its surface.
fn results_folder<'f>(args: &RunArgs, scene: &Scene, folder: &'f Path) -> ResultsFolder<'f> {
    let (own, beside) = match &args.scene {
        Place::Standard => (None, Path::new("")),
        Place::File(path) => (Some(("", vec![path.clone()])), path.parent().unwrap_or(Path::new(""))),
    };
    let files = scene.surface.files().into_iter().map(|name| beside.join(name)).collect();
    ResultsFolder::open(folder, own.into_iter().chain([(scene.title.as_str(), files)]))
}

/// The failure of a binary file given in place of a scene, such as a scan.
fn not_a_scene(bytes: &[u8], name: &str) -> Option<Failure> {
    let problem = SceneProblem::NotAScene(FileContent::recognise(bytes)?);
    Some(Failure::Input(report::scene_errors::drawn(&SceneError { problem, span: None }, "", name)))
}

fn overrides(args: &RunArgs) -> Result<Overrides, Failure> {
    Ok(Overrides {
        normalisation: args.normalisation.normalisation,
        amplitude: args.amplitude.amplitude,
        scales_per_decade: args.sampling.scales_per_decade,
        hardness: args.hardness.hardness_formula,
        strength_cap: args.strength_cap.strength_cap,
        cutoff: args.sampling.cutoff,
        counterface: args
            .counterface
            .input()
            .map(|body| body.body("counterface_poisson_ratio"))
            .transpose()?,
        ..Overrides::default()
    })
}

/// Refuses options that nothing in the scene has a use for.
fn refuse_idle_options(args: &RunArgs, scene: &Scene) -> Result<(), Failure> {
    args.sampling.input().check(&scene.surface)?;
    match overrides(args)?.first_unused(scene) {
        None => Ok(()),
        Some(option) => Err(Failure::Input(format!(
            "--{} does not affect {}: none of its curves and figures depends on it; leave it out",
            option.replace('_', "-"),
            args.scene
        ))),
    }
}

/// The day in universal time, so that runs repeated within it give equal bytes; that of `SOURCE_DATE_EPOCH` where it is set.
fn date() -> String {
    let set = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|seconds| seconds.parse().ok());
    let at = set.and_then(|seconds| DateTime::from_timestamp(seconds, 0));
    at.unwrap_or_else(|| SystemTime::now().into()).format("%Y-%m-%d UTC").to_string()
}

fn default_folder(scene: &Place) -> PathBuf {
    let stem = match scene {
        Place::Standard => None,
        Place::File(path) => path.file_stem(),
    };
    PathBuf::from(format!("{}-results", stem.map_or("scene".into(), |stem| stem.to_string_lossy())))
}
