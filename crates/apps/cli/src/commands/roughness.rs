//! `roughness`: parameters of profiles and maps after ISO 21920-2 and ISO 25178-2, or slopes and curvatures down to each
//! wavelength.

use measurements::{RoughnessOfFiles, RoughnessSettings, ScalesOfFiles};
use roughness::Evaluation;
use tables::staging::StagedFiles;

use super::readable::Readable;
use super::{Context, psd};
use crate::args::RoughnessArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::timings::Timings;

pub(super) fn run(args: &RoughnessArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests = args.defaults.complete_all(&args.files)?;
    let folder = Folder::current();
    let requests = psd::scans_in_folders(&requests, &folder)?;
    let mut timings = Timings::start();
    let evaluation = Evaluation {
        form: args.form,
        longest_m: args.filter.map(|cutoff| cutoff.m),
        shortest_m: args.short_filter.map(|cutoff| cutoff.m),
    };
    let (table, for_people, notes, unreadable) = if args.scales {
        let found = ScalesOfFiles::read(&requests, &folder, &evaluation);
        (found.table(), None, found.notes(), found.unreadable)
    } else {
        let settings = RoughnessSettings {
            evaluation,
            ratio_height_m: args.ratio_height.map_or(0.0, |height| height.m),
            conventions: args.convention,
        };
        let found = RoughnessOfFiles::read(&requests, &folder, &settings);
        (found.table(), Some(found.describe()), found.notes(), found.unreadable)
    };
    timings.lap("evaluating");
    let lines = notes.iter().map(|note| format!("note: {note}")).collect();
    Readable { table, for_people, lines, unreadable }.write(StagedFiles::default(), timings, context)
}
