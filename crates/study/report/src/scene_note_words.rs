//! Keys of a scene that have no effect, in a line each.

use scene::{SceneNote, Unused};
use units::display::length;
use units::number;

/// The key, its line, and why it has no effect.
#[must_use]
pub fn line(note: &SceneNote) -> String {
    let why = match note.reason {
        Unused::ModelDoesNotYield => "has no effect: the model does not yield".to_owned(),
        Unused::ModelHasNoInterferenceLaw => "has no effect: only elastic-sine has a choice of it".to_owned(),
        Unused::ModelHasNoSuchOption => "has no effect: the model has no such option".to_owned(),
        Unused::CorrectionsAreElastic => "has no effect: the corrected forms are elastic ones".to_owned(),
        Unused::OtherHardnessLaw => "has no effect: only hardness_law = \"nix-gao\" takes it".to_owned(),
        Unused::FigureShowsSomethingElse => "has no effect on what this figure shows".to_owned(),
        Unused::NoCurveUsesIt => "has no effect: no curve depends on it".to_owned(),
        Unused::EveryCurveHasItsOwn => "has no effect: every curve that it is for has its own".to_owned(),
        Unused::NothingNeedsIt => "has no effect: no curve and no figure needs it".to_owned(),
        Unused::CutoffBelowData { shortest_m } => {
            format!("has no effect: the spectrum ends above it, at {}", length(shortest_m))
        }
        Unused::JudgeIsOff => "has no effect: the judge is off".to_owned(),
        Unused::UncertaintyIsOff => "has no effect: nothing is drawn".to_owned(),
        Unused::NothingScatters => {
            "has no effect: there are no several scans, no standard errors and no +- in this scene".to_owned()
        }
        Unused::ToleranceHeld { used } => {
            format!("is finer than double precision reaches: {} is used", number(used))
        }
        // Further reasons are told by their names until they have words.
        other => format!("has no effect: {other:?}"),
    };
    format!("line {}: {} {why}", note.line, note.key)
}
