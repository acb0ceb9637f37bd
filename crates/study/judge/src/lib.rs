#![doc = include_str!("../README.md")]

mod assumptions;
mod body;
mod error;
mod hardness_of_scales;
mod headline;
mod judgement;
mod layout;
mod on_windows;
mod phases;
mod reason;
mod scene_judge;
mod settings;
mod solve;
mod student;
mod tables;
mod verdict;
mod verdicts;
mod window;
mod yielding;

pub use assumptions::{Broken, LARGEST_SHARE_OUT_OF_RANGE};
pub use body::Body;
pub use error::JudgeError;
pub use hardness_of_scales::AboveHardness;
pub use headline::{Headline, RestsOn};
pub use judgement::Judgement;
pub use layout::Extent;
pub use phases::OfMap;
pub use reason::Reason;
pub use scene_judge::{JudgePlan, STEEP};
pub use settings::{DEFAULT_BUDGET, DEFAULT_REALISATIONS, DEFAULT_SEED, Settings};
pub use verdict::{AGREEMENT, ERRORS_GIVEN, Verdict};
pub use verdicts::{Judged, OfCurve, OnWindow};
pub use yielding::Yielding;
