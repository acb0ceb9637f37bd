//! The judgement in words, and the verdict on every curve.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene, table};
use crate::verdict_words;
use units::display::{typeset, typeset_digits};

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "verdict", title: "Which model to believe", body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let judgement = report.evidence.judgement?;
    let head = html! {
        tr {
            th scope="col" { "nominal pressure" } th scope="col" { "model" } th scope="col" { "area" }
            th scope="col" { "over boundary elements" } th scope="col" { "verdict" } th scope="col" { "why" }
        }
    };
    let digits = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), typeset_digits);
    let rows = (0..report.scene.needs.loads.len())
        .flat_map(|load| judgement.curves.iter().filter(move |curve| curve.load == load));
    let body = html! {
        tbody {
            @for row in rows {
                tr {
                    th scope="row" { (report.load(row.load)) }
                    td { span.curve { (report.curve(row.curve)) } }
                    td { (digits(row.area_fraction)) }
                    td { (digits(row.ratio())) }
                    td { (row.verdict.name()) }
                    td { (typeset(&row.reason.to_string())) }
                }
            }
        }
    };
    let caption =
        "Every curve under every load: its area over that of boundary elements, both with the whole band.";
    Some(html! {
        @for text in verdict_words::sentences(judgement, report.scene) { p { (typeset(&text)) } }
        (table(caption, &head, &body))
    })
}
