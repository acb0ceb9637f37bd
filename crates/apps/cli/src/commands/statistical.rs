//! `statistical`: populations of asperities, from a spectrum or row by row of a table.

use measurements::ScanRequest;
use questions::CurveQuestion;
use questions::rows::Populations;

use super::row_by_row::{self, Constants};
use super::{Context, say_all};
use crate::args::StatisticalArgs;
use crate::failure::Failure;
use crate::flags::Flags;
use crate::place::Place;

pub(super) fn run(args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    match (&args.psd[..], &args.input) {
        (psd @ [_, ..], _) => over_cutoffs(psd, args, context),
        ([], Some(input)) => of_rows(input, args, context),
        ([], None) => Err(Failure::input("give a spectrum, or a table with --input")),
    }
}

fn over_cutoffs(psd: &[ScanRequest], args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let material = args.material.input();
    let figure = args.figure.figure.as_ref();
    let question = CurveQuestion {
        model: args.model,
        options: args.options(),
        material,
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        separations_m: args.separations.iter().map(|separation| separation.m).collect(),
        sampling: args.sampling.input(),
        normalisation: args.normalisation.normalisation,
        tolerance: Some(args.tolerance),
        details: args.details,
        figure: figure.is_some(),
        ..CurveQuestion::default()
    };
    context.curve(&question, psd, &args.reading, figure, &Flags)
}

fn of_rows(input: &Place, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    say_all(args.tolerance.remark().as_slice(), &Flags);
    let mut rows = Populations::default();
    let material = args.material.input();
    rows.counterface = material.counterface()?;
    rows.options = args.options();
    rows.strength_cap = material.strength_cap;
    rows.given = args.given;
    rows.how_to_say_given = "say with --given which one counts";
    rows.tolerance = args.tolerance;
    rows.details = args.details;
    let mut constants = Constants::default();
    if let Some(model) = args.model {
        constants.add("model", "model", model.name);
    }
    constants.add_elastic(&material)?;
    constants.add_strength(&material)?;
    let length_m = material.strain_gradient_length_m;
    constants.add_number("strain_gradient_length", "strain_gradient_length_m", length_m);
    if args.loads.pressures.len() + args.separations.len() > 1 {
        return Err(Failure::input("the rows of a table take one --pressure or one --separation"));
    }
    constants.add_pressure(&args.loads.pressures, material.hardness_and_strength()?.hardness_pa())?;
    for separation in &args.separations {
        constants.add_number("separation", "separation_m", Some(separation.m));
    }
    row_by_row::run(input, &constants, &mut rows, context)
}
