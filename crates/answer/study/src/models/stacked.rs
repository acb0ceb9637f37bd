//! Archard's stack of scales.

use asperity::MaterialPair;
use stacked_contact::{FinalLevels, Level, Scale, StackedModel, levels_under_loads};
use tables::Table;

use super::{Choice, CurveResult, Framework, Job, ModelEntry, ModelOptions, Theory};
use crate::model_options::unless_default;
use crate::plan::error::PlanError;
use crate::plan::prepared_spectrum::Cutoffs;
use crate::plan::work::Work;

/// Loads computed together share the load-independent work of each level. More than 8 gain nothing (measured).
const LOADS_PER_BLOCK: usize = 8;

/// The stacks.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "elastic",
        short_name: "Archard, elastic",
        full_name: "Archard stack, elastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Jackson & Streator (2006), Wear 261:1337",
        aliases: &["archard", "archardstack", "jacksonstreator"],
        framework: Framework::Stacked,
        choices: &[],
        takes_moments: false,
        build: |material, _| Ok(Theory::Stacked(StackedModel::Elastic { pair: material.pair })),
    },
    ModelEntry {
        name: "elastic-plastic",
        short_name: "Archard, elastic-plastic",
        full_name: "Archard stack, elastic-plastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Krithivasan & Jackson (2007), Tribol. Lett. 27:31",
        aliases: &[],
        framework: Framework::Stacked,
        choices: &[Choice::Strength, Choice::StrainGradient, Choice::YieldingArea],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            let area = options.elastic_plastic_area.unwrap_or_default();
            Ok(Theory::Stacked(StackedModel::ElasticPlastic { pair: material.pair, strength, area }))
        },
    },
];

/// Returns the same stack of other bodies in contact.
pub(super) fn with_pair(model: &StackedModel, pair: MaterialPair) -> Theory {
    Theory::Stacked(match *model {
        StackedModel::Elastic { .. } => StackedModel::Elastic { pair },
        StackedModel::ElasticPlastic { strength, area, .. } => {
            StackedModel::ElasticPlastic { pair, strength, area }
        }
    })
}

/// Returns the options of a stack that differ from their defaults, but for the strain gradient.
pub(super) fn options(model: &StackedModel) -> ModelOptions {
    let mut options = ModelOptions::default();
    if let StackedModel::ElasticPlastic { area, .. } = model {
        options.elastic_plastic_area = unless_default(*area);
    }
    options
}

/// Computes a block of levels for every nominal pressure \[Pa\].
///
/// # Errors
/// [`PlanError::Cancelled`].
pub(super) fn blocks(
    model: &StackedModel,
    job: &Job<'_>,
    pressures_pa: &[f64],
) -> Result<(CurveResult, Work), PlanError> {
    let (scales, run) = (&job.prepared.scales[..], job.run);
    let (blocks, stacked_levels) = match job.cutoffs {
        Cutoffs::Every => {
            let together: Vec<&[f64]> = pressures_pa.chunks(LOADS_PER_BLOCK).collect();
            let blocks = numerics::parallel::try_map(&together, |pressures_pa| {
                run.go_on().map(|()| levels_together(model, pressures_pa, scales))
            })?;
            (blocks.into_iter().flatten().collect(), pressures_pa.len() * scales.len())
        }
        Cutoffs::Shortest => {
            let stack = FinalLevels::new(model, scales);
            let ends = numerics::parallel::try_map(pressures_pa, |&pressure_pa| {
                run.go_on().map(|()| stack.under(pressure_pa))
            })?;
            let visited = ends.iter().flatten().map(|end| end.visited).sum();
            (ends.iter().map(|end| end.iter().map(|end| end.level).collect()).collect(), visited)
        }
    };
    Ok((CurveResult::Stacked(blocks), Work { stacked_levels, ..Work::default() }))
}

fn levels_together(model: &StackedModel, pressures_pa: &[f64], scales: &[Scale]) -> Vec<Vec<Level>> {
    let mut blocks = vec![Vec::with_capacity(scales.len()); pressures_pa.len()];
    for (at, level) in levels_under_loads(model, pressures_pa, scales.iter().copied()).enumerate() {
        blocks[at % pressures_pa.len()].push(level);
    }
    blocks
}

/// Returns wavelength \[m\], area fraction and real pressure \[Pa\] of a level.
pub(super) fn point(level: &Level) -> [f64; 3] {
    [level.wavelength_m, level.area_fraction, level.real_pressure_pa]
}

/// Appends the columns of the levels to a table of their loads, with `details` of how each was found.
pub(super) fn table(loads: Table, blocks: &[Vec<Level>], details: bool) -> Table {
    let column = |of: fn(&Level) -> f64| blocks.iter().flatten().map(of);
    let table = loads
        .with_numbers("wavelength_m", column(|level| level.wavelength_m))
        .with_numbers("amplitude_m", column(|level| level.amplitude_m))
        .with_numbers("area_fraction", column(|level| level.area_fraction))
        .with_numbers("real_pressure_pa", column(|level| level.real_pressure_pa))
        .with_words("regime", blocks.iter().flatten().map(|level| level.regime.name()));
    if !details {
        return table;
    }
    // An infinite strength, of a scale above which nothing was deformed, is an empty cell like an unneeded one.
    let strength = |level: &Level| level.yield_strength_pa.filter(|strength_pa| strength_pa.is_finite());
    table
        .with_numbers("pressure_in_pa", column(|level| level.pressure_in_pa))
        .with_numbers("yield_strength_pa", blocks.iter().flatten().map(strength))
}
