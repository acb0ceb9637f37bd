//! The inputs of conclusions, and the trust in them.

use judge::Judgement;
use scene::Scene;
use serde::Serialize;
use study::plan::Results;
use uncertainty::Uncertainty;

use findings::answer::SceneAnswer;

/// The inputs of conclusions: a scene and what was found about it.
#[derive(Clone, Copy)]
pub struct Evidence<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its results.
    pub results: &'a Results,
    /// Its answer.
    pub answer: &'a SceneAnswer,
    /// The verdicts of boundary elements; absent if nothing was judged.
    pub judgement: Option<&'a Judgement>,
    /// The uncertainty of the areas; absent if nothing was drawn.
    pub uncertainty: Option<&'a Uncertainty>,
}

/// The trust in the conclusions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Trust {
    /// The numbers cannot be used.
    None,
    /// An order of magnitude.
    Poor,
    /// A number with a condition.
    Fair,
    /// A number with its range.
    Good,
}

impl Trust {
    /// Returns the name, for print and for scripts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Trust::None => "none",
            Trust::Poor => "poor",
            Trust::Fair => "fair",
            Trust::Good => "good",
        }
    }
}
