//! One asperity under its contact law, row by row.

use asperity::ElasticBody;
use parallel::Progress;
use tables::{InputTable, Refusal};

use super::asperity_table::AsperityTable;
use super::{RowByRow, RowsError, RowsNote};

/// A table of asperities.
#[derive(Debug)]
pub struct Asperities {
    law: AsperityTable,
    counterface: Option<ElasticBody>,
    rows: usize,
    /// How many of them lie beyond the law's range.
    beyond: usize,
}

impl Asperities {
    /// Asperities under a law, against a counterface or a rigid one where absent.
    #[must_use]
    pub fn new(law: AsperityTable, counterface: Option<ElasticBody>) -> Self {
        Asperities { law, counterface, rows: 0, beyond: 0 }
    }
}

impl RowByRow for Asperities {
    fn check(&self, block: &InputTable) -> Result<(), Refusal> {
        self.law.check(block)
    }

    fn fill_in(&mut self, block: &mut InputTable, _: &dyn Progress) -> Result<Vec<RowsNote>, RowsError> {
        self.beyond += self.law.set_results(block, self.counterface)?;
        self.rows += block.table.rows();
        Ok(Vec::new())
    }

    fn notes(&self) -> Vec<RowsNote> {
        let note = RowsNote::BeyondRange { rows: self.beyond, all: self.rows, range: self.law.range() };
        (self.beyond > 0).then_some(note).into_iter().collect()
    }
}
