//! `psd`: from scans to their composite spectrum.

use super::{Context, announce_figure, say_all, say_notes};
use crate::args::ScansArgs;
use crate::failure::Failure;
use crate::files::{Folder, whole_table};
use crate::flags::Flags;
use crate::inputs::announce;
use crate::place::Place;
use crate::progress::Progress;
use crate::stderr::say;
use crate::timings::Timings;
use measurements::{
    CompositeOfFiles, STEPS_PER_FILE, ScanProblem, ScanRequest, ScansInFolders, TipRadius, TopographyError,
    areal_spectrum, requests_of_list,
};
use report::provenance::program;
use report::scan_words;
use report::scans_table::scans_table;
use scans::{Mend, ScanOption};
use study::figure::composite_figure;
use tables::staging::StagedFiles;
use topography::Recipe;
use units::RemarkCode;

pub(super) fn run(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    refuse_two_outputs(args, context)?;
    let recipe = Recipe {
        detrend: args.detrend,
        window: args.window,
        average: args.average,
        bins_per_decade: args.bins_per_decade,
        tip_radius_m: args.tip_radius.and_then(TipRadius::known_m),
        ..Recipe::default()
    };
    let output = args.out.as_ref().unwrap_or(&context.shared.output);
    announce_figure(args.figure.as_ref())?;
    announce("--out", args.out.clone())?;
    let requests = requests(args)?;
    let folder = Folder::current();
    let mut timings = Timings::start();
    let requests = scans_in_folders(&requests, &folder)?;
    if args.areal {
        let [request] = &requests[..] else {
            return Err(Failure::Input(format!(
                "--areal takes one map, and {} files are given",
                requests.len()
            )));
        };
        let found = areal_spectrum(request, &folder, &recipe).map_err(refused)?;
        say_all(&found.remarks, &Flags);
        let mut files = StagedFiles::default();
        let comments = [program(context.typed), found.provenance];
        context.stage_table(&mut files, output, &comments, &found.table)?;
        timings.lap("reading and transforming");
        return context.finish(files, timings);
    }
    let progress = Progress::towards(STEPS_PER_FILE * requests.len(), "steps of reading and transforming");
    let found = CompositeOfFiles::read_spectrum(&requests, &folder, &recipe, &progress).map_err(refused)?;
    drop(progress);
    timings.lap("reading and transforming");
    say_lines(&scans_table(&found.spectrum));
    let remarks = found.spectrum.remarks();
    say_all(&remarks, &Flags);
    let mut comments = vec![program(context.typed)];
    comments.extend(found.provenance());
    let holes = remarks.iter().filter(|remark| remark.code == RemarkCode::ScanHoles);
    comments.extend(holes.map(|remark| remark.words(&Flags)));
    let table = if args.per_scan { found.series_table() } else { found.table() };
    let mut files = StagedFiles::default();
    if let Some(picture) = &args.figure {
        let subject = format!("{} scans", found.spectrum.scans.len());
        context.stage_picture(&mut files, picture, &composite_figure(&found, "psd"), &subject, &comments)?;
    }
    // Later commands tell from them what the composite is made of.
    context.stage_table(&mut files, output, &comments, &table)?;
    context.finish(files, timings)
}

/// The scans that were typed, and behind them those of the list; what is said for all counts where they say nothing.
fn requests(args: &ScansArgs) -> Result<Vec<ScanRequest>, Failure> {
    let listed = args.list.as_ref().map(listed).transpose()?.unwrap_or_default();
    args.with_common_options(&[&args.files[..], &listed].concat())
}

/// The scans of a list, their files relative to it.
fn listed(list: &Place) -> Result<Vec<ScanRequest>, Failure> {
    let table = whole_table(list)?;
    let requests = requests_of_list(&list.to_string(), &table).map_err(Failure::input)?;
    let folder = match list {
        Place::Standard => None,
        Place::File(path) => path.parent(),
    };
    let beside = |request: ScanRequest| match folder {
        None => request,
        Some(folder) => {
            ScanRequest { path: folder.join(&request.path).to_string_lossy().into_owned(), ..request }
        }
    };
    Ok(requests.into_iter().map(beside).collect())
}

/// The failure of a command that cannot do without these scans.
pub(super) fn refused(error: TopographyError) -> Failure {
    Failure::Input(refusal(error))
}

/// Words an error of scans, with the option that mends it where one does.
pub(super) fn refusal(error: TopographyError) -> String {
    let [flag, option] = [0, 1].map(|at| {
        move |option| match option {
            ScanOption::Unit => Some(["--unit", "unit=um"][at]),
            ScanOption::Size => Some(["--size", "size=10um"][at]),
            ScanOption::Channel => Some(["--channel", "channel=NAME"][at]),
            _ => None,
        }
    });
    let mend = match (&error.problem, &error.file, error.mend()) {
        (ScanProblem::IsAScene, Some(file), _) => format!("; try `truearea run {file}`"),
        (_, Some(file), Some(Mend::Give(wanted))) => {
            option(wanted).map_or_else(String::new, |typed| format!("; write {file}:{typed}"))
        }
        (_, _, mend) => mend.map_or_else(String::new, |mend| scan_words::mend(mend, flag)),
    };
    format!("{error}{mend}")
}

/// Replaces folders by the scans in them, and names the files that are none.
pub(super) fn scans_in_folders(
    requests: &[ScanRequest],
    folder: &Folder,
) -> Result<Vec<ScanRequest>, Failure> {
    let found = ScansInFolders::find(requests, folder).map_err(refused)?;
    say_notes(found.note());
    Ok(found.requests)
}

/// Says text of several lines on stderr.
fn say_lines(text: &str) {
    text.lines().for_each(say);
}

/// Refuses two places for one table.
fn refuse_two_outputs(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    if args.out.is_some() && context.shared.output != Place::Standard {
        return Err(Failure::input("--out and --output are the same; give one of them"));
    }
    Ok(())
}
