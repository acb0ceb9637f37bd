//! The change of the area if an open modelling choice is made differently.

use maud::{Markup, html};

use super::{SceneReport, Section, gists, per_scene, row_group, table};
use findings::sensitivity::Sensitivity;
use units::display::typeset_digits;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let tables = per_scene(scenes, of)?;
    let gist = gists(scenes, |scene| {
        let (decisive, _) = by_effect(scene);
        Some(match decisive.len() {
            0 => format!("none changes the area more than {NOTABLE} times"),
            some => format!(
                "{} the area more than {NOTABLE} times",
                if some == 1 { "one setting changes".to_owned() } else { format!("{some} settings change") }
            ),
        })
    });
    let body = html! {
        p {
            "The area with one choice made the other way, over the area with the scene’s own choice; from the smallest to the \
             largest ratio under its loads. A dash: the curve does not depend on the choice."
        }
        (tables)
    };
    Some(Section { id: "sensitivities", title: "Sensitivity to modelling choices", gist, body })
}

/// A setting that changes an area by a smaller factor is folded.
const NOTABLE: f64 = 1.1;

/// The settings that change an area by more than [`NOTABLE`], and the others.
fn by_effect<'a>(report: &SceneReport<'a>) -> (Vec<&'a Sensitivity>, Vec<&'a Sensitivity>) {
    let is_notable =
        |varied: &&Sensitivity| varied.rows.iter().any(|row| row.ratio.ln().abs() > NOTABLE.ln());
    report.sensitivities.iter().filter(|varied| !varied.rows.is_empty()).partition(is_notable)
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let (notable, others) = by_effect(report);
    let folded = settings(report, &others).map(|table| {
        html! { details.folded { summary { h4 { "Settings that change less" } } (table) } }
    });
    let shown = settings(report, &notable);
    (shown.is_some() || folded.is_some())
        .then(|| html! { (shown.unwrap_or_default()) (folded.unwrap_or_default()) })
}

/// A table of settings; `None` without any.
fn settings(report: &SceneReport<'_>, varied: &[&Sensitivity]) -> Option<Markup> {
    let mut curves: Vec<usize> = varied.iter().flat_map(|varied| &varied.rows).map(|row| row.curve).collect();
    curves.sort_unstable();
    curves.dedup();
    if curves.is_empty() {
        return None;
    }
    let mut columns = ["choice", "made as"].map(str::to_owned).to_vec();
    columns.extend(curves.iter().map(|curve| report.curve(*curve)));
    let cells = |varied: &&Sensitivity| {
        html! {
            th scope="row" { (varied.setting_in_words) }
            @for curve in &curves { td { (ratios(varied, *curve)) } }
        }
    };
    let body = html! {
        @for group in varied.chunk_by(|a, b| a.choice == b.choice) {
            (row_group(group[0].choice, group, cells))
        }
    };
    Some(table("Area over the scene’s own area.", &columns, &body))
}

/// `×0.56`, `×0.93–1.07`, or a dash.
fn ratios(varied: &Sensitivity, curve: usize) -> String {
    let ratios = varied.rows.iter().filter(|row| row.curve == curve).map(|row| row.ratio);
    let (least, most) = ratios
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), ratio| (least.min(ratio), most.max(ratio)));
    if least > most {
        return "–".to_owned();
    }
    let text = |ratio: f64| {
        if (0.01..100.0).contains(&ratio) { format!("{ratio:.2}") } else { typeset_digits(ratio) }
    };
    let (least, most) = (text(least), text(most));
    if least == most { format!("×{least}") } else { format!("×{least}–{most}") }
}
