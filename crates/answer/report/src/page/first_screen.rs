//! The first screen: the answer, what decides it, what to know before quoting it, the models, and the area against the cutoff.
//!
//! Chips choose the load and boxes the lines, by CSS alone, so that the page needs no script.

use std::fmt::Write;

use conclusions::{AnswerUnderLoad, Conclusions, ModelCell, ReferenceGroup, foremost};
use judge::{AGREEMENT, Reference, Verdict};
use maud::{Markup, PreEscaped, html};
use study::figure::CurveLook;
use units::SceneKeys;
use units::display::{three_digits, typeset};

use super::area_curve::{self, drawn_at_first};
use super::cards::{before_quoting, best_estimate, interface_strip, other_hardness};
use super::contact_picture::contact_picture;
use super::{SceneReport, load_class, table};
use crate::chart::palette::{ModelStyle, variables};
use crate::conclusion_words::{answers_under, rough_body};
use crate::curve_names::in_words_with_publication;
use crate::listing::{share, share_range};

/// Makes the first screen of a scene; `at` is the number of the scene in the page.
pub(super) fn first_screen(report: &SceneReport<'_>, at: usize, several: bool) -> Markup {
    let conclusions = report.conclusions;
    let styles: Vec<ModelStyle> =
        CurveLook::of_curves(&report.scene.needs.curves).into_iter().map(ModelStyle::new).collect();
    html! {
        section.screen id=(format!("s{at}")) aria-label="The answer" {
            style { (PreEscaped(rules(report, at))) }
            div.top {
                h2 class=[(!several).then_some("unseen")] { @if several { (report.label) } @else { "The answer" } }
                @if let Some(bodies) = bodies(report) { p.bodies { (bodies) } }
                @if conclusions.loads.len() > 1 { (chips(conclusions, at)) }
                @else if let Some(load) = conclusions.loads.first() { p.bodies { "at " (typeset(&load.label)) } }
            }
            @if conclusions.loads.is_empty() {
                div.cards { section.card { h3 { "No area" } p { "The scene has no curve with an area." } } (before_quoting(conclusions, false)) }
            }
            div.answer {
                @if let Some(picture) = contact_picture(report, &conclusions.loads, load_class) { (picture) }
                @for load in &conclusions.loads {
                    div class={ "cards " (load_class(load)) } {
                        (best_estimate(report, load, &styles))
                        (other_hardness(load))
                        (before_quoting(conclusions, load.factor_of_hardness().is_some()))
                    }
                }
            }
            @for load in &conclusions.loads { (interface_strip(report, load)) }
            @if conclusions.loads.len() > 1 { (every_load(report)) }
            div.below {
                @if conclusions.loads.iter().any(|load| !load.references.is_empty()) { (matrix(report, at, &styles)) }
                div.chart {
                    @for load in &conclusions.loads {
                        @if let Some(figure) = area_curve::figure(report, load.load, &styles) {
                            figure class=(load_class(load)) { (figure) }
                        }
                    }
                }
            }
        }
    }
}

/// The rules that hide what belongs to other loads, and lines of models whose box is empty. A browser that does not know
/// `:has` shows all.
fn rules(report: &SceneReport<'_>, at: usize) -> String {
    let mut text = String::new();
    if report.conclusions.loads.len() > 1 {
        for load in &report.conclusions.loads {
            let load = load.load;
            let _ = write!(text, "#s{at}:not(:has(#s{at}-l{load}:checked)) .l{load}{{display:none}}");
        }
    }
    if report.conclusions.loads.iter().any(|load| !load.references.is_empty()) {
        for curve in 0..report.scene.needs.curves.len() {
            let _ = write!(text, "#s{at}:not(:has(#s{at}-m{curve}:checked)) .m{curve}{{display:none}}");
        }
    }
    text
}

