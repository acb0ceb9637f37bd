//! The uncertainty of the areas: intervals, their sources, and the inputs of the draws.

use conclusions::foremost;
use maud::{Markup, PreEscaped, html};

use super::{SceneReport, Section, gists, per_scene, row_group, share_cell, table};
use crate::advice_words::{foremost_advice, subject};
use crate::chart;
use crate::listing::share_range;
use crate::uncertainty_words::{self, level};
use uncertainty::{
    Advice, AreaInterval, DecadeOfVariance, Group, InstrumentInput, InstrumentName, OverlapMisfit, Resampled,
    Uncertainty,
};
use units::display::{counted, length, three_digits, typeset, typeset_digits};

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    let gist = gists(scenes, |scene| {
        let load = foremost(&scene.conclusions.loads)?;
        scene.evidence.uncertainty?;
        Some(format!("{}, at {}", share_range(load.area.low, load.area.high), load.label))
    });
    Some(Section { id: "how-sure", title: "How sure", gist, body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let uncertainty = report.evidence.uncertainty?;
    let is_nearest = |area: &AreaInterval| {
        let mut loads = report.conclusions.loads.iter();
        loads.any(|load| load.load == area.load && load.nearest_curve() == Some(area.curve))
    };
    let advice = foremost_advice(&report.evidence, report.conclusions);
    Some(html! {
        (intervals(report, uncertainty, "The model nearest to the elements.", is_nearest))
        details.folded {
            summary { h3 { "Every model, and the inputs of the draws" } }
            @for (text, ..) in uncertainty_words::sentences(uncertainty) { p { (typeset(&text)) } }
            (intervals(report, uncertainty, EVERY_AREA, |_| true))
            @if let Some(advice) = advice { (decades(report, advice)) }
            @if !uncertainty.instruments.is_empty() { (instruments(uncertainty)) }
            @if !uncertainty.overlaps.is_empty() { (overlaps(uncertainty)) }
        }
    })
}

const EVERY_AREA: &str = "Coverage intervals of every area, and how much of the variance of ln A each group of inputs carries by itself, in \
    percent; “together” is what no group carries alone. Shares known no better than to 10 % are left empty. The Monte Carlo error is that of \
    the interval, as a share of its width.";

/// The areas that are shown, with their intervals and the shares of their variance.
fn intervals(
    report: &SceneReport<'_>,
    uncertainty: &Uncertainty,
    caption: &str,
    is_shown: impl Fn(&AreaInterval) -> bool,
) -> Markup {
    let groups = &uncertainty.groups;
    let mut columns = ["curve", "nominal pressure", "area fraction"].map(str::to_owned).to_vec();
    columns.push(level(uncertainty));
    columns.extend(groups.iter().map(|group| group_name(*group).to_owned()));
    columns.extend((groups.len() > 1).then(|| "together".to_owned()));
    columns.extend(["median", "68 %", "Monte Carlo error"].map(str::to_owned));
    let cells = |area: &&AreaInterval| {
        html! {
            td { (report.load(area.load)) }
            td { (typeset_digits(area.area_fraction)) }
            td { (between(area.low, area.high)) }
            @for group in groups { (share_cell(percent(uncertainty.share(area, *group)))) }
            @if groups.len() > 1 { (share_cell(percent(uncertainty.share_of_others(area)))) }
            td { (typeset_digits(area.median)) }
            td { (between(area.within_68[0], area.within_68[1])) }
            td { (three_digits((1000.0 * area.monte_carlo_error).round() / 10.0)) "\u{a0}%" }
        }
    };
    let of_curve = |curve: usize| -> Vec<&AreaInterval> {
        uncertainty.areas.iter().filter(|area| area.curve == curve && is_shown(area)).collect()
    };
    let curves = (0..report.scene.needs.curves.len()).map(|curve| (curve, of_curve(curve)));
    let body = html! {
        @for (curve, areas) in curves.filter(|(_, areas)| !areas.is_empty()) {
            (row_group(&report.curve(curve), &areas, cells))
        }
    };
    table(caption, &columns, &body)
}

/// The share of each decade in the variance, as a figure.
fn decades(report: &SceneReport<'_>, advice: &Advice) -> Markup {
    let subject = subject(advice, report.scene);
    let words = format!(
        "Share of each decade of wavelengths in the variance of ln A, {subject}: {}",
        advice.decades.iter().map(in_words).collect::<Vec<_>>().join(", ")
    );
    let is_drawable = |decade: &&DecadeOfVariance| {
        decade.shortest_m > 0.0 && decade.longest_m > decade.shortest_m && decade.share.is_finite()
    };
    // A share below 0 is within its own error.
    let bar = |decade: &DecadeOfVariance| {
        ([decade.shortest_m, decade.longest_m], 100.0 * decade.share.clamp(0.0, 1.0))
    };
    let shown: Vec<_> = advice.decades.iter().filter(is_drawable).map(bar).collect();
    let drawn = chart::bars(&shown, "share of variance (%)", &words);
    html! {
        @if let Some(drawn) = drawn {
            figure {
                div.panels { div { (PreEscaped(drawn)) } }
                figcaption {
                    strong { "Where the interval comes from." } " How much of the variance of ln A that the spectrum brings each decade \
                    of wavelengths carries, " (typeset(&subject)) "."
                }
            }
        }
    }
}

fn in_words(decade: &DecadeOfVariance) -> String {
    format!("{} to {} {:.0} %", length(decade.longest_m), length(decade.shortest_m), 100.0 * decade.share)
}

/// The inputs that every instrument adds to the draws.
fn instruments(uncertainty: &Uncertainty) -> Markup {
    let columns = [
        "instrument",
        "scans",
        "wavelengths",
        "scatter (type A) from",
        "height scale (type B)",
        "exponent (type B)",
        "gain left by overlaps",
    ];
    let body = html! {
        tbody { @for instrument in &uncertainty.instruments { (instrument_row(instrument)) } }
    };
    table(
        "Instruments: standard uncertainties of their height scales and of the exponents of their spectra, and the gain of ln C \
         with its standard uncertainty that overlaps with other instruments leave.",
        &columns,
        &body,
    )
}

fn instrument_row(instrument: &InstrumentInput) -> Markup {
    let [longest_m, shortest_m] = instrument.band_m;
    let [gain, gain_uncertainty] = instrument.gain;
    let resampled = match instrument.resampled {
        Resampled::Scans(scans) => counted(scans, "scan"),
        Resampled::BlocksOfLines(blocks) => counted(blocks, "block") + " of lines",
        Resampled::SingleLine => "the Fourier bins of one scan".to_owned(),
    };
    html! {
        tr {
            th scope="row" { (instrument.name.text()) @if is_guessed(instrument) { " (guessed)" } }
            td { (instrument.scans) }
            td { (length(longest_m)) " to " (length(shortest_m)) }
            td { (resampled) }
            td {
                (three_digits(100.0 * instrument.z_calibration)) "\u{a0}%"
                @if instrument.z_calibration_is_assumed { " (assumed)" }
            }
            td { @if instrument.slope_uncertainty == 0.0 { "–" } @else { (three_digits(instrument.slope_uncertainty)) } }
            td { (signed(gain)) " ± " (three_digits(gain_uncertainty)) }
        }
    }
}

fn is_guessed(instrument: &InstrumentInput) -> bool {
    !matches!(instrument.name, InstrumentName::Given(_))
}

/// The overlaps of instruments.
fn overlaps(uncertainty: &Uncertainty) -> Markup {
    let columns = [
        "instruments",
        "where both measure",
        "bins",
        "ratio of spectra",
        "from scatter",
        "with height scales",
        "",
    ];
    let name = |at: usize| uncertainty.instruments.get(at).map_or("", |instrument| instrument.name.text());
    let found = |overlap: &OverlapMisfit| match uncertainty_words::is_as_expected(overlap) {
        true => "as expected",
        false => "more than explained",
    };
    let body = html! {
        tbody {
            @for overlap in &uncertainty.overlaps {
                tr {
                    th scope="row" { (name(overlap.instruments[0])) " over " (name(overlap.instruments[1])) }
                    td { (length(overlap.longest_m)) " to " (length(overlap.shortest_m)) }
                    td { (overlap.bins) }
                    td { "×" (three_digits(overlap.misfit.exp())) }
                    td { "×" (three_digits(overlap.scatter.exp())) }
                    td { "×" (three_digits(overlap.expected.exp())) }
                    td { (found(overlap)) }
                }
            }
        }
    };
    table(
        "Overlaps: the geometric mean of the ratio of two spectra, and its standard uncertainty as a factor.",
        &columns,
        &body,
    )
}

fn between(low: f64, high: f64) -> String {
    format!("{} to {}", typeset_digits(low), typeset_digits(high))
}

fn percent(share: Option<f64>) -> Option<i32> {
    share.map(|share| (100.0 * share).round() as i32)
}

fn group_name(group: Group) -> &'static str {
    match group {
        Group::Scans => "scans",
        Group::Instruments => "instruments",
        Group::Material => "elastic constants",
        Group::Strength => "strength",
        Group::Holes => "holes in the spectrum",
    }
}

/// A number with a typeset sign.
fn signed(value: f64) -> String {
    let sign = if value < 0.0 { "−" } else { "" };
    format!("{sign}{}", three_digits(value.abs()))
}
