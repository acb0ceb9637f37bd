//! `gap`: mean gap and stiffness of a surface under loads.

use questions::{GapModel, GapQuestion};
use study::surface::Surface;

use super::Context;
use crate::args::GapArgs;
use crate::failure::Failure;
use crate::memory;

pub(super) fn run(args: &GapArgs, context: &Context<'_>) -> Result<(), Failure> {
    let question = GapQuestion {
        by: GapModel { tolerance: args.tolerance, ..args.choices.input(args.model.0) },
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        random: args.random.input(),
    };
    question.check()?;
    memory::refuse_beyond(args.random.grid)?;
    let steps = |surface: &Surface| question.steps(surface);
    context.answer(&args.psd, &question.by.sampling, None, steps, |surface, progress| {
        question.answer(surface, progress)
    })
}
