//! `statistical`: populations of asperities, from a spectrum or row by row of a table.

use super::row_by_row::{self, Constants};
use super::{Context, loads, material};
use crate::args::StatisticalArgs;
use crate::failure::Failure;
use crate::output::Place;
use study::material::{MaterialError, NeededFor, hardness_pa};
use study::models::ModelOptions;
use study::plan::{Curve, Cutoffs, Needs};
use study::rows::Populations;

pub(super) fn run(args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    match (&args.psd, &args.input) {
        (Some(psd), _) => over_cutoffs(psd, args, context),
        (None, Some(input)) => of_rows(input, args, context),
        (None, None) => Err(Failure::input("give a spectrum, or a table with --input")),
    }
}

fn options(args: &StatisticalArgs, context: &Context<'_>) -> ModelOptions {
    ModelOptions {
        strain_gradient: args.material.strain_gradient_length.is_some(),
        hardness: context.shared.hardness.unwrap_or_default(),
        interference: args.interference_law,
    }
}

fn over_cutoffs(psd: &str, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let model = args.model.ok_or_else(|| Failure::input("a spectrum needs --model"))?;
    let material = material(&args.material, context)?;
    let needs = Needs {
        moments: Some(context.shared.normalisation.unwrap_or_default()),
        curves: vec![Curve {
            name: model.to_string(),
            model: model.build(&material, &options(args, context))?,
            cutoffs: Cutoffs::Every,
        }],
        loads: loads(&args.pressures, &args.pressure_ranges, &material)?,
        separations_m: args.separations.iter().map(|separation| separation.m).collect(),
        tolerance: args.tolerance,
        ..Needs::default()
    };
    context.curve_to_table(psd, &args.reading, needs, args.details, |_| {
        "the longest wavelength has no asperities yet: its row is empty".to_owned()
    })
}

fn of_rows(input: &Place, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut rows = Populations::new();
    rows.counterface = context.counterface()?;
    rows.options = options(args, context);
    rows.strength_cap = context.shared.strength_cap;
    rows.given = args.given;
    rows.how_to_say_given = "say with --given which one counts";
    rows.tolerance = args.tolerance;
    rows.details = args.details;
    row_by_row::run(input, &constants(args)?, &mut rows, context)
}

/// What the options say of every row.
fn constants(args: &StatisticalArgs) -> Result<Constants, Failure> {
    let mut constants = Constants::default();
    if let Some(model) = args.model {
        constants.add("--model", "model", model.name);
    }
    let material = &args.material;
    constants.add_elastic(material.youngs_modulus, material.poisson_ratio)?;
    constants.add_strength(material.yield_strength)?;
    let length_m = material.strain_gradient_length.map(|length| length.m);
    constants.add_number("--strain-gradient-length", "strain_gradient_length_m", length_m);
    if args.pressures.len() + args.separations.len() > 1 {
        return Err(Failure::input("the rows of a table take one --pressure or one --separation"));
    }
    for (pressure, label) in &args.pressures {
        let strength_pa = material.yield_strength.and_then(|strength| strength.pascals(None));
        let pressure_pa = pressure
            .pascals(strength_pa.map(hardness_pa))
            .ok_or(MaterialError::Missing(NeededFor::PressureInHardnesses))
            .map_err(|error| Failure::Input(format!("--pressure {label}: {error}: add --yield-strength")))?;
        constants.add_number("--pressure", "pressure_pa", Some(pressure_pa));
    }
    for separation in &args.separations {
        constants.add_number("--separation", "separation_m", Some(separation.m));
    }
    Ok(constants)
}
