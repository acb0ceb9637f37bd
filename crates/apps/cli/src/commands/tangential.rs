//! `tangential`: a surface sheared under a constant normal load.

use questions::TangentialQuestion;

use super::{Context, load_inputs, range_inputs};
use crate::args::TangentialArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &TangentialArgs, context: &Context<'_>) -> Result<(), Failure> {
    let question = TangentialQuestion {
        by: args.choices.input(args.model.0),
        friction: Some(args.friction),
        pressures: load_inputs(&args.loads.pressures),
        pressure_ranges: range_inputs(&args.loads.pressure_ranges),
        stresses: load_inputs(&args.stresses),
        random: args.random.input(),
        figure: args.figure.figure.is_some(),
    };
    let figure = args.figure.figure.as_ref();
    question.check()?;
    let mut timings = Timings::start();
    let surface = context.load(&args.psd, &args.reading, figure)?;
    timings.lap("reading");
    let progress = Progress::towards(question.steps(&surface)?, "steps");
    let answer = question.answer(&surface, &progress)?;
    drop(progress);
    timings.lap("computing");
    context.publish_answer(&answer, &surface, question.by.sampling.sampling(), figure, timings)
}
