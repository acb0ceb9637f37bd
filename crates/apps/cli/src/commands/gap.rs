//! `gap`: mean gap and stiffness of a surface under loads.

use questions::{GapModel, GapQuestion};

use super::{Context, load_inputs, range_inputs};
use crate::args::GapArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &GapArgs, context: &Context<'_>) -> Result<(), Failure> {
    let tolerance = args.tolerance.map(|tolerance| tolerance.asked_finer().unwrap_or(tolerance.value()));
    let question = GapQuestion {
        by: GapModel { tolerance, ..args.choices.input(args.model.0) },
        pressures: load_inputs(&args.loads.pressures),
        pressure_ranges: range_inputs(&args.loads.pressure_ranges),
        random: args.random.input(),
    };
    question.check()?;
    let mut timings = Timings::start();
    let surface = context.load(&args.psd, &args.reading, None)?;
    timings.lap("reading");
    let progress = Progress::towards(question.steps(&surface)?, "steps");
    let answer = question.answer(&surface, &progress)?;
    drop(progress);
    timings.lap("computing");
    context.publish_answer(&answer, &surface, question.by.sampling.sampling(), None, timings)
}
