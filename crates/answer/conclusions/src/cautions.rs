//! Cautions: what to know before quoting a number.

use std::collections::BTreeMap;

use findings::doubts;
use interface::conductance::MOST_PLASTIC_SHARE;
use judge::Reference;
use scene::Scene;
use serde::ser::{Serialize, SerializeMap, Serializer};
use study::bodies::{Body, Softer};
use study::interface::InterfaceStates;
use uncertainty::MIN_SCANS;
use units::{Remark, RemarkCode};

use super::area::Source;
use super::cause::Cause;
use super::evidence::{Evidence, Trust};
use super::load_answer::{AnswerUnderLoad, foremost};
use super::stickiness::stickiness;

/// Returns the trust that a caution leaves.
#[must_use]
pub fn trust_left(caution: &Remark) -> Trust {
    let is_wide = || {
        let ends_m = caution.number("longest_m").zip(caution.number("shortest_m"));
        ends_m.is_some_and(|(longest_m, shortest_m)| longest_m > 10.0 * shortest_m)
    };
    match caution.code {
        RemarkCode::TooFewScales => Trust::None,
        RemarkCode::InstrumentsDisagree
        | RemarkCode::HardnessDecides
        | RemarkCode::NotJudged
        | RemarkCode::StickyByPastewka
        | RemarkCode::StickyByFuller
        | RemarkCode::ThinLayer => Trust::Poor,
        RemarkCode::NotMeasured if is_wide() => Trust::Poor,
        code if is_doubt(code) => Trust::Poor,
        // Who has the part sees its lay.
        RemarkCode::LayUnknown => Trust::Good,
        _ => Trust::Fair,
    }
}

fn is_doubt(code: RemarkCode) -> bool {
    code.name().starts_with("doubt.")
}

/// Writes cautions for `answer.json`: the name of each in `caution`, and its data beside it; those of a doubt in an object named after
/// the doubt.
pub(crate) fn serialize<S: Serializer>(cautions: &[Remark], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(cautions.iter().map(InAnswer))
}

struct InAnswer<'c>(&'c Remark);

impl Serialize for InAnswer<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Remark { code, place, numbers, .. } = self.0;
        let mut map = serializer.serialize_map(None)?;
        if let Some(doubt) = code.name().strip_prefix("doubt.") {
            map.serialize_entry("caution", "doubt")?;
            map.serialize_entry(
                doubt,
                &numbers.iter().map(|(name, value)| (*name, value)).collect::<BTreeMap<_, _>>(),
            )?;
            return map.end();
        }
        map.serialize_entry("caution", code.name())?;
        if !place.files.is_empty() {
            map.serialize_entry("names", &place.files)?;
        }
        numbers.iter().try_for_each(|(name, value)| map.serialize_entry(name, value))?;
        map.end()
    }
}

