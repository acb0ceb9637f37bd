//! Time and error of a law by a program, as scripts print them, joined and in a table.

use serde::{Deserialize, Serialize};
use tables::markdown::table;

use crate::csv_rows::{parse, write};
use crate::words::{error, time};

/// Time and error of one or many evaluations of a law by a program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// Law, and what is given if that matters.
    pub law: String,
    /// Program, with its tolerance if it has one.
    pub program: String,
    /// Seconds for each evaluation.
    pub seconds: f64,
    /// Error, as the part defines it.
    pub error: f64,
}

impl Cost {
    /// Creates the cost of a law by this program.
    pub fn new(law: impl Into<String>, program: impl Into<String>, seconds: f64, error: f64) -> Self {
        Cost { law: law.into(), program: program.into(), seconds, error }
    }
}

/// Joins the costs of each law and program to a row of a file: their mean time, and one of their errors, which are given from
/// small to large.
///
/// # Errors
/// A message if a row cannot be written.
pub fn joined(costs: &[Cost], one_of: fn(&[f64]) -> f64) -> Result<String, String> {
    let mut groups: Vec<Vec<&Cost>> = Vec::new();
    for cost in costs {
        let same = |group: &&mut Vec<&Cost>| (&group[0].law, &group[0].program) == (&cost.law, &cost.program);
        match groups.iter_mut().find(same) {
            Some(group) => group.push(cost),
            None => groups.push(vec![cost]),
        }
    }
    let join = |group: &Vec<&Cost>| {
        let mut errors: Vec<f64> = group.iter().map(|cost| cost.error).collect();
        errors.sort_by(f64::total_cmp);
        let seconds = group.iter().map(|cost| cost.seconds).sum::<f64>() / group.len() as f64;
        Cost::new(&group[0].law, &group[0].program, three_digits(seconds), three_digits(one_of(&errors)))
    };
    write(&groups.iter().map(join).collect::<Vec<_>>())
}

/// The largest of errors from small to large.
pub fn largest(errors: &[f64]) -> f64 {
    errors.last().copied().unwrap_or(f64::NAN)
}

/// The median of errors from small to large.
pub fn median(errors: &[f64]) -> f64 {
    errors[errors.len() / 2]
}

/// Table of a file of costs, with a line for each law and a column for each program.
///
/// # Errors
/// A message if the file cannot be parsed.
pub fn table_of(csv: &str) -> Result<String, String> {
    let costs: Vec<Cost> = parse(csv)?;
    let distinct = |of: fn(&Cost) -> &str| {
        let mut names: Vec<&str> = Vec::new();
        costs.iter().map(of).for_each(|name| {
            if !names.contains(&name) {
                names.push(name);
            }
        });
        names
    };
    let (laws, programs) = (distinct(|cost| &cost.law), distinct(|cost| &cost.program));
    let line = |law: &&str| {
        let cell = |program: &&str| {
            let cost = costs.iter().find(|cost| cost.law == *law && cost.program == *program);
            cost.map(|cost| format!("{}, {}", time(cost.seconds), error(cost.error))).unwrap_or_default()
        };
        std::iter::once((*law).to_owned()).chain(programs.iter().map(cell)).collect::<Vec<String>>()
    };
    let headings: Vec<&str> = std::iter::once("law").chain(programs.iter().copied()).collect();
    Ok(table(&headings, &laws.iter().map(line).collect::<Vec<_>>()))
}

/// Rounds to three digits: times and errors have no more.
fn three_digits(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_are_joined_by_mean_time_and_largest_error_and_have_a_column_for_each_program() {
        let printed = "law,program,seconds,error\n\
            hertz,truearea,1e-6,3e-12\n\
            hertz,truearea,3e-6,1e-12\n\
            ep-sine,truearea,1e-5,1e-12\n\
            hertz,scipy,2e-4,1e-11\n";
        let text = table_of(&joined(&parse(printed).unwrap(), largest).unwrap()).unwrap();
        let rows: Vec<&str> = text.lines().skip(2).collect();
        assert_eq!(
            rows,
            ["| hertz | 2.00 µs, 3.0e-12 | 200 µs, 1.0e-11 |", "| ep-sine | 10.0 µs, 1.0e-12 |  |"]
        );
    }
}
