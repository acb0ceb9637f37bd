//! `persson`: contact area, mean gap and stiffness by Persson's theory, from a spectrum or row by row of a table.

use std::path::Path;

use measurements::ScanRequest;
use questions::CurveQuestion;
use questions::rows::Flattened;
use study::growth_law::GrowthLaw;
use study::models::{self, Framework, ModelOptions};
use study::persson_law::Deformation;

use super::Context;
use super::row_by_row::{self, Constants};
use crate::args::{GrowthArg, PerssonArgs};
use crate::failure::Failure;
use crate::files::whole_table;
use crate::flags::PerssonFlags;
use crate::place::Place;

pub(super) fn run(args: &PerssonArgs, context: &Context<'_>) -> Result<(), Failure> {
    match (&args.psd[..], args.model, &args.input) {
        (psd @ [_, ..], Some(model), _) => over_cutoffs(psd, model, args, context),
        ([], _, Some(input)) => of_rows(input, args, context),
        _ => Err(Failure::input("give a spectrum with --model, or a table with --input")),
    }
}

fn over_cutoffs(
    psd: &[ScanRequest],
    deformation: Deformation,
    args: &PerssonArgs,
    context: &Context<'_>,
) -> Result<(), Failure> {
    let model = models::named(Framework::Persson, deformation.model_name()).map_err(Failure::input)?;
    let material = args.material.input();
    let hardness_law = args.hardness_law.as_ref().map(|law| match law {
        GrowthArg::Law(law) => Ok(law.clone()),
        GrowthArg::Table(path) => table_of_hardnesses(path),
    });
    let hardness_law = hardness_law.transpose()?;
    let has_length = material.strain_gradient_length_m.is_some();
    let figure = args.figure.figure.as_ref();
    let question = CurveQuestion {
        model: Some(model),
        name: Some("persson".to_owned()),
        options: ModelOptions {
            strain_gradient: has_length && hardness_law != Some(GrowthLaw::NixGao),
            hardness_law,
            ..args.options()
        },
        material,
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        sampling: args.sampling.input(),
        amplitude: args.amplitude.amplitude,
        figure: figure.is_some(),
        ..CurveQuestion::default()
    };
    context.curve(&question, psd, &args.reading, figure, &PerssonFlags)
}

fn table_of_hardnesses(path: &Path) -> Result<GrowthLaw, Failure> {
    let table = whole_table(&Place::File(path.to_owned()))?;
    GrowthLaw::from_table(&table).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}

fn of_rows(input: &Place, args: &PerssonArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut constants = Constants::default();
    if args.loads.pressures.len() > 1 {
        return Err(Failure::input("the rows of a table take one --pressure"));
    }
    let hardness_pa = args.material.bodies.indentation_hardness.map(|hardness| hardness.pa);
    constants.add_pressure(&args.loads.pressures, hardness_pa)?;
    constants.add_number("indentation_hardness", "hardness_pa", hardness_pa);
    let yields = args.model.map(|model| model == Deformation::ElasticPlastic);
    row_by_row::run(input, &constants, &mut Flattened::new(yields), context)
}