/// Lists the cautions, the most serious first.
pub(crate) fn cautions(
    evidence: &Evidence<'_>,
    loads: &[AnswerUnderLoad],
    states: Option<&InterfaceStates<'_>>,
) -> Vec<Remark> {
    let Evidence { scene, answer, judgement, uncertainty, .. } = *evidence;
    let mut cautions = Vec::new();
    let new = Remark::new;
    cautions.extend(states.and_then(|states| fluid_parts(loads, states)));
    cautions.extend(states.and_then(stickiness));
    let too_few = |scales: usize| new(RemarkCode::TooFewScales).with("scales", scales);
    cautions.extend(answer.too_few_scales.map(too_few));
    cautions.extend(answer.instruments_disagree.as_ref().map(|found| {
        new(RemarkCode::InstrumentsDisagree)
            .about(found.names.clone())
            .with("ratio", found.ratio)
            .with("longest_m", found.longest_m)
            .with("shortest_m", found.shortest_m)
    }));
    cautions.extend(doubts::of_scene(scene, answer).into_iter().filter(doubts::is_about_inputs));
    cautions.extend(hardness_decides(loads));
    if !loads.is_empty() && loads.iter().all(|load| load.area.source.is_of_models()) {
        cautions.push(new(RemarkCode::NotJudged));
    }
    let of_layer =
        scene.material.as_ref().and_then(|material| doubts::of_layer(material, &scene.surface.psd));
    let from_curves = loads.is_empty() || loads.iter().any(|load| load.area.source.is_of_models());
    cautions.extend(of_layer.filter(|_| from_curves));
    cautions.extend(states.and_then(|states| spreads_over_part(loads, states)));
    cautions.extend(states.and_then(|states| longer_waves(scene, states)));
    cautions.extend(scene.surface.holes.iter().map(|hole| {
        let remark = new(RemarkCode::NotMeasured).with("longest_m", hole.longest_m);
        remark.with("shortest_m", hole.shortest_m)
    }));
    let maps = judgement.into_iter().flat_map(|judgement| &judgement.maps);
    let farthest =
        maps.filter(|map| map.differs()).max_by(|a, b| a.ratio().ln().abs().total_cmp(&b.ratio().ln().abs()));
    cautions.extend(farthest.map(|map| {
        let code =
            if map.has_direction() { RemarkCode::SlopesByDirection } else { RemarkCode::NotGaussianMap };
        let remark = new(code).with("map", map.map.as_str()).with("ratio", map.ratio());
        let several = scene.needs.loads.len() > 1;
        if several { remark.with("load", scene.needs.loads[map.load].label.as_str()) } else { remark }
    }));
    let on_roughness =
        loads.iter().any(|load| !matches!(load.cause, Cause::Hardness { .. } | Cause::Adhesion));
    cautions.extend(upper_bound(evidence, loads).filter(|_| on_roughness));
    let steep_from_m = judgement.and_then(|judgement| judgement.steep_from_m);
    cautions.extend(steep_from_m.map(|from_m| new(RemarkCode::TooSteep).with("from_m", from_m)));
    let none_agrees =
        |load: &AnswerUnderLoad| load.tally.agree == 0 && load.tally.off + load.tally.not_valid > 0;
    if !loads.is_empty() && loads.iter().all(none_agrees) {
        // Models of other bodies than those of the estimate may agree with their own elements.
        let others = loads.iter().map(|load| load.tally.of_other_elements).min().unwrap_or(0);
        let models = scene.needs.curves.len() - others;
        let code = if models == 1 { RemarkCode::TheModelDisagrees } else { RemarkCode::NoModelAgrees };
        cautions.push(new(code).with("models", models));
    }
    cautions.extend(softer_without_hardness(scene));
    cautions.extend(skewed_heights(scene));
    cautions.extend(directional_waves(scene));
    cautions.extend(scene.surface.assumed().map(|body| new(RemarkCode::MadeOfNumbers).with("body", body)));
    cautions.extend(unknown_tip(scene));
    let guesses = uncertainty.into_iter().flat_map(|found| &found.guesses);
    cautions.extend(
        guesses
            .filter(|guess| matches!(guess.code, RemarkCode::FewScans | RemarkCode::OneInstrument))
            .cloned(),
    );
    cautions.extend(few_places(scene).filter(|_| uncertainty.is_none()));
    cautions.extend(states.and_then(|states| elastic_formulas(loads, states)));
    cautions.extend(traces_alone(scene).then(|| new(RemarkCode::LayUnknown)));
    if !on_roughness && states.is_none_or(|states| !needs_heights(states)) {
        cautions.retain(|caution| !is_about_roughness(caution.code));
    }
    cautions
}

/// The caution on what is computed for bodies that do not yield, where more yields than that allows.
fn elastic_formulas(loads: &[AnswerUnderLoad], states: &InterfaceStates<'_>) -> Option<Remark> {
    let leaks = states.request.seal.is_some_and(|seal| seal.joint.is_some());
    let what = match (leaks, states.request.shear.is_some()) {
        _ if states.inputs.pair.layer_compliance().is_some() => "gap and stiffness",
        (true, true) => "channels of leaks and tangential loads",
        (true, false) => "channels of leaks",
        (false, true) => "tangential loads",
        (false, false) => return None,
    };
    let may_yield = loads.iter().filter(|load| load.area.source != Source::Elements(Reference::Elastic));
    let largest = may_yield.filter_map(|load| states.plastic_share(load.load)).reduce(f64::max);
    let share = largest.filter(|share| *share > MOST_PLASTIC_SHARE)?;
    Some(Remark::new(RemarkCode::GapOfYieldingContact).with("share", share).with("what", what))
}

