//! Results of the files that can be read, of `scan` and `roughness`.

use std::io::IsTerminal;

use measurements::TopographyError;
use report::provenance::program;
use tables::Table;
use tables::staging::StagedFiles;

use super::{Context, psd};
use crate::failure::Failure;
use crate::place::Place;
use crate::stderr::say;
use crate::timings::Timings;

/// Results of the readable files.
pub(super) struct Readable {
    pub table: Table,
    /// The results on a terminal; the table if absent.
    pub for_people: Option<String>,
    /// Lines for standard error.
    pub lines: Vec<String>,
    pub unreadable: Vec<TopographyError>,
}

impl Readable {
    /// Writes the results beside the files that are staged already; then the unreadable files end the command.
    pub fn write(
        self,
        mut files: StagedFiles,
        timings: Timings,
        context: &Context<'_>,
    ) -> Result<(), Failure> {
        let refusals: Vec<String> = self.unreadable.into_iter().map(psd::refusal).collect();
        let refusals = if refusals.is_empty() { Ok(()) } else { Err(Failure::Input(refusals.join("\n"))) };
        if self.table.rows() == 0 && refusals.is_err() {
            return refusals;
        }
        let shared = &context.shared;
        let is_plain =
            shared.output == Place::Standard && shared.format.is_none() && shared.provenance.is_none();
        match self.for_people.filter(|_| is_plain && std::io::stdout().is_terminal()) {
            Some(text) => shared.output.stage(&mut files, |out| out.write_all(text.as_bytes()))?,
            None => {
                let comments = [program(context.typed)];
                context.stage_table(&mut files, &shared.output, context.wanted(&comments), &self.table)?;
            }
        }
        context.finish(files, timings)?;
        self.lines.iter().for_each(|line| say(line));
        refusals
    }
}
