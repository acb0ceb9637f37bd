//! `stacked`: contact area against cutoff, scale upon scale.

use super::{Context, loads, material, say_doubts};
use crate::args::StackedArgs;
use crate::failure::Failure;
use report::summary::sampling_of;
use study::doubts::Doubt;
use study::plan::{Curve, CurveModel, Cutoffs, Needs};

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = material(&args.material, context)?;
    let gradient = args.material.strain_gradient_length.is_some();
    let model = CurveModel::Stacked(material.stacked(args.model, gradient).map_err(Failure::input)?);
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let needs = Needs {
        amplitudes: Some(context.shared.amplitude.unwrap_or_default()),
        curves: vec![Curve { name: "stacked".to_owned(), model, cutoffs: Cutoffs::Every }],
        loads,
        load_ranges,
        ..Needs::default()
    };
    context.curve_to_table(
        &args.psd.psd,
        &args.psd.reading,
        needs,
        material.hardness_pa(),
        args.details,
        |stream| {
            let sampling = sampling_of(stream.psd());
            format!("{sampling}; the area depends on how densely scales are sampled (--scales-per-decade)")
        },
    )
}
