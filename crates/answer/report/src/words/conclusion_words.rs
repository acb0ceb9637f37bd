//! Conclusions in words: a summary of at most twelve lines, cautions, and what to measure next.

use std::fmt::Write;

use findings::conclusions::{
    AreaEstimate, Conclusions, LoadConclusion, ModelCell, NextStep, OtherHardness, SealConclusion,
    ShearConclusion, Source,
};
use judge::{Reference, Verdict};
use scene::Scene;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};
use units::display::{counted, energy_per_area, length, percent, pressure, three_digits};
use units::{Remark, RemarkCode, SceneKeys};

use crate::curve_names::short_name;
use crate::interface_words;
use crate::listing::{capital, listed, number_word, share, share_range};
use crate::uncertainty_words;

/// The most lines of a summary.
const MAX_LINES: usize = 12;
/// The most loads with a line of their own.
const LOADS_SHOWN: usize = 3;
/// The most cautions after the trust in a summary.
const CAUTIONS_SHOWN: usize = 2;
/// The most models that a summary names.
const MODELS_SHOWN: usize = 2;
/// The quantities of the interface that a summary shows, and their headings.
const QUANTITIES: [(Quantity, &str); 3] = [
    (Quantity::MeanGap, "Gap"),
    (Quantity::ThermalConductance, "Heat"),
    (Quantity::ElectricalConductance, "Current"),
];

/// The end of a summary, which only a front end knows.
#[derive(Debug, Clone, Copy)]
pub struct SummaryEnd<'a> {
    /// The path of the report; absent if none was written.
    pub report: Option<&'a str>,
    /// The number of warnings that the summary leaves out.
    pub warnings: usize,
    /// The number of notes that it leaves out.
    pub notes: usize,
    /// The option that prints them.
    pub verbose_option: &'a str,
}

/// Returns the summary of a scene in at most twelve lines: what touches, the seal and the gap, the models, the trust and
/// its reason, and what to measure next.
#[must_use]
pub fn short_summary(
    conclusions: &Conclusions,
    scene: &Scene,
    states: Option<&InterfaceStates<'_>>,
    end: &SummaryEnd<'_>,
) -> String {
    let mut rows: Vec<(&str, String)> = touching_rows(conclusions, scene);
    if rows.is_empty() {
        rows.push(("Touches", "no area was computed: the scene has no curve with an area".to_owned()));
    }
    rows.extend(conclusions.seal.as_ref().map(|seal| ("Seals?", seal_words(seal, scene))));
    rows.extend(states.into_iter().flat_map(|states| quantity_rows(conclusions, states)));
    rows.extend(
        middle(conclusions).and_then(|load| models_words(load, scene)).map(|words| ("Models", words)),
    );
    if !conclusions.loads.is_empty() {
        rows.push(("Trust", trust_words(conclusions)));
    }
    rows.extend(conclusions.next.first().map(|step| ("Next", next_words(step))));
    if let Some(report) = end.report {
        rows.push(("Report", report_words(report, end)));
    }
    let mut text = format!("{}\n", heading(conclusions, scene));
    if rows.len() + 2 <= MAX_LINES {
        text.push('\n');
    }
    for (name, words) in rows.iter().take(MAX_LINES - 1) {
        let _ = writeln!(text, "  {name:<9} {words}");
    }
    text
}

/// The name of the rough body, if it has one: `steel 100Cr6`, or `coated steel 100Cr6` under a layer.
pub(crate) fn rough_body(scene: &Scene) -> Option<String> {
    let name = &scene.bodies.from_table.as_ref()?.name;
    let is_coated = scene.material.as_ref().is_some_and(|material| material.pair.layer().is_some());
    Some(if is_coated { format!("coated {name}") } else { name.clone() })
}

/// The title, the bodies and the load, if there is one only.
fn heading(conclusions: &Conclusions, scene: &Scene) -> String {
    let mut parts = vec![scene.title.clone()];
    let counterface = scene.bodies.counterface_from_table.as_ref().map(|body| body.name.as_str());
    let is_rigid = scene.material.as_ref().is_some_and(|material| material.counterface().is_none());
    parts.extend(match (rough_body(scene), counterface) {
        (Some(rough), Some(counterface)) => Some(format!("{rough} on {counterface}")),
        (Some(rough), None) if is_rigid => Some(format!("{rough} on a rigid flat")),
        _ => None,
    });
    if let [load] = &conclusions.loads[..] {
        parts.push(load.label.clone());
    }
    parts.join(" · ")
}

