//! The ledger as the opening of a report.

use maud::{Markup, html};
use report::page::table;
use units::display::typeset;

use crate::evidence::Reading;
use crate::ledger::{Part, Row, Statement, UNKNOWN, Verdict, parts_that_hold};
use crate::other_models::OtherModel;

impl Verdict {
    fn symbol(self) -> &'static str {
        match self {
            Verdict::Reproduced => "✓",
            Verdict::NotReproduced => "✗",
            Verdict::ByConstruction => "~",
        }
    }

    fn class(self) -> &'static str {
        match self {
            Verdict::Reproduced => "agrees",
            Verdict::NotReproduced => "large",
            Verdict::ByConstruction => "invalid",
        }
    }
}

/// Returns the ledger as the opening of a report: for every spectrum and reading a square for each part of a statement, and,
/// folded, its check and its findings, with other models below. `label` returns the name of a spectrum in print.
#[must_use]
pub fn opening(rows: &[Row], parts: &[Part], others: &[OtherModel], label: fn(&str) -> &str) -> Markup {
    let mut spectra: Vec<&str> = Vec::new();
    for (spectrum, _) in rows.iter().flat_map(|row| &row.findings) {
        if !spectra.contains(spectrum) {
            spectra.push(spectrum);
        }
    }
    html! {
        section.screen id="ledger" {
            h2 { "Statements of the paper" }
            @for spectrum in &spectra {
                h3 { (label(spectrum)) ": " (counts(rows, spectrum)) }
                @for reading in Reading::ALL { (squares(parts, spectrum, Some(reading))) }
                (squares(parts, spectrum, None))
            }
            details.folded {
                summary { h3 { "Each statement, how it is checked, and what was found" } }
                @for row in rows { (folded(row, &spectra, label)) }
                h3 { "What cannot be known" }
                ul { @for unknown in UNKNOWN { li { (typeset(unknown)) } } }
                @if !others.is_empty() { (other_models(others, &spectra, label)) }
            }
        }
    }
}

/// A square for each part of a statement on a spectrum in a reading, or in any, linked to the statement.
fn squares(parts: &[Part], spectrum: &str, reading: Option<Reading>) -> Markup {
    let name = reading.map_or("any reading", |reading| reading.name);
    let count = parts_that_hold(parts, spectrum, reading);
    html! {
        div.squares {
            p { strong { (name) } " " span { (count) " of " (parts.len()) " parts hold." } }
            ol {
                @for part in parts {
                    @if let Some(verdict) = part.mark(spectrum, reading) {
                        li {
                            a class={ "cell " (verdict.class()) } href=(anchor(&part.statement)) {
                                (part.label) " " (verdict.symbol())
                                span.reason { (verdict.name()) ": " (typeset(part.words)) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn anchor(statement: &Statement) -> String {
    format!("#statement-{}", statement.number)
}

/// A statement with its verdicts, folded over the check and the findings.
fn folded(Row { statement, findings }: &Row, spectra: &[&str], label: fn(&str) -> &str) -> Markup {
    html! {
        details.folded id=(&anchor(statement)[1..]) {
            summary {
                h4 { (statement.number) ". " (typeset(statement.statement)) }
                @for (_, finding) in findings {
                    " " span class=(finding.verdict.class()) { (finding.verdict.symbol()) span.unseen { (finding.verdict.name()) } }
                }
            }
            p { (typeset(statement.how)) }
            dl {
                @for spectrum in spectra {
                    dt { (label(spectrum)) }
                    @for (_, finding) in findings.iter().filter(|(of, _)| of == spectrum) {
                        dd {
                            strong { (finding.verdict.name()) } ": " (typeset(&finding.found))
                            @if !finding.remark.is_empty() { ". " (typeset(&finding.remark)) }
                        }
                    }
                }
            }
        }
    }
}

/// The findings of other models, below the counts and outside them.
fn other_models(models: &[OtherModel], spectra: &[&str], label: fn(&str) -> &str) -> Markup {
    let mut columns = vec!["model", "what it says"];
    columns.extend(spectra.iter().map(|spectrum| label(spectrum)));
    let body = html! {
        tbody {
            @for other in models {
                tr {
                    th scope="row" { (other.model) }
                    td { (typeset(other.statement)) }
                    @for spectrum in spectra {
                        td {
                            @for (_, finding) in other.findings.iter().filter(|(of, _)| of == spectrum) {
                                span.found { (typeset(finding)) }
                                span.remark { (typeset(other.remark)) }
                            }
                        }
                    }
                }
            }
        }
    };
    html! {
        h3 { "Other models" }
        div.ledger { (table("What models that are not the paper’s say of the same surfaces; not counted above.", &columns, &body)) }
    }
}

/// The number of statements of each verdict, e.g. `12 reproduced, 3 not reproduced.`
fn counts(rows: &[Row], spectrum: &str) -> String {
    let findings = || rows.iter().flat_map(|row| &row.findings).filter(|(of, _)| *of == spectrum);
    let count = |verdict: Verdict| findings().filter(|(_, finding)| finding.verdict == verdict).count();
    let counts = Verdict::ALL.iter().map(|&verdict| (count(verdict), verdict.name()));
    let counted: Vec<String> =
        counts.filter(|(count, _)| *count > 0).map(|(count, words)| format!("{count} {words}")).collect();
    format!("{}.", counted.join(", "))
}
