//! Laws used outside their fitted range, and states limited by a bound.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene};
use crate::words::curve_counts::{beyond_fitted_range, statistical_notes};
use findings::doubts;
use units::SceneKeys;
use units::display::percent;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "validity", title: "Validity", gist: String::new(), body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    if report.scene.needs.curves.is_empty() {
        return None;
    }
    let doubts = doubts::of_scene(report.scene, report.answer);
    let warned: Vec<(String, Vec<String>)> = report
        .answers()
        .map(|(curve, _)| (report.curve(curve), warnings(report, curve)))
        .filter(|(_, warnings)| !warnings.is_empty())
        .collect();
    Some(html! {
        @if !doubts.is_empty() {
            p { "Some of these numbers are physically implausible:" }
            ul { @for doubt in &doubts { li { (doubt.words(&SceneKeys)) "." } } }
        }
        @if warned.is_empty() { p { "No law was used outside its fitted range." } }
        @else {
            dl.validity {
                @for (curve, warnings) in &warned {
                    dt { (curve) }
                    @for warning in warnings { dd { (warning) "." } }
                }
            }
        }
    })
}

fn warnings(report: &SceneReport<'_>, curve: usize) -> Vec<String> {
    let result = &report.results.curves[curve];
    let answers = report.answer.curves[curve].iter().flatten();
    let shares = answers.filter_map(|answer| answer.out_of_range_load_share);
    let largest = shares.fold(0.0, f64::max);
    let mut warnings = Vec::new();
    if largest > 0.0 {
        let share = percent(largest);
        warnings.push(format!(
            "at the shortest wavelength up to {share} of the load rests on asperities outside the fitted range of their law"
        ));
    }
    warnings.extend(statistical_notes(result));
    if let Some(levels) = result.stacked() {
        warnings.extend(beyond_fitted_range(levels));
    }
    warnings
}
