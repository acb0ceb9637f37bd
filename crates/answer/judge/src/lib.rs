#![doc = include_str!("../README.md")]

mod assumptions;
mod body;
mod case;
mod closed_form;
mod comparison;
mod error;
mod hardness_of_scales;
mod headline;
mod judge_plan;
mod judgement;
mod layout;
mod maps;
mod model_areas;
mod scatter;
mod seam;
mod solve;
mod tables;
mod verdict;
mod verdicts;
mod waves;
mod window;
mod yielding;

pub use assumptions::LARGEST_SHARE_OUT_OF_RANGE;
pub use body::{BodyKind, Reference};
pub use error::JudgeError;
pub use hardness_of_scales::AboveHardness;
pub use headline::{Basis, Headline, Otherwise};
pub use judge_plan::JudgePlan;
pub use judgement::Judgement;
pub use layout::Extent;
pub use maps::MapVerdict;
pub use scene::JudgeSettings;
pub use verdict::{AGREEMENT, ERRORS_GIVEN, Verdict, WorstWindow};
pub use verdicts::{AreaRange, CurveVerdict, ElementArea, ReferenceArea, WindowOutcome};
pub use waves::exponent_of_stiffness;
pub use yielding::Yielding;
