//! The ledger: every statement of the paper with its findings.

use tables::Table;

use crate::evidence::Evidence;

/// The verdict on a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The statement holds.
    Reproduced,
    /// The statement does not hold.
    NotReproduced,
    /// The statement holds because the data were made so.
    ByConstruction,
}

units::named!(Verdict, "verdict", {
    Reproduced => "reproduced",
    NotReproduced => "not reproduced",
    ByConstruction => "by construction",
});

/// Returns `Reproduced` if `holds`.
pub(crate) fn verdict(holds: bool) -> Verdict {
    if holds { Verdict::Reproduced } else { Verdict::NotReproduced }
}

/// Statement of the paper and its measurement, in our words.
#[derive(Debug, Clone, Copy)]
pub struct Statement {
    /// Number in the ledger, 1 to 20.
    pub number: u32,
    /// Statement of the paper.
    pub statement: &'static str,
    /// Quantity that is computed to check it, and the criterion for reproduction.
    pub how: &'static str,
    /// Unit of the value; empty for a pure number.
    pub unit: &'static str,
    /// Checks it on one spectrum.
    pub(crate) check: fn(&Evidence) -> Finding,
}

/// Finding on a statement for one spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Number that decides the verdict.
    pub value: f64,
    /// All measured values.
    pub found: String,
    /// Verdict on the statement.
    pub verdict: Verdict,
    /// Remark of one sentence.
    pub remark: String,
}

/// Row of the ledger: a statement, and a finding for every spectrum.
#[derive(Debug, Clone)]
pub struct Row {
    /// Statement of the row.
    pub statement: Statement,
    /// Names of the spectra with their findings.
    pub findings: Vec<(&'static str, Finding)>,
}

/// Returns the ledger as a table: `claim, spectrum, statement, how_measured, value, unit, found, verdict, remark`, a
/// row per statement and spectrum.
pub fn table(rows: &[Row]) -> Table {
    let each = || {
        rows.iter()
            .flat_map(|row| row.findings.iter().map(|(spectrum, found)| (&row.statement, *spectrum, found)))
    };
    Table::default()
        .with_numbers("claim", each().map(|(statement, ..)| f64::from(statement.number)))
        .with_words("spectrum", each().map(|(_, spectrum, _)| spectrum))
        .with_words("statement", each().map(|(statement, ..)| statement.statement))
        .with_words("how_measured", each().map(|(statement, ..)| statement.how))
        .with_numbers("value", each().map(|(_, _, finding)| finding.value))
        .with_words("unit", each().map(|(statement, ..)| statement.unit))
        .with_text("found", each().map(|(_, _, finding)| finding.found.clone()))
        .with_words("verdict", each().map(|(_, _, finding)| finding.verdict.name()))
        .with_text("remark", each().map(|(_, _, finding)| finding.remark.clone()))
}
