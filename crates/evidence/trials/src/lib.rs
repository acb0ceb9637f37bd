//! Trials on surfaces whose spectrum is known, which make tables of the documentation:
//!
//! * [`sections`]: every model against boundary elements (`docs/guide/which-model.md`);
//! * [`judge_trials`] and [`layer_trials`]: the judge of scenes against whole bands solved at once (`docs/develop/trials.md`);
//! * [`gap_trials`]: mean gap and stiffness of Persson's theory against boundary elements (`docs/develop/trials.md`);
//! * [`flatness_trials`]: parts that are not flat against elements with a long wave (`docs/develop/trials.md`);
//! * [`yielding_trials`]: gap and stiffness after yielding against elements that flow (`docs/develop/trials.md`);
//! * [`flattening_trials`]: spheres that flatten against elements that flow (`docs/develop/trials.md`);
//! * [`scene_trials`]: the answer of reports on files of instruments (`docs/develop/trials.md`);
//! * [`coverage`]: how often intervals of the area hold the truth (`docs/theory/intervals.md`).
#![deny(missing_docs)]

pub mod coverage;
pub mod elements;
mod error;
pub mod flatness_trials;
pub mod flattening_trials;
pub mod flow_trials;
pub mod gap_trials;
pub mod judge_spectra;
pub mod judge_trials;
pub mod judge_truth;
pub mod layer_trials;
pub mod models;
pub mod pressing;
pub mod programme;
pub mod ratios;
pub mod scene_trials;
pub mod sections;
pub mod spectra;
pub mod statistics;
pub mod yielding_trials;

pub use error::TrialError;
