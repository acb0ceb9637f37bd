//! `roughness`: parameters of profiles and maps after ISO 21920-2 and ISO 25178-2.

use std::io::IsTerminal;

use measurements::{RoughnessOfFiles, RoughnessSettings};
use report::provenance::program;
use roughness::Evaluation;
use staging::StagedFiles;

use super::{Context, psd, say_notes};
use crate::args::RoughnessArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, publish};
use crate::timings::Timings;

pub(super) fn run(args: &RoughnessArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests: Vec<_> = args.files.iter().map(|file| args.untold.told_of(file)).collect();
    let folder = Folder::current(context.targets(None)?);
    let requests = psd::scans_in_folders(&requests, &folder)?;
    let mut timings = Timings::start();
    let settings = RoughnessSettings {
        evaluation: Evaluation {
            form: args.form,
            longest_m: args.filter.map(|cutoff| cutoff.m),
            shortest_m: args.short_filter.map(|cutoff| cutoff.m),
        },
        ratio_height_m: args.ratio_height.map_or(0.0, |height| height.m),
        conventions: args.convention,
    };
    let found = RoughnessOfFiles::read(&requests, &folder, &settings);
    timings.lap("evaluating");
    let shared = &context.shared;
    let for_people =
        shared.output == Place::Standard && shared.format.is_none() && shared.provenance.is_none();
    let mut files = StagedFiles::default();
    if for_people && std::io::stdout().is_terminal() {
        shared.output.stage(&mut files, |out| out.write_all(found.describe().as_bytes()))?;
    } else {
        let comments = [program(context.typed)];
        context.stage_blocks(&mut files, &shared.output, context.wanted(&comments), |out| {
            Ok(out.block(&found.table())?)
        })?;
    }
    publish(files)?;
    say_notes(found.notes());
    timings.lap("writing");
    timings.report(shared.timings);
    // Rows of readable files are written before the first unreadable file ends the command.
    let refusals: Vec<String> = found.unreadable.into_iter().map(psd::refusal).collect();
    if refusals.is_empty() { Ok(()) } else { Err(Failure::Input(refusals.join("\n"))) }
}
