//! Notes on keys of a scene that have no effect on its results. Such keys are reported, not refused.

use std::ops::Range;

use serde::Serialize;
use toml::de::{DeTable, DeValue};

use super::{Overrides, Scene};
use study::figure::Shows;
use study::models::{Choice, IgnoredOption, IgnoredReason, ModelEntry};

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
    scene: &Scene,
    ignored: &[Vec<IgnoredOption>],
    overrides: &Overrides,
) -> Vec<SceneNote> {
    // A text that does not parse was refused before.
    let Ok(document) = DeTable::parse(text) else { return Vec::new() };
    let mut keys = Keys { text, document: document.get_ref(), notes: Vec::new() };
    curves(&mut keys, ignored);
    loads(&mut keys, scene);
    figures(&mut keys, scene);
    cutoffs(&mut keys, scene, overrides);
    options(&mut keys, scene, overrides);
    judge(&mut keys, scene, overrides);
    uncertainty(&mut keys, scene, overrides);
    keys.notes
}

fn curves(keys: &mut Keys<'_>, ignored: &[Vec<IgnoredOption>]) {
    for (table, ignored) in keys.tables("curve").into_iter().zip(ignored) {
        for option in ignored {
            let reason = match (option.reason, option.choice) {
                (IgnoredReason::NeverYields, _) => Unused::ModelDoesNotYield,
                (IgnoredReason::CorrectionsAreElastic, _) => Unused::CorrectionsAreElastic,
                (IgnoredReason::OtherHardnessLaw, _) => Unused::OtherHardnessLaw,
                (_, Choice::Interference) => Unused::ModelHasNoInterferenceLaw,
                _ => Unused::ModelHasNoSuchOption,
            };
            keys.note("curve", table, option.choice.key(), reason);
        }
    }
}

fn loads(keys: &mut Keys<'_>, scene: &Scene) {
    let Some(table) = keys.section("loads") else { return };
    if scene.needs.curves.is_empty() && scene.interface.is_none() {
        for key in ["pressures", "force", "nominal_area"] {
            keys.note("loads", table, key, Unused::NoCurveUsesIt);
        }
    }
}

fn figures(keys: &mut Keys<'_>, scene: &Scene) {
    for (table, figure) in keys.tables("figure").into_iter().zip(&scene.figures) {
        let idle: &[&str] = match figure.shows {
            Shows::AreaAgainstLoad => &[],
            Shows::Area => &["loads", "cutoff_multiples"],
            Shows::Psd | Shows::Moments | Shows::Amplitude | Shows::AspectRatio => {
                &["curves", "loads", "cutoff_multiples"]
            }
        };
        for key in idle {
            keys.note("figure", table, key, Unused::FigureShowsSomethingElse);
        }
    }
}

fn cutoffs(keys: &mut Keys<'_>, scene: &Scene, overrides: &Overrides) {
    let shortest_m = scene.surface.psd.shortest_wavelength_m();
    let below = scene.sampling.cutoff_m.is_some_and(|cutoff_m| cutoff_m < shortest_m);
    if let Some(table) = keys.section("cutoffs").filter(|_| below && overrides.cutoff.is_none()) {
        keys.note("cutoffs", table, "shortest_wavelength", Unused::CutoffBelowData { shortest_m });
    }
}

fn options(keys: &mut Keys<'_>, scene: &Scene, overrides: &Overrides) {
    let Some(table) = keys.section("options") else { return };
    let needs = &scene.needs;
    let any_model = |is: fn(&ModelEntry) -> bool| needs.curves.iter().any(|curve| is(curve.model.entry()));
    if needs.moments.is_none() && overrides.normalisation.is_none() {
        keys.note("options", table, "normalisation", Unused::NothingNeedsIt);
    }
    if needs.amplitudes.is_none() && overrides.amplitude.is_none() {
        keys.note("options", table, "amplitude", Unused::NothingNeedsIt);
    }
    if overrides.hardness.is_none() && !any_model(|model| model.has(Choice::Hardness)) {
        keys.note("options", table, "hardness", Unused::NoCurveUsesIt);
    }
    if overrides.strength_cap.is_none() && !needs.curves.iter().any(|curve| curve.model.strength_grows()) {
        keys.note("options", table, "strength_cap", Unused::NoCurveUsesIt);
    }
    interference_law(keys, table, scene);
    if needs.curves.iter().all(|curve| curve.model.statistical().is_none()) {
        keys.note("options", table, "tolerance", Unused::NoCurveUsesIt);
    } else if needs.tolerance.asked_finer().is_some() {
        let used = needs.tolerance.value();
        keys.note("options", table, "tolerance", Unused::ToleranceHeld { used });
    }
}

