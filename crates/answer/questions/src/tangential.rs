//! A surface sheared under a constant normal load: displacement, stiffness, slip and energy lost.

use interface::tangential::{NOTICEABLE_MISMATCH, ShearedContact, ShearedPair};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::figure::{FigureData, ShearLoop, shear_loops};
use study::gap_law::{GapLaw, GapState};
use study::interface::sheared_pair;
use study::material::Material;
use study::models::Choice;
use study::plan::PlanError;
use study::surface::Surface;
use tables::Table;
use units::display::{percent, pressure};
use units::{PressureRange, Remark, RemarkCode};

use crate::elements::RandomInput;
use crate::gap::remarks_on_gap_law;
use crate::gap::{GapModel, GapQuestion};
use crate::loads::{LoadInput, nominal_pressure, pressures_pa};
use crate::{Answer, QuestionError};

/// Shares of the load at which all slides, where no tangential stress is given.
const SHARES: [f64; 11] = [0.01, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99];
/// Loads per decade between which the stiffness of boundary elements is interpolated.
const ELEMENT_LOADS_PER_DECADE: f64 = 8.0;
/// Shares that a figure draws where no tangential stress is given: several under one pressure, one under several.
const DRAWN_SHARES: [f64; 3] = [0.3, 0.6, 0.9];
/// Steps of each part of a drawn cycle.
const CYCLE_STEPS: usize = 40;

/// Tangential loads on a surface under nominal pressures, with Coulomb friction at every point.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TangentialQuestion {
    /// Elastic model, material and spectrum.
    pub by: GapModel,
    /// Coefficient of friction, above 0.
    pub friction: Option<f64>,
    /// Nominal pressures.
    pub pressures: Vec<LoadInput>,
    /// Nominal pressures as ranges, behind the others.
    pub pressure_ranges: Vec<PressureRange>,
    /// Tangential stresses; shares of friction times pressure where there are none.
    pub stresses: Vec<LoadInput>,
    /// Random surfaces, for boundary elements.
    pub random: RandomInput,
    /// True for a figure with the loop of each load.
    pub figure: bool,
}

/// Row of the answer; without a response everything slides.
struct Sheared {
    pressure_pa: f64,
    stress_pa: f64,
    share: f64,
    area_fraction: f64,
    response: Option<(ShearedContact, f64)>,
}

impl TangentialQuestion {
    /// The most loops of a figure.
    pub const MOST_LOOPS: usize = 8;

