//! `roughness`: parameters of profiles and maps after ISO 21920-2 and ISO 25178-2, or slopes and curvatures down to each
//! wavelength.

use std::io::IsTerminal;

use measurements::{RoughnessOfFiles, RoughnessSettings, ScalesOfFiles, TopographyError};
use report::provenance::program;
use roughness::Evaluation;
use tables::Table;
use tables::staging::StagedFiles;

use super::{Context, psd, say_notes};
use crate::args::RoughnessArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::publish;
use crate::place::Place;
use crate::timings::Timings;

pub(super) fn run(args: &RoughnessArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests = args.defaults.complete_all(&args.files)?;
    let folder = Folder::current(context.targets(None)?);
    let requests = psd::scans_in_folders(&requests, &folder)?;
    let timings = Timings::start();
    let evaluation = Evaluation {
        form: args.form,
        longest_m: args.filter.map(|cutoff| cutoff.m),
        shortest_m: args.short_filter.map(|cutoff| cutoff.m),
    };
    if args.scales {
        let found = ScalesOfFiles::read(&requests, &folder, &evaluation);
        let results = Readable { table: found.table(), for_people: None, notes: found.notes() };
        return write(results, found.unreadable, timings, context);
    }
    let settings = RoughnessSettings {
        evaluation,
        ratio_height_m: args.ratio_height.map_or(0.0, |height| height.m),
        conventions: args.convention,
    };
    let found = RoughnessOfFiles::read(&requests, &folder, &settings);
    let results = Readable { table: found.table(), for_people: Some(found.describe()), notes: found.notes() };
    write(results, found.unreadable, timings, context)
}

/// Results of the readable files.
struct Readable {
    table: Table,
    /// The results on a terminal; the table if absent.
    for_people: Option<String>,
    notes: Vec<String>,
}

fn write(
    results: Readable,
    unreadable: Vec<TopographyError>,
    mut timings: Timings,
    context: &Context<'_>,
) -> Result<(), Failure> {
    timings.lap("evaluating");
    // Rows of readable files are written before the unreadable ones end the command.
    let refusals: Vec<String> = unreadable.into_iter().map(psd::refusal).collect();
    if results.table.rows() == 0 && !refusals.is_empty() {
        return Err(Failure::Input(refusals.join("\n")));
    }
    let shared = &context.shared;
    let is_plain = shared.output == Place::Standard && shared.format.is_none() && shared.provenance.is_none();
    let mut files = StagedFiles::default();
    match results.for_people.filter(|_| is_plain && std::io::stdout().is_terminal()) {
        Some(text) => shared.output.stage(&mut files, |out| out.write_all(text.as_bytes()))?,
        None => {
            let comments = [program(context.typed)];
            context.stage_blocks(&mut files, &shared.output, context.wanted(&comments), |out| {
                Ok(out.block(&results.table)?)
            })?;
        }
    }
    publish(files)?;
    say_notes(results.notes);
    timings.lap("writing");
    timings.report(shared.timings);
    if refusals.is_empty() { Ok(()) } else { Err(Failure::Input(refusals.join("\n"))) }
}
