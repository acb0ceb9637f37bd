//! `statistical`: populations of asperities, from a spectrum or row by row of a table.

use super::material_options::{counterface, loads, material, refuse_idle_strength_cap, say_assumed_strength};
use super::row_by_row::{self, Constants};
use super::{Context, Drawn, Spectrum, say_doubts, say_notes};
use crate::args::StatisticalArgs;
use crate::failure::Failure;
use crate::material_errors;
use crate::output::Place;
use findings::doubts::Doubt;
use state_tables::Populations;
use study::material::{MaterialError, NeededFor};
use study::models::{self, Choice, Framework, ModelEntry, ModelOptions};
use study::plan::{Curve, Cutoffs, Needs};
use units::number;

pub(super) fn run(args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    say_notes(args.tolerance.asked_finer().map(|asked| {
        let used = number(args.tolerance.value());
        format!("--tolerance {} is finer than double precision reaches: {used} is used", number(asked))
    }));
    match (&args.psd, &args.input) {
        (Some(psd), _) => over_cutoffs(psd, args, context),
        (None, Some(input)) => of_rows(input, args, context),
        (None, None) => Err(Failure::input("give a spectrum, or a table with --input")),
    }
}

fn options(args: &StatisticalArgs) -> ModelOptions {
    ModelOptions {
        strain_gradient: args.material.strain_gradient_length.is_some(),
        hardness: args.hardness.hardness,
        interference_law: args.interference_law,
        ..ModelOptions::default()
    }
}

fn over_cutoffs(psd: &str, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let model = args.model.ok_or_else(|| Failure::input("a spectrum needs --model"))?;
    refuse_idle_options(args, model)?;
    let material = material(&args.material)?;
    say_assumed_strength(&material, model);
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let mut needs = Needs {
        moments: Some(args.normalisation.normalisation.unwrap_or_default()),
        curves: vec![Curve {
            name: model.to_string(),
            model: model.build(&material, &options(args))?,
            cutoffs: Cutoffs::Every,
        }],
        loads,
        load_ranges,
        separations_m: args.separations.iter().map(|separation| separation.m).collect(),
        tolerance: args.tolerance,
        ..Needs::default()
    };
    let spectrum = Spectrum {
        psd,
        reading: &args.reading,
        sampling: args.sampling.sampling(),
        figure: Drawn::area(&args.figure, &mut needs, material.hardness_pa())?,
    };
    context.curve_to_table(&spectrum, needs, material.hardness_pa(), args.details, |_| {
        "the longest wavelength has no asperities yet: its row is empty".to_owned()
    })
}

/// Refuses options that the model has no use for.
fn refuse_idle_options(args: &StatisticalArgs, model: &ModelEntry) -> Result<(), Failure> {
    let idle = [
        ("--hardness", args.hardness.hardness.is_some(), Choice::Hardness),
        ("--interference-law", args.interference_law.is_some(), Choice::Interference),
    ];
    for (option, given, choice) in idle {
        if given && !model.has(choice) {
            let its_models = models::of_framework(Framework::Statistical).filter(|entry| entry.has(choice));
            let names: Vec<&str> = its_models.map(|entry| entry.name).collect();
            return Err(Failure::Input(format!(
                "{option} has no bearing on --model {model}, only on {}; leave it out",
                names.join(", ")
            )));
        }
    }
    refuse_idle_strength_cap(&args.material, model.name, model.has(Choice::Strength))
}

fn of_rows(input: &Place, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut rows = Populations::new();
    rows.counterface = counterface(&args.material.counterface)?;
    rows.options = options(args);
    rows.strength_cap = args.material.strength_cap.strength_cap;
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
    let hardness_and_strength =
        constants.add_strength(material.indentation_hardness, material.yield_strength)?;
    let length_m = material.strain_gradient_length.map(|length| length.m);
    constants.add_number("--strain-gradient-length", "strain_gradient_length_m", length_m);
    if args.pressures.len() + args.separations.len() > 1 {
        return Err(Failure::input("the rows of a table take one --pressure or one --separation"));
    }
    for (pressure, label) in &args.pressures {
        let pressure_pa = pressure
            .pascals(hardness_and_strength.hardness_pa())
            .ok_or(MaterialError::Missing(NeededFor::PressureInHardnesses))
            .map_err(|error| {
                Failure::Input(format!("--pressure {label}: {}", material_errors::told(&error)))
            })?;
        constants.add_number("--pressure", "pressure_pa", Some(pressure_pa));
    }
    for separation in &args.separations {
        constants.add_number("--separation", "separation_m", Some(separation.m));
    }
    Ok(constants)
}
