//! `asperity`: the contact law of one asperity, row by row of a table.

use super::Context;
use super::row_by_row::{self, Constants};
use crate::args::AsperityLaw;
use crate::failure::Failure;
use questions::rows::Asperities;
use questions::rows::asperity_table::AsperityTable;

pub(super) fn run(law: &AsperityLaw, context: &Context<'_>) -> Result<(), Failure> {
    let (law, args) = match law {
        AsperityLaw::Sphere(args) => (AsperityTable::Sphere, args),
        AsperityLaw::Sinusoid(args) => (AsperityTable::Sinusoid, args),
        AsperityLaw::SinusoidInterference(args) => (AsperityTable::SinusoidInterference, args),
    };
    let mut constants = Constants::default();
    let material = args.bodies.input();
    constants.add_elastic(&material)?;
    constants.add_strength(&material)?;
    row_by_row::run(&args.input, &constants, &mut Asperities::new(law, material.counterface()?), context)
}
