//! The judgement in words, and the verdict on every curve.

use conclusions::foremost;
use maud::{Markup, html};

use super::{SceneReport, Section, gists, per_scene, row_group, table};
use crate::listing::range;
use crate::verdict_words;
use judge::CurveVerdict;
use units::SceneKeys;
use units::display::{typeset, typeset_digits};

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    let gist = gists(scenes, |scene| {
        let tally = foremost(&scene.conclusions.loads)?.tally;
        Some(format!("{} agree, {} off, {} not valid", tally.agree, tally.off, tally.not_valid))
    });
    Some(Section { id: "verdict", title: "Verdicts on the models", gist, body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let judgement = report.evidence.judgement?;
    let columns = ["model", "nominal pressure", "area", "over boundary elements", "verdict", "why"];
    let cells = |row: &&[&CurveVerdict]| {
        html! {
            td { (report.loads(&row.iter().map(|of| of.load).collect::<Vec<_>>())) }
            td { (digits(row.iter().filter_map(|of| of.area_fraction))) }
            td { (digits(row.iter().filter_map(|of| of.ratio()))) }
            td { (row[0].verdict.name()) }
            td.reason { (typeset(&furthest(row).reason.words(&SceneKeys))) }
        }
    };
    let body = html! {
        @for curve in 0..report.scene.needs.curves.len() {
            @let verdicts: Vec<&CurveVerdict> = judgement.curves.iter().filter(|of| of.curve == curve).collect();
            // Neighbouring loads with one verdict share a row, with the reason of the load that is furthest off.
            @let rows: Vec<&[&CurveVerdict]> = verdicts.chunk_by(|a, b| a.verdict == b.verdict).collect();
            @if !rows.is_empty() { (row_group(&report.curve(curve), &rows, cells)) }
        }
    };
    let caption = "The area of every curve over that of boundary elements, both with the whole band.";
    Some(html! {
        @for text in verdict_words::about_elements(judgement, report.scene) { p { (typeset(&text)) } }
        (table(caption, &columns, &body))
    })
}

/// A number or a range with three digits, or a dash.
fn digits(values: impl Iterator<Item = f64> + Clone) -> String {
    match values.clone().next() {
        Some(_) => range(values, typeset_digits),
        None => "–".to_owned(),
    }
}

/// The verdict under the load at which the area is furthest from that of the elements.
fn furthest<'a>(row: &[&'a CurveVerdict]) -> &'a CurveVerdict {
    let distance = |of: &&CurveVerdict| of.ratio().map_or(0.0, |ratio| ratio.ln().abs());
    row.iter().copied().reduce(|a, b| if distance(&b) > distance(&a) { b } else { a }).unwrap_or(row[0])
}
