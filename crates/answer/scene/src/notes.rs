//! Notes on keys of a scene that have no effect on its results. Such keys are reported, not refused.

use std::ops::Range;

use serde::Serialize;
use toml_edit::Document;

use super::raw::RawScene;
use super::{Overrides, Scene};
use study::figure::{Figure, Shows};
use study::models::{Choice, IgnoredOption, IgnoredReason};

/// A key of a scene that has no effect, or not the one that it reads as.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneNote {
    /// The key with its section, e.g. `curve.strain_gradient`.
    pub key: String,
    /// The line that it stands in, counted from 1.
    pub line: usize,
    /// The bytes of the scene that it stands in.
    pub span: Range<usize>,
    /// Reason for the missing effect.
    pub reason: Unused,
}

/// Reason why a key of a scene has no effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Unused {
    /// The curve's model does not yield, so that it has no strength.
    ModelDoesNotYield,
    /// The curve's model has no choice of an interference law.
    ModelHasNoInterferenceLaw,
    /// The curve's model has no such option.
    ModelHasNoSuchOption,
    /// The curve's model yields, and the corrected forms are elastic ones.
    CorrectionsAreElastic,
    /// The curve's hardness law is not `nix-gao`, the only one that takes a strain-gradient length.
    OtherHardnessLaw,
    /// The figure shows something else.
    FigureShowsSomethingElse,
    /// No curve depends on it.
    NoCurveUsesIt,
    /// Every curve that depends on it has a setting of its own.
    EveryCurveHasItsOwn,
    /// No curve and no figure needs it.
    NothingNeedsIt,
    /// The spectrum ends above the cutoff.
    CutoffBelowData {
        /// The shortest wavelength of the spectrum \[m\].
        shortest_m: f64,
    },
    /// The judge is off.
    JudgeIsOff,
    /// The uncertainty analysis is off.
    UncertaintyIsOff,
    /// Nothing in the scene scatters.
    NothingScatters,
    /// The tolerance is finer than double precision reaches.
    ToleranceHeld {
        /// Tolerance used instead.
        used: f64,
    },
}

/// Returns the notes on a scene in the order of its sections. Keys that are overridden from outside get no note.
pub(super) fn notes(
    text: &str,
    raw: &RawScene,
    scene: &Scene,
    ignored: &[Vec<IgnoredOption>],
    overrides: &Overrides,
) -> Vec<SceneNote> {
    // A text that does not parse was refused before.
    let Ok(document) = Document::parse(text) else { return Vec::new() };
    let mut sections = Vec::new();
    sections.extend(ignored.iter().enumerate().map(|(at, options)| ("curve", Some(at), curve(options))));
    sections.push(("loads", None, loads(scene)));
    sections.extend(scene.figures.iter().enumerate().map(|(at, figure)| ("figure", Some(at), shown(figure))));
    sections.push(("cutoffs", None, cutoffs(scene, overrides)));
    sections.push(("options", None, options(raw, scene, overrides)));
    sections.push(("judge", None, judge(scene, overrides)));
    sections.push(("uncertainty", None, uncertainty(scene, overrides)));
    let note = |section: &str, at: Option<usize>, (key, reason): (&str, Unused)| {
        let found = document.get(section)?;
        let table = at.map_or(Some(found), |at| found.get(at))?.as_table_like()?;
        let (name, value) = table.get_key_value(key)?;
        let span = name.span()?.start..value.span()?.end;
        let line = 1 + text[..span.start].matches('\n').count();
        Some(SceneNote { key: format!("{section}.{key}"), line, span, reason })
    };
    let keys = sections
        .into_iter()
        .flat_map(|(section, at, keys)| keys.into_iter().filter_map(move |key| note(section, at, key)));
    keys.collect()
}

