//! Conclusions in words: a summary of at most twelve lines, cautions, and what to measure next.

use std::f64::consts::FRAC_1_SQRT_2;
use std::fmt::Write;

use conclusions::{
    AnswerUnderLoad, AreaEstimate, AskedValue, Cause, Conclusions, LeakInUnit, ModelCell, NextStep, OfInputs,
    OtherHardness, PeakState, SealVerdict, ShearConclusion, Source, SpotsUnderLoad, foremost,
};
use judge::{Reference, Verdict};
use scene::Scene;
use study::bodies::Body;
use study::interface::Quantity;
use uncertainty::Uncertainty;
use units::display::{counted, energy_per_area, length, percent, pressure, three_digits};
use units::{Remark, RemarkCode, SceneKeys};

use crate::cause_words::cause_line;
use crate::curve_names::short_name;
use crate::interface_words;
use crate::listing::{capital, listed, number_word, share, share_beside, share_range};
use crate::uncertainty_words;

/// The most lines of a summary.
const MAX_LINES: usize = 12;
/// The most loads with a line of their own.
const LOADS_SHOWN: usize = 3;
/// The most cautions after the trust in a summary.
const CAUTIONS_SHOWN: usize = 2;
/// The share of the high end of a leak rate below which its low end is left out.
const NEGLIGIBLE: f64 = 1e-3;
/// The most models that a summary names.
const MODELS_SHOWN: usize = 2;
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
pub fn short_summary(conclusions: &Conclusions, scene: &Scene, end: &SummaryEnd<'_>) -> String {
    let mut rows: Vec<(&str, String)> = touching_rows(conclusions, scene);
    if rows.is_empty() {
        rows.push(("Touches", "no area was computed: the scene has no curve with an area".to_owned()));
    }
    rows.extend(seal_words(conclusions).map(|words| ("Seals?", words)));
    rows.extend(foremost(&conclusions.loads).into_iter().flat_map(|load| asked_rows(conclusions, load)));
    rows.extend(
        foremost(&conclusions.loads).and_then(|load| cause_line(load.cause)).map(|words| ("Hangs on", words)),
    );
    rows.extend(
        foremost(&conclusions.loads)
            .and_then(|load| models_words(load, scene))
            .map(|words| ("Models", words)),
    );
    if !conclusions.loads.is_empty() {
        rows.push(("Trust", trust_words(conclusions)));
        rows.push(("Next", foremost_step(conclusions)));
    }
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
        (Some(rough), None) if is_rigid && scene.surface.parts.is_some() => {
            Some(format!("{rough} on a rigid face"))
        }
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
    let otherwise = foremost(&conclusions.loads).and_then(|load| Some((load, load.otherwise?)));
    rows.extend(otherwise.map(|(load, other)| {
        let at = if several { format!(" at {}", load.label) } else { String::new() };
        ("or", format!("{}{at}, {}", share(other.area_fraction), condition(&other)))
    }));
    rows
}

/// `0.18 %   0.14 to 0.22 %   boundary elements, yielding at 6.9 GPa`.
fn estimate_line(area: &AreaEstimate, scene: &Scene) -> String {
    let source = source_words(area, scene);
    let range = share_range(area.low, area.high);
    match area.area_fraction {
        Some(area_fraction) if area.low < area.high => {
            format!("{:<9} {range:<19} {source}", share_beside(area_fraction, area.high))
        }
        Some(area_fraction) => format!("{:<9} {source}", share(area_fraction)),
        None => format!("{range:<9} {source}"),
    }
}

/// The source of an area: `boundary elements, yielding at 6.9 GPa`, with whose hardness it has where both bodies have one.
pub(crate) fn source_words(area: &AreaEstimate, scene: &Scene) -> String {
    let whose = scene
        .softer()
        .filter(|softer| area.source != Source::Elements(Reference::Elastic) && softer.remark().is_some());
    let name = |flows: Body| {
        let table = match flows {
            Body::Rough => &scene.bodies.from_table,
            Body::Counterface => &scene.bodies.counterface_from_table,
        };
        table.as_ref().map_or_else(|| flows.words(), |table| &table.name)
    };
    let whose = whose.map_or_else(String::new, |softer| format!("; hardness of {}", name(softer.flows)));
    method_words(area) + &whose
}

