//! Tables of any length, checked as a whole and then computed block by block.

use super::{Context, say_notes};
use crate::failure::Failure;
use crate::files::open_table;
use crate::output::{Place, Stopped};
use crate::progress::Progress;
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
    let mut comments = vec![program(context.typed)];
    comments.append(&mut source.comments);
    context.write_blocks(&context.shared.output, &comments, |out| {
        source.blocks(BLOCK, |mut block| {
            command.fill_in(&mut block, &progress)?;
            Ok::<(), Stopped>(out.block(&block.table)?)
        })?;
        progress.aside(|| say_notes(command.notes()));
        Ok(())
    })
}
