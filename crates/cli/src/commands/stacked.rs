//! `stacked`: contact area against cutoff, scale upon scale.

use super::{Context, loads, material};
use crate::args::StackedArgs;
use crate::failure::Failure;
use report::summary::sampling_of;
use study::models::ModelOptions;
use study::plan::{Curve, Cutoffs, Needs};

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = material(&args.material, context)?;
    let options = ModelOptions {
        strain_gradient: args.material.strain_gradient_length.is_some(),
        ..ModelOptions::default()
    };
    let model = args.model.build(&material, &options)?;
    let needs = Needs {
        amplitudes: Some(context.shared.amplitude.unwrap_or_default()),
        curves: vec![Curve { name: "stacked".to_owned(), model, cutoffs: Cutoffs::Every }],
        loads: loads(&args.pressures, &args.pressure_ranges, &material)?,
        ..Needs::default()
    };
    context.curve_to_table(&args.psd.psd, &args.psd.reading, needs, args.details, |stream| {
        let sampling = sampling_of(stream.psd());
        format!("{sampling}; the area depends on how densely scales are sampled (--scales-per-decade)")
    })
}