    /// Finds options that the model ignores, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        if let Some(entry) = self.by.model.filter(|entry| entry.has(Choice::Strength)) {
            return Err(QuestionError::NotElastic(entry));
        }
        self.gaps(Vec::new()).check()?;
        let material = self.by.material.of_half_spaces("tangential loads")?;
        self.pair(&material)?;
        let lines = self.drawn_loads(&material)?.len();
        if self.figure && lines > Self::MOST_LOOPS {
            let (drawn, most) = ("loop for each pressure and tangential stress", Self::MOST_LOOPS);
            return Err(QuestionError::TooManyLines { drawn, lines, most });
        }
        Ok(())
    }

    /// Number of steps that the progress will count: those of boundary elements, and none for models.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn steps(&self, surface: &Surface) -> Result<usize, QuestionError> {
        self.gaps(self.element_loads()?).steps(surface)
    }

    /// Computes the response to each tangential stress under each pressure.
    ///
    /// The table has the columns `nominal_pressure_pa, tangential_stress_pa, share_of_sliding, displacement_m,
    /// initial_stiffness_pa_per_m, tangent_stiffness_pa_per_m, dissipation_j_per_m2, damping_ratio, area_fraction,
    /// stuck_area_fraction`.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        self.check()?;
        let material = self.by.material.of_half_spaces("tangential loads")?;
        let pair = self.pair(&material)?;
        let (normal, mut notes) = self.normal_law(&material, surface, progress)?;
        let pressures_pa = pressures_pa(&self.pressures, &self.pressure_ranges, &material)?;
        let area = |&pressure_pa: &f64| Some((pressure_pa, normal.at(pressure_pa).ok()?.1));
        notes.extend(self.by.doubts(&material, pressures_pa.iter().filter_map(area), None));
        let rows = numerics::parallel::try_map(&self.loads(&material)?, |&(pressure_pa, stress_pa)| {
            if progress.is_cancelled() {
                return Err(QuestionError::Plan(PlanError::Cancelled));
            }
            sheared(&pair, &normal, pressure_pa, stress_pa)
        })?;
        if pair.mismatch().abs() > NOTICEABLE_MISMATCH {
            notes.push(Remark::new(RemarkCode::CoupledTractions).with("mismatch", pair.mismatch()));
        }
        let sliding = rows.iter().filter(|row| row.response.is_none()).count();
        if sliding > 0 {
            notes.push(Remark::new(RemarkCode::Sliding).with("sliding", sliding).with("all", rows.len()));
        }
        let figure =
            if self.figure { Some(self.loops_figure(&pair, &normal, &material, progress)?) } else { None };
        Ok(Answer { table: table(&rows), notes, figure })
    }

    /// Draws the loop of every load that sticks.
    fn loops_figure(
        &self,
        pair: &ShearedPair,
        normal: &NormalLaw,
        material: &Material,
        progress: &dyn Progress,
    ) -> Result<FigureData, QuestionError> {
        let loads = self.drawn_loads(material)?;
        let sticking: Vec<&DrawnLoad> = loads.iter().filter(|load| load.share(pair) < 1.0).collect();
        let loops = numerics::parallel::try_map(&sticking, |load| {
            if progress.is_cancelled() {
                return Err(QuestionError::Plan(PlanError::Cancelled));
            }
            let stiffness = |pressure_pa| normal.at(pressure_pa).map(|(stiffness, _)| stiffness);
            let share = load.share(pair);
            Ok(ShearLoop::new(pair, &load.label, load.pressure_pa, share, CYCLE_STEPS, stiffness)?)
        })?;
        shear_loops(&loops).ok_or(QuestionError::NoLoop)
    }

    /// The loads whose loops are drawn, under labels that tell them apart.
    fn drawn_loads(&self, material: &Material) -> Result<Vec<DrawnLoad>, QuestionError> {
        let pressures_pa = pressures_pa(&self.pressures, &self.pressure_ranges, material)?;
        let stresses_pa = self.stresses_pa(material)?;
        let friction = self.pair(material)?.friction();
        let shares = if pressures_pa.len() > 1 { &DRAWN_SHARES[2..] } else { &DRAWN_SHARES[..] };
        let under = |&pressure_pa: &f64| -> Vec<DrawnLoad> {
            let at = pressure(pressure_pa);
            let of_share = |share: &f64| DrawnLoad {
                label: match shares.len() {
                    1 => at.clone(),
                    _ => format!("{} of sliding", percent(*share)),
                },
                pressure_pa,
                stress_pa: share * friction * pressure_pa,
            };
            let of_stress = |&stress_pa: &f64| DrawnLoad {
                label: match (pressures_pa.len(), stresses_pa.len()) {
                    (1, many) if many > 1 => pressure(stress_pa),
                    (_, 1) => at.clone(),
                    _ => format!("{at}, {}", pressure(stress_pa)),
                },
                pressure_pa,
                stress_pa,
            };
            match stresses_pa.is_empty() {
                true => shares.iter().map(of_share).collect(),
                false => stresses_pa.iter().map(of_stress).collect(),
            }
        };
        Ok(pressures_pa.iter().flat_map(under).collect())
    }

    /// The question for the normal law of boundary elements under these loads.
    fn gaps(&self, pressures: Vec<LoadInput>) -> GapQuestion {
        let (pressures, pressure_ranges) = match pressures.is_empty() {
            true => (self.pressures.clone(), self.pressure_ranges.clone()),
            false => (pressures, Vec::new()),
        };
        GapQuestion { by: self.by.clone(), pressures, pressure_ranges, random: self.random }
    }

    fn normal_law(
        &self,
        material: &Material,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<(NormalLaw, Vec<Remark>), QuestionError> {
        let mut notes = self.by.notes(material, surface);
        Ok(match self.by.model {
            Some(entry) => {
                let law = self.by.law(entry, material, surface, progress)?;
                let pressures_pa: Vec<f64> = self.loads(material)?.iter().map(|load| load.0).collect();
                notes.extend(remarks_on_gap_law(&law, &pressures_pa));
                (NormalLaw::Model(law), notes)
            }
            None => {
                let gaps = self.gaps(self.element_loads()?);
                let (states, found) = gaps.states_of_elements(surface, progress)?;
                notes.extend(found);
                (NormalLaw::Elements(states), notes)
            }
        })
    }

    /// Loads of boundary elements: from the least pressure that sticks, or under which all slides, to the largest, evenly in the
    /// logarithm.
    fn element_loads(&self) -> Result<Vec<LoadInput>, QuestionError> {
        if self.by.model.is_some() {
            return Ok(Vec::new());
        }
        let material = self.by.material.of_half_spaces("tangential loads")?;
        let friction = self.pair(&material)?.friction();
        let needed_pa = |(pressure_pa, stress_pa): (f64, f64)| {
            let share = stress_pa / (friction * pressure_pa);
            // A load that slides needs its area alone.
            if share < 1.0 { pressure_pa * (1.0 - share) } else { pressure_pa }
        };
        let loads = self.loads(&material)?;
        let most_pa = loads.iter().fold(0.0f64, |most, load| most.max(load.0));
        let least_pa = loads.into_iter().map(needed_pa).fold(most_pa, f64::min);
        let decades = (most_pa / least_pa).log10();
        let steps = (ELEMENT_LOADS_PER_DECADE * decades).ceil().max(2.0);
        let load = |step: usize| {
            let pa = most_pa * (least_pa / most_pa).powf(step as f64 / steps);
            LoadInput { pressure: units::Pressure::Pascals(pa), label: String::new() }
        };
        Ok((0..=steps as usize).map(load).collect())
    }

    /// Pressures and tangential stresses \[Pa\], pressure after pressure.
    fn loads(&self, material: &Material) -> Result<Vec<(f64, f64)>, QuestionError> {
        let pressures_pa = pressures_pa(&self.pressures, &self.pressure_ranges, material)?;
        let stresses_pa = self.stresses_pa(material)?;
        let friction = self.pair(material)?.friction();
        let under = |pressure_pa: f64| -> Vec<(f64, f64)> {
            match stresses_pa.is_empty() {
                true => SHARES.iter().map(|share| (pressure_pa, share * friction * pressure_pa)).collect(),
                false => stresses_pa.iter().map(|stress_pa| (pressure_pa, *stress_pa)).collect(),
            }
        };
        Ok(pressures_pa.into_iter().flat_map(under).collect())
    }

    fn stresses_pa(&self, material: &Material) -> Result<Vec<f64>, QuestionError> {
        let stress = |stress: &LoadInput| {
            nominal_pressure("tangential_stress", Some(&stress.label), stress.pressure, material)
        };
        self.stresses.iter().map(|given| Ok(stress(given)?.pa())).collect()
    }

    fn pair(&self, material: &Material) -> Result<ShearedPair, QuestionError> {
        let friction = self.friction.ok_or(QuestionError::missing("friction"))?;
        sheared_pair(friction, &material.pair)
            .map_err(|error| QuestionError::Value { option: "friction", error })
    }
}