/// The caution on waves longer than those of the spectrum, where something is asked that the longest waves decide: the spectrum ends before
/// the mean gap has settled, or a few numbers say nothing of them.
fn longer_waves(scene: &Scene, states: &InterfaceStates<'_>) -> Option<Remark> {
    let request = states.request;
    if !request.hangs_on_long_waves() {
        return None;
    }
    if states.lacks_roll_off() {
        let remark = Remark::new(RemarkCode::GapNotSettled)
            .with("longest_m", scene.surface.psd.longest_wavelength_m());
        let flatness = request.flatness.map(|flatness| flatness.to_string());
        return Some(flatness.into_iter().fold(remark, |remark, flatness| remark.with("flatness", flatness)));
    }
    let is_guessed = scene.surface.assumed().is_some() && request.flatness.is_none();
    is_guessed.then(|| Remark::new(RemarkCode::TakenAsFlat))
}

/// The caution that contact spreads over a part of a nominal contact that is not flat, under the load that stands for all.
fn spreads_over_part(loads: &[AnswerUnderLoad], states: &InterfaceStates<'_>) -> Option<Remark> {
    let flatness = states.request.flatness?;
    let load = foremost(loads)?;
    let [wave, cap] = states.flatness_limits(load.load)?.map(|limit| limit.share);
    // What touches is a part of what contact spreads over, also where it flows.
    let (low, high) = (wave.min(cap).max(load.area.low), wave.max(cap).max(load.area.high));
    let remark = || {
        Remark::new(RemarkCode::SpreadsOverPart)
            .with("flatness", flatness.to_string())
            .with("low", low)
            .with("high", high)
            .with("load", load.label.as_str())
    };
    let peak_pa = 1.5 * load.nominal_pressure_pa / cap;
    let flows = states.inputs.hardness_pa.is_some_and(|hardness_pa| peak_pa > hardness_pa);
    (low < 0.995).then(|| if flows { remark().with("peak_pa", peak_pa) } else { remark() })
}

/// Returns true if something is asked that hangs on the heights of the roughness, even where the area does not.
fn needs_heights(states: &InterfaceStates<'_>) -> bool {
    states.request.hangs_on_long_waves() || states.request.shear.is_some()
}

/// Returns true for cautions on the spectrum, without effect on an area that hangs on the hardness alone.
fn is_about_roughness(code: RemarkCode) -> bool {
    matches!(
        code,
        RemarkCode::FewScans
            | RemarkCode::OneInstrument
            | RemarkCode::TipMayShow
            | RemarkCode::SkewedHeights
            | RemarkCode::DirectionalWaves
            | RemarkCode::LayUnknown
            | RemarkCode::MadeOfNumbers
            | RemarkCode::NotMeasured
            | RemarkCode::TooSteep
    )
}

/// Returns true if an area changes by more than 1 % on the last tenth of a decade, or on the last step.
fn still_falls(areas: &[(f64, f64)]) -> bool {
    let Some((end, before)) = areas.split_last() else { return false };
    let earlier = before.iter().rev().find(|(wavelength_m, _)| *wavelength_m >= 1.25 * end.0);
    earlier.or_else(|| before.first()).is_some_and(|(_, area)| area / end.1 > 1.01)
}

/// The unknown tip that may show at the longest wavelengths.
fn unknown_tip(scene: &Scene) -> Option<Remark> {
    let notes = scene.surface.notes.iter().filter(|note| note.code == RemarkCode::TipIndicated);
    let shows = notes.filter_map(|note| Some((note, note.number("may_show_below_m")?)));
    let (note, below_m) = shows.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let remark = Remark::new(RemarkCode::TipMayShow).about(note.place.files.clone());
    Some(remark.with("may_show_below_m", below_m))
}

/// The caution on the trace whose heights are skewed most. Plateaus between deep valleys are smooth, and high peaks are rough.
fn skewed_heights(scene: &Scene) -> Option<Remark> {
    let notes = scene.surface.notes.iter().filter(|note| note.code == RemarkCode::TraceSkewed);
    let skewed = notes.filter_map(|note| Some((note, note.number("skewness")?)));
    let (note, skewness) = skewed.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let remark = Remark::new(RemarkCode::SkewedHeights).about(note.place.files.clone());
    Some(remark.with("skewness", skewness).with("touches", if skewness < 0.0 { "more" } else { "less" }))
}

/// The caution on the scan of which waves of one length carry most.
fn directional_waves(scene: &Scene) -> Option<Remark> {
    let notes = scene.surface.notes.iter().filter(|note| note.code == RemarkCode::NarrowLine);
    let shares = notes.filter_map(|note| Some((note, note.number("share")?, note.number("wavelength_m")?)));
    let (note, share, wavelength_m) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let remark = Remark::new(RemarkCode::DirectionalWaves).about(note.place.files.clone());
    Some(remark.with("share", share).with("wavelength_m", wavelength_m))
}

