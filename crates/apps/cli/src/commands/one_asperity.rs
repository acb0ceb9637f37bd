//! `asperity`: the contact law of one asperity, row by row of a table.

use super::Context;
use super::material_options::counterface;
use super::row_by_row::{self, Constants};
use crate::args::AsperityLaw;
use crate::failure::Failure;
use state_tables::Asperities;
use state_tables::asperity_table::AsperityTable;

pub(super) fn run(law: &AsperityLaw, context: &Context<'_>) -> Result<(), Failure> {
    let (law, args) = match law {
        AsperityLaw::Sphere(args) => (AsperityTable::Sphere, args),
        AsperityLaw::Sinusoid(args) => (AsperityTable::Sinusoid, args),
        AsperityLaw::SinusoidInterference(args) => (AsperityTable::SinusoidInterference, args),
    };
    let mut constants = Constants::default();
    constants.add_elastic(args.youngs_modulus, args.poisson_ratio)?;
    constants.add_strength(args.indentation_hardness, args.yield_strength)?;
    row_by_row::run(
        &args.input,
        &constants,
        &mut Asperities::new(law, counterface(&args.counterface)?),
        context,
    )
}
