//! `gap`: mean gap and stiffness of a surface under loads.

use report::provenance::provenance;
use report::{elements_words, gap_words};
use rough_bem::{Pressing, Surfaces};
use staging::StagedFiles;
use study::gap_law::{GapChoices, GapError, GapLaw, GapState};
use study::material::Material;
use study::models::{Choice, Framework, ModelEntry, ModelOptions};
use study::plan::{Needs, NominalPressure, Plan, Tolerance};
use study::result_tables;
use study::surface::Surface;

use super::material_options::{loads, material, refuse_idle_strength_cap, say_assumed_strength};
use super::{Context, Spectrum, bem, compute, say_doubts, say_notes, say_surface};
use crate::args::{GapArgs, GapChoiceArgs, GapModel};
use crate::failure::Failure;
use crate::output::publish;
use crate::progress::Progress;
use crate::timings::Timings;
use findings::doubts::Doubt;

/// What makes a law take the waves of the surface.
pub(super) const BY_SURFACE: &str = "--band 2d";

pub(super) fn run(args: &GapArgs, context: &Context<'_>) -> Result<(), Failure> {
    match args.model {
        GapModel::Curve(entry) => refuse_idle_options(&args.choices, entry)?,
        GapModel::Elements => refuse_options_of_models(args)?,
    }
    if let (GapModel::Curve(entry), Some(option)) = (args.model, args.random.given().next()) {
        return Err(Failure::Input(format!(
            "{option} has no bearing on --model {entry}, only on bem; leave it out"
        )));
    }
    let material = material(&args.choices.material)?;
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let needs = Needs { loads, load_ranges, ..Needs::default() };
    let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
    let mut timings = Timings::start();
    let surface = load(&args.psd, &args.reading, &args.choices, context)?;
    timings.lap("reading");
    say_surface(&surface);
    let (states, light) = match args.model {
        GapModel::Curve(entry) => {
            let law = law(entry, &args.choices, args.tolerance, &material, &surface)?;
            let state = |&pressure_pa: &f64| law.at(pressure_pa);
            let states = parallel::try_map(&pressures_pa, state)?;
            let least_pa = pressures_pa.iter().copied().fold(f64::INFINITY, f64::min);
            say_notes(gap_words::of_law(&law, least_pa, BY_SURFACE));
            let rms_height_m = law.light_loads().is_none().then(|| law.rms_height_m());
            say_notes(gap_words::of_states(&states, rms_height_m));
            (states, law.light_loads())
        }
        GapModel::Elements => (by_elements(args, &material, pressures_pa, &surface)?, None),
    };
    timings.lap("computing");
    let table = result_tables::gaps(&states, light.as_ref());
    let comments = provenance(context.typed, &surface, args.choices.sampling.sampling());
    let mut files = StagedFiles::default();
    context.stage_blocks(&mut files, &context.shared.output, context.wanted(&comments), |out| {
        Ok(out.block(&table)?)
    })?;
    publish(files)?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

impl From<GapError> for Failure {
    fn from(error: GapError) -> Self {
        Failure::input(error)
    }
}

/// The spectrum as a command is given it.
pub(super) fn load(
    psd: &str,
    reading: &crate::args::ReadingArgs,
    choices: &GapChoiceArgs,
    context: &Context<'_>,
) -> Result<Surface, Failure> {
    context.load(&Spectrum { psd, reading, sampling: choices.sampling.sampling(), figure: None })
}

/// The law of a model with the whole spectrum.
pub(super) fn law(
    entry: &'static ModelEntry,
    choices: &GapChoiceArgs,
    tolerance: Tolerance,
    material: &Material,
    surface: &Surface,
) -> Result<GapLaw, Failure> {
    say_assumed_strength(material, entry);
    let options = ModelOptions {
        strain_gradient: choices.material.strain_gradient_length.is_some(),
        hardness: choices.hardness.hardness,
        interference_law: choices.interference_law,
        ..ModelOptions::default()
    };
    let model = entry.build(material, &options)?;
    let normalisation = match entry.framework {
        Framework::Persson => spectrum::Normalisation::Parseval,
        _ => choices.normalisation.normalisation.unwrap_or_default(),
    };
    let needs = Needs {
        moments: Some(normalisation),
        amplitudes: model.needs_amplitudes().then(Default::default),
        ..Needs::default()
    };
    let plan = Plan { psd: &surface.psd, sampling: choices.sampling.sampling(), needs };
    let results = compute(&plan)?;
    let band = choices.band.unwrap_or_default();
    let choices = GapChoices { energy_factor: choices.energy_factor(), band, tolerance };
    Ok(GapLaw::of(&model, &plan, &results, &choices)?)
}

/// Refuses options that the model has no use for.
pub(super) fn refuse_idle_options(choices: &GapChoiceArgs, entry: &ModelEntry) -> Result<(), Failure> {
    let persson = entry.framework == Framework::Persson;
    let idle = [
        ("--gamma", choices.gamma.is_some() && !persson),
        ("--band", choices.band.is_some() && !persson),
        ("--normalisation", choices.normalisation.normalisation.is_some() && persson),
        ("--hardness", choices.hardness.hardness.is_some() && !entry.has(Choice::Hardness)),
        ("--interference-law", choices.interference_law.is_some() && !entry.has(Choice::Interference)),
    ];
    if let Some((option, _)) = idle.into_iter().find(|(_, idle)| *idle) {
        return Err(Failure::Input(format!("{option} has no bearing on --model {entry}; leave it out")));
    }
    refuse_idle_strength_cap(&choices.material, entry.name, entry.has(Choice::Strength))
}

/// Refuses options that boundary elements have no use for.
fn refuse_options_of_models(args: &GapArgs) -> Result<(), Failure> {
    let choices = &args.choices;
    let idle = [
        ("--gamma", choices.gamma.is_some()),
        ("--normalisation", choices.normalisation.normalisation.is_some()),
        ("--hardness", choices.hardness.hardness.is_some()),
        ("--interference-law", choices.interference_law.is_some()),
        ("--strain-gradient-length", choices.material.strain_gradient_length.is_some()),
        ("--strength-cap", choices.material.strength_cap.strength_cap.is_some()),
        ("--scales-per-decade", choices.sampling.scales_per_decade.is_some()),
        ("--cutoff", choices.sampling.cutoff.is_some()),
    ];
    match idle.into_iter().find(|(_, idle)| *idle) {
        None => Ok(()),
        Some((option, _)) => Err(Failure::Input(format!(
            "{option} has no bearing on --model bem, which is elastic and takes its waves by --longest and --shortest; \
             leave it out"
        ))),
    }
}

/// The mean of random surfaces under elastic boundary elements.
fn by_elements(
    args: &GapArgs,
    material: &Material,
    pressures_pa: Vec<f64>,
    surface: &Surface,
) -> Result<Vec<GapState>, Failure> {
    let modulus_pa = material.pair.composite_modulus_pa();
    let pressing = Pressing { pressures_pa, stiffness: true, ..Pressing::elastic(modulus_pa) };
    pressing.check().map_err(Failure::input)?;
    let random = bem::random_surfaces(surface, &args.random, &pressing)?;
    let rms_height_m = random.band.mean_square_height_m2().sqrt();
    let surfaces = Surfaces::Random(random);
    let progress = Progress::towards(rough_bem::progress_steps(&surfaces, &pressing), "steps");
    let pressed = rough_bem::press::<Failure>(&surfaces, &pressing, |_| Ok(()), &progress)?;
    drop(progress);
    say_notes(elements_words::of_results(&pressed));
    let states = gap_words::states_of_elements(&pressed);
    say_notes(gap_words::of_states(&states, Some(rms_height_m)));
    Ok(states)
}
