//! `psd`: from scans to their composite spectrum, and the sum of two faces.

use std::slice;

use super::{Context, FaceReader, announce_figure, say_all, say_notes};
use crate::args::{CounterfaceSurfaceArgs, ScansArgs};
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
use report::provenance::{of_surface, program};
use report::scan_words;
use report::scans_table::scans_table;
use scans::{Mend, ScanOption, ScanReadError};
use spectrum::ReadOptions;
use study::figure::composite_figure;
use study::surface::Surface;
use tables::staging::StagedFiles;
use topography::Recipe;
use units::RemarkCode;
use units::display::counted;

pub(super) fn run(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    refuse_two_outputs(args, context)?;
    let recipe = Recipe {
        detrend: args.detrend,
        window: args.window,
        average: args.average,
        line_average: args.line_average,
        remove_spikes: args.remove_spikes,
        bins_per_decade: args.bins_per_decade,
        tip_radius_m: args.tip_radius.and_then(TipRadius::known_m),
        ..Recipe::default()
    };
    let output = args.out.as_ref().unwrap_or(&context.shared.output);
    announce_figure(args.figure.as_ref())?;
    announce("--out", args.out.clone())?;
    let (requests, counterface_scans) = requests(args)?;
    let folder = Folder::current();
    let mut timings = Timings::start();
    let of_spectra = |request: &ScanRequest| request.check_takes(&ScanRequest::OF_SPECTRA);
    requests.iter().chain(&counterface_scans).try_for_each(of_spectra).map_err(refused)?;
    let at_once = if args.sum || !args.other.files().is_empty() {
        let other = CounterfaceSurfaceArgs { counterface_scans, ..args.other.clone() };
        let reader = FaceReader { folder: &folder, options: ReadOptions::default(), recipe };
        let both = both_faces(args.sum, &requests, &other, &reader)?;
        for scans in both.each().into_iter().filter_map(|face| face.made_from.as_ref()) {
            say_lines(&scans_table(&scans.spectrum));
        }
        Some((both.notes.clone(), of_surface(&both), both.table()))
    } else if args.areal {
        let requests = scans_in_folders(&requests, &folder)?;
        let [request] = &requests[..] else {
            return Err(Failure::Input(format!(
                "--areal takes one map, and {} files are given",
                requests.len()
            )));
        };
        let found = areal_spectrum(request, &folder, &recipe).map_err(refused)?;
        Some((found.remarks, vec![found.provenance], found.table))
    } else {
        None
    };
    if let Some((remarks, provenance, table)) = at_once {
        say_all(&remarks, &Flags);
        let mut files = StagedFiles::default();
        let comments = [vec![program(context.typed)], provenance].concat();
        context.stage_table(&mut files, output, &comments, &table)?;
        timings.lap("reading and transforming");
        return context.finish(files, timings);
    }
    let requests = scans_in_folders(&requests, &folder)?;
    let progress = Progress::towards(STEPS_PER_FILE * requests.len(), "steps of reading and transforming");
    let found = CompositeOfFiles::read_spectrum(&requests, &folder, &recipe, &progress)
        .map_err(refused_among(&requests))?;
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

/// The sum of two faces: of two files, or of files and those of the other face.
fn both_faces(
    is_sum: bool,
    files: &[ScanRequest],
    other: &CounterfaceSurfaceArgs,
    reader: &FaceReader<'_>,
) -> Result<Surface, Failure> {
    let (own, other) = match files {
        files if !is_sum => (files, reader.counterface(other)?),
        [_, other] => (&files[..1], Some(reader.face(slice::from_ref(other))?)),
        files => {
            let given = counted(files.len(), "file");
            let way_out = "of several scans, write psd A1 A2 --counterface-scans B1 B2";
            return Err(Failure::Input(format!(
                "--sum adds two files, one for each face, not {given}; {way_out}"
            )));
        }
    };
    Ok(other.into_iter().fold(reader.face(own)?, Surface::against))
}

/// The scans that were typed, and behind them those of the list; and those of the other face. What is said for all counts where
/// they say nothing.
fn requests(args: &ScansArgs) -> Result<(Vec<ScanRequest>, Vec<ScanRequest>), Failure> {
    let listed = args.list.as_ref().map(listed).transpose()?.unwrap_or_default();
    let own = [&args.files[..], &listed].concat();
    let mut all = args.with_common_options(&[&own[..], &args.other.counterface_scans].concat())?;
    let other = all.split_off(own.len());
    Ok((all, other))
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

/// The failure of scans, with all options of the one at fault.
fn refused_among(requests: &[ScanRequest]) -> impl Fn(TopographyError) -> Failure {
    |error| Failure::Input(refusal_of(error.request.and_then(|at| requests.get(at)), error))
}

/// Words an error of scans, with the option that mends it where one does.
pub(super) fn refusal(error: TopographyError) -> String {
    refusal_of(None, error)
}

/// Words an error of a scan, with the option that mends it beside those that it has.
pub(super) fn refusal_of(request: Option<&ScanRequest>, error: TopographyError) -> String {
    let given = |typed: &str| -> String {
        let is_another = |option: &&str| option.split('=').next() != typed.split('=').next();
        let options = request.map(ScanRequest::options).unwrap_or_default();
        options.split_inclusive(',').filter(is_another).collect()
    };
    let [flag, option] = [0, 1].map(|at| {
        move |option| match option {
            ScanOption::Unit => Some(["--unit", "unit=um"][at]),
            ScanOption::HeightUnit => Some(["--height-unit", "height-unit=um"][at]),
            ScanOption::Units => Some(
                ["--unit, and --height-unit where they differ", "unit=um, or unit=mm,height-unit=um"][at],
            ),
            ScanOption::Size => Some(["--size", "size=10um"][at]),
            ScanOption::Channel => Some(["--channel", "channel=NAME"][at]),
            _ => None,
        }
    });
    let mend = match (&error.problem, &error.file, error.mend()) {
        (ScanProblem::IsAScene, Some(file), _) => format!("; try `truearea run {file}`"),
        (ScanProblem::HoldsASpectrum, Some(file), _) => {
            format!(
                "; give a scan, or a command that takes a PSD, the other face's as --counterface-psd {file}"
            )
        }
        (ScanProblem::Format(problem), Some(file), _)
            if matches!(**problem, ScanReadError::NoHeightChannel { .. }) =>
        {
            format!("; `truearea scan {file} --all-channels` shows what they hold")
        }
        (_, Some(file), Some(Mend::Give(wanted))) => option(wanted).map_or_else(
            || "; unpack it, and name the scans or their folder".to_owned(),
            |typed| format!("; write {file}:{}{typed}", given(typed)),
        ),
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
