//! Tables of any length, checked as a whole and then computed block by block.

use super::{Context, say_notes};
use crate::failure::Failure;
use crate::files::open_table;
use crate::output::{Place, Stopped, publish};
use crate::progress::Progress;
use staging::StagedFiles;
use study::Progress as _;
use study::provenance::program;
use tables::{InputTable, Refusal, TableError};

/// Rows that are in memory together.
const BLOCK: usize = 1 << 12;

/// What a command makes of the rows of a table.
pub(super) trait RowByRow {
    /// Finds what is wrong with rows.
    fn check(&self, block: &InputTable) -> Result<(), Refusal>;

    /// Sets the computed columns of rows that have been checked; with a step for each row that takes long, and what there is
    /// to say of single rows said aside.
    fn fill_in(&mut self, block: &mut InputTable, progress: &Progress) -> Result<(), Failure>;

    /// What there is to say of all rows.
    fn notes(&self) -> Vec<String>;
}

/// Reads the table at a place twice, to check all of it before anything is computed, and writes it as it is filled in.
pub(super) fn run(input: &Place, command: &mut dyn RowByRow, context: &Context<'_>) -> Result<(), Failure> {
    // A table may be extended in its own place.
    context.targets(None)?;
    let mut source = open_table(input)?;
    let mut rows = 0;
    let mut refusal = Refusal::default();
    source.blocks(BLOCK, |block| {
        rows += block.table.rows();
        refusal.extend(command.check(&block).err().unwrap_or_default());
        Ok::<(), TableError>(())
    })?;
    refusal.into_result()?;
    let progress = Progress::towards(rows);
    let mut comments = context.wanted(&[program(context.typed)]).to_vec();
    // What somebody else has written above the table belongs to it.
    comments.append(&mut source.comments);
    let mut files = StagedFiles::default();
    context.stage_blocks(&mut files, &context.shared.output, &comments, |out| {
        source.blocks(BLOCK, |mut block| {
            command.fill_in(&mut block, &progress)?;
            out.block(&block.table)?;
            if progress.is_cancelled() { Err(Failure::Interrupted.into()) } else { Ok::<(), Stopped>(()) }
        })?;
        progress.aside(|| say_notes(command.notes()));
        Ok(())
    })?;
    publish(files)
}
