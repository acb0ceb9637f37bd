//! Remarks on keys of a scene that have no effect on its results. Such keys are reported, not refused.

use toml_edit::{Document, Item};

use super::raw::RawScene;
use super::{Overrides, Scene};
use study::bodies::{Body, Transport};
use study::body_properties::BodyProperty;
use study::figure::{Figure, Shows};
use study::models::Choice;
use study::surface::Surface;
use units::{Remark, RemarkCode, RemarkPlace};

/// Returns the notes on a scene in the order of its sections. Keys that are overridden from outside get no note.
pub(super) fn notes(
    text: &str,
    raw: &RawScene,
    scene: &Scene,
    ignored: &[Vec<Remark>],
    overrides: &Overrides,
) -> Vec<Remark> {
    // A text that does not parse was refused before.
    let Ok(document) = Document::parse(text) else { return Vec::new() };
    let mut sections = Vec::new();
    sections.extend(ignored.iter().enumerate().map(|(at, options)| ("curve", Some(at), options.clone())));
    sections.push(("material", None, alone(&scene.bodies.counterface_transport)));
    sections.push(("counterface", None, alone(&scene.bodies.transport)));
    let softer = scene.softer().filter(|softer| softer.remark().is_some());
    let harder = softer.map(|softer| if softer.flows == Body::Rough { "counterface" } else { "material" });
    let strengths = || all(&["yield_strength", "indentation_hardness"], RemarkCode::OtherBodyYields);
    sections.extend(harder.map(|section| (section, None, strengths())));
    sections.extend(["material", "counterface"].map(|section| (section, None, growth_of_nothing(scene))));
    sections.push(("counterface", None, of_nothing_pressed(scene)));
    sections.push(("surface", None, of_several_scans(scene)));
    sections.push(("loads", None, loads(scene)));
    sections.extend(scene.figures.iter().enumerate().map(|(at, figure)| ("figure", Some(at), shown(figure))));
    sections.push(("figures", None, of_all_figures(document.get("figure"), scene)));
    sections.push(("cutoffs", None, cutoffs(scene, overrides)));
    sections.push(("options", None, options(raw, scene, overrides)));
    sections.push(("judge", None, judge(raw, scene)));
    if let Some(reason) = no_uncertainty(scene) {
        // A section that turns the analysis off has an effect.
        let keys = ["level", "draws", "seed", "shares_draws", "off"];
        let turns_off = reason == RemarkCode::UncertaintyIsOff;
        sections.push(("uncertainty", None, all(&keys[..keys.len() - usize::from(turns_off)], reason)));
        let counterface = raw.counterface.as_ref().and_then(|raw| raw.get_ref().surface.as_ref());
        let surfaces = [("surface.scans", Some(&raw.surface)), ("counterface.surface.scans", counterface)];
        for (section, surface) in surfaces {
            let scans = surface.map_or(0, |surface| surface.get_ref().scans.len());
            let of_scan = || all(&["instrument", "z_calibration", "slope_uncertainty"], reason);
            sections.extend((0..scans).map(|at| (section, Some(at), of_scan())));
        }
    } else if one_scatters(scene) {
        sections.push(("uncertainty", None, all(&["shares_draws"], RemarkCode::OneInputScatters)));
    }
    let note = |section: &str, at: Option<usize>, remark: Remark| {
        let key = remark.place.option.as_deref()?;
        let found = section.split('.').try_fold(document.as_item(), |item, part| item.get(part))?;
        let table = at.map_or(Some(found), |at| found.get(at))?.as_table_like()?;
        let (name, _) = table.get_key_value(key)?;
        let line = 1 + text[..name.span()?.start].matches('\n').count();
        let key = Some(format!("{section}.{key}"));
        Some(Remark {
            place: Box::new(RemarkPlace { line: Some(line), key, ..RemarkPlace::default() }),
            ..remark
        })
    };
    let keys = sections
        .into_iter()
        .flat_map(|(section, at, keys)| keys.into_iter().filter_map(move |key| note(section, at, key)));
    keys.collect()
}

/// Keys of a section that have no effect where they are in the text.
type UnusedKeys = Vec<Remark>;

fn one(key: &str, code: RemarkCode) -> Remark {
    Remark::new(code).on(key)
}

fn all(keys: &[&str], code: RemarkCode) -> UnusedKeys {
    keys.iter().map(|key| one(key, code)).collect()
}

/// The average of spectra, of which a surface has one.
fn of_several_scans(scene: &Scene) -> UnusedKeys {
    let own = scene.surface.parts.as_ref().map_or(&scene.surface, |parts| &parts[0]);
    match &own.made_from {
        Some(found) if found.spectrum.scans.len() == 1 => all(&["average"], RemarkCode::OneSpectrum),
        _ => Vec::new(),
    }
}

fn loads(scene: &Scene) -> UnusedKeys {
    if !scene.needs.curves.is_empty() || scene.interface.is_some() {
        return Vec::new();
    }
    all(&["pressures", "force", "nominal_area"], RemarkCode::NoCurveUsesIt)
}

fn shown(figure: &Figure) -> UnusedKeys {
    let unused: &[&str] = match figure.shows {
        Shows::AreaAgainstLoad => &[],
        Shows::Area if figure.loads.is_some() => &["cutoff_multiples"],
        Shows::Area => &["loads", "cutoff_multiples"],
        _ => &["curves", "models", "loads", "cutoff_multiples"],
    };
    all(unused, RemarkCode::FigureShowsSomethingElse)
}

