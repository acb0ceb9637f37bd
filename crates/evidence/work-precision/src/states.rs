//! States of rough contact beside scipy and `ContactMechanics`: time and error at the states of
//! `tests/reference/work_precision.csv`.

use std::hint::black_box;

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use serde::Deserialize;
use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};

use crate::clock::seconds_per_call;
use crate::costs::{Cost, joined, largest};
use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::reference::{repository, rows};

const TABLE: &str = "work_precision.csv";
/// Tolerances of ours; the script has the first.
const TOLERANCES: [f64; 2] = [1e-10, 1e-13];
/// Seconds for the repetitions of a state, before the script of the others and again after it.
const BUDGET_S: f64 = 2e-3;

/// Given quantity of a question, as the tables name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Question {
    AtSeparation,
    AtPressure,
}

const QUESTIONS: [(&str, Question); 2] = [("p(d)", Question::AtSeparation), ("d(p)", Question::AtPressure)];

/// State of a population under a law.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct State {
    population: String,
    model: String,
    youngs_modulus_pa: f64,
    poisson_ratio: f64,
    yield_strength_pa: f64,
    strain_gradient_length_m: Option<f64>,
    radius_m: f64,
    density_per_m2: f64,
    sigma_s_m: f64,
    separation_m: f64,
    pressure_pa: f64,
    area_fraction: f64,
}

impl State {
    fn law(&self) -> String {
        let gradient = if self.strain_gradient_length_m.is_some() { ", strain gradient" } else { "" };
        format!("{}{gradient}", self.model)
    }

    /// Builds the contact anew.
    fn contact(&self) -> StatisticalContact {
        let body = ElasticBody::new(self.youngs_modulus_pa, self.poisson_ratio).expect("a body of the table");
        let strength = NixGao::constant(self.yield_strength_pa).expect("a strength of the table");
        let strength = match self.strain_gradient_length_m {
            Some(length_m) => strength.with_strain_gradient(length_m).expect("a length of the table"),
            None => strength,
        };
        let law = match self.model.as_str() {
            "hertz" => AsperityLaw::Hertz,
            "ep-sphere" => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None },
            "elastic-sine" => AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
            "ep-sine" => AsperityLaw::EpSine { strength },
            other => unreachable!("the table has no law {other}"),
        };
        let population = Population::new(self.radius_m, self.density_per_m2, self.sigma_s_m);
        let population = population.expect("a population of the table");
        StatisticalContact::new(&MaterialPair::against_rigid(body), &population, &law)
    }

    /// Computes the state with nothing carried over, and returns the larger of its two errors; infinite for a NaN.
    fn error(&self, question: Question, tolerance: f64) -> f64 {
        let found = match question {
            Question::AtSeparation => self.contact().at_separation(self.separation_m, tolerance),
            Question::AtPressure => self.contact().at_pressure(self.pressure_pa, tolerance, None),
        };
        let found = found.expect("a state of the table");
        let area = (found.area_fraction / self.area_fraction - 1.0).abs();
        let other = match question {
            Question::AtSeparation => (found.pressure_pa / self.pressure_pa - 1.0).abs(),
            Question::AtPressure => {
                (found.separation_m.unwrap_or(f64::NAN) - self.separation_m).abs() / self.sigma_s_m
            }
        };
        if area.is_nan() || other.is_nan() { f64::INFINITY } else { area.max(other) }
    }
}

/// Computes every state with every program.
///
/// # Errors
/// A message if the table cannot be read, or if the script fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    let states: Vec<State> = rows(TABLE)?;
    let mut costs = ours(&states);
    let printed = environment.output("states.py", [repository("tests/reference").join(TABLE)])?;
    // A machine that slows down or speeds up favours nobody.
    for (before, after) in costs.iter_mut().zip(ours(&states)) {
        before.seconds = before.seconds.min(after.seconds);
    }
    costs.extend(parse::<Cost>(&printed)?);
    joined(&costs, largest)
}

/// Our cost of every state at every tolerance.
fn ours(states: &[State]) -> Vec<Cost> {
    let mut costs = Vec::new();
    for state in states {
        for (given, question) in QUESTIONS {
            costs.extend(TOLERANCES.map(|tolerance| {
                let seconds = seconds_per_call(BUDGET_S, || black_box(state).error(question, tolerance));
                let law = format!("{}, {given}", state.law());
                Cost::new(law, format!("truearea, {tolerance:e}"), seconds, state.error(question, tolerance))
            }));
        }
    }
    costs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_state_of_the_table_is_right_at_every_tolerance() {
        let states: Vec<State> = rows(TABLE).unwrap();
        assert_eq!(states.len(), 3 * 6 * 5);
        for state in &states {
            for (_, question) in QUESTIONS {
                let error = |tolerance| state.error(question, tolerance);
                assert!(error(1e-3) <= 1e-2, "{state:?} {question:?}: {:e}", error(1e-3));
                assert!(error(1e-10) <= 1e-9, "{state:?} {question:?}: {:e}", error(1e-10));
            }
        }
    }
}
