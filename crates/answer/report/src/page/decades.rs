//! The decades of wavelengths on which the area is lost: a strip of shares per curve and load.

use conclusions::foremost;
use maud::{Markup, html};

use super::{SceneReport, Section, gists, per_scene, row_group, share_cell, table};
use crate::listing::decade_name;
use findings::answer::LoadAnswer;
use findings::features::DecadeShare;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let strips = per_scene(scenes, of)?;
    let gist = gists(scenes, gist);
    let body = html! {
        p {
            "How much of the way from the nominal area to the real one each decade of wavelengths accounts for, in percent \
             of log(A" sub { "n" } "/A). Darker is more; a negative share means that finer roughness made the area larger."
        }
        (strips)
    };
    Some(Section { id: "decades", title: "Where the area is lost", gist, body })
}

/// The most decades in a gist.
const DECADES_NAMED: usize = 2;

/// `100 µm to 10 µm: 50 % · 10 µm to 1 µm: 24 %`, of the model nearest to the elements, where scales
/// decide.
fn gist(report: &SceneReport<'_>) -> Option<String> {
    let load = foremost(&report.conclusions.loads).filter(|load| load.cause.has_scales())?;
    let answer = report.answer.curves[load.nearest_curve()?][load.load].as_ref()?;
    let mut decades: Vec<&DecadeShare> = answer.decades.iter().collect();
    decades.sort_by(|a, b| b.share.total_cmp(&a.share));
    let named = |decade: &&DecadeShare| {
        format!("{}: {:.0}\u{a0}%", decade_name(decade, &report.results.psd), 100.0 * decade.share)
    };
    let named: Vec<String> = decades.iter().take(DECADES_NAMED).map(named).collect();
    (!named.is_empty()).then(|| named.join(" · "))
}

/// A strip: the loads that share it, and for each decade its share in percent.
struct Strip {
    loads: Vec<usize>,
    percents: Vec<Option<i32>>,
}

/// The nearest models, and all of them below a fold.
fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let is_nearest =
        |curve: usize| report.conclusions.loads.iter().any(|load| load.nearest_curve() == Some(curve));
    let every = strips_table(report, |_| true)?;
    let others = report.answers().any(|(curve, _)| !is_nearest(curve));
    let Some(nearest) = strips_table(report, is_nearest).filter(|_| others) else { return Some(every) };
    Some(html! {
        (nearest)
        details.folded { summary { h3 { "Every model" } } (every) }
    })
}

fn strips_table(report: &SceneReport<'_>, is_shown: impl Fn(usize) -> bool) -> Option<Markup> {
    let shown = || report.answers().filter(|(curve, _)| is_shown(*curve));
    let answers = || shown().flat_map(|(_, loads)| loads);
    let mut decades: Vec<DecadeShare> =
        answers().flat_map(|(_, answer)| answer.decades.iter().copied()).collect();
    decades.sort_by(|a, b| b.longest_m.total_cmp(&a.longest_m));
    decades.dedup_by(|a, b| a.longest_m == b.longest_m);
    if decades.is_empty() {
        return None;
    }
    let psd = &report.results.psd;
    let mut columns = ["curve", "nominal pressure"].map(str::to_owned).to_vec();
    columns.extend(decades.iter().map(|decade| decade_name(decade, psd)));
    let cells = |strip: &Strip| {
        html! {
            td { (report.loads(&strip.loads)) }
            @for percent in &strip.percents { (share_cell(*percent)) }
        }
    };
    let body = html! {
        @for (curve, strips) in shown().map(|(curve, answers)| (curve, strips(answers, &decades))).filter(|(_, strips)| !strips.is_empty()) { (row_group(&report.curve(curve), &strips, cells)) }
    };
    Some(table("Share of each decade of wavelengths, in percent.", &columns, &body))
}

/// The strips of a curve. Neighbouring loads share a strip if their strips read the same.
fn strips(answers: Vec<(usize, &LoadAnswer)>, decades: &[DecadeShare]) -> Vec<Strip> {
    let mut strips: Vec<Strip> = Vec::new();
    for (load, answer) in answers.into_iter().filter(|(_, answer)| !answer.decades.is_empty()) {
        let share = |of: &DecadeShare| {
            let decade = answer.decades.iter().find(|decade| decade.longest_m == of.longest_m)?;
            Some((100.0 * decade.share).round() as i32)
        };
        let percents: Vec<Option<i32>> = decades.iter().map(share).collect();
        match strips.last_mut().filter(|strip| strip.percents == percents) {
            Some(strip) => strip.loads.push(load),
            None => strips.push(Strip { loads: vec![load], percents }),
        }
    }
    strips
}
