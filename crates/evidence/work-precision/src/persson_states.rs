//! Persson's theory at every cutoff of a spectrum, beside numpy and scipy: time of a state and its error at the states of
//! `tests/reference/persson_states.csv`.

use persson::{constant_hardness, elastic};

use crate::clock::seconds_per_call;
use crate::costs::{Cost, joined, largest};
use crate::csv_rows::parse;
use crate::environment::Environment;
use crate::reference::{Columns, columns, repository};

const TABLE: &str = "persson_states.csv";
const BUDGET_S: f64 = 0.05;

/// Shares in contact and plastic at a pressure and a spread.
type Law = fn(f64, f64) -> [f64; 2];

const LAWS: [(&str, Law, [&str; 2]); 2] = [
    ("elastic", |p, s| [elastic::area_fraction(p, s), 0.0], ["area_elastic_theory", ""]),
    (
        "constant hardness",
        |p, s| {
            let areas = constant_hardness::areas(p, s, 1.0);
            [areas.contact(), areas.plastic]
        },
        ["area_contact", "area_plastic"],
    ),
];

/// Computes every state of the table with every program.
///
/// # Errors
/// A message if the table cannot be read, or if the script of the competitors fails.
pub fn measure(environment: &Environment) -> Result<String, String> {
    let mut costs = ours(&columns(TABLE)?);
    let printed = environment.output("persson.py", [repository("tests/reference").join(TABLE)])?;
    costs.extend(parse::<Cost>(&printed)?);
    joined(&costs, largest)
}

/// Our cost and largest error for each law and load: of the area in contact, and of the plastic share over that area.
fn ours(states: &[Columns]) -> Vec<Cost> {
    let mut loads: Vec<f64> = states.iter().map(|state| state["p_over_h"]).collect();
    loads.dedup();
    let cost = |(name, law, exact): (&str, Law, [&str; 2]), p_over_h: f64| {
        let states: Vec<&Columns> = states.iter().filter(|state| state["p_over_h"] == p_over_h).collect();
        let spreads: Vec<f64> = states.iter().map(|state| state["s_over_h"]).collect();
        let all =
            || spreads.iter().map(|&spread| law(std::hint::black_box(p_over_h), spread)).collect::<Vec<_>>();
        let errors = all().into_iter().zip(&states).map(|(found, state)| {
            let [contact, plastic] = exact.map(|column| state.get(column).copied().unwrap_or(0.0));
            (found[0] - contact).abs().max((found[1] - plastic).abs()) / contact
        });
        let error = errors.fold(0.0, f64::max);
        Cost::new(name, "truearea", seconds_per_call(BUDGET_S, all) / spreads.len() as f64, error)
    };
    LAWS.iter().flat_map(|law| loads.iter().map(move |&load| cost(*law, load))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_state_of_the_table_is_right_to_rounding() {
        for cost in ours(&columns(TABLE).unwrap()) {
            assert!(cost.error < 2e-15, "{cost:?}");
        }
    }
}
