//! `asperity`: the contact law of one asperity, row by row of a table.

use super::{Context, say_notes};
use crate::args::AsperityLaw;
use crate::asperity_table::AsperityTable;
use crate::failure::Failure;
use crate::provenance::program;
use crate::table::InputTable;

pub(super) fn run(law: &AsperityLaw, context: &Context<'_>) -> Result<(), Failure> {
    let (law, args) = match law {
        AsperityLaw::Sphere(args) => (AsperityTable::Sphere, args),
        AsperityLaw::Sinusoid(args) => (AsperityTable::Sinusoid, args),
        AsperityLaw::SinusoidInterference(args) => (AsperityTable::SinusoidInterference, args),
    };
    let mut input = InputTable::read(&args.input)?;
    say_notes(law.extend(&mut input, context.counterface()?)?);
    let mut comments = vec![program(context.typed)];
    comments.append(&mut input.comments);
    context.write(&input.table, &comments)
}
