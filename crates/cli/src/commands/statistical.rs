//! `statistical`: populations of asperities, from a spectrum or row by row of a table.

use asperity::{Bound, ElasticBody, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, ContactState, Model, Population, StatisticalContact};

use super::row_by_row::{self, RowByRow};
use super::{Context, loads, material, say_doubts, say_notes};
use crate::args::{GivenColumn, StatisticalArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use report::summary::StateCounts;
use study::Progress as _;
use study::doubts::Doubt;
use study::material::strength;
use study::plan::{Curve, CurveModel, Cutoffs, Needs, NominalPressure};
use study::result_tables::STATE_DETAILS;
use tables::{Cell, Cells, InputTable, Refusal, Row};
use units::number;

pub(super) fn run(args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    say_notes(args.tolerance.asked_finer().map(|asked| {
        let used = number(args.tolerance.value());
        format!("--tolerance {} is finer than double precision reaches: {used} is used", number(asked))
    }));
    match (&args.psd, &args.input) {
        (Some(psd), _) => over_cutoffs(psd, args, context),
        (None, Some(input)) => {
            let counterface = context.counterface()?;
            let counts = StateCounts::default();
            row_by_row::run(input, &mut Populations { args, context, counterface, counts }, context)
        }
        (None, None) => Err(Failure::input("give a spectrum, or a table with --input")),
    }
}

fn over_cutoffs(psd: &str, args: &StatisticalArgs, context: &Context<'_>) -> Result<(), Failure> {
    let model = args.model.ok_or_else(|| Failure::input("a spectrum needs --model"))?;
    let material = material(&args.material, context)?;
    let hardness = context.shared.hardness.unwrap_or_default();
    let gradient = args.material.strain_gradient_length.is_some();
    let law =
        material.statistical(model, gradient, hardness, args.interference_law).map_err(Failure::input)?;
    say_doubts(Doubt::of_material(&material));
    let (loads, load_ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let needs = Needs {
        moments: Some(context.shared.normalisation.unwrap_or_default()),
        curves: vec![Curve {
            name: model.to_string(),
            model: CurveModel::Statistical { pair: material.pair, law },
            cutoffs: Cutoffs::Every,
        }],
        loads,
        load_ranges,
        separations_m: args.separations.iter().map(|separation| separation.m).collect(),
        tolerance: args.tolerance,
        ..Needs::default()
    };
    context.curve_to_table(psd, &args.reading, needs, material.hardness_pa(), args.details, |_| {
        "the longest wavelength has no asperities yet: its row is empty".to_owned()
    })
}

/// A row of the table: a population, and what it is asked at.
struct Asked {
    contact: StatisticalContact,
    at: At,
}

#[derive(Clone, Copy)]
enum At {
    Separation(f64),
    Pressure(f64),
}

const REQUIRED_COLUMNS: [&str; 6] =
    ["model", "youngs_modulus_pa", "poisson_ratio", "radius_m", "density_per_m2", "sigma_s_m"];

/// A table of populations.
struct Populations<'a> {
    args: &'a StatisticalArgs,
    context: &'a Context<'a>,
    counterface: Option<ElasticBody>,
    counts: StateCounts,
}

impl RowByRow for Populations<'_> {
    fn check(&self, block: &InputTable) -> Result<(), Refusal> {
        self.asked(block).map(|_| ())
    }

    fn fill_in(&mut self, block: &mut InputTable, progress: &Progress) -> Result<(), Failure> {
        let asked = self.asked(block)?;
        let tolerance = self.args.tolerance.value();
        let state = |Asked { contact, at }: &Asked| {
            let state = match at {
                At::Separation(separation_m) => contact.at_separation(*separation_m, tolerance),
                At::Pressure(pressure_pa) => contact.at_pressure(*pressure_pa, tolerance, None),
            };
            progress.advance(1);
            state
        };
        let states = parallel::try_map(&asked, state).map_err(Failure::input)?;
        progress.aside(|| say_notes(beyond_complete_contact(block, &asked, &states)));
        self.counts.add(&states);
        fill_in(block, &asked, &states, self.args.details);
        Ok(())
    }

    fn notes(&self) -> Vec<String> {
        self.counts.notes()
    }
}

