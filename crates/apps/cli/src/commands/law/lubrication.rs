//! `law --quantity asperity-pressure`: pressure and area over separation, for solvers of mixed lubrication.

use interface::finite_elements::{ContactLaw, Dialect, UnitSystem};
use measurements::ScanRequest;
use questions::LubricationQuestion;
use report::provenance::{program, provenance};
use scene::Overrides;
use spectrum::ReadOptions;
use tables::staging::StagedFiles;
use units::{Remark, RemarkCode};

use super::{Context, say_all};
use crate::args::LawArgs;
use crate::commands::reading_options;
use crate::commands::run_scene::read_scene;
use crate::failure::Failure;
use crate::flags::{Flags, refuse_first};
use crate::memory;
use crate::place::Place;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if args.dialect != Dialect::Csv {
        return Err(Failure::input("solvers of mixed lubrication read a table; take --dialect csv"));
    }
    let question = args.lubrication();
    let reason = Remark::new(RemarkCode::OtherQuantity).with("quantity", LubricationQuestion::QUANTITY);
    let fixed = [("units", args.units != UnitSystem::Si), ("error", args.error != ContactLaw::TOLERANCE)];
    refuse_first(fixed, reason)?;
    question.check(&args.question())?;
    memory::refuse_beyond(args.random.grid)?;
    let mut timings = Timings::start();
    let progress = Progress::counting("steps");
    let (found, mut comments) = match &args.psd.psd[..] {
        [] => (question.answer_summits()?, vec![program(context.typed)]),
        [scene] if is_scene(scene) => {
            let reading = &args.psd.reading;
            if reading_options(reading) != ReadOptions::default() || !reading.other.files().is_empty() {
                return Err(Failure::input(
                    "options for reading spectra do not affect a scene; leave them out",
                ));
            }
            let scene = read_scene(&Place::from(scene.path.as_str()), &Overrides::default())?;
            (
                question.answer_scene(&scene, &progress)?,
                provenance(context.typed, &scene.surface, scene.sampling),
            )
        }
        psd => {
            let surface = context.load(psd, &args.psd.reading, None)?;
            let comments = provenance(context.typed, &surface, question.by.sampling.sampling());
            (question.answer(&surface, &progress)?, comments)
        }
    };
    progress.aside(|| say_all(&found.notes, &Flags));
    drop(progress);
    timings.lap("computing");
    comments.extend(found.description(&Flags));
    let mut files = StagedFiles::default();
    context.stage_table(&mut files, &context.shared.output, &comments, &found.table)?;
    context.finish(files, timings)
}

/// Returns true for the file of a scene.
fn is_scene(request: &ScanRequest) -> bool {
    std::path::Path::new(&request.path).extension().is_some_and(|extension| extension == "toml")
}
