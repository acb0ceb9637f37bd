//! Disagreements between models.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene, table};
use findings::answer::DISAGREEMENT;
use units::display::{length, typeset_digits};

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "disagreements", title: "Where the models disagree", gist: String::new(), body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let found = &report.answer.disagreements;
    if found.is_empty() {
        return None;
    }
    let apart = format!("more than {DISAGREEMENT}x apart for cutoffs below");
    let columns = ["nominal pressure", "smallest area", "largest area", "ratio", &apart];
    let area = |curve: usize, load: usize| {
        let answer = report.answer.curves[curve][load].as_ref();
        let fraction = answer.map_or_else(String::new, |answer| typeset_digits(answer.area_fraction));
        html! { td { (fraction) " " span.curve { (report.curve(curve)) } } }
    };
    let body = html! {
        tbody {
            @for found in found {
                tr {
                    th scope="row" { (report.load(found.load)) }
                    (area(found.least, found.load)) (area(found.most, found.load))
                    td { (typeset_digits(found.ratio)) }
                    td { (found.parting_wavelength_m.map_or("–".to_owned(), length)) }
                }
            }
        }
    };
    Some(table("The smallest and the largest area that the curves end in.", &columns, &body))
}