/// Settings of all figures that none takes, or that each sets itself. `figures` are those of the text.
fn of_all_figures(figures: Option<&Item>, scene: &Scene) -> UnusedKeys {
    let has_own = |at: usize, key| figures.and_then(|all| all.get(at)?.get(key)).is_some();
    let takes = |key, shows: Shows| match key {
        "models" => shows.draws_areas(),
        "loads" => shows == Shows::Area,
        _ => true,
    };
    let is_taken = |key| {
        scene.figures.iter().enumerate().any(|(at, figure)| takes(key, figure.shows) && !has_own(at, key))
    };
    let keys = ["title", "models", "loads", "width", "format", "font_size"].into_iter();
    keys.filter(|key| !is_taken(*key)).map(|key| one(key, RemarkCode::NothingNeedsIt)).collect()
}

fn cutoffs(scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let shortest_m = scene.surface.psd.shortest_wavelength_m();
    let below = scene.sampling.cutoff_m.is_some_and(|cutoff_m| cutoff_m < shortest_m);
    if !below || overrides.cutoff.is_some() {
        return Vec::new();
    }
    vec![one("shortest_wavelength", RemarkCode::CutoffBelowData).with("shortest_m", shortest_m)]
}

fn options(raw: &RawScene, scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let needs = &scene.needs;
    let has = |choice| needs.curves.iter().any(|curve| curve.model.entry.has(choice));
    let idle = overrides.uses(scene).into_iter().filter(|(_, is_given, is_used, _)| !is_given && !is_used);
    let mut unused: UnusedKeys = idle.map(|(key, .., code)| one(key, code)).collect();
    for choice in [Choice::Flattening, Choice::YieldingArea] {
        if !has(choice) {
            unused.push(one(choice.key(), RemarkCode::NoCurveUsesIt));
        }
    }
    let mut sinusoids = raw
        .curve
        .iter()
        .map(|curve| curve.get_ref())
        .filter(|curve| curve.model.is_some_and(|model| model.has(Choice::Interference)));
    if !has(Choice::Interference) {
        unused.push(one("interference_law", RemarkCode::NoCurveUsesIt));
    } else if sinusoids.all(|curve| curve.options.interference_law.is_some()) {
        unused.push(one("interference_law", RemarkCode::EveryCurveHasItsOwn));
    }
    if needs.curves.iter().all(|curve| curve.model.statistical().is_none()) {
        unused.push(one("tolerance", RemarkCode::NoCurveUsesIt));
    } else {
        unused.extend(needs.tolerance.remark());
    }
    unused
}

fn judge(raw: &RawScene, scene: &Scene) -> UnusedKeys {
    let keys = ["grid", "realisations", "seed", "budget", "off", "all_models"];
    if scene.needs.curves.is_empty() {
        return all(&keys, RemarkCode::NoCurveUsesIt);
    }
    let is_off = scene.judge.is_some_and(|judge| judge.off);
    let runs_all = raw.curve.is_empty() && raw.figure.is_empty();
    let idle =
        [(is_off, &keys[..4], RemarkCode::JudgeIsOff), (runs_all, &keys[5..], RemarkCode::AllModelsRun)];
    idle.into_iter().filter(|(is_idle, ..)| *is_idle).flat_map(|(_, keys, code)| all(keys, code)).collect()
}

/// The length of a growth that no body has, since none yields, or that neither curves nor elements take.
fn growth_of_nothing(scene: &Scene) -> UnusedKeys {
    let yields = scene.material.as_ref().is_none_or(|material| material.yield_strength_pa().is_some());
    let grows = scene.needs.curves.iter().any(|curve| curve.model.strength_grows());
    let is_used = grows || !scene.judge.is_some_and(|judge| judge.off);
    let reasons = [(yields, RemarkCode::NoBodyYields), (is_used, RemarkCode::NoCurveUsesIt)];
    let reason = reasons.into_iter().find(|(has_use, _)| !has_use);
    reason.map_or_else(Vec::new, |(_, code)| all(&["strain_gradient_length"], code))
}

/// Keys of a counterface where there is no body to press it on.
fn of_nothing_pressed(scene: &Scene) -> UnusedKeys {
    if scene.material.is_some() {
        return Vec::new();
    }
    let properties = BodyProperty::ALL.map(BodyProperty::key);
    ["name"].into_iter().chain(properties).map(|key| one(key, RemarkCode::NoCurveUsesIt)).collect()
}

/// Transport properties of a body whose counterpart has none.
fn alone(other: &Transport) -> UnusedKeys {
    let missing = [
        ("thermal_conductivity", other.thermal_conductivity_w_per_m_k.is_none()),
        ("resistivity", other.resistivity_ohm_m.is_none()),
    ];
    let missing = missing.into_iter().filter(|(_, is_missing)| *is_missing);
    missing.map(|(key, _)| one(key, RemarkCode::OnlyOneBodyHasIt)).collect()
}

/// The reason that nothing is drawn.
fn no_uncertainty(scene: &Scene) -> Option<RemarkCode> {
    match scene.uncertainty {
        Some(uncertainty) if uncertainty.off => Some(RemarkCode::UncertaintyIsOff),
        _ if scene.needs.curves.is_empty() => Some(RemarkCode::NoCurveUsesIt),
        _ if !scene.scatters() => Some(RemarkCode::NothingScatters),
        _ => None,
    }
}

/// Returns true if only one input scatters; scans do by their places and by their calibration.
fn one_scatters(scene: &Scene) -> bool {
    let (surface, spreads) = (&scene.surface, &scene.spreads);
    let inputs = [
        surface.each().into_iter().any(Surface::scatters_by_errors),
        !surface.holes.is_empty(),
        !spreads.elastic_are_exact(),
        spreads.strength.is_some() || spreads.strain_gradient_length.is_some(),
    ];
    let is_scanned = surface.each().iter().any(|part| part.made_from.is_some());
    !is_scanned && inputs.into_iter().filter(|scatters| *scatters).count() == 1
}