/// `diamond on a rigid flat`.
pub(super) fn bodies(report: &SceneReport<'_>) -> Option<String> {
    let scene = report.scene;
    let material = scene.material.as_ref()?;
    let other = match material.counterface() {
        None if scene.surface.parts.is_some() => "a rigid face",
        None => "a rigid flat",
        Some(_) => &scene.bodies.counterface_from_table.as_ref()?.name,
    };
    Some(match rough_body(scene) {
        Some(rough) => format!("{rough} on {other}"),
        None => format!("on {other}"),
    })
}

fn chips(conclusions: &Conclusions, at: usize) -> Markup {
    let opens_on = foremost(&conclusions.loads).map(|load| load.load);
    html! {
        fieldset.chips {
            legend { "pressure" }
            @for load in &conclusions.loads {
                @let id = format!("s{at}-l{}", load.load);
                (input("radio", &id, &format!("s{at}-load"), Some(load.load) == opens_on))
                label for=(id) { (typeset(&load.label)) }
            }
        }
    }
}

/// The answers under all loads, for paper, where no chip chooses one.
fn every_load(report: &SceneReport<'_>) -> Markup {
    let columns = ["pressure", "touches", "range", "nearest model", "besides"];
    let besides = |load: &AnswerUnderLoad| {
        let rows = answers_under(report.conclusions, load).into_iter();
        typeset(&rows.map(|(name, words)| format!("{name} {words}")).collect::<Vec<_>>().join("; "))
    };
    html! {
        div.printed {
            (table("The answer under every load.", &columns, &html! {
                tbody {
                    @for load in &report.conclusions.loads {
                        tr {
                            th scope="row" { (typeset(&load.label)) }
                            td { (load.area.area_fraction.map_or_else(|| "–".to_owned(), share)) }
                            td { (share_range(load.area.low, load.area.high)) }
                            td { (load.best_model.map_or_else(|| "–".to_owned(), |best| report.short_curve(best.curve))) }
                            td.reason { (besides(load)) }
                        }
                    }
                }
            }))
        }
    }
}

/// A radio button or a box, closed so that the page reads as XML as well.
fn input(kind: &str, id: &str, name: &str, is_checked: bool) -> Markup {
    let checked = if is_checked { " checked=\"checked\"" } else { "" };
    PreEscaped(format!("<input type=\"{kind}\" id=\"{id}\" name=\"{name}\"{checked} />"))
}

/// The most loads whose ratios have room for the area beside them; of more it stands below.
const MOST_BESIDE: usize = 3;

/// Every model under every load beside the elements.
fn matrix(report: &SceneReport<'_>, at: usize, styles: &[ModelStyle]) -> Markup {
    let loads = &report.conclusions.loads;
    let drawn = drawn_at_first(loads);
    let references = references(loads);
    html! {
        div.matrix {
            h3 { "Which model to believe – area ÷ boundary elements" }
            div.wide.stacked[loads.len() > MOST_BESIDE] role="region" aria-label="Models against boundary elements" tabindex="0" {
                table {
                    thead { tr { th scope="col" { "model" } @for load in loads { th scope="col" { (typeset(&load.label)) } } } }
                    @for reference in references {
                        tbody {
                            tr.group { th colspan=(loads.len() + 1) scope="rowgroup" { (group_heading(reference, loads)) } }
                            @for curve in curves_of(reference, loads) {
                                @let id = format!("s{at}-m{curve}");
                                tr {
                                    th scope="row" {
                                        (input("checkbox", &id, &id, drawn.contains(&curve)))
                                        label for=(id) title=(in_words_with_publication(&report.scene.needs.curves[curve].model)) { span.key.line style=(variables(styles[curve].colour, styles[curve].dark_colour)) {} (report.short_curve(curve)) }
                                    }
                                    @for load in loads { (cell(report, load, reference, curve)) }
                                }
                            }
                        }
                    }
                }
            }
            p.legend {
                span.agrees { "✓ within 4/3, less the error" } " " span.large { "▲ too large" } " " span.small { "▼ too small" } " "
                span.invalid { "⊘ outside its assumptions" } " " span.hint { "tick a model to draw it; point at a cell for its reason" }
            }
        }
    }
}

