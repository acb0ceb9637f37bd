//! Statements, each held against what was found.

use maud::{Markup, html};

use super::{Section, table};
use units::display::typeset;

/// Statements and what was found of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Ledger {
    /// The statements.
    pub rows: Vec<LedgerRow>,
    /// What models that the statements are not about say of the same surfaces; not counted.
    pub other_models: Vec<OtherModel>,
}

/// Another model and what it says.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherModel {
    /// The model.
    pub model: String,
    /// What it says.
    pub statement: String,
    /// What was found in each of the scenes: the scene's label, the finding, and what else there is to say.
    pub findings: Vec<OtherFinding>,
}

/// What was found of another model in one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherFinding {
    /// The scene's label.
    pub label: String,
    /// What was found.
    pub found: String,
    /// What else there is to say.
    pub remark: String,
}

/// A statement and what was found of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LedgerRow {
    /// Its number.
    pub number: u32,
    /// What it states.
    pub statement: String,
    /// How it is checked.
    pub how: String,
    /// What was found, in each of the scenes.
    pub findings: Vec<Finding>,
}

/// What was found of a statement in one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The scene's label.
    pub label: String,
    /// What was found.
    pub found: String,
    /// Whether that is what was stated.
    pub verdict: Verdict,
    /// What else there is to say.
    pub remark: String,
}

/// Whether a statement was found to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds.
    Reproduced,
    /// It does not.
    NotReproduced,
    /// It holds because the data were made so.
    ByConstruction,
}

impl Verdict {
    const ALL: [Verdict; 3] = [Verdict::Reproduced, Verdict::NotReproduced, Verdict::ByConstruction];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Reproduced => "reproduced",
            Verdict::NotReproduced => "not reproduced",
            Verdict::ByConstruction => "by construction",
        }
    }

    fn symbol(self) -> &'static str {
        match self {
            Verdict::Reproduced => "✓",
            Verdict::NotReproduced => "✗",
            Verdict::ByConstruction => "≡",
        }
    }

    fn class(self) -> &'static str {
        match self {
            Verdict::Reproduced => "verdict holds",
            Verdict::NotReproduced => "verdict fails",
            Verdict::ByConstruction => "verdict given",
        }
    }
}

pub(super) fn section(ledger: &Ledger) -> Section {
    let mut labels: Vec<&str> = Vec::new();
    for finding in ledger.rows.iter().flat_map(|row| &row.findings) {
        if !labels.contains(&finding.label.as_str()) {
            labels.push(&finding.label);
        }
    }
    let head = html! {
        tr {
            th scope="col" { "no." } th scope="col" { "statement, and how it is checked" }
            @for label in &labels { th scope="col" { (label) } }
        }
    };
    let body = html! {
        tbody {
            @for row in &ledger.rows {
                tr {
                    th scope="row" { (row.number) }
                    td { (typeset(&row.statement)) span.how { (typeset(&row.how)) } }
                    @for label in &labels {
                        td { @for finding in row.findings.iter().filter(|found| found.label == *label) { (cell(finding)) } }
                    }
                }
            }
        }
    };
    let body = html! {
        @for label in &labels { p { strong { (label) } ": " (counts(ledger, label)) } }
        div.ledger { (table("Statements and what was found of them.", &head, &body)) }
        @if !ledger.other_models.is_empty() { (other_models(&ledger.other_models, &labels)) }
    };
    Section { id: "ledger", title: "Statements checked", body }
}

/// What other models say, below the counts and outside them.
fn other_models(models: &[OtherModel], labels: &[&str]) -> Markup {
    let head = html! {
        tr {
            th scope="col" { "model" } th scope="col" { "what it says" }
            @for label in labels { th scope="col" { (label) } }
        }
    };
    let body = html! {
        tbody {
            @for other in models {
                tr {
                    th scope="row" { (other.model) }
                    td { (typeset(&other.statement)) }
                    @for label in labels {
                        td {
                            @for finding in other.findings.iter().filter(|found| found.label == *label) {
                                span.found { (typeset(&finding.found)) }
                                span.remark { (typeset(&finding.remark)) }
                            }
                        }
                    }
                }
            }
        }
    };
    html! {
        h3 { "Other models" }
        div.ledger { (table("What models that are not the paper’s say of the same surfaces; not counted above.", &head, &body)) }
    }
}

fn cell(finding: &Finding) -> Markup {
    html! {
        span class=(finding.verdict.class()) {
            span aria-hidden="true" { (finding.verdict.symbol()) } " " (finding.verdict.words())
        }
        span.found { (typeset(&finding.found)) }
        @if !finding.remark.is_empty() { span.remark { (typeset(&finding.remark)) } }
    }
}

/// How many statements came to which verdict, e.g. `12 reproduced, 3 not reproduced.`
fn counts(ledger: &Ledger, label: &str) -> String {
    let findings = || ledger.rows.iter().flat_map(|row| &row.findings).filter(|found| found.label == label);
    let count = |verdict: Verdict| findings().filter(|found| found.verdict == verdict).count();
    let told: Vec<String> = Verdict::ALL
        .into_iter()
        .filter(|verdict| count(*verdict) > 0)
        .map(|verdict| format!("{} {}", count(verdict), verdict.words()))
        .collect();
    format!("{}.", told.join(", "))
}
