//! Persson's theory at every cutoff of a spectrum, beside numpy and scipy: time of a state against its error.

use persson::{constant_hardness, elastic};
use serde::Deserialize;
use tables::markdown::table;

use crate::bench::{Bench, Contents};
use crate::clock::seconds_per_call;
use crate::files::{self, scientific};
use crate::page::{error, three_digits, time};
use crate::reference::{Columns, columns, repository};
use crate::seeds::mean;

const TABLE: &str = "persson_states.csv";
const BUDGET_S: f64 = 0.05;
const OURS: &str = "truearea";
const ELASTIC: &str = "elastic";
const CONSTANT_HARDNESS: &str = "constant hardness";

/// All cutoffs under one load by one engine; `persson.py` prints the same columns.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Row {
    law: String,
    engine: String,
    /// Number of terms of a series; `None` for engines that choose for themselves.
    terms: Option<u32>,
    p_over_h: f64,
    /// Seconds for each cutoff.
    seconds: f64,
    /// Largest error over the cutoffs: of the area in contact, and of the plastic share over that area.
    error: f64,
}

/// Shares in contact and plastic at a pressure and a spread.
type Law = fn(f64, f64) -> [f64; 2];

const LAWS: [(&str, Law, [&str; 2]); 2] = [
    (ELASTIC, |p, s| [elastic::area_fraction(p, s), 0.0], ["area_elastic_theory", ""]),
    (
        CONSTANT_HARDNESS,
        |p, s| {
            let areas = constant_hardness::areas(p, s, 1.0);
            [areas.contact(), areas.plastic]
        },
        ["area_contact", "area_plastic"],
    ),
];

/// Computes every state of the table with every engine.
///
/// # Errors
/// A message if the table cannot be read, or if the script of the competitors fails.
pub fn measure(bench: &mut Bench) -> Result<Contents, String> {
    let mut rows = ours(&columns(TABLE)?);
    let printed = bench.environment.output("persson.py", [repository("tests/reference").join(TABLE)])?;
    rows.extend(files::parse::<Row>(&printed)?);
    Ok(Contents {
        sections: vec![("persson", costs(&rows))],
        files: vec![("persson.csv", files::comments(&bench.facts) + &csv(&rows))],
    })
}

/// Our cost and error for each law and load.
fn ours(states: &[Columns]) -> Vec<Row> {
    let mut loads: Vec<f64> = states.iter().map(|state| state["p_over_h"]).collect();
    loads.dedup();
    let row = |(name, law, exact): (&str, Law, [&str; 2]), p_over_h: f64| {
        let states: Vec<&Columns> = states.iter().filter(|state| state["p_over_h"] == p_over_h).collect();
        let spreads: Vec<f64> = states.iter().map(|state| state["s_over_h"]).collect();
        let all =
            || spreads.iter().map(|&spread| law(std::hint::black_box(p_over_h), spread)).collect::<Vec<_>>();
        let errors = all().into_iter().zip(&states).map(|(found, state)| {
            let [contact, plastic] = exact.map(|column| state.get(column).copied().unwrap_or(0.0));
            (found[0] - contact).abs().max((found[1] - plastic).abs()) / contact
        });
        Row {
            law: name.to_owned(),
            engine: OURS.to_owned(),
            terms: None,
            p_over_h,
            seconds: seconds_per_call(BUDGET_S, all) / spreads.len() as f64,
            error: errors.fold(0.0, f64::max),
        }
    };
    LAWS.iter().flat_map(|law| loads.iter().map(move |&load| row(*law, load))).collect()
}

/// Table of the cost of a state by law and engine: the mean over the loads, and the largest error.
fn costs(rows: &[Row]) -> String {
    let columns = ["law", "engine", "terms", "time per cutoff", "over ours", "largest error"];
    let mut cells = Vec::new();
    for (law, ..) in LAWS {
        let mut own_s = f64::NAN;
        let of_law: Vec<&Row> = rows.iter().filter(|row| row.law == law).collect();
        let mut settings: Vec<(&str, Option<u32>)> = Vec::new();
        for row in &of_law {
            if !settings.contains(&(&row.engine, row.terms)) {
                settings.push((&row.engine, row.terms));
            }
        }
        for (engine, terms) in settings {
            let here = of_law.iter().filter(|row| row.engine == engine && row.terms == terms);
            let (seconds, errors): (Vec<f64>, Vec<f64>) = here.map(|row| (row.seconds, row.error)).unzip();
            let seconds = mean(&seconds);
            let is_own = engine == OURS;
            own_s = if is_own { seconds } else { own_s };
            cells.push(vec![
                law.to_owned(),
                engine.to_owned(),
                terms.map(|terms| terms.to_string()).unwrap_or_default(),
                time(seconds),
                if is_own { String::new() } else { three_digits(seconds / own_s) },
                error(errors.into_iter().fold(0.0, f64::max)),
            ]);
        }
    }
    table(&columns, &cells)
}

fn csv(rows: &[Row]) -> String {
    let row = |row: &Row| {
        let Row { law, engine, p_over_h, .. } = row;
        let terms = row.terms.map(|terms| terms.to_string()).unwrap_or_default();
        let (seconds, error) = (scientific(row.seconds), scientific(row.error));
        format!("{law},{engine},{terms},{p_over_h},{seconds},{error}\n")
    };
    let header = "law,engine,terms,p_over_h,seconds_per_cutoff,largest_error\n";
    header.to_owned() + &rows.iter().map(row).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_state_of_the_table_is_right_to_rounding() {
        for row in ours(&columns(TABLE).unwrap()) {
            assert!(row.error < 2e-15, "{row:?}");
        }
    }

    #[test]
    fn loads_are_joined_by_mean_time_and_largest_error() {
        let printed = "law,engine,terms,p_over_h,seconds,error\n\
            elastic,truearea,,0.1,1e-8,1e-16\n\
            elastic,truearea,,0.3,3e-8,2e-16\n\
            elastic,series,30,0.1,1e-7,1e-3\n";
        let text = costs(&files::parse(printed).unwrap());
        let rows: Vec<&str> = text.lines().skip(2).collect();
        assert_eq!(
            rows,
            [
                "| elastic | truearea |  | 20.0 ns |  | 2.0e-16 |",
                "| elastic | series | 30 | 100 ns | 5.00 | 1.0e-3 |"
            ]
        );
    }
}
