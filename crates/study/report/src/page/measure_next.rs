//! The advice on what to measure next: steps that shrink the interval, decades that widen it, and whether the area can settle.

use maud::{Markup, PreEscaped, html};

use super::{SceneReport, Section, per_numbered_scene, table};
use crate::advice_words::{describe_step, foremost_advice, in_a_line, narrows, settling, subject};
use crate::plot;
use uncertainty::{Advice, DecadeOfVariance, Uncertainty};
use units::display::{length, typeset};

/// The most steps in words; the table holds all.
const STEPS_SHOWN: usize = 5;

const SHARE: &str = "share of variance (%)";

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_numbered_scene(scenes, of)?;
    Some(Section { id: "measure-next", title: "What to measure next", body })
}

fn of(report: &SceneReport<'_>, at: usize) -> Option<Markup> {
    let uncertainty = report.evidence.uncertainty?;
    let advice = foremost_advice(&report.evidence, report.conclusions)?;
    let worthwhile: Vec<String> = advice
        .steps
        .iter()
        .filter(|step| narrows(step))
        .take(STEPS_SHOWN)
        .map(|step| in_a_line(uncertainty, step))
        .collect();
    Some(html! {
        p { "For " strong.curve { (typeset(&subject(advice, report.scene))) } ":" }
        @if worthwhile.is_empty() { p { "None of the steps tried would narrow its interval." } }
        @else { ol { @for step in &worthwhile { li { (typeset(step)) "." } } } }
        p { (typeset(&settling(advice))) }
        (decades(report, advice, &format!("scene-{at}-variance")))
        (every_step(report, uncertainty))
    })
}

/// The share of each decade in the variance, as a figure.
fn decades(report: &SceneReport<'_>, advice: &Advice, id: &str) -> Markup {
    let words = format!(
        "Share of each decade of wavelengths in the variance of ln A, {}: {}",
        subject(advice, report.scene),
        advice.decades.iter().map(in_words).collect::<Vec<_>>().join(", ")
    );
    let Some(drawn) = plot::shares_of_decades(&advice.decades, SHARE, id, &words) else { return html! {} };
    html! {
        figure {
            div.panels { div { (PreEscaped(drawn)) } }
            figcaption {
                strong { "Where the interval comes from." } " How much of the variance of ln A that the spectrum brings each decade \
                of wavelengths carries, " (typeset(&subject(advice, report.scene))) "."
            }
        }
    }
}

fn in_words(decade: &DecadeOfVariance) -> String {
    format!("{} to {} {:.0} %", length(decade.longest_m), length(decade.shortest_m), 100.0 * decade.share)
}

/// The effect of every step on every area.
fn every_step(report: &SceneReport<'_>, uncertainty: &Uncertainty) -> Markup {
    let head = html! {
        tr {
            th scope="col" { "curve" } th scope="col" { "nominal pressure" } th scope="col" { "step" }
            th scope="col" { "width of the interval" } th scope="col" { "area" }
        }
    };
    let body = html! {
        @for advice in &uncertainty.advice {
            tbody {
                @for (place, step) in advice.steps.iter().enumerate() {
                    tr {
                        @if place == 0 {
                            th scope="rowgroup" rowspan=(advice.steps.len()) { (report.curve(advice.curve)) }
                        }
                        td { (report.load(advice.load)) }
                        td { (describe_step(uncertainty, &step.kind)) }
                        td { "×" (format!("{:.2}", step.width_ratio)) }
                        td { "×" (format!("{:.2}", step.area_ratio)) }
                    }
                }
            }
        }
    };
    table("The effect of every step, the one that narrows the interval most first.", &head, &body)
}
