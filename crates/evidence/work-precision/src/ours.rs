//! Answers of this program.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, Condition, ContactState, InterferenceLaw, Population, StatisticalContact};

use crate::clock::seconds_per_call;
use crate::point::{Answer, GivenQuantity};
use crate::reference::{Case, Group, State};

/// Number of states in a batch, as in the competitors' (`engines.py`).
const BATCH: usize = 1000;

/// Parts from which the library builds a contact.
struct Parts {
    pair: MaterialPair,
    population: Population,
    law: AsperityLaw,
}

/// Body of a case against a rigid counterface, and its strength.
pub fn material(case: &Case) -> (MaterialPair, NixGao) {
    let body = ElasticBody::new(case.youngs_modulus_pa, case.poisson_ratio).expect("a body of the table");
    let strength = NixGao::constant(case.yield_strength_pa).expect("a strength of the table");
    let strength = match case.strain_gradient_length_m {
        Some(length_m) => strength.with_strain_gradient(length_m).expect("a length of the table"),
        None => strength,
    };
    (MaterialPair::against_rigid(body), strength)
}

fn parts(case: &Case) -> Parts {
    let (pair, strength) = material(case);
    let law = match case.model.as_str() {
        "hertz" => AsperityLaw::Hertz,
        "ep-sphere" => AsperityLaw::EpSphere { strength, hardness: Hardness::default() },
        "elastic-sine" => AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
        "ep-sine" => AsperityLaw::EpSine { strength },
        other => unreachable!("the table has no law {other}"),
    };
    let population = Population::new(case.radius_m, case.density_per_m2, case.sigma_s_m);
    Parts { pair, population: population.expect("a population of the table"), law }
}

impl Parts {
    fn contact(&self) -> StatisticalContact {
        StatisticalContact::new(&self.pair, &self.population, &self.law)
    }

    fn answer(&self, state: &State, given: GivenQuantity, tolerance: f64) -> Answer {
        let found = match given {
            GivenQuantity::Separation => self.contact().at_separation(state.separation_m, tolerance),
            GivenQuantity::Pressure => self.contact().at_pressure(state.pressure_pa, tolerance, None),
        };
        self.as_answer(&found.expect("a state of the table"))
    }

    /// States at many separations \[m\] or pressures \[Pa\] of one contact, from a table.
    fn answers(&self, asked: &[f64], given: GivenQuantity, tolerance: f64) -> Vec<ContactState> {
        let condition = match given {
            GivenQuantity::Separation => Condition::Separation,
            GivenQuantity::Pressure => Condition::Pressure,
        };
        let contact = self.contact();
        let least = asked.iter().copied().fold(f64::INFINITY, f64::min);
        let most = asked.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let table =
            contact.table([least, most].map(condition), tolerance).expect("ends between those of the table");
        let states = asked.iter().map(|&value| table.at(condition(value))).collect::<Result<_, _>>();
        states.expect("states between those of the table")
    }

    fn as_answer(&self, state: &ContactState) -> Answer {
        Answer {
            separation_over_sigma: state.separation_m.unwrap_or(f64::NAN) / self.population.sigma_s_m(),
            pressure_pa: state.pressure_pa,
            area_fraction: state.area_fraction,
        }
    }
}

/// State computed anew, with nothing carried over.
pub fn answer(group: &Group, state: &State, given: GivenQuantity, tolerance: f64) -> Answer {
    parts(&group.case).answer(state, given, tolerance)
}

/// Answer with its seconds: the contact is built anew for every state.
pub fn timed_answer(
    group: &Group,
    state: &State,
    given: GivenQuantity,
    tolerance: f64,
    budget_s: f64,
) -> (Answer, f64) {
    let parts = parts(&group.case);
    let seconds = seconds_per_call(budget_s, || parts.answer(std::hint::black_box(state), given, tolerance));
    (parts.answer(state, given, tolerance), seconds)
}

/// States of a group, with as many others between them as make a batch, and the seconds per state.
pub fn timed_batch(group: &Group, given: GivenQuantity, tolerance: f64, budget_s: f64) -> (Vec<Answer>, f64) {
    let parts = parts(&group.case);
    let asked = batch(group, given);
    let seconds =
        seconds_per_call(budget_s, || parts.answers(std::hint::black_box(&asked), given, tolerance));
    let states = parts.answers(&asked, given, tolerance);
    let answers = states[..group.states.len()].iter().map(|state| parts.as_answer(state));
    (answers.collect(), seconds / asked.len() as f64)
}

/// Separations or pressures of a group, with others evenly spaced in separation or in ln p over the same range.
fn batch(group: &Group, given: GivenQuantity) -> Vec<f64> {
    let own = group.states.iter().map(|state| match given {
        GivenQuantity::Separation => state.separation_m,
        GivenQuantity::Pressure => state.pressure_pa.ln(),
    });
    let own: Vec<f64> = own.collect();
    let least = own.iter().copied().fold(f64::INFINITY, f64::min);
    let most = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let others = BATCH - own.len();
    let step = (most - least) / (others - 1) as f64;
    let others = (0..others).map(|i| match given {
        GivenQuantity::Separation => least + step * i as f64,
        GivenQuantity::Pressure => (least + step * i as f64).exp(),
    });
    let exact = group.states.iter().map(|state| match given {
        GivenQuantity::Separation => state.separation_m,
        GivenQuantity::Pressure => state.pressure_pa,
    });
    exact.chain(others).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_batch_begins_with_the_states_of_the_table() {
        let group = &crate::reference::committed().unwrap()[1];
        for given in GivenQuantity::ALL {
            let (answers, _) = timed_batch(group, given, 1e-10, 0.0);
            assert_eq!(answers.len(), group.states.len());
            for (answer, state) in answers.iter().zip(&group.states) {
                assert!(given.error(answer, state) < 1e-9, "{answer:?} {state:?}");
            }
            assert_eq!(batch(group, given).len(), BATCH);
        }
    }

    #[test]
    fn every_state_of_the_table_is_right_at_every_tolerance() {
        for group in &crate::reference::committed().unwrap() {
            for state in &group.states {
                for given in GivenQuantity::ALL {
                    let error = |tolerance| given.error(&answer(group, state, given, tolerance), state);
                    let place = format!("{} {} {state:?} {given:?}", group.population, group.case.law());
                    assert!(error(1e-3) <= 1e-2, "{place}: {:e}", error(1e-3));
                    assert!(error(1e-10) <= 1e-9, "{place}: {:e}", error(1e-10));
                }
            }
        }
    }
}