/// Returns true if the spectrum of a face comes from traces alone, which are taken as those of a surface without direction.
fn traces_alone(scene: &Scene) -> bool {
    let parts = scene.surface.each();
    let mut scanned = parts.iter().filter_map(|part| part.made_from.as_ref());
    scanned.any(|scans| scans.spectrum.scans.iter().all(|scan| scan.checks.slope_across.is_none()))
}

/// The caution on a surface that was scanned at one or two places, where nothing is drawn that would tell.
fn few_places(scene: &Scene) -> Option<Remark> {
    let parts = scene.surface.each();
    let scans = parts.iter().filter_map(|part| part.made_from.as_ref());
    let places = scans.map(|scans| scans.spectrum.place_count()).min()?;
    (places < MIN_SCANS).then(|| {
        Remark::new(RemarkCode::FewScans)
            .with("scans", places)
            .with("instrument", scene.surface.name.as_str())
    })
}

/// The caution on a body that is less stiff than the one whose hardness was given, and has none of its own. Rubbers do not flow.
fn softer_without_hardness(scene: &Scene) -> Option<Remark> {
    const STIFFEST_RUBBER_PA: f64 = 100e6;
    let material = scene.material.as_ref()?;
    let harder = match material.softer() {
        Some(Softer { other_pa: Some(_), .. }) => return None,
        Some(softer) => softer.flows,
        None => material.hardness_pa().map(|_| Body::Rough)?,
    };
    let (rough, counterface) = (material.pair.body(), material.counterface()?);
    let (softer, softer_body, harder_body) = match harder {
        Body::Rough => (Body::Counterface, counterface, rough),
        Body::Counterface => (Body::Rough, rough, counterface),
    };
    let modulus_pa = softer_body.youngs_modulus_pa();
    let remark = Remark::new(RemarkCode::SofterWithoutHardness)
        .with("softer", softer.words())
        .with("harder", harder.words());
    (modulus_pa > STIFFEST_RUBBER_PA && modulus_pa < harder_body.youngs_modulus_pa()).then_some(remark)
}

/// The caution on a fluid that presses more than the bodies do, under the lightest such load.
fn fluid_parts(loads: &[AnswerUnderLoad], states: &InterfaceStates<'_>) -> Option<Remark> {
    let joint = states.request.seal?.joint?;
    let parted = loads.iter().find(|load| states.request.parts_bodies(load.nominal_pressure_pa))?;
    let remark = Remark::new(RemarkCode::FluidParts).with("fluid_pressure_pa", joint.pressure_drop_pa());
    Some(remark.with("pressure_pa", parted.nominal_pressure_pa))
}

/// The caution that the hardness at small scales decides, with the largest factor of any load.
pub(crate) fn hardness_decides(loads: &[AnswerUnderLoad]) -> Option<Remark> {
    let ratio = loads.iter().filter_map(AnswerUnderLoad::factor_of_hardness).reduce(f64::max)?;
    Some(Remark::new(RemarkCode::HardnessDecides).with("ratio", ratio))
}

/// The caution that the area is still falling at the end of the spectrum, for any load.
fn upper_bound(evidence: &Evidence<'_>, loads: &[AnswerUnderLoad]) -> Option<Remark> {
    let falls = |load: &AnswerUnderLoad| {
        let followed = |curve: usize| {
            let answer = evidence.answer.curves[curve][load.load].as_ref();
            answer.filter(|answer| answer.followed).map(|answer| {
                let areas = evidence.results.curves[curve].area_fractions(load.load);
                !answer.settled && still_falls(&areas)
            })
        };
        // Where no curve agrees with elements, all must fall.
        let mut all = (0..evidence.answer.curves.len()).filter_map(followed).peekable();
        match load.best_model.and_then(|cell| followed(cell.curve)) {
            Some(falls) => falls,
            None if load.area.source.is_of_models() => all.any(|falls| falls),
            None => all.peek().is_some() && all.all(|falls| falls),
        }
    };
    let shortest_m = evidence.results.psd.shortest_wavelength_m();
    loads.iter().any(falls).then(|| Remark::new(RemarkCode::UpperBound).with("shortest_m", shortest_m))
}