fn touching_rows(conclusions: &Conclusions, scene: &Scene) -> Vec<(&'static str, String)> {
    let several = conclusions.loads.len() > 1;
    let width = conclusions.loads.iter().map(|load| load.label.chars().count()).max().unwrap_or(0);
    let mut rows = Vec::new();
    for load in conclusions.loads.iter().take(LOADS_SHOWN) {
        let at = if several { format!("at {:<width$}  ", load.label) } else { String::new() };
        rows.push(("Touches", format!("{at}{}", estimate_line(&load.area, scene))));
    }
    let others = conclusions.loads.len().saturating_sub(LOADS_SHOWN);
    if let (Some((_, last)), 1..) = (rows.last_mut(), others) {
        let _ = write!(last, "; {} in the report", counted(others, "more load"));
    }
    let otherwise = middle(conclusions).and_then(|load| Some((load, load.otherwise?)));
    rows.extend(otherwise.map(|(load, other)| {
        let at = if several { format!(" at {}", load.label) } else { String::new() };
        ("or", format!("{}{at}, {}", share(other.area_fraction), condition(&other)))
    }));
    rows
}

/// `0.18 %   0.14 to 0.22 %   boundary elements, yielding at 6.9 GPa`.
fn estimate_line(area: &AreaEstimate, scene: &Scene) -> String {
    let source = source_words(area.source, scene);
    let range = share_range(area.low, area.high);
    match area.area_fraction {
        Some(area_fraction) if area.low < area.high => {
            format!("{:<9} {range:<19} {source}", share(area_fraction))
        }
        Some(area_fraction) => format!("{:<9} {source}", share(area_fraction)),
        None => format!("{range:<9} {source}"),
    }
}

/// The source of an area: `boundary elements, yielding at 6.9 GPa`, with whose hardness it has where both bodies have one.
pub(crate) fn source_words(source: Source, scene: &Scene) -> String {
    let whose = scene
        .softer()
        .filter(|softer| source != Source::Elements(Reference::Elastic) && softer.remark().is_some());
    let whose = whose.map_or_else(String::new, |softer| format!("; hardness of {}", softer.flows.words()));
    method_words(source) + &whose
}

fn method_words(source: Source) -> String {
    match source {
        Source::Elements(Reference::Elastic) => "boundary elements, elastic".to_owned(),
        Source::Elements(Reference::Yielding { hardness_pa }) => {
            format!("boundary elements, yielding at {}", pressure(hardness_pa))
        }
        Source::Elements(Reference::Growing) => {
            "the range from a hardness that grows at small scales to a constant one".to_owned()
        }
        Source::Model { .. } => "one model, not compared with boundary elements".to_owned(),
        Source::Models => "the range of the models, not compared with boundary elements".to_owned(),
    }
}

/// `if the hardness is 5.4 GPa at every scale`.
pub(crate) fn condition(other: &OtherHardness) -> String {
    format!("if the hardness is {} at every scale", pressure(other.hardness_pa))
}

/// The seal in words: `NO   closes near 2.9 GPa as the contact yields, 290 times the load`.
pub(crate) fn seal_words(seal: &SealConclusion, scene: &Scene) -> String {
    let loads = &scene.needs.loads;
    let labels = |loads_at: &[usize]| {
        listed(&loads_at.iter().map(|load| loads[*load].label.as_str()).collect::<Vec<_>>())
    };
    let state = match (&seal.closed_under[..], &seal.open_under[..]) {
        ([], _) => "NO".to_owned(),
        (_, []) => "YES".to_owned(),
        (closed, open) => format!("YES at {}, NO at {}", labels(closed), labels(open)),
    };
    let Some(closing) = seal.closes else { return format!("{state}; no pressure closes it") };
    let how = if closing.by_yielding { " as the contact yields" } else { "" };
    let times = match (&seal.open_under[..], loads.len()) {
        ([load], 1) => {
            let ratio = closing.nominal_pressure_pa / loads[*load].nominal_pressure_pa();
            format!(", {} times the load", three_digits(ratio))
        }
        _ => String::new(),
    };
    format!("{state}; closes near {}{how}{times}", pressure(closing.nominal_pressure_pa))
}

/// The quantities of the interface under the middle load.
pub(crate) fn quantity_rows(
    conclusions: &Conclusions,
    states: &InterfaceStates<'_>,
) -> Vec<(&'static str, String)> {
    let Some(load) = middle(conclusions) else { return Vec::new() };
    let is_guess =
        conclusions.cautions.iter().any(|caution| caution.code == RemarkCode::GapOfYieldingContact);
    let remark = if is_guess { "; order of magnitude, since the contact yields" } else { "" };
    let at = if conclusions.loads.len() > 1 { format!(" at {}", load.label) } else { String::new() };
    let row = |(quantity, heading): (Quantity, &'static str)| {
        let slot = Slot { quantity, load: Some(load.load), curve: None };
        let value = states.slots().contains(&slot).then(|| states.value(slot).ok().flatten()).flatten()?;
        Some((heading, format!("{}{at}{remark}", interface_words::value(quantity, value))))
    };
    let shear = conclusions.shear.iter().find(|shear| shear.load == load.load);
    let shear = shear.map(|shear| ("Shear", format!("{}{at}{remark}", shear_words(shear))));
    QUANTITIES.into_iter().filter_map(row).chain(shear).collect()
}

