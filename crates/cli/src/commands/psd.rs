//! `psd`: from scans to their composite spectrum.

use super::{Context, say_notes, say_of_severity};
use crate::args::ScansArgs;
use crate::failure::Failure;
use crate::files::{Folder, open_table};
use crate::output::Place;
use crate::stderr::say;
use crate::timings::Timings;
use report::plot;
use report::scan_words;
use report::scans_table::scans_table;
use scans::ScanOption;
use study::provenance::program;
use study::topography::{CompositeOfFiles, ScanRequest, TopographyError, areal_spectrum, requests_of_list};
use topography::{Recipe, Remark};

pub(super) fn run(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    refuse_idle_options(args, context)?;
    let recipe = Recipe {
        detrend: args.detrend,
        window: args.window,
        average: args.average,
        bins_per_decade: args.bins_per_decade,
        tip_radius_m: args.tip_radius.map(|radius| radius.m),
    };
    let requests = requests(args)?;
    let output = args.out.as_ref().unwrap_or(&context.shared.output);
    if args.areal {
        let [request] = &requests[..] else {
            return Err(Failure::Input(format!(
                "--areal takes one map, and {} files are given",
                requests.len()
            )));
        };
        let found = areal_spectrum(request, &Folder::current(), &recipe).map_err(refused)?;
        say_notes(found.notes);
        return context.write_to(output, &found.table, &[program(context.typed), found.provenance]);
    }
    let mut timings = Timings::start();
    let found = CompositeOfFiles::read(&requests, &Folder::current(), &recipe).map_err(refused)?;
    timings.lap("reading and transforming");
    say_lines(&scans_table(&found.spectrum));
    let remarks = found.spectrum.remarks();
    for remark in &remarks {
        say_of_severity(remark.severity(), &scan_words::remark(remark));
    }
    let mut comments = vec![program(context.typed)];
    comments.extend(found.provenance());
    let holes = remarks.iter().filter(|remark| matches!(remark, Remark::Holes(_)));
    comments.extend(holes.map(scan_words::remark));
    let table = if args.per_scan { found.series_table() } else { found.table() };
    context.write_to(output, &table, &comments)?;
    if let Some(path) = &args.figure {
        let title = format!("{} scans", found.spectrum.scans.len());
        let svg = plot::svg(&found.figure("psd"), &title, &comments);
        Place::File(path.clone()).write(|out| out.write_all(svg.as_bytes()))?;
    }
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

/// The scans that were typed, and behind them those of the list; what is said for all counts where they say nothing.
fn requests(args: &ScansArgs) -> Result<Vec<ScanRequest>, Failure> {
    let listed = args.list.as_ref().map_or_else(|| Ok(Vec::new()), listed)?;
    Ok(args.files.iter().chain(&listed).map(|file| args.with_common_options(file)).collect())
}

/// The scans of a list, their files relative to it.
fn listed(list: &Place) -> Result<Vec<ScanRequest>, Failure> {
    let folder = match list {
        Place::Standard => Folder::current(),
        Place::File(path) => Folder::of(path),
    };
    let table = open_table(list)?.whole()?;
    let requests = requests_of_list(&list.to_string(), &table).map_err(Failure::input)?;
    let beside = |request: ScanRequest| ScanRequest {
        path: folder.0.join(&request.path).to_string_lossy().into_owned(),
        ..request
    };
    Ok(requests.into_iter().map(beside).collect())
}

/// What is wrong with scans, with the option that mends it where one does.
fn refused(error: TopographyError) -> Failure {
    let flag = |option| match option {
        ScanOption::Unit => Some("--unit"),
        ScanOption::Size => Some("--size"),
        ScanOption::Channel => Some("--channel"),
        _ => None,
    };
    let mend = error.mend().map_or_else(String::new, |mend| scan_words::mend(mend, flag));
    Failure::Input(format!("{error}{mend}"))
}

/// Says text of several lines on stderr.
fn say_lines(text: &str) {
    text.lines().for_each(say);
}

/// Refuses options that say nothing about scans: a call that is not carried out as it reads is worse than none.
fn refuse_idle_options(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    let shared = &context.shared;
    let idle = [
        ("--normalisation", shared.normalisation.is_some()),
        ("--amplitude", shared.amplitude.is_some()),
        ("--scales-per-decade", shared.scales_per_decade.is_some()),
        ("--hardness", shared.hardness.is_some()),
        ("--strength-cap", shared.strength_cap.is_some()),
        ("--cutoff", shared.cutoff.is_some()),
        ("--counterface-youngs-modulus", shared.counterface_youngs_modulus.is_some()),
    ];
    if let Some((option, _)) = idle.iter().find(|(_, given)| *given) {
        let message = "has no bearing on the spectrum of scans; leave it out, and give it to the command that takes the spectrum";
        return Err(Failure::Input(format!("{option} {message}")));
    }
    if args.out.is_some() && shared.output != Place::Standard {
        return Err(Failure::input("--out and --output are the same; give one of them"));
    }
    Ok(())
}
