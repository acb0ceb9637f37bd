//! The final area and pressure of every curve under every load.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene, row_group, table};
use crate::yardstick_words::yardsticks;
use findings::answer::LoadAnswer;
use findings::features::Convergence;
use units::display::{length, typeset, typeset_digits};

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "key-numbers", title: "Key numbers", gist: String::new(), body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let curves: Vec<(usize, Vec<(usize, &LoadAnswer)>)> =
        report.answers().filter(|(_, loads)| !loads.is_empty()).collect();
    if curves.is_empty() {
        return None;
    }
    let columns = [
        "curve",
        "nominal pressure",
        "area fraction",
        "real pressure",
        "settled within 1\u{a0}% at",
        "within 0.1\u{a0}% at",
        "pressure set by the scale at",
        "load outside the fitted range",
    ];
    let cells = |(load, answer): &(usize, &LoadAnswer)| {
        html! {
            td { (report.load(*load)) }
            td { (typeset_digits(answer.area_fraction)) }
            td { (report.pressure(answer.real_pressure_pa)) }
            (settled(answer, answer.within_1_percent)) (settled(answer, answer.within_01_percent))
            td { (answer.setting.map_or("–".to_owned(), |scale| length(scale.wavelength_m))) }
            td { (answer.out_of_range_load_share.map_or("–".to_owned(), share_text)) }
        }
    };
    let body = html! {
        @for (curve, loads) in &curves { (row_group(&report.curve(*curve), loads, cells)) }
    };
    let caption = match report.scene.hardness_pa() {
        Some(_) => "At the shortest wavelength of the spectrum; pressures in units of the hardness H.",
        None => "At the shortest wavelength of the spectrum.",
    };
    let mut linear_laws: Vec<String> = Vec::new();
    for (curve, _) in &curves {
        // Elastic curves of one material have the same ones.
        linear_laws.extend(yardsticks(report.scene, report.results, &report.scene.needs.curves[*curve]));
    }
    linear_laws.dedup();
    Some(html! {
        (table(caption, &columns, &body))
        @for sentence in &linear_laws { p { "For comparison with the elastic areas: " (typeset(sentence)) "." } }
    })
}

fn settled(answer: &LoadAnswer, found: Convergence) -> Markup {
    match (answer.followed, answer.settled_at_m(found)) {
        (false, _) => html! { td { "–" } },
        (true, Some(wavelength_m)) => html! { td { (length(wavelength_m)) } },
        (true, None) => html! { td.open { "not settled" } },
    }
}

/// A share in a cell: `< 0.1 %`, `5.2 %`, `37 %`.
fn share_text(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0\u{a0}%".to_owned(),
        percent if percent < 0.1 => "< 0.1\u{a0}%".to_owned(),
        percent if percent < 10.0 => format!("{percent:.1}\u{a0}%"),
        percent => format!("{percent:.0}\u{a0}%"),
    }
}