/// The response to a tangential load: `2.1 nm, 310 µJ/m² lost per cycle (50 % of sliding)`.
fn shear_words(shear: &ShearConclusion) -> String {
    let share = percent(shear.share_of_sliding);
    match shear.displacement_m.zip(shear.dissipation_j_per_m2) {
        Some((displacement_m, lost)) => {
            let (displacement, lost) = (length(displacement_m), energy_per_area(lost));
            format!("{displacement}, {lost} lost per cycle ({share} of sliding)")
        }
        None => format!("slides: {share} of friction times pressure"),
    }
}

/// The load in the middle, for which a summary compares models.
fn middle(conclusions: &Conclusions) -> Option<&LoadConclusion> {
    conclusions.loads.get(conclusions.loads.len() / 2)
}

/// The models that agree, by name, and the number of the others.
fn models_words(load: &LoadConclusion, scene: &Scene) -> Option<String> {
    let cells: &[ModelCell] = &load.references.first()?.models;
    let agreeing: Vec<String> = cells
        .iter()
        .filter(|cell| cell.verdict == Verdict::Agrees)
        .take(MODELS_SHOWN)
        .filter_map(|cell| {
            Some(format!("{} (×{})", short_name(&scene.needs.curves[cell.curve]), three_digits(cell.ratio?)))
        })
        .collect();
    let more = match load.tally.agree.saturating_sub(agreeing.len()) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let mut parts = Vec::new();
    parts.push(match agreeing.is_empty() {
        true => "none agrees".to_owned(),
        false => format!("agree: {}{more}", agreeing.join("; ")),
    });
    for (count, words) in [
        (load.tally.off, "off"),
        (load.tally.not_valid, "not valid"),
        (load.tally.not_judged, "not judged"),
        (load.tally.of_other_elements, "of another hardness"),
    ] {
        if count > 0 {
            parts.push(format!("{words}: {count}"));
        }
    }
    Some(parts.join("   "))
}

fn trust_words(conclusions: &Conclusions) -> String {
    let reasons: Vec<String> =
        conclusions.cautions.iter().take(CAUTIONS_SHOWN).map(Remark::in_short).collect();
    match reasons.is_empty() {
        true => conclusions.trust.name().to_owned(),
        false => format!("{} - {}", conclusions.trust.name(), reasons.join("; ")),
    }
}

fn report_words(report: &str, end: &SummaryEnd<'_>) -> String {
    let counts: Vec<String> = [(end.warnings, "warning"), (end.notes, "note")]
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| counted(count, name))
        .collect();
    match counts.is_empty() {
        true => format!("{report}   details: {}", end.verbose_option),
        false => format!("{report}   {}: {}", counts.join(", "), end.verbose_option),
    }
}

/// A caution in a sentence with its consequence.
#[must_use]
pub fn caution_words(caution: &Remark) -> String {
    let words = caution.words(&SceneKeys);
    // Doubts and remarks on models are without a full stop.
    if words.ends_with('.') { words } else { format!("{}.", capital(&words)) }
}

/// A measurement in words: `three more AFM scans at other places (range shrinks to 70 %)`.
#[must_use]
pub fn next_words(step: &NextStep) -> String {
    let shrinks = |width_ratio: &f64| match *width_ratio < 0.05 {
        true => "(nearly closes the range)".to_owned(),
        false => format!("(range shrinks to {})", percent(*width_ratio)),
    };
    match step {
        NextStep::CloseHole(hole) => {
            format!("measure between {} and {}", length(hole.longest_m), length(hole.shortest_m))
        }
        NextStep::HardnessAtSmallDepth => {
            "measure the hardness by indentation at the depth of the roughness".to_owned()
        }
        NextStep::MoreScans { instrument, added: 1, width_ratio } => {
            format!("one more {instrument} scan at another place {}", shrinks(width_ratio))
        }
        NextStep::MoreScans { instrument, added, width_ratio } => {
            format!(
                "{} more {instrument} scans at other places {}",
                number_word(*added),
                shrinks(width_ratio)
            )
        }
        NextStep::HeightScale { instrument, width_ratio } => {
            format!("calibrate the height scale of {instrument} {}", shrinks(width_ratio))
        }
        NextStep::Material { group, width_ratio } => {
            format!("measure {} {}", uncertainty_words::describe_group(*group, true), shrinks(width_ratio))
        }
        NextStep::Wavelengths { to_m, area_ratio } if (area_ratio - 1.0).abs() > 0.05 => format!(
            "measure wavelengths to {} (area expected to change by a factor {})",
            length(*to_m),
            three_digits(*area_ratio)
        ),
        NextStep::Wavelengths { to_m, .. } => format!("measure wavelengths to {}", length(*to_m)),
        other => format!("{other:?}"),
    }
}