fn method_words(area: &AreaEstimate) -> String {
    let elements = match area.maps {
        None => "boundary elements",
        Some(_) => "boundary elements on the scanned map",
    };
    match area.source {
        Source::Elements(Reference::Elastic) => format!("{elements}, elastic"),
        Source::Elements(Reference::Yielding { hardness_pa }) => {
            format!("{elements}, yielding at {}", pressure(hardness_pa))
        }
        Source::Elements(Reference::Growing) => {
            "the range from a hardness that grows at small scales to a constant one".to_owned()
        }
        Source::Model { .. } => "one model, not compared with boundary elements".to_owned(),
        Source::Models => "the range of the models, not compared with boundary elements".to_owned(),
    }
}

/// The share of scans in an interval from which on it does not tell what leads the rest.
const SHARE_OF_OTHERS: f64 = 0.3;

/// The least factor between the ends of a range that waves beyond the end of a spectrum are named for.
const LEAST_OF_END: f64 = 1.2;

/// Tells what a range consists of: `Highest over lowest: 1.32; 1.1 from the elements alone and 1.3 from uncertain inputs alone, mostly from
/// the hardness`.
pub(crate) fn parts_of_range(load: &AnswerUnderLoad, uncertainty: Option<&Uncertainty>) -> Option<String> {
    let area = &load.area;
    // Squares of logarithms add.
    let is_of_end = area.factor_of_spectrum_end.ln()
        > FRAC_1_SQRT_2 * area.factor_of_elements.ln().max(LEAST_OF_END.ln());
    if !is_of_end && area.of_inputs.is_none() {
        return None;
    }
    let from = match area.source {
        Source::Elements(Reference::Growing) => "growth of the hardness",
        Source::Elements(_) => "elements",
        Source::Model { .. } | Source::Models => "models",
    };
    let [whole, of_elements] = [area.high / area.low, area.factor_of_elements].map(three_digits);
    let mut parts = format!("Highest over lowest: {whole}; {of_elements} from the {from} alone");
    if is_of_end {
        parts += " (mostly from waves beyond the end of the spectrum)";
    }
    if let Some(OfInputs { curve, factor, share_of_scans }) = area.of_inputs {
        let interval = uncertainty
            .zip(curve)
            .and_then(|(found, curve)| Some((found, found.interval(curve, load.load)?)));
        let mostly = match interval {
            Some((found, interval)) => uncertainty_words::carried_by(found, interval),
            None => Some("all from the hardness".to_owned()),
        };
        parts += &format!(" and {} from uncertain inputs alone", three_digits(factor));
        parts.extend(mostly.filter(|_| share_of_scans < SHARE_OF_OTHERS).map(|mostly| format!(", {mostly}")));
    }
    Some(parts)
}

/// `if the hardness is 5.4 GPa at every scale`.
pub(crate) fn condition(other: &OtherHardness) -> String {
    format!("if the hardness is {} at every scale", pressure(other.hardness_pa))
}

/// The seal in words, of all loads: `NO at 0.1 and 0.2 MPa, LIKELY at 0.5 MPa (open in 25 % of draws); closes at ...`.
fn seal_words(conclusions: &Conclusions) -> Option<String> {
    let several = conclusions.loads.len() > 1;
    let mut groups: Vec<([String; 2], Vec<&str>)> = Vec::new();
    for load in &conclusions.loads {
        let words = verdict_words(load)?;
        match groups.last_mut().filter(|(of_last, _)| *of_last == words) {
            Some((_, labels)) => labels.push(&load.label),
            None => groups.push((words, vec![&load.label])),
        }
    }
    let in_words = |([verdict, behind], labels): &([String; 2], Vec<&str>)| {
        let at = if several { format!(" at {}", listed(labels)) } else { String::new() };
        format!("{verdict}{at}{behind}")
    };
    let verdicts: Vec<String> = groups.iter().map(in_words).collect();
    (!verdicts.is_empty()).then(|| format!("{}; {}", verdicts.join(", "), closing_words(conclusions)))
}

/// The verdict on a seal under a load, and what is behind it: `LIKELY`, ` (open in 25 % of draws)`.
fn verdict_words(load: &AnswerUnderLoad) -> Option<[String; 2]> {
    let seal = load.seal?;
    let verdict = match seal.verdict {
        SealVerdict::Tight => "YES",
        SealVerdict::LikelyTight => "LIKELY",
        SealVerdict::LikelyOpen => "UNLIKELY",
        SealVerdict::Open => "NO",
    };
    let is_open = matches!(seal.verdict, SealVerdict::LikelyTight | SealVerdict::LikelyOpen);
    let share = seal.open_share.filter(|_| is_open);
    let share = share.map_or_else(String::new, |share| format!(" (open in {} of draws)", percent(share)));
    Some([verdict.to_owned(), format!("{share}{}", without_adhesion(load))])
}

