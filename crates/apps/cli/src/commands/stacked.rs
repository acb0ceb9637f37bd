//! `stacked`: contact area against cutoff, scale upon scale.

use questions::CurveQuestion;
use study::models::ModelOptions;

use super::Context;
use crate::args::StackedArgs;
use crate::failure::Failure;
use crate::flags::Flags;

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = args.material.input();
    let strain_gradient = material.strain_gradient_length_m.is_some();
    let figure = args.figure.figure.as_ref();
    let question = CurveQuestion {
        model: Some(args.model),
        name: Some("stacked".to_owned()),
        options: ModelOptions {
            strain_gradient,
            elastic_plastic_area: args.elastic_plastic_area,
            ..ModelOptions::default()
        },
        material,
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        sampling: args.sampling.input(),
        amplitude: args.amplitude.amplitude,
        details: args.details,
        figure: figure.is_some(),
        ..CurveQuestion::default()
    };
    context.curve(&question, &args.psd.psd, &args.psd.reading, figure, &Flags)
}
