//! The measurements that would narrow the answer most, and whether the area can settle.

use maud::{Markup, html};

use super::{SceneReport, Section, gists, per_scene};
use crate::advice_words::{foremost_advice, settling};
use crate::conclusion_words::next_words;
use crate::listing::capital;
use units::display::typeset;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    let gist = gists(scenes, |scene| scene.conclusions.next.first().map(next_words));
    Some(Section { id: "measure-next", title: "What to measure next", gist, body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let steps = &report.conclusions.next;
    let settling = foremost_advice(&report.evidence, report.conclusions).map(settling);
    (!steps.is_empty() || settling.is_some()).then(|| {
        html! {
            @if !steps.is_empty() { ol { @for step in steps { li { (typeset(&capital(&next_words(step)))) "." } } } }
            @if let Some(settling) = settling { p { (typeset(&settling)) } }
        }
    })
}
