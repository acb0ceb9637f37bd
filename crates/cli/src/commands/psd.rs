//! `psd`: from scans to their composite spectrum.

use super::{Context, say_notes};
use crate::args::ScansArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, publish};
use crate::timings::Timings;
use staging::StagedFiles;
use study::provenance::program;
use study::topography::{CompositeSpectrum, Recipe, ScanRequest, areal_spectrum};

pub(super) fn run(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    refuse_two_outputs(args, context)?;
    let recipe = Recipe {
        detrend: args.detrend,
        window: args.window,
        average: args.average,
        bins_per_decade: args.bins_per_decade,
        tip_radius_m: args.tip_radius.map(|radius| radius.m),
    };
    let requests: Vec<ScanRequest> = args.files.iter().map(|file| args.with_common_options(file)).collect();
    let output = args.out.as_ref().unwrap_or(&context.shared.output);
    let targets = context
        .targets(args.figure.as_ref())?
        .with("--out", args.out.as_ref().unwrap_or(&Place::Standard))?;
    let folder = Folder::current(targets);
    if args.areal {
        let [request] = &requests[..] else {
            return Err(Failure::Input(format!(
                "--areal takes one map, and {} files are given",
                requests.len()
            )));
        };
        let found = areal_spectrum(request, &folder, &recipe).map_err(Failure::input)?;
        say_notes(found.notes);
        let mut files = StagedFiles::default();
        let comments = [program(context.typed), found.provenance];
        context.stage_blocks(&mut files, output, &comments, |out| Ok(out.block(&found.table)?))?;
        return publish(files);
    }
    let mut timings = Timings::start();
    let found = CompositeSpectrum::of_files(&requests, &folder, &recipe).map_err(Failure::input)?;
    timings.lap("reading and transforming");
    say_notes(found.notes());
    let mut comments = vec![program(context.typed)];
    comments.extend(found.provenance());
    let table = if args.per_scan { found.series_table() } else { found.table() };
    let mut files = StagedFiles::default();
    if let Some(picture) = &args.figure {
        let subject = format!("{} scans", found.scans.len());
        context.stage_picture(&mut files, picture, &found.figure("psd"), &subject, &comments)?;
    }
    // Later commands tell from them what the composite is made of.
    context.stage_blocks(&mut files, output, &comments, |out| Ok(out.block(&table)?))?;
    publish(files)?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

/// Refuses two places for one table.
fn refuse_two_outputs(args: &ScansArgs, context: &Context<'_>) -> Result<(), Failure> {
    if args.out.is_some() && context.shared.output != Place::Standard {
        return Err(Failure::input("--out and --output are the same; give one of them"));
    }
    Ok(())
}