/// Returns the words for answers of a theory without adhesion, where surfaces stick.
fn without_adhesion(load: &AnswerUnderLoad) -> &'static str {
    if load.cause == Cause::Adhesion { " without adhesion" } else { "" }
}

/// The pressure that closes a seal: `closes at 336 kPa, 141 to 862 kPa`.
fn closing_words(conclusions: &Conclusions) -> String {
    let Some(closing) = conclusions.seal.and_then(|seal| seal.closes) else {
        return "no pressure closes it".to_owned();
    };
    let how = if closing.by_yielding { " as the contact yields" } else { "" };
    let range = interface_words::range(Quantity::TightPressure, closing.low, closing.high);
    let range = range.map_or_else(String::new, |range| format!(", {range}"));
    format!("closes at {}{range}{how}", pressure(closing.nominal_pressure_pa))
}

/// Lists the answers of a load besides the area, a row each: the seal, its leak, and the quantities of the interface.
pub(crate) fn answers_under(
    conclusions: &Conclusions,
    load: &AnswerUnderLoad,
) -> Vec<(&'static str, String)> {
    let seal = verdict_words(load)
        .map(|words| ("Seals?", format!("{}{}; {}", words[0], words[1], closing_words(conclusions))));
    seal.into_iter().chain(asked_rows(conclusions, load)).collect()
}

/// The rows of a load but for the seal's verdict.
fn asked_rows(conclusions: &Conclusions, load: &AnswerUnderLoad) -> Vec<(&'static str, String)> {
    let at = if conclusions.loads.len() > 1 { format!(" at {}", load.label) } else { String::new() };
    let at = format!("{at}{}", without_adhesion(load));
    let leak = load.seal.and_then(|seal| Some((seal.leak_rate?, seal.fluid_parts_bodies)));
    let leak = leak.map(|(leak, parts)| {
        let held = if parts { ", if something keeps the bodies together" } else { "" };
        ("Leaks", format!("{}{at}{held}{}", leak_words(&leak), few_waves(conclusions)))
    });
    let asked = load.asked.iter().map(|asked| {
        let heading = asked_heading(asked.quantity);
        let is_of_current = matches!(heading, "Current" | "Resistance");
        let spots = load.spots.filter(|_| is_of_current).map_or_else(String::new, spots_words);
        (heading, format!("{}{spots}", asked_words(asked, &at)))
    });
    let shear = conclusions.shear.iter().find(|shear| shear.load == load.load);
    let shear = shear.map(|shear| ("Shear", format!("{}{at}", shear_words(shear))));
    leak.into_iter().chain(asked).chain(shear).collect()
}

/// A leak rate in its unit: `0.12 to 0.4 ml/min`.
fn leak_words(leak: &LeakInUnit) -> String {
    let LeakInUnit { low, high, unit } = *leak;
    let unit = unit.name().replace("^3", "³");
    let [from, to] = [low, high].map(three_digits);
    match from == to {
        _ if low <= NEGLIGIBLE * high => format!("at most {to} {unit}"),
        true => format!("{to} {unit}"),
        false => format!("{from} to {to} {unit}"),
    }
}

/// Says how few of the longest waves fit into a seal, if chance decides its leak.
fn few_waves(conclusions: &Conclusions) -> String {
    let few = conclusions.seal.and_then(|seal| seal.few_waves);
    few.map_or_else(String::new, |waves| {
        format!("; the seal is only {} of the longest waves wide", three_digits(waves))
    })
}

fn asked_heading(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::MeanGap => "Gap",
        Quantity::Stiffness => "Stiffness",
        Quantity::FrictionCoefficient => "Friction",
        Quantity::ElectricalConductance => "Current",
        Quantity::ElectricalResistance => "Resistance",
        Quantity::ThermalConductanceWithGas => "Heat, with gas",
        _ => "Heat",
    }
}

/// `838 W/(m² K) at 1 MPa, 630 to 1100 W/(m² K); part of the peaks has flowed`.
fn asked_words(asked: &AskedValue, at: &str) -> String {
    let range = interface_words::range(asked.quantity, asked.low, asked.high);
    let state = match asked.state {
        Some(PeakState::Partly) => "; part of the peaks has flowed",
        Some(PeakState::Unknown) => "; from elastic to flowed peaks",
        Some(PeakState::Flowed) => "; the peaks have flowed",
        Some(PeakState::Elastic) | None => "",
    };
    let value = asked.value.map(|value| interface_words::value(asked.quantity, value));
    let flat = asked.flat.map(|flat| interface_words::value(asked.quantity, flat));
    let flat = flat.filter(|flat| Some(flat) != value.as_ref()).map(|flat| format!("; {flat} if flat"));
    let words: Vec<String> = value.map(|value| format!("{value}{at}")).into_iter().chain(range).collect();
    format!("{}{state}{}", words.join(", "), flat.unwrap_or_default())
}

