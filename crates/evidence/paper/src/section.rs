//! The ledger as a section of a report.

use maud::{Markup, html};
use report::page::{Section, table};
use units::display::typeset;

use crate::ledger::{Finding, Row, Verdict};
use crate::other_models::OtherModel;

impl Verdict {
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

/// Returns the ledger as a section of a report: every statement with its finding for each spectrum, and other models below the
/// counts. `label` returns the name of a spectrum in print.
#[must_use]
pub fn section(rows: &[Row], others: &[OtherModel], label: fn(&str) -> &str) -> Section {
    let mut spectra: Vec<&str> = Vec::new();
    for (spectrum, _) in rows.iter().flat_map(|row| &row.findings) {
        if !spectra.contains(spectrum) {
            spectra.push(spectrum);
        }
    }
    let head = html! {
        tr {
            th scope="col" { "no." } th scope="col" { "statement, and how it is checked" }
            @for spectrum in &spectra { th scope="col" { (label(spectrum)) } }
        }
    };
    let body = html! {
        tbody {
            @for Row { statement, findings } in rows {
                tr {
                    th scope="row" { (statement.number) }
                    td { (typeset(statement.statement)) span.how { (typeset(statement.how)) } }
                    @for spectrum in &spectra {
                        td { @for (_, finding) in findings.iter().filter(|(of, _)| of == spectrum) { (cell(finding)) } }
                    }
                }
            }
        }
    };
    let body = html! {
        @for spectrum in &spectra { p { strong { (label(spectrum)) } ": " (counts(rows, spectrum)) } }
        div.ledger { (table("Statements and what was found of them.", &head, &body)) }
        @if !others.is_empty() { (other_models(others, &spectra, label)) }
    };
    Section { id: "ledger", title: "Statements checked", body }
}

/// The findings of other models, below the counts and outside them.
fn other_models(models: &[OtherModel], spectra: &[&str], label: fn(&str) -> &str) -> Markup {
    let head = html! {
        tr {
            th scope="col" { "model" } th scope="col" { "what it says" }
            @for spectrum in spectra { th scope="col" { (label(spectrum)) } }
        }
    };
    let body = html! {
        tbody {
            @for other in models {
                tr {
                    th scope="row" { (other.model) }
                    td { (typeset(other.statement)) }
                    @for spectrum in spectra {
                        td {
                            @for (_, finding) in other.findings.iter().filter(|(of, _)| of == spectrum) {
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

/// The number of statements of each verdict, e.g. `12 reproduced, 3 not reproduced.`
fn counts(rows: &[Row], spectrum: &str) -> String {
    let findings = || rows.iter().flat_map(|row| &row.findings).filter(|(of, _)| *of == spectrum);
    let count = |verdict: Verdict| findings().filter(|(_, finding)| finding.verdict == verdict).count();
    let counts = Verdict::ALL.into_iter().map(|verdict| (count(verdict), verdict.words()));
    let counted: Vec<String> =
        counts.filter(|(count, _)| *count > 0).map(|(count, words)| format!("{count} {words}")).collect();
    format!("{}.", counted.join(", "))
}