fn judge(keys: &mut Keys<'_>, scene: &Scene, overrides: &Overrides) {
    let Some(table) = keys.section("judge").filter(|_| !overrides.no_judge) else { return };
    let off = scene.judge.is_some_and(|judge| judge.off);
    let idle = off.then_some(Unused::JudgeIsOff);
    if let Some(reason) = idle.or(scene.needs.curves.is_empty().then_some(Unused::NoCurveUsesIt)) {
        for key in ["grid", "realisations", "seed", "budget"] {
            keys.note("judge", table, key, reason);
        }
    }
}

fn uncertainty(keys: &mut Keys<'_>, scene: &Scene, overrides: &Overrides) {
    let Some(table) = keys.section("uncertainty").filter(|_| !overrides.no_uncertainty) else { return };
    let off = scene.uncertainty.is_some_and(|uncertainty| uncertainty.off);
    let idle = [
        (off, Unused::UncertaintyIsOff),
        (scene.needs.curves.is_empty(), Unused::NoCurveUsesIt),
        (!scene.scatters(), Unused::NothingScatters),
    ];
    let Some((_, reason)) = idle.into_iter().find(|(holds, _)| *holds) else { return };
    for key in ["level", "draws", "seed", "shares_draws"] {
        keys.note("uncertainty", table, key, reason);
    }
}

fn interference_law<'d>(keys: &mut Keys<'d>, options: &'d DeTable<'d>, scene: &Scene) {
    let tables = keys.tables("curve");
    let of_sinusoids: Vec<_> = tables
        .into_iter()
        .zip(&scene.needs.curves)
        .filter(|(_, curve)| curve.model.entry().has(Choice::Interference))
        .collect();
    if of_sinusoids.is_empty() {
        keys.note("options", options, "interference_law", Unused::NoCurveUsesIt);
    } else if of_sinusoids.iter().all(|(table, _)| value(table, "interference_law").is_some()) {
        keys.note("options", options, "interference_law", Unused::EveryCurveHasItsOwn);
    }
}

/// The keys that stand in a scene, and what there is to note of them.
struct Keys<'d> {
    text: &'d str,
    document: &'d DeTable<'d>,
    notes: Vec<SceneNote>,
}

impl<'d> Keys<'d> {
    fn section(&self, name: &str) -> Option<&'d DeTable<'d>> {
        match value(self.document, name)? {
            DeValue::Table(table) => Some(table),
            _ => None,
        }
    }

    /// The tables of an array of them, in order.
    fn tables(&self, name: &str) -> Vec<&'d DeTable<'d>> {
        let Some(DeValue::Array(items)) = value(self.document, name) else { return Vec::new() };
        let table = |item: &'d toml::Spanned<DeValue<'d>>| match item.get_ref() {
            DeValue::Table(table) => Some(table),
            _ => None,
        };
        items.iter().filter_map(table).collect()
    }

    /// Notes a key where it stands in its table.
    fn note(&mut self, section: &str, table: &DeTable<'_>, key: &str, reason: Unused) {
        let found = table.iter().find(|(name, _)| name.get_ref() == key);
        let Some((name, value)) = found else { return };
        let span = name.span().start..value.span().end;
        let line = 1 + self.text[..span.start].matches('\n').count();
        self.notes.push(SceneNote { key: format!("{section}.{key}"), line, span, reason });
    }
}

fn value<'d>(table: &'d DeTable<'d>, key: &str) -> Option<&'d DeValue<'d>> {
    table.iter().find(|(name, _)| name.get_ref() == key).map(|(_, value)| value.get_ref())
}
