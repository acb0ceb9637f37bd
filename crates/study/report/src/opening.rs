//! What is said first of a scene: how much touches, and how sure that is.

use findings::answer::Answer;
use scene::Scene;

use crate::trust::Trust;
use crate::{uncertainty_words, verdict_words};

/// The number that a judge stands for; where none was asked, or no curve is left to him, the curves with their intervals.
pub(crate) fn lines(scene: &Scene, answer: &Answer, trust: Trust<'_>) -> Vec<String> {
    // A spectrum that tells nothing has no number.
    if answer.too_few_scales.is_some() || answer.instruments_disagree.is_some() {
        return Vec::new();
    }
    if let Some(first) = verdict_words::first_line(trust, scene) {
        return vec![first];
    }
    trust.uncertainty.map_or_else(Vec::new, |found| uncertainty_words::of_curves(found, scene))
}
