//! Populations of asperities pressed to a separation or under a pressure, row by row.

use asperity::{Bound, ElasticBody};
use numerics::parallel::Progress;
use stat_contact::{Condition, ContactState, NoSeparation, Population, Sweep};
use tables::{Cell, Cells, InputTable, Refusal, Row};
use units::{Pressure, Remark, RemarkCode};

use super::contact_states::{RowRoughness, StatesFound, is_above};
use super::strength_columns::{
    INDENTATION_HARDNESS, STRAIN_GRADIENT_LENGTH, YIELD_STRENGTH, hardness_and_strength,
};
use super::{INPUT_COLUMNS, RowByRow, RowsError, StateCounts, rows_of};
use study::body_properties::BodyProperty;
use study::material::{GivenMaterial, Material, MaterialError};
use study::models::{self, Choice, Framework, ModelEntry, ModelOptions, Pressable, Statistical};
use study::plan::{NominalPressure, Tolerance};
use study::result_tables::STATE_DETAILS;

/// The column that rows with both filled are computed from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenColumn {
    /// `separation_m`
    Separation,
    /// `pressure_pa`
    Pressure,
}

units::named!(GivenColumn, "column that is given", { Separation => "separation", Pressure => "pressure" });

/// A table of populations, with what holds for all of its rows.
#[derive(Debug, Default)]
pub struct Populations {
    /// The counterface; rigid if `None`.
    pub counterface: Option<ElasticBody>,
    /// The options of the laws; the rows decide whether the strength grows.
    pub options: ModelOptions,
    /// The cap of a growing strength.
    pub strength_cap: Option<Pressure>,
    /// The column that counts if both are filled.
    pub given: Option<GivenColumn>,
    /// The remedy for rows with both filled, in the words of the front end.
    pub how_to_say_given: &'static str,
    /// Relative tolerance of the states.
    pub tolerance: Tolerance,
    /// True to append columns on how each state was found.
    pub details: bool,
    found: StatesFound,
    /// The models of the rows checked so far, each once.
    models: Vec<&'static ModelEntry>,
    /// True if the strength grows in a row checked so far.
    grows: bool,
    /// True if a row checked so far gives its separation, its pressure.
    given_columns: [bool; 2],
}

/// A row of the table: a population and the condition of its state.
struct RowRequest {
    contact: Pressable,
    at: Condition,
    /// True if a third of the hardness is used as the yield strength.
    strength_is_assumed: bool,
    entry: &'static ModelEntry,
    grows: bool,
    /// Hardness \[Pa\] that an elastic model does not count, if one is known.
    hardness_pa: Option<f64>,
    /// Asperities of one curvature, and their plasticity index where a hardness is known.
    population: Option<(Population, Option<f64>)>,
}

const REQUIRED_COLUMNS: [&str; 3] = ["model", "youngs_modulus_pa", "poisson_ratio"];

impl Populations {
    /// The requests of all rows; `None` for a row without asperities.
    fn asked(&self, block: &InputTable) -> Result<Vec<Option<RowRequest>>, Refusal> {
        block.rows(&required_columns(block)?, |row| self.read(row))
    }

    fn read(&self, row: &Row<'_>) -> Result<Option<RowRequest>, String> {
        let entry = models::named(Framework::Statistical, row.text("model").trim())
            .map_err(|error| format!("column model: {error}"))?;
        let is_plastic = entry.has(Choice::Strength);
        let material = self.material(row, is_plastic)?;
        let strength_is_assumed = is_plastic && material.assumed_yield_strength_pa().is_some();
        let grows = material.strain_gradient_length_m().is_some();
        let hardness_pa = material.hardness_pa().filter(|_| !is_plastic);
        let contact = self.contact(row, entry, &material)?;
        contact
            .map(|contact| {
                let (at, modulus_pa) = (self.condition(row)?, material.pair.composite_modulus_pa());
                let numbers = RowRoughness::ASPERITIES.map(|column| row.number(column, Bound::Magnitude));
                let population = match (entry.takes_moments, numbers) {
                    (false, [Ok(radius), Ok(density), Ok(sigma)]) => {
                        Population::new(radius, density, sigma).ok()
                    }
                    _ => None,
                };
                let index = |of: &Population| Some(of.plasticity_index(modulus_pa, material.hardness_pa()?));
                let population = population.map(|of| (of, index(&of)));
                Ok(RowRequest { contact, at, strength_is_assumed, entry, grows, hardness_pa, population })
            })
            .transpose()
    }

