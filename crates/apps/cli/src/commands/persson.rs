//! `persson`: contact area, mean gap and stiffness by Persson's theory, from a spectrum or row by row of a table.

use std::path::Path;

use persson::hardness_laws::{HardnessError, HardnessTable};
use persson::separation::LightLoads;
use persson::{Cut, PerssonModel, Roughness};

use super::material_options::{loads, material};
use super::row_by_row::{self, Constants};
use super::{Context, Drawn, Spectrum, compute, say_doubts, say_notes, say_surface};
use crate::args::{GrowthArg, PerssonArgs};
use crate::failure::Failure;
use crate::files::open_table;
use crate::output::{Place, publish};
use crate::timings::Timings;
use findings::doubts::{Doubt, RealPressures};
use report::persson_words;
use report::provenance::provenance;
use report::summary::CurveCounts;
use staging::StagedFiles;
use state_tables::Flattened;
use study::gap_law;
use study::hardness_growth::{GrowthError, GrowthLaw, hardness_of};
use study::material::Material;
use study::models::{self, CurveModel, Framework, ModelOptions};
use study::persson_law::Deformation;
use study::plan::{Curve, CurveResult, Cutoffs, Needs, NominalPressure, Plan, Results};
use study::result_tables;
use units::Bound;

pub(super) fn run(args: &PerssonArgs, context: &Context<'_>) -> Result<(), Failure> {
    match (&args.psd, args.model, &args.input) {
        (Some(psd), Some(model), _) => over_cutoffs(psd, model, args, context),
        (None, _, Some(input)) => of_rows(input, args, context),
        _ => Err(Failure::input("give a spectrum with --model, or a table with --input")),
    }
}