/// Keys of a section that have no effect where they are in the text.
type UnusedKeys = Vec<(&'static str, Unused)>;

fn all(keys: &[&'static str], reason: Unused) -> UnusedKeys {
    keys.iter().map(|key| (*key, reason)).collect()
}

fn curve(ignored: &[IgnoredOption]) -> UnusedKeys {
    let key = |option: &IgnoredOption| {
        let reason = match (option.reason, option.choice) {
            (IgnoredReason::NeverYields, _) => Unused::ModelDoesNotYield,
            (IgnoredReason::CorrectionsAreElastic, _) => Unused::CorrectionsAreElastic,
            (IgnoredReason::OtherHardnessLaw, _) => Unused::OtherHardnessLaw,
            (_, Choice::Interference) => Unused::ModelHasNoInterferenceLaw,
            _ => Unused::ModelHasNoSuchOption,
        };
        (option.choice.key(), reason)
    };
    ignored.iter().map(key).collect()
}

fn loads(scene: &Scene) -> UnusedKeys {
    if !scene.needs.curves.is_empty() || scene.interface.is_some() {
        return Vec::new();
    }
    all(&["pressures", "force", "nominal_area"], Unused::NoCurveUsesIt)
}

fn shown(figure: &Figure) -> UnusedKeys {
    let unused: &[&str] = match figure.shows {
        Shows::AreaAgainstLoad => &[],
        Shows::Area if figure.loads.is_some() => &["cutoff_multiples"],
        Shows::Area => &["loads", "cutoff_multiples"],
        _ => &["curves", "models", "loads", "cutoff_multiples"],
    };
    all(unused, Unused::FigureShowsSomethingElse)
}

fn cutoffs(scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let shortest_m = scene.surface.psd.shortest_wavelength_m();
    let below = scene.sampling.cutoff_m.is_some_and(|cutoff_m| cutoff_m < shortest_m);
    if !below || overrides.cutoff.is_some() {
        return Vec::new();
    }
    vec![("shortest_wavelength", Unused::CutoffBelowData { shortest_m })]
}

fn options(raw: &RawScene, scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let needs = &scene.needs;
    let has = |choice| needs.curves.iter().any(|curve| curve.model.entry().has(choice));
    let grows = needs.curves.iter().any(|curve| curve.model.strength_grows());
    let mut unused = Vec::new();
    if needs.moments.is_none() && overrides.normalisation.is_none() {
        unused.push(("normalisation", Unused::NothingNeedsIt));
    }
    if needs.amplitudes.is_none() && overrides.amplitude.is_none() {
        unused.push(("amplitude", Unused::NothingNeedsIt));
    }
    if overrides.hardness.is_none() && !has(Choice::Hardness) {
        unused.extend(all(&["hardness_formula"], Unused::NoCurveUsesIt));
    }
    if overrides.strength_cap.is_none() && !grows {
        unused.push(("strength_cap", Unused::NoCurveUsesIt));
    }
    let mut sinusoids = raw
        .curve
        .iter()
        .map(|curve| curve.get_ref())
        .filter(|curve| curve.model.is_some_and(|model| model.has(Choice::Interference)));
    if !has(Choice::Interference) {
        unused.push(("interference_law", Unused::NoCurveUsesIt));
    } else if sinusoids.all(|curve| curve.options.interference_law.is_some()) {
        unused.push(("interference_law", Unused::EveryCurveHasItsOwn));
    }
    if needs.curves.iter().all(|curve| curve.model.statistical().is_none()) {
        unused.push(("tolerance", Unused::NoCurveUsesIt));
    } else if needs.tolerance.asked_finer().is_some() {
        unused.push(("tolerance", Unused::ToleranceHeld { used: needs.tolerance.value() }));
    }
    unused
}

fn judge(scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let reason = match scene.judge {
        _ if overrides.no_judge => return Vec::new(),
        Some(judge) if judge.off => Unused::JudgeIsOff,
        _ if scene.needs.curves.is_empty() => Unused::NoCurveUsesIt,
        _ => return Vec::new(),
    };
    all(&["grid", "realisations", "seed", "budget"], reason)
}

fn uncertainty(scene: &Scene, overrides: &Overrides) -> UnusedKeys {
    let reason = match scene.uncertainty {
        _ if overrides.no_uncertainty => return Vec::new(),
        Some(uncertainty) if uncertainty.off => Unused::UncertaintyIsOff,
        _ if scene.needs.curves.is_empty() => Unused::NoCurveUsesIt,
        _ if !scene.scatters() => Unused::NothingScatters,
        _ => return Vec::new(),
    };
    all(&["level", "draws", "seed", "shares_draws"], reason)
}