/// The elements that models are compared with under the foremost load, those of its estimate first. A model whose strength grows may
/// have others under other loads.
fn references(loads: &[AnswerUnderLoad]) -> Vec<Reference> {
    foremost(loads)
        .map_or_else(Vec::new, |load| load.references.iter().map(|group| group.reference).collect())
}

fn group(load: &AnswerUnderLoad, reference: Reference) -> Option<&ReferenceGroup> {
    load.references.iter().find(|group| group.reference == reference)
}

/// The area of the elements of a group, or its range where that is all.
pub(super) fn area_words(group: &ReferenceGroup) -> Option<String> {
    group.area_fraction.map(share).or_else(|| group.range.map(|range| share_range(range.low, range.high)))
}

/// The curves of a group, in the order of the foremost load.
fn curves_of(reference: Reference, loads: &[AnswerUnderLoad]) -> Vec<usize> {
    let of_load = foremost(loads).and_then(|load| group(load, reference));
    of_load.map_or_else(Vec::new, |group| group.models.iter().map(|cell| cell.curve).collect())
}

pub(super) fn reference_words(reference: Reference) -> &'static str {
    match reference {
        Reference::Elastic => "elastic elements",
        Reference::Yielding { .. } => "elements that yield",
        Reference::Growing => "the range of a hardness that grows",
    }
}

fn group_heading(reference: Reference, loads: &[AnswerUnderLoad]) -> Markup {
    html! {
        "against " (reference_words(reference))
        @for load in loads {
            @if let Some(area) = group(load, reference).and_then(area_words) {
                span class=(load_class(load)) { ": " (area) " at " (typeset(&load.label)) }
            }
        }
    }
}

fn cell(report: &SceneReport<'_>, load: &AnswerUnderLoad, reference: Reference, curve: usize) -> Markup {
    let models = |group: &'_ ReferenceGroup| group.models.iter().find(|cell| cell.curve == curve).copied();
    let found = load.references.iter().find_map(|group| Some((group.reference, models(group)?)));
    let Some((own, found)) = found else { return html! { td {} } };
    let (class, glyph) = class_and_glyph(found.verdict);
    let mut reason = reason(report, &found, load.load);
    if own != reference && !reason.is_empty() {
        reason = format!("against {}: {reason}", reference_words(own));
    }
    html! {
        td class={ "cell " (class) } style={ "--fill:" (format!("{:.2}", fill(&found))) } tabindex="0" {
            (glyph)
            @if let Some(ratio) = found.ratio { " ×" (three_digits(ratio)) }
            @if let Some(area) = found.area_fraction { " " small { (share(area)) } }
            @if !reason.is_empty() { span.reason role="tooltip" { strong { (report.short_curve(curve)) ", " (typeset(&load.label)) } " " (typeset(&reason)) } }
        }
    }
}

/// The class of a verdict in the style sheet, and its sign.
pub(super) fn class_and_glyph(verdict: Verdict) -> (&'static str, &'static str) {
    match verdict {
        Verdict::Agrees => ("agrees", "✓"),
        Verdict::TooLarge => ("large", "▲"),
        Verdict::TooSmall => ("small", "▼"),
        Verdict::OutOfRange => ("invalid", "⊘"),
        Verdict::NotJudged => ("unknown", "–"),
    }
}

/// The strength of a cell's fill: faint at the limit of agreement, full a factor of 1.5 away from it.
pub(super) fn fill(cell: &ModelCell) -> f64 {
    let Some(ratio) = cell.ratio else { return 0.3 };
    let distance = (ratio.ln().abs() - AGREEMENT.ln()).abs() / 1.5f64.ln();
    0.35 + 0.65 * distance.min(1.0)
}

pub(super) fn reason(report: &SceneReport<'_>, cell: &ModelCell, load: usize) -> String {
    let verdicts = report.evidence.judgement.map_or(&[][..], |judgement| &judgement.curves);
    let verdict = verdicts.iter().find(|verdict| verdict.curve == cell.curve && verdict.load == load);
    verdict.map_or_else(String::new, |verdict| verdict.reason.words(&SceneKeys))
}
