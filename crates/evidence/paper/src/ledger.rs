//! The ledger: every statement of the paper with its findings.

use tables::Table;

use crate::evidence::{Evidence, Reading};

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
    /// Parts of a statement that says several things, each with whether it holds; empty for all others.
    pub parts: Vec<(bool, &'static str)>,
    /// Remark of one sentence.
    pub remark: String,
}

impl Finding {
    /// Creates the finding on a statement that says one thing.
    pub(crate) fn new(value: f64, found: String, verdict: Verdict, remark: impl Into<String>) -> Self {
        Finding { value, found, verdict, parts: Vec::new(), remark: remark.into() }
    }

    /// Creates the finding on a statement that holds if all of its parts do.
    pub(crate) fn of_parts(value: f64, found: String, parts: &[(bool, &'static str)]) -> Self {
        let all = verdict(parts.iter().all(|(holds, _)| *holds));
        Finding { value, found, verdict: all, parts: parts.to_vec(), remark: which_parts(parts) }
    }
}

/// Lists the parts of a statement that hold and those that do not.
fn which_parts(parts: &[(bool, &str)]) -> String {
    let names = |wanted: bool| {
        let chosen: Vec<&str> =
            parts.iter().filter(|(holds, _)| *holds == wanted).map(|(_, name)| *name).collect();
        chosen.join(", ")
    };
    match (names(true), names(false)) {
        (all, none) if none.is_empty() => format!("Found: {all}."),
        (none, all) if none.is_empty() => format!("Not found: {all}."),
        (some, others) => format!("Found: {some}. Not found: {others}."),
    }
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

/// Part of a statement, or a whole one that has no parts, with a mark for every spectrum and reading.
#[derive(Debug, Clone)]
pub struct Part {
    /// Statement that it belongs to.
    pub statement: Statement,
    /// Number in the ledger, with a letter for a part: `7`, `8a`.
    pub label: String,
    /// Words of the part.
    pub words: &'static str,
    /// Spectra and readings, each with its verdict.
    pub marks: Vec<(&'static str, Reading, Verdict)>,
}

impl Part {
    /// Returns the parts of a statement, checked on every spectrum in every reading.
    pub(crate) fn of(statement: Statement, evidence: &[Evidence]) -> Vec<Part> {
        let mut parts: Vec<Part> = Vec::new();
        for of_scene in evidence {
            let found = (statement.check)(of_scene);
            let whole = [(found.verdict, statement.statement)];
            let of_parts = found.parts.iter().map(|&(holds, words)| (verdict(holds), words));
            let marks = whole.into_iter().filter(|_| found.parts.is_empty()).chain(of_parts);
            for (at, (mark, words)) in marks.enumerate() {
                if at == parts.len() {
                    let letter = if found.parts.is_empty() { "" } else { &"abcdef"[at..=at] };
                    let label = format!("{}{letter}", statement.number);
                    parts.push(Part { statement, label, words, marks: Vec::new() });
                }
                parts[at].marks.push((of_scene.template.name(), of_scene.reading, mark));
            }
        }
        parts
    }

    /// Returns the mark of a spectrum in a reading or, without one, in the best of all.
    #[must_use]
    pub fn mark(&self, spectrum: &str, reading: Option<Reading>) -> Option<Verdict> {
        let chosen = |(_, own, _): &&(&str, Reading, Verdict)| reading.is_none_or(|reading| *own == reading);
        let of_spectrum = self.marks.iter().filter(|(own, ..)| *own == spectrum).filter(chosen);
        of_spectrum.map(|(.., mark)| *mark).min_by_key(|mark| *mark as usize)
    }
}

/// Returns the marks as a table: `part, spectrum, reading, words, verdict`.
pub fn parts_table(parts: &[Part]) -> Table {
    let each = || parts.iter().flat_map(|part| part.marks.iter().map(move |mark| (part, mark)));
    Table::default()
        .with_text("part", each().map(|(part, _)| part.label.clone()))
        .with_words("spectrum", each().map(|(_, (spectrum, ..))| *spectrum))
        .with_words("reading", each().map(|(_, (_, reading, _))| reading.name))
        .with_words("words", each().map(|(part, _)| part.words))
        .with_words("verdict", each().map(|(.., (.., verdict))| verdict.name()))
}

/// Counts the parts that hold on a spectrum in a reading, or in any.
#[must_use]
pub fn parts_that_hold(parts: &[Part], spectrum: &str, reading: Option<Reading>) -> usize {
    let holds =
        |part: &&Part| part.mark(spectrum, reading).is_some_and(|mark| mark != Verdict::NotReproduced);
    parts.iter().filter(holds).count()
}

/// Questions on the paper that no text within reach answers; nothing is tuned to answer them.
pub const UNKNOWN: [&str; 4] = [
    "The exact area of a sinusoid that yields: Jackson, Krithivasan & Wilson 2008, An et al. 2019 and Chu et al. 2021 were not to be had, \
     and no implementation of the stack was found. 8 H needs an area that is full only at p*_ep, and a p*_ep of 7 to 8.5 H.",
    "The force of a sphere flattened beyond a = 0.41 R: the law was fitted no further. Public implementations hold neither force nor area.",
    "The loads of the paper's figures: the text names none.",
    "The paper's spectrum below 30 nm: the reconstruction is pinned to two printed numbers there, and the measured one ends at 3.5 nm.",
];
