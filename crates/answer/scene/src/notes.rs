//! Remarks on keys of a scene that have no effect on its results. Such keys are reported, not refused.

use toml_edit::Document;

use super::raw::RawScene;
use super::{Overrides, Scene};
use study::bodies::Transport;
use study::body_properties::BodyProperty;
use study::figure::{Figure, Shows};
use study::models::Choice;
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
    sections.extend(["material", "counterface"].map(|section| (section, None, growth_of_nothing(scene))));
    sections.push(("counterface", None, of_nothing_pressed(scene)));
    sections.push(("loads", None, loads(scene)));
    sections.extend(scene.figures.iter().enumerate().map(|(at, figure)| ("figure", Some(at), shown(figure))));
    sections.push(("cutoffs", None, cutoffs(scene, overrides)));
    sections.push(("options", None, options(raw, scene, overrides)));
    sections.push(("judge", None, judge(scene)));
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
    let grows = needs.curves.iter().any(|curve| curve.model.strength_grows());
    let mut unused = Vec::new();
    if !scene.takes_normalisation() && overrides.normalisation.is_none() {
        unused.push(one("normalisation", RemarkCode::NothingNeedsIt));
    }
    if needs.amplitudes.is_none() && overrides.amplitude.is_none() {
        unused.push(one("amplitude", RemarkCode::NothingNeedsIt));
    }
    if overrides.hardness.is_none() && !has(Choice::Hardness) {
        unused.extend(all(&["hardness_formula"], RemarkCode::NoCurveUsesIt));
    }
    if overrides.strength_cap.is_none() && !grows {
        unused.push(one("strength_cap", RemarkCode::NoCurveUsesIt));
    }
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

fn judge(scene: &Scene) -> UnusedKeys {
    let keys = ["grid", "realisations", "seed", "budget", "all_models", "off"];
    match scene.judge {
        _ if scene.needs.curves.is_empty() => all(&keys, RemarkCode::NoCurveUsesIt),
        Some(judge) if judge.off => all(&keys[..4], RemarkCode::JudgeIsOff),
        _ => Vec::new(),
    }
}

/// The length of a growth that no body has, since none yields.
fn growth_of_nothing(scene: &Scene) -> UnusedKeys {
    let yields = scene.material.as_ref().is_none_or(|material| material.yield_strength_pa().is_some());
    if yields { Vec::new() } else { all(&["strain_gradient_length"], RemarkCode::NoBodyYields) }
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