fn over_cutoffs(
    psd: &str,
    deformation: Deformation,
    args: &PerssonArgs,
    context: &Context<'_>,
) -> Result<(), Failure> {
    refuse_idle_options(args, deformation)?;
    let material = material(&args.material)?;
    let model = model(args, deformation, &material)?;
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let mut needs = Needs {
        moments: Some(spectrum::Normalisation::Parseval),
        amplitudes: Some(args.amplitude.amplitude.unwrap_or_default()),
        loads,
        load_ranges,
        ..Needs::default()
    };
    let spectrum = Spectrum {
        psd,
        reading: &args.reading,
        sampling: args.sampling.sampling(),
        figure: Drawn::area(&args.figure, &mut needs, material.hardness_pa())?,
    };
    let mut timings = Timings::start();
    let surface = context.load(&spectrum)?;
    timings.lap("reading");
    let mut plan = Plan { psd: &surface.psd, sampling: spectrum.sampling, needs };
    let mut results = compute(&plan)?;
    let roughness = gap_law::roughness(&plan, &results, args.band.unwrap_or_default());
    let pressures_pa: Vec<f64> = plan.needs.pressures().map(NominalPressure::pa).collect();
    let rows = CurveResult::Persson(blocks(&model, &roughness, &pressures_pa, args.gamma)?);
    timings.lap("computing");

    say_surface(&surface);
    if let Some(correction) = args.correction {
        say_notes(persson_words::correction(correction, &roughness));
    }
    let separation = model.separation(&roughness, args.gamma).light_loads();
    let least_pa = pressures_pa.iter().copied().fold(f64::INFINITY, f64::min);
    say_notes(separation_notes(separation, &roughness, rms_height_m(&results), least_pa));
    let curve =
        Curve { name: "persson".to_owned(), model: named(deformation, &material)?, cutoffs: Cutoffs::Every };
    say_findings(&curve, &rows, &plan.needs, &material, args.hardness_law.is_some());

    let comments = provenance(context.typed, &surface, plan.sampling);
    let several = plan.needs.load_count() > 1;
    let table = result_tables::part_of_curve(&rows, &pressures_pa, several, false);
    let mut files = StagedFiles::default();
    if let Some(figure) = &spectrum.figure {
        plan.needs.curves.push(curve);
        results.curves.push(rows);
        let data = figure.of.data(&results, &plan.needs, figure.hardness_pa);
        context.stage_picture(&mut files, figure.picture, &data, &surface.name, &comments)?;
    }
    context.stage_blocks(&mut files, &context.shared.output, context.wanted(&comments), |out| {
        Ok(out.block(&table)?)
    })?;
    publish(files)?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

/// Refuses options that the model has no use for.
fn refuse_idle_options(args: &PerssonArgs, deformation: Deformation) -> Result<(), Failure> {
    let idle = |option: &str, why: &str| {
        Err(Failure::Input(format!("{option} has no bearing on --model {deformation}{why}; leave it out")))
    };
    let material = &args.material;
    let grows = args.hardness_law.is_some() || material.strain_gradient_length.is_some();
    match deformation {
        Deformation::Elastic if args.hardness_law.is_some() => {
            idle("--hardness-law", ", which does not yield")
        }
        Deformation::Elastic if material.strength_cap.strength_cap.is_some() => {
            idle("--strength-cap", ", which does not yield")
        }
        Deformation::ElasticPlastic if args.correction.is_some() => {
            idle("--correction", ": the corrected forms are elastic ones")
        }
        Deformation::ElasticPlastic if material.strength_cap.strength_cap.is_some() && !grows => idle(
            "--strength-cap",
            " without --hardness-law or --strain-gradient-length: the hardness does not grow",
        ),
        Deformation::ElasticPlastic
            if material.strain_gradient_length.is_some()
                && args
                    .hardness_law
                    .as_ref()
                    .is_some_and(|law| *law != GrowthArg::Law(GrowthLaw::NixGao)) =>
        {
            idle("--strain-gradient-length", " with a --hardness-law other than nix-gao")
        }
        _ => Ok(()),
    }
}

/// The theory as the options have it.
fn model(args: &PerssonArgs, deformation: Deformation, material: &Material) -> Result<PerssonModel, Failure> {
    let contact_modulus_pa = material.pair.composite_modulus_pa();
    if deformation == Deformation::Elastic {
        return Ok(PerssonModel::Elastic { contact_modulus_pa, correction: args.correction });
    }
    let law = match &args.hardness_law {
        None => args.material.strain_gradient_length.map(|_| GrowthLaw::NixGao),
        Some(GrowthArg::Law(law)) => Some(law.clone()),
        Some(GrowthArg::Table(path)) => Some(GrowthLaw::Table(table_of_hardnesses(path)?)),
    };
    let hardness = hardness_of(material, law.as_ref()).map_err(|error| match error {
        GrowthError::Material(error) => error.into(),
        GrowthError::Hardness(error) => Failure::input(error),
    })?;
    Ok(PerssonModel::ElasticPlastic { contact_modulus_pa, hardness })
}

fn table_of_hardnesses(path: &Path) -> Result<HardnessTable, Failure> {
    let place = Place::from(path.to_string_lossy().as_ref());
    let table = open_table(&place)?.whole()?;
    let columns = [("contact_size_m", Bound::Magnitude), ("hardness_pa", Bound::Magnitude)];
    let rows = table.numbers(columns)?;
    HardnessTable::new(rows.into_iter().map(|[size_m, hardness_pa]| (size_m, hardness_pa)))
        .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}

/// The model by the name that scenes give it.
fn named(deformation: Deformation, material: &Material) -> Result<CurveModel, Failure> {
    let name = match deformation {
        Deformation::Elastic => "persson",
        Deformation::ElasticPlastic => "persson-plastic",
    };
    let entry = models::named(Framework::Persson, name).map_err(Failure::input)?;
    // A table brings its own hardness.
    if deformation == Deformation::ElasticPlastic && material.hardness_pa().is_none() {
        return named(Deformation::Elastic, material);
    }
    Ok(entry.build(material, &ModelOptions::default())?)
}

fn blocks(
    model: &PerssonModel,
    roughness: &Roughness,
    pressures_pa: &[f64],
    gamma: f64,
) -> Result<Vec<Vec<Cut>>, Failure> {
    let separation = model.separation(roughness, gamma);
    let of_load = |&pressure_pa: &f64| model.along(roughness, &separation, pressure_pa);
    parallel::try_map(pressures_pa, of_load).map_err(|error: HardnessError| Failure::input(error))
}

fn rms_height_m(results: &Results) -> f64 {
    results.moments.last().map_or(0.0, |(moments, _)| moments.rms_height_m())
}

fn separation_notes(
    separation: Option<LightLoads>,
    roughness: &Roughness,
    rms_height_m: f64,
    least_pa: f64,
) -> Vec<String> {
    separation
        .map_or_else(Vec::new, |light| persson_words::separation(&light, roughness, rms_height_m, least_pa))
}

/// Says what the curve leaves open or goes beyond.
fn say_findings(curve: &Curve, rows: &CurveResult, needs: &Needs, material: &Material, grows: bool) {
    let mut counts = CurveCounts::default();
    counts.add(rows);
    say_notes(counts.notes());
    // A hardness that grows bears more than that of the bulk.
    let hardness_pa = material.hardness_pa().filter(|_| !grows);
    let labels = needs.loads.iter().map(|load| Some(load.label.as_str())).chain(std::iter::repeat(None));
    say_doubts(Doubt::of_pressures(needs.pressures().zip(labels), hardness_pa));
    let mut real_pressures = RealPressures::new(hardness_pa);
    let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
    real_pressures.add_part(curve, rows, &pressures_pa);
    say_doubts(real_pressures.doubts());
}

fn of_rows(input: &Place, args: &PerssonArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut constants = Constants::default();
    if args.pressures.len() > 1 {
        return Err(Failure::input("the rows of a table take one --pressure"));
    }
    let hardness_pa = args.material.indentation_hardness.map(|hardness| hardness.pa);
    if args.model == Some(Deformation::Elastic) && hardness_pa.is_some() {
        return Err(Failure::input(
            "--indentation-hardness has no bearing on --model elastic, which does not yield; leave it out",
        ));
    }
    for (pressure, label) in &args.pressures {
        let pressure_pa = pressure.pascals(hardness_pa).ok_or_else(|| {
            Failure::Input(format!(
                "--pressure {label}: a pressure in H needs the hardness: give --indentation-hardness"
            ))
        })?;
        constants.add_number("--pressure", "pressure_pa", Some(pressure_pa));
    }
    constants.add_number("--indentation-hardness", "hardness_pa", hardness_pa);
    let yields = args.model.map(|model| model == Deformation::ElasticPlastic);
    row_by_row::run(input, &constants, &mut Flattened::new(yields), context)
}