impl Populations<'_> {
    fn asked(&self, block: &InputTable) -> Result<Vec<Asked>, Refusal> {
        block.rows(&REQUIRED_COLUMNS, |row| self.read(row))
    }

    fn read(&self, row: &Row<'_>) -> Result<Asked, String> {
        let model: Model =
            row.text("model").trim().parse().map_err(|error| format!("column model: {error}"))?;
        let modulus_pa = row.number("youngs_modulus_pa", Bound::Positive)?;
        let poisson_ratio = row.number("poisson_ratio", ElasticBody::POISSON_RATIO)?;
        let body = ElasticBody::new(modulus_pa, poisson_ratio).map_err(|error| error.to_string())?;
        let pair = self
            .counterface
            .map_or(MaterialPair::against_rigid(body), |other| MaterialPair::against(body, other));
        let [radius_m, density_per_m2, sigma_s_m] = [
            row.number("radius_m", Bound::Positive)?,
            row.number("density_per_m2", Bound::Positive)?,
            row.number("sigma_s_m", Bound::Positive)?,
        ];
        let population =
            Population::new(radius_m, density_per_m2, sigma_s_m).map_err(|error| error.to_string())?;
        let contact = StatisticalContact::new(&pair, &population, &self.law(model, row)?);
        Ok(Asked { contact, at: self.asked_at(row)? })
    }

    fn law(&self, model: Model, row: &Row<'_>) -> Result<AsperityLaw, String> {
        Ok(match model {
            Model::Hertz => AsperityLaw::Hertz,
            Model::ElasticSine => AsperityLaw::ElasticSine { interference: self.args.interference_law },
            Model::EpSphere => AsperityLaw::EpSphere {
                strength: self.strength(row)?,
                hardness: self.context.shared.hardness.unwrap_or_default(),
            },
            Model::EpSine => AsperityLaw::EpSine { strength: self.strength(row)? },
        })
    }

    fn strength(&self, row: &Row<'_>) -> Result<NixGao, String> {
        let strength_pa = row.number("yield_strength_pa", Bound::Positive)?;
        let length_m = row.optional_number("strain_gradient_length_m", Bound::Positive)?;
        strength(strength_pa, length_m, self.context.shared.strength_cap).map_err(|error| error.to_string())
    }

    fn asked_at(&self, row: &Row<'_>) -> Result<At, String> {
        let separation = || row.optional_number("separation_m", Bound::Finite);
        let pressure = || -> Result<Option<f64>, String> {
            let pressure_pa = row.optional_number("pressure_pa", Bound::Positive)?;
            let pressure = pressure_pa.map(NominalPressure::new).transpose();
            pressure
                .map(|pressure| pressure.map(NominalPressure::pa))
                .map_err(|error| format!("column pressure_pa: {error}"))
        };
        match self.args.given {
            Some(GivenColumn::Separation) => separation()?.map(At::Separation).ok_or_else(|| {
                "column separation_m: the cell is empty, and --given separation needs it".to_owned()
            }),
            Some(GivenColumn::Pressure) => pressure()?.map(At::Pressure).ok_or_else(|| {
                "column pressure_pa: the cell is empty, and --given pressure needs it".to_owned()
            }),
            None => match (separation()?, pressure()?) {
                (Some(separation_m), None) => Ok(At::Separation(separation_m)),
                (None, Some(pressure_pa)) => Ok(At::Pressure(pressure_pa)),
                (Some(_), Some(_)) => Err(
                    "columns separation_m and pressure_pa are both filled; say with --given which one counts"
                        .to_owned(),
                ),
                (None, None) => {
                    Err("columns separation_m and pressure_pa are both empty; fill one".to_owned())
                }
            },
        }
    }
}

fn beyond_complete_contact(input: &InputTable, asked: &[Asked], states: &[ContactState]) -> Vec<String> {
    let rows = asked.iter().zip(states).enumerate().filter(|(_, (_, state))| state.separation_m.is_none());
    rows.map(|(row, (asked, state))| {
        format!(
            "{}: {} Pa is beyond complete contact of every asperity: area fraction 1, no separation; every pressure \
             below {} Pa has one",
            input.row_name(row),
            number(state.pressure_pa),
            number(asked.contact.highest_pressure_pa())
        )
    })
    .collect()
}

/// What was given stays as typed; the rest is computed.
fn fill_in(input: &mut InputTable, asked: &[Asked], states: &[ContactState], details: bool) {
    let computed = |value: Option<f64>| value.map_or_else(|| Cell::Field(String::new()), Cell::Computed);
    let mut filled = |name: &str, given: fn(&At) -> bool, of: fn(&ContactState) -> Option<f64>| {
        let typed = input.table.column(name).cloned();
        let cell = |row: usize| match &typed {
            Some(Cells::Typed(cells)) if given(&asked[row].at) => cells[row].clone(),
            _ => computed(of(&states[row])),
        };
        let cells = (0..states.len()).map(cell).collect();
        input.table.set(name, Cells::Typed(cells));
    };
    filled("separation_m", |at| matches!(at, At::Separation(_)), |state| state.separation_m);
    filled("pressure_pa", |at| matches!(at, At::Pressure(_)), |state| Some(state.pressure_pa));
    filled("area_fraction", |_| false, |state| Some(state.area_fraction));
    if details {
        for (name, of) in STATE_DETAILS {
            input.table.set(name, Cells::Numbers(states.iter().map(of).collect()));
        }
    }
}