/// A load whose loop is drawn.
struct DrawnLoad {
    label: String,
    pressure_pa: f64,
    stress_pa: f64,
}

impl DrawnLoad {
    fn share(&self, pair: &ShearedPair) -> f64 {
        self.stress_pa / (pair.friction() * self.pressure_pa)
    }
}

/// Stiffness and area under any pressure.
enum NormalLaw {
    Model(GapLaw),
    /// States from the largest pressure to the least, between which logarithms are straight.
    Elements(Vec<GapState>),
}

impl NormalLaw {
    /// Stiffness \[Pa/m\] and share in contact.
    fn at(&self, pressure_pa: f64) -> Result<(f64, f64), QuestionError> {
        match self {
            NormalLaw::Model(law) => {
                let state = law.at(pressure_pa)?;
                let stiffness = state.stiffness_pa_per_m.ok_or(QuestionError::NoStiffness { pressure_pa })?;
                Ok((stiffness, state.area_fraction))
            }
            NormalLaw::Elements(states) => {
                let after = states.partition_point(|state| state.nominal_pressure_pa > pressure_pa);
                let after = after.clamp(1, states.len() - 1);
                let (upper, lower) = (&states[after - 1], &states[after]);
                let ln = |state: &GapState| state.nominal_pressure_pa.ln();
                // All loads are one pressure if it slides.
                let share = match ln(upper) > ln(lower) {
                    true => (pressure_pa.ln() - ln(lower)) / (ln(upper) - ln(lower)),
                    false => 1.0,
                };
                let between = |upper: f64, lower: f64| (lower.ln() + share * (upper.ln() - lower.ln())).exp();
                let of = |state: &GapState| {
                    state
                        .stiffness_pa_per_m
                        .ok_or(QuestionError::NoStiffness { pressure_pa: state.nominal_pressure_pa })
                };
                let stiffness = between(of(upper)?, of(lower)?);
                Ok((stiffness, between(upper.area_fraction, lower.area_fraction)))
            }
        }
    }
}

