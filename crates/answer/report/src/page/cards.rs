//! The cards of the first screen, and the line of the answers besides the area.

use conclusions::{AnswerUnderLoad, Cause, Conclusions, Source};
use judge::Reference;
use maud::{Markup, html};
use units::display::{three_digits, typeset};
use units::{Remark, RemarkCode};

use super::range_bar::range_bar;
use super::{SceneReport, load_class};
use crate::cause_words::cause_words;
use crate::chart::palette::ModelStyle;
use crate::conclusion_words::{
    answers_under, caution_words, condition, foremost_step, parts_of_range, source_words, told_once,
};
use crate::listing::{capital, share, share_beside, share_range};

/// The most cautions on the first screen.
const CAUTIONS_SHOWN: usize = 3;

/// Makes the card of the best estimate, with its range as a bar.
pub(super) fn best_estimate(
    report: &SceneReport<'_>,
    load: &AnswerUnderLoad,
    styles: &[ModelStyle],
) -> Markup {
    let area = &load.area;
    let number = match area.area_fraction {
        Some(area_fraction) if area.low < area.high => share_beside(area_fraction, area.high),
        Some(area_fraction) => share(area_fraction),
        None => share_range(area.low, area.high),
    };
    let heading = match (area.source, load.otherwise) {
        _ if load.cause == Cause::Adhesion => "Without adhesion",
        (Source::Model { .. } | Source::Models, _) => "Not checked",
        (_, Some(_)) => "✓ Best estimate – if the hardness grows at small scales",
        (Source::Elements(Reference::Growing), None) => "✓ Range – the hardness at small scales is not known",
        _ => "✓ Best estimate",
    };
    html! {
        section.card.best {
            h3 { (heading) }
            div.figures-of-answer {
                p.number { (number) " " small { "touches" } small.printed { " at " (typeset(&load.label)) } }
                @if area.low < area.high { (range_bar(report, load, styles)) }
            }
            p {
                @if area.area_fraction.is_some() && area.low < area.high { strong { (share_range(area.low, area.high)) } " by " }
                (source_words(area, report.scene)) "."
                @if let Some(parts) = parts_of_range(load, report.evidence.uncertainty) { " " (parts) "." }
                @if let Some(best) = &load.best_model {
                    " Nearest model: " (report.short_curve(best.curve))
                    @if let Some(area_fraction) = best.area_fraction { ", " (share(area_fraction)) }
                    "."
                }
            }
            @if load.otherwise.is_none() { p { strong { "What decides: " } (typeset(&cause_words(load.cause))) } }
        }
    }
}

/// Makes the card of the area under the other assumption on the hardness; empty unless that moves it beyond the range.
pub(super) fn other_hardness(load: &AnswerUnderLoad) -> Markup {
    html! {
        @if let Some(other) = load.otherwise {
            section.card.other {
                h3 { (capital(&condition(&other))) }
                p.number { (share(other.area_fraction)) " " small { "touches" } }
                p {
                    (three_digits(other.ratio)) " times as much. Settle it by nano-indentation at the depth of the roughness."
                }
            }
        }
    }
}

/// The cautions; that on the hardness is left out if it has a card of its own.
pub(super) fn before_quoting(conclusions: &Conclusions, says_hardness: bool) -> Markup {
    let is_shown = |caution: &&Remark| !(says_hardness && caution.code == RemarkCode::HardnessDecides);
    html! {
        section.card.before {
            h3 { "Before you quote it – trust: " (conclusions.trust.name()) }
            @if conclusions.cautions.is_empty() { p { "No cautions." } }
            @else {
                ol {
                    @for caution in told_once(&conclusions.cautions).filter(is_shown).take(CAUTIONS_SHOWN) { li { (typeset(&caution_words(caution))) } }
                }
            }
            p.next { strong { "Next: " } (typeset(&foremost_step(conclusions))) "." }
        }
    }
}

/// Makes the line of the answers besides the area, under a load.
pub(super) fn interface_strip(report: &SceneReport<'_>, load: &AnswerUnderLoad) -> Markup {
    let rows = answers_under(report.conclusions, load);
    html! {
        @if !rows.is_empty() {
            dl.strip.(load_class(load)) { @for (name, words) in &rows { div { dt { (name) } dd { (typeset(words)) } } } }
        }
    }
}
