//! Notes on keys of a scene without effect, a line each.

use scene::{SceneNote, Unused};
use units::display::length;
use units::number;

/// The key, its line, and the reason why it has no effect.
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
        Unused::EveryCurveHasItsOwn => {
            "has no effect: every curve that it applies to sets its own".to_owned()
        }
        Unused::NothingNeedsIt => "has no effect: no curve and no figure needs it".to_owned(),
        Unused::CutoffBelowData { shortest_m } => {
            format!("has no effect: the spectrum ends above it, at {}", length(shortest_m))
        }
        Unused::JudgeIsOff => "has no effect: the judge is off".to_owned(),
        Unused::UncertaintyIsOff => "has no effect: the uncertainty analysis is off".to_owned(),
        Unused::NothingScatters => {
            "has no effect: nothing in this scene is uncertain (several scans, standard errors or +-)"
                .to_owned()
        }
        Unused::ToleranceHeld { used } => {
            format!("is finer than double precision reaches: {} is used", number(used))
        }
        // Reasons without words of their own show their names.
        other => format!("has no effect: {other:?}"),
    };
    format!("line {}: {} {why}", note.line, note.key)
}
