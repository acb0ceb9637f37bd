//! The ledger: every statement of the paper with its findings.

use tables::Table;

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

impl Verdict {
    pub(crate) const ALL: [Verdict; 3] =
        [Verdict::Reproduced, Verdict::NotReproduced, Verdict::ByConstruction];

    /// The verdict in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Reproduced => "reproduced",
            Verdict::NotReproduced => "not reproduced",
            Verdict::ByConstruction => "by construction",
        }
    }
}

/// Reproduced if `holds`.
pub(crate) fn verdict(holds: bool) -> Verdict {
    if holds { Verdict::Reproduced } else { Verdict::NotReproduced }
}

/// A statement of the paper and how it is measured, in our words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Statement {
    /// Its number in the ledger, 1 to 20.
    pub number: u32,
    /// What the paper says.
    pub statement: &'static str,
    /// What is computed to check it, and when it counts as reproduced.
    pub how: &'static str,
    /// The unit of the value; empty for a pure number.
    pub unit: &'static str,
}

/// What one spectrum has to say of a statement.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The number that the verdict turns on.
    pub value: f64,
    /// Everything that was measured.
    pub found: String,
    /// The verdict.
    pub verdict: Verdict,
    /// One honest sentence.
    pub remark: String,
}

/// A row of the ledger: a statement, and the finding for every spectrum by its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The statement.
    pub statement: Statement,
    /// For every spectrum, its name and the finding.
    pub findings: Vec<(&'static str, Finding)>,
}

/// The ledger as a table: `claim, spectrum, statement, how_measured, value, unit, found, verdict, remark`, a row per statement
/// and spectrum.
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
        .with_words("verdict", each().map(|(_, _, finding)| finding.verdict.words()))
        .with_text("remark", each().map(|(_, _, finding)| finding.remark.clone()))
}
