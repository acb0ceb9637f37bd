//! `asperity`: the contact law of one asperity, row by row of a table.

use asperity::ElasticBody;

use super::row_by_row::{self, RowByRow};
use super::{Context, counterface};
use crate::args::AsperityLaw;
use crate::failure::Failure;
use crate::progress::Progress;
use study::asperity_table::AsperityTable;
use tables::{InputTable, Refusal};

pub(super) fn run(law: &AsperityLaw, context: &Context<'_>) -> Result<(), Failure> {
    let (law, args) = match law {
        AsperityLaw::Sphere(args) => (AsperityTable::Sphere, args),
        AsperityLaw::Sinusoid(args) => (AsperityTable::Sinusoid, args),
        AsperityLaw::SinusoidInterference(args) => (AsperityTable::SinusoidInterference, args),
    };
    let counterface = counterface(&args.counterface)?;
    row_by_row::run(&args.input, &mut Asperities { law, counterface, rows: 0, beyond: 0 }, context)
}

/// A table of asperities.
struct Asperities {
    law: AsperityTable,
    counterface: Option<ElasticBody>,
    rows: usize,
    /// How many of them lie beyond the law's range.
    beyond: usize,
}

impl RowByRow for Asperities {
    fn check(&self, block: &InputTable) -> Result<(), Refusal> {
        self.law.check(block)
    }

    fn fill_in(&mut self, block: &mut InputTable, _: &Progress) -> Result<(), Failure> {
        self.beyond += self.law.set_results(block, self.counterface)?;
        self.rows += block.table.rows();
        Ok(())
    }

    fn notes(&self) -> Vec<String> {
        self.law.note(self.beyond, self.rows).into_iter().collect()
    }
}