    /// The contact of a row, if it has a population. The material is checked in any case.
    fn contact(
        &self,
        row: &Row<'_>,
        entry: &'static ModelEntry,
        material: &Material,
    ) -> Result<Option<Pressable>, String> {
        let strain_gradient =
            entry.has(Choice::Strength) && !row.text(STRAIN_GRADIENT_LENGTH).trim().is_empty();
        let model = entry.build(material, &ModelOptions { strain_gradient, ..self.options.clone() });
        let model = model.map_err(|error| missing_cell(&error))?;
        let columns = RowRoughness::columns(entry);
        if columns.iter().all(|column| row.text(column).trim().is_empty()) {
            return Ok(None);
        }
        let [first, second, third] = columns.map(|column| row.number(column, Bound::Magnitude));
        let roughness = RowRoughness([first?, second?, third?]);
        let press = |statistical: &Statistical| statistical.press(roughness.0);
        model.statistical().map(press).transpose().map_err(|error| error.to_string())
    }

    /// The material of a row. Its strength is ignored if the model has none.
    fn material(&self, row: &Row<'_>, strong: bool) -> Result<Material, String> {
        let modulus_pa = row.number("youngs_modulus_pa", Bound::Magnitude)?;
        let poisson_ratio = row.number("poisson_ratio", ElasticBody::POISSON_RATIO)?;
        let optional = |column| if strong { row.optional_number(column, Bound::Magnitude) } else { Ok(None) };
        let body = ElasticBody::new(modulus_pa, poisson_ratio).map_err(|error| error.to_string())?;
        Ok(Material::new(GivenMaterial {
            counterface: self.counterface,
            hardness_and_strength: hardness_and_strength(row, Bound::Magnitude)?,
            strength_cap: self.strength_cap,
            strain_gradient_length_m: optional(STRAIN_GRADIENT_LENGTH)?,
            ..GivenMaterial::new(body)
        }))
    }

    fn condition(&self, row: &Row<'_>) -> Result<Condition, String> {
        let separation = || row.optional_number("separation_m", Sweep::SEPARATION_M);
        let pressure = || {
            // Reports invalid pressures before too large ones.
            row.optional_number("pressure_pa", Bound::Positive)?;
            row.optional_number("pressure_pa", NominalPressure::BOUND)
        };
        match self.given {
            Some(GivenColumn::Separation) => separation()?.map(Condition::Separation).ok_or_else(|| {
                "column separation_m: the cell is empty, and the separation is to be given".to_owned()
            }),
            Some(GivenColumn::Pressure) => pressure()?.map(Condition::Pressure).ok_or_else(|| {
                "column pressure_pa: the cell is empty, and the pressure is to be given".to_owned()
            }),
            None => match (separation()?, pressure()?) {
                (Some(separation_m), None) => Ok(Condition::Separation(separation_m)),
                (None, Some(pressure_pa)) => Ok(Condition::Pressure(pressure_pa)),
                (Some(_), Some(_)) => Err(format!(
                    "columns separation_m and pressure_pa are both filled; {}",
                    self.how_to_say_given
                )),
                (None, None) => {
                    Err("columns separation_m and pressure_pa are both empty; fill one".to_owned())
                }
            },
        }
    }