fn sheared(
    pair: &ShearedPair,
    normal: &NormalLaw,
    pressure_pa: f64,
    stress_pa: f64,
) -> Result<Sheared, QuestionError> {
    let share = stress_pa / (pair.friction() * pressure_pa);
    let (_, area_fraction) = normal.at(pressure_pa)?;
    let response = match share < 1.0 {
        true => {
            let found = pair.respond(pressure_pa, share, |pressure_pa| {
                normal.at(pressure_pa).map(|(stiffness, _)| stiffness)
            })?;
            let (_, stuck) = normal.at(found.stuck_pressure_pa)?;
            Some((found, stuck))
        }
        false => None,
    };
    Ok::<_, QuestionError>(Sheared { pressure_pa, stress_pa, share, area_fraction, response })
}

fn table(rows: &[Sheared]) -> Table {
    let column = |of: fn(&Sheared) -> f64| rows.iter().map(move |row| Some(of(row)));
    let of_response = |of: fn(&ShearedContact) -> f64| {
        rows.iter().map(move |row| row.response.as_ref().map(|(found, _)| of(found)))
    };
    Table::default()
        .with_numbers("nominal_pressure_pa", column(|row| row.pressure_pa))
        .with_numbers("tangential_stress_pa", column(|row| row.stress_pa))
        .with_numbers("share_of_sliding", column(|row| row.share))
        .with_numbers("displacement_m", of_response(|found| found.displacement_m))
        .with_numbers("initial_stiffness_pa_per_m", of_response(|found| found.initial_stiffness_pa_per_m))
        .with_numbers("tangent_stiffness_pa_per_m", of_response(|found| found.tangent_stiffness_pa_per_m))
        .with_numbers("dissipation_j_per_m2", of_response(|found| found.dissipation_j_per_m2))
        .with_numbers("damping_ratio", of_response(|found| found.damping_ratio))
        .with_numbers("area_fraction", column(|row| row.area_fraction))
        .with_numbers(
            "stuck_area_fraction",
            rows.iter().map(|row| row.response.as_ref().map(|found| found.1)),
        )
}
