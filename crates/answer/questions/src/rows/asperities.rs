//! Single asperities under their contact law, row by row.

use asperity::ElasticBody;
use numerics::parallel::Progress;
use tables::{InputTable, Refusal};

use super::asperity_table::AsperityTable;
use super::strength_columns::assumed_strengths;
use super::{RowByRow, RowsError, RowsNote};

/// A table of asperities.
#[derive(Debug)]
pub struct Asperities {
    law: AsperityTable,
    counterface: Option<ElasticBody>,
    rows: usize,
    /// The number of rows beyond the range of the law.
    beyond: usize,
    /// The number of rows with a hardness and no yield strength.
    assumed: usize,
}

impl Asperities {
    /// Asperities under a law, against a counterface, or a rigid one if `None`.
    #[must_use]
    pub fn new(law: AsperityTable, counterface: Option<ElasticBody>) -> Self {
        Asperities { law, counterface, rows: 0, beyond: 0, assumed: 0 }
    }
}

impl RowByRow for Asperities {
    fn check(&self, block: &InputTable) -> Result<(), Refusal> {
        self.law.check(block)
    }

    fn fill_in(&mut self, block: &mut InputTable, _: &dyn Progress) -> Result<Vec<RowsNote>, RowsError> {
        self.beyond += self.law.set_results(block, self.counterface)?;
        self.assumed += assumed_strengths(block);
        self.rows += block.table.rows();
        Ok(Vec::new())
    }

    fn notes(&self) -> Vec<RowsNote> {
        let (assumed, beyond, all) = (self.assumed, self.beyond, self.rows);
        let assumed = (assumed > 0).then_some(RowsNote::AssumedStrengths { rows: assumed, all });
        let beyond =
            (beyond > 0).then_some(RowsNote::BeyondRange { rows: beyond, all, range: self.law.range() });
        assumed.into_iter().chain(beyond).collect()
    }
}