    /// Sets the results. Given cells are kept as typed; computed ones are empty for rows without asperities.
    fn set_results(
        &self,
        input: &mut InputTable,
        asked: &[Option<RowRequest>],
        states: &[Option<ContactState>],
    ) {
        let computed = |value: Option<f64>| value.map_or_else(|| Cell::Field(String::new()), Cell::Computed);
        let mut filled = |name: &str, given: fn(&Condition) -> bool, of: fn(&ContactState) -> Option<f64>| {
            let typed = input.table.column(name).cloned();
            let cell = |row: usize| match (&typed, &asked[row]) {
                (Some(Cells::Typed(cells)), Some(asked)) if given(&asked.at) => cells[row].clone(),
                _ => computed(states[row].as_ref().and_then(of)),
            };
            let cells = (0..states.len()).map(cell).collect();
            input.table.set(name, Cells::Typed(cells));
        };
        filled("separation_m", |at| matches!(at, Condition::Separation(_)), |state| state.separation_m);
        filled("pressure_pa", |at| matches!(at, Condition::Pressure(_)), |state| Some(state.pressure_pa));
        filled("area_fraction", |_| false, |state| Some(state.area_fraction));
        if self.details {
            for (name, of) in STATE_DETAILS {
                let cells = states.iter().map(|state| state.as_ref().and_then(of)).collect();
                input.table.set(name, Cells::Numbers(cells));
            }
            let heights = self.options.summit_heights.unwrap_or_default();
            let population = |asked: &Option<RowRequest>| asked.as_ref()?.population;
            let contacts = asked.iter().zip(states).map(|(asked, state)| {
                let separation_m = state.as_ref()?.separation_m?;
                Some(population(asked)?.0.contacts_per_m2(separation_m, heights))
            });
            input.table.set("contacts_per_m2", Cells::Numbers(contacts.collect()));
            let indices = asked.iter().map(|asked| population(asked)?.1);
            input.table.set("plasticity_index", Cells::Numbers(indices.collect()));
        }
    }
}

impl RowByRow for Populations {
    fn check(&mut self, block: &InputTable) -> Result<(), Refusal> {
        for asked in self.asked(block)?.into_iter().flatten() {
            self.grows |= asked.grows;
            self.given_columns[usize::from(matches!(asked.at, Condition::Pressure(_)))] = true;
            if !self.models.contains(&asked.entry) {
                self.models.push(asked.entry);
            }
        }
        Ok(())
    }

    fn knows(&self, column: &str) -> bool {
        INPUT_COLUMNS[..14].contains(&column)
    }

    fn depends_on(&self, column: &str) -> bool {
        match column {
            YIELD_STRENGTH | INDENTATION_HARDNESS | STRAIN_GRADIENT_LENGTH => {
                let index = self.details && column != STRAIN_GRADIENT_LENGTH;
                let takes =
                    |entry: &&ModelEntry| entry.has(Choice::Strength) || index && !entry.takes_moments;
                self.models.iter().any(takes)
            }
            "separation_m" => self.given_columns[0],
            "pressure_pa" => self.given_columns[1],
            _ => {
                let takes = |entry: &&ModelEntry| RowRoughness::columns(entry).contains(&column);
                REQUIRED_COLUMNS.contains(&column) || self.models.iter().any(takes)
            }
        }
    }

