//! `stacked`: contact area against cutoff.

use super::{Context, elastic_body};
use crate::args::StackedArgs;
use crate::failure::Failure;
use crate::material::{GivenMaterial, Material};
use crate::plan::{Curve, Load, Needs, Results};
use crate::{summary, tables};

pub(super) fn run(args: &StackedArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = material(args, context)?;
    let gradient = args.material.strain_gradient_length.is_some();
    let model = material.stacked(args.model, gradient).map_err(Failure::input)?;
    let loads = args
        .pressures
        .iter()
        .map(|(pressure, label)| {
            let nominal_pressure_pa = material.pascals(*pressure).map_err(|error| {
                Failure::Input(format!("--pressure {label}: {error}: add --yield-strength"))
            })?;
            Ok(Load { nominal_pressure_pa, label: label.clone() })
        })
        .collect::<Result<_, Failure>>()?;
    let needs = Needs {
        amplitudes: Some(context.shared.amplitude.unwrap_or_default()),
        curves: vec![Curve { name: "stacked".to_owned(), model }],
        loads,
        ..Needs::default()
    };
    let table =
        |results: &Results, needs: &Needs| tables::stacked(&results.curves[0], &needs.loads, args.details);
    context.spectrum_to_table(&args.psd, needs, table, notes)
}

fn material(args: &StackedArgs, context: &Context<'_>) -> Result<Material, Failure> {
    let given = &args.material;
    let body =
        elastic_body("--youngs-modulus", given.youngs_modulus, "--poisson-ratio", given.poisson_ratio)?;
    Material::new(GivenMaterial {
        body,
        counterface: context.counterface()?,
        yield_strength: given.yield_strength,
        strength_cap: context.shared.strength_cap,
        strain_gradient_length_m: given.strain_gradient_length.map(|length| length.m),
    })
    .map_err(Failure::input)
}

fn notes(results: &Results) -> Vec<String> {
    let mut notes = vec![format!(
        "{}; the area depends on how densely scales are sampled (--scales-per-decade)",
        summary::sampling(results)
    )];
    notes.extend(summary::beyond_fitted_range(&results.curves[0]));
    notes
}
