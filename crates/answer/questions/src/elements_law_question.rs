//! Laws by boundary elements, asked: loads that are pressed, and more where the error needs them.

use elements::{ImposedLoad, Pressing};
use interface::finite_elements::{ContactLaw, Dialect, SamplingError};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::surface::Surface;
use units::Bound;

use crate::QuestionError;
use crate::conductance::{FoundConductance, LawQuantity, LawTableQuestion};
use crate::elements::{RandomInput, random_surfaces, remarks_on_pressed};
use crate::elements_law::ElementsLaw;
use crate::gap::{LawForm, remarks_on_gaps, states_of_elements, yielding};
use crate::option::{first_given, not_of_model};

/// Loads per decade of pressure that are pressed at first.
const LOADS_PER_DECADE: f64 = 6.0;

/// Number of loads from which no more are pressed.
const MOST_LOADS: usize = 200;

/// Share of the error that may arise between loads; the rest is left to the straight lines.
const MOST_BETWEEN_LOADS: f64 = 0.75;

/// Residual of the elements: pressures at a distance are then off by less than 5e-4, nearly all of them by less than 2e-5.
const TOLERANCE: f64 = 1e-5;

/// A law by boundary elements, which flow at the hardness where the material has one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ElementsLawQuestion {
    /// Quantity, pressures, bodies and spectrum, without a model and a correlation.
    pub table: LawTableQuestion,
    /// Random surfaces.
    pub random: RandomInput,
    /// Largest relative error on straight lines between rows; [`ContactLaw::TOLERANCE`] if absent.
    pub error: Option<f64>,
}

/// Answer to an [`ElementsLawQuestion`].
#[derive(Debug)]
pub enum ElementsLawAnswer {
    /// The mechanical law.
    Pressure(Box<ElementsLaw>),
    /// Conductance against pressure.
    Conductance(FoundConductance),
}

impl ElementsLawQuestion {
    /// Finds options without effect, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        let is_exponential = self.table.form == Some(LawForm::Exponential);
        first_given([("form", is_exponential)], not_of_model("bem").with("models", "persson"))?;
        self.table.check()?;
        self.check_error(ContactLaw::TOLERANCES)?;
        let [from_pa, to_pa] = self.table.law.range_pa(&self.table.law.by.material.material()?)?;
        if from_pa < to_pa { Ok(()) } else { Err(SamplingError::EmptyRange { from_pa, to_pa }.into()) }
    }

    fn check_error(&self, bound: Bound) -> Result<f64, QuestionError> {
        let tolerance = self.error.unwrap_or(ContactLaw::TOLERANCE);
        let checked = bound.check("error of the law", tolerance).map(|_| tolerance);
        checked.map_err(|error| QuestionError::Value { option: "error", error })
    }

    /// Presses the surfaces, under more loads where the error needs them; `progress` advances once per surface and load.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(
        &self,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<ElementsLawAnswer, QuestionError> {
        self.check()?;
        let by = &self.table.law.by;
        let material = by.material.material()?;
        let range_pa = self.table.law.range_pa(&material)?;
        let is_pressure = self.table.quantity == LawQuantity::Pressure;
        // Cards of the mechanical law have no room for the stiffness.
        let stiffness = !is_pressure || self.table.dialect.is_none_or(|dialect| dialect == Dialect::Csv);
        let pressing = Pressing { tolerance: TOLERANCE, stiffness, ..yielding(&material, range_pa.to_vec()) };
        let (surfaces, made) = random_surfaces(surface, &self.random, &pressing)?;
        let press = |pressures_pa: Vec<f64>| {
            let loads = pressures_pa.into_iter().map(ImposedLoad::PressurePa).collect();
            elements::press_in_turn(&surfaces, &Pressing { loads, ..pressing.clone() }, progress)
        };
        let [from_pa, to_pa] = range_pa;
        // Laws are cut off at 1/e of the least pressure, and need nothing in between.
        let cut = [-1.0f64, -0.5].map(|log| from_pa * log.exp());
        let half = (0.5 * LOADS_PER_DECADE * (to_pa / from_pa).log10()).ceil().max(1.0) as usize;
        let inner = (0..2 * half).map(|at| from_pa * (to_pa / from_pa).powf(at as f64 / (2 * half) as f64));
        let mut loads = press(cut.into_iter().chain(inner).chain([to_pa]).collect())?;
        let tolerance = self.check_error(ContactLaw::TOLERANCES)?;
        let mut law = loop {
            let law = ElementsLaw::through(&surfaces, range_pa, pressing.saturation_pa, loads)?;
            let error = if is_pressure { law.error } else { law.stiffness_error };
            if error <= MOST_BETWEEN_LOADS * tolerance {
                break law;
            }
            if law.loads.len() >= MOST_LOADS {
                self.check_error(Bound::AtLeast(error / MOST_BETWEEN_LOADS))?;
            }
            let between = law.loads.windows(2).map(|pair| {
                let [low_pa, high_pa] = [0, 1].map(|at| pair[at].nominal_pressure_pa);
                (low_pa * high_pa).sqrt()
            });
            let finer = press(between.collect())?;
            loads = [law.loads, finer].concat();
            loads.sort_by(|one, other| one.nominal_pressure_pa.total_cmp(&other.nominal_pressure_pa));
        };
        law.notes = by.notes(&material, surface);
        law.notes.extend(made.into_iter().chain(remarks_on_pressed(&law.loads)));
        law.notes.extend(remarks_on_gaps(
            &states_of_elements(&law.loads, pressing.saturation_pa),
            Some(law.rms_height_m),
        ));
        Ok(if is_pressure {
            ElementsLawAnswer::Pressure(Box::new(law))
        } else {
            ElementsLawAnswer::Conductance(self.table.conductance_of_elements(law)?)
        })
    }
}