    fn unused_option(&self) -> Option<&'static str> {
        let is_used = |choice| self.models.iter().any(|entry| entry.has(choice));
        let choice =
            self.options.given().find(|choice| *choice != Choice::StrainGradient && !is_used(*choice));
        let cap = self.strength_cap.filter(|_| !self.grows).map(|_| "strength_cap");
        choice.map(Choice::key).or(cap).filter(|_| !self.models.is_empty())
    }

    fn fill_in(&mut self, block: &mut InputTable, progress: &dyn Progress) -> Result<Vec<Remark>, RowsError> {
        let asked = self.asked(block)?;
        let tolerance = self.tolerance.value();
        let state = |asked: &Option<RowRequest>| -> Result<Option<ContactState>, RowsError> {
            if progress.is_cancelled() {
                return Err(RowsError::Cancelled);
            }
            let Some(RowRequest { contact: Pressable::Contact(contact), at, .. }) = asked else {
                return Ok(None);
            };
            let state = contact.at(*at, tolerance, None);
            progress.advance(1);
            Ok(Some(state?))
        };
        let states = numerics::parallel::try_map(&asked, state)?;
        let found = &mut self.found;
        found.counts.add(states.iter().flatten());
        for (asked, state) in asked.iter().zip(&states) {
            let Some(asked) = asked else {
                found.without_asperities += 1;
                continue;
            };
            found.assumed_strengths += usize::from(asked.strength_is_assumed);
            found.above_hardness += usize::from(is_above(state.as_ref(), asked.hardness_pa));
            if let Pressable::TooNarrow { alpha } = asked.contact {
                found.narrow.add(alpha);
            }
        }
        self.set_results(block, &asked, &states);
        Ok(without_separation(block, &asked, &states))
    }

    fn notes(&self) -> Vec<Remark> {
        let StatesFound { counts, narrow, without_asperities: rows, .. } = self.found;
        let all = rows + narrow.count + counts.all;
        let without = rows_of(RemarkCode::RowsWithoutAsperities, rows, all);
        let narrow = narrow.remark(all);
        // Rows beyond complete contact have remarks of their own.
        let of_states = StateCounts { incomplete: 0, flattened: 0, ..counts }.remarks();
        without.into_iter().chain(narrow).chain(self.found.of_strength(counts.all)).chain(of_states).collect()
    }
}

/// Returns the columns that the rows of a block need together: those of asperities unless every model takes moments.
fn required_columns(block: &InputTable) -> Result<Vec<&'static str>, Refusal> {
    let models = block.rows(&["model"], |row| {
        // An unknown model is reported with its row.
        Ok(models::named(Framework::Statistical, row.text("model").trim()).ok())
    })?;
    let takes_moments = |model: &Option<&ModelEntry>| model.is_some_and(|entry| entry.takes_moments);
    let any_moments = models.iter().any(takes_moments);
    let any_asperities = models.is_empty() || !models.iter().all(takes_moments);
    let asperities = any_asperities.then_some(RowRoughness::ASPERITIES);
    let moments = any_moments.then_some(RowRoughness::MOMENTS);
    Ok(REQUIRED_COLUMNS.into_iter().chain([asperities, moments].into_iter().flatten().flatten()).collect())
}

/// The message on a missing property, with its column.
fn missing_cell(error: &MaterialError) -> String {
    let MaterialError::Missing(needed_for) = error else { return error.to_string() };
    let column = match needed_for.property() {
        BodyProperty::IndentationHardness => INDENTATION_HARDNESS,
        BodyProperty::YieldStrength => YIELD_STRENGTH,
        _ => STRAIN_GRADIENT_LENGTH,
    };
    format!("column {column}: the cell is empty; {error}")
}

fn without_separation(
    input: &InputTable,
    asked: &[Option<RowRequest>],
    states: &[Option<ContactState>],
) -> Vec<Remark> {
    let rows = asked.iter().zip(states).enumerate();
    rows.filter_map(|(row, (asked, state))| {
        let (asked, state) = (asked.as_ref()?, state.as_ref()?);
        let Pressable::Contact(contact) = &asked.contact else { return None };
        state.no_separation().map(|reason| {
            Remark::new(match reason {
                NoSeparation::CompleteContact => RemarkCode::BeyondCompleteContact,
                NoSeparation::AllFlattened => RemarkCode::BeyondFlattened,
            })
            .with("row", input.row_name(row))
            .with("pressure_pa", state.pressure_pa)
            .with("highest_pressure_pa", contact.highest_pressure_pa())
        })
    })
    .collect()
}