/// `; 31 spots on the map of 1 mm x 1 mm, the largest carries 18 %; about 3100 on the nominal area`.
fn spots_words(spots: SpotsUnderLoad) -> String {
    let [x, y] = spots.map_m.map(length);
    let all = spots.on_nominal_area.filter(|all| *all > spots.on_map as f64);
    let all =
        all.map_or_else(String::new, |all| format!("; about {} on the nominal area", three_digits(all)));
    let on_map = counted(spots.on_map, "spot");
    format!("; {on_map} on the map of {x} x {y}, the largest carries {}{all}", percent(spots.largest_share))
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

/// The models that agree, by name, and the number of the others.
fn models_words(load: &AnswerUnderLoad, scene: &Scene) -> Option<String> {
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
        (load.tally.of_other_elements, other_bodies(load)),
    ] {
        if count > 0 {
            parts.push(format!("{words}: {count}"));
        }
    }
    Some(parts.join("   "))
}

/// Names the models that are compared with elements of other bodies than those of the estimate.
fn other_bodies(load: &AnswerUnderLoad) -> &'static str {
    match load.area.source {
        Source::Elements(Reference::Elastic) => "that yield, not needed",
        Source::Elements(_) => "of another hardness, or of none",
        _ => "of other bodies",
    }
}

/// The cautions without the same sentence about the few scans of another instrument.
pub(crate) fn told_once(cautions: &[Remark]) -> impl Iterator<Item = &Remark> {
    let is_of_few = |caution: &Remark| caution.code == RemarkCode::FewScans;
    let first = cautions.iter().position(is_of_few);
    let told = move |&(at, caution): &(usize, &Remark)| !is_of_few(caution) || Some(at) == first;
    cautions.iter().enumerate().filter(told).map(|(_, caution)| caution)
}

fn trust_words(conclusions: &Conclusions) -> String {
    let reasons: Vec<String> =
        told_once(&conclusions.cautions).take(CAUTIONS_SHOWN).map(Remark::in_short).collect();
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

/// Words the most useful measurement.
pub(crate) fn foremost_step(conclusions: &Conclusions) -> String {
    match conclusions.next.first() {
        Some(step) => next_words(step),
        None => "no measurement would narrow the range by a tenth".to_owned(),
    }
}

/// A measurement in words: `three more AFM scans at other places (the range becomes 0.7 times as wide)`.
#[must_use]
pub fn next_words(step: &NextStep) -> String {
    let shrinks = |width_ratio: &f64| match *width_ratio < 0.05 {
        true => "(nearly closes the range)".to_owned(),
        false => format!("(the range becomes {} times as wide)", three_digits(*width_ratio)),
    };
    match step {
        NextStep::Surface { body } => format!("scan {body}: the spectrum is made of a few numbers"),
        NextStep::Adhesion => "press a map with its adhesion: truearea bem MAP --work-of-adhesion W --adhesion-range R --boundary periodic \
                               --detrend plane"
            .to_owned(),
        NextStep::MoreScales => "scan a wider and a finer field: the spectrum has too few scales".to_owned(),
        NextStep::Hardness => {
            "measure the hardness by indentation: the area is in inverse proportion to it".to_owned()
        }
        NextStep::TipRadius { scan } => format!("find out the radius of the tip of {scan}"),
        NextStep::HardnessOfSofter { body } => format!("find out the hardness of {body}"),
        NextStep::SecondScan { instrument } => format!("a second {instrument} scan, at another place"),
        NextStep::FinerScan { from_m } => {
            format!("a scan finer than {}: the area still falls there", length(*from_m))
        }
        NextStep::Flatness { from_m } => format!(
            "measure the flatness of the parts (flatness = \"5 um over 40 mm\"): waves longer than {} decide gap, heat and leaks",
            length(*from_m)
        ),
        NextStep::WiderScan { from_m } => {
            format!("a scan wider than {}: longer waves decide gap, heat and leaks", length(*from_m))
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_scans_are_told_once_and_all_else_each_time() {
        let [few, hole] = [RemarkCode::FewScans, RemarkCode::NotMeasured].map(Remark::new);
        let cautions = [hole.clone(), few.clone().with("scans", 1), hole.clone(), few.with("scans", 2)];
        let told: Vec<&Remark> = told_once(&cautions).collect();
        assert_eq!(told, [&cautions[0], &cautions[1], &cautions[2]]);
    }
}
