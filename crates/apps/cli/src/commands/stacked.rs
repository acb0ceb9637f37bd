//! `stacked`: contact area against cutoff, scale upon scale.

use super::material_options::{loads, material, refuse_idle_strength_cap, say_assumed_strength};
use super::{Context, Drawn, Spectrum, say_doubts};
use crate::args::StackedArgs;
use crate::failure::Failure;
use findings::doubts::Doubt;
use report::summary::sampling_of;
use study::models::{Choice, ModelOptions};
use study::plan::{Curve, Cutoffs, Needs};

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    refuse_idle_strength_cap(&args.material, args.model.name, args.model.has(Choice::Strength))?;
    let material = material(&args.material)?;
    let options = ModelOptions {
        strain_gradient: args.material.strain_gradient_length.is_some(),
        ..ModelOptions::default()
    };
    let model = args.model.build(&material, &options)?;
    say_assumed_strength(&material, args.model);
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let mut needs = Needs {
        amplitudes: Some(args.amplitude.amplitude.unwrap_or_default()),
        curves: vec![Curve { name: "stacked".to_owned(), model, cutoffs: Cutoffs::Every }],
        loads,
        load_ranges,
        ..Needs::default()
    };
    let spectrum = Spectrum {
        psd: &args.psd.psd,
        reading: &args.psd.reading,
        sampling: args.sampling.sampling(),
        figure: Drawn::area(&args.figure, &mut needs, material.hardness_pa())?,
    };
    context.curve_to_table(&spectrum, needs, material.hardness_pa(), args.details, |psd| {
        let sampling = sampling_of(psd);
        format!("{sampling}; the area depends on how densely scales are sampled (--scales-per-decade)")
    })
}
