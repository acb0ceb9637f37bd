//! `tangential`: a surface sheared under a constant normal load.

use questions::TangentialQuestion;
use study::surface::Surface;

use super::Context;
use crate::args::TangentialArgs;
use crate::failure::Failure;
use crate::memory;

pub(super) fn run(args: &TangentialArgs, context: &Context<'_>) -> Result<(), Failure> {
    let question = TangentialQuestion {
        by: args.choices.input(args.model.0),
        friction: Some(args.friction),
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        stresses: args.stresses.clone(),
        random: args.random.input(),
        figure: args.figure.figure.is_some(),
    };
    question.check()?;
    memory::refuse_beyond(args.random.grid)?;
    let (figure, steps) = (args.figure.figure.as_ref(), |surface: &Surface| question.steps(surface));
    context.answer(&args.psd, &question.by.sampling, figure, steps, |surface, progress| {
        question.answer(surface, progress)
    })
}
