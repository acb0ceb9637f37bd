//! Every contact model of the program compared with boundary elements on the same surfaces: the study behind
//! `docs/guide/which-model.md`.
#![deny(missing_docs)]

pub mod elements;
mod error;
pub mod gap_trials;
pub mod gluing;
pub mod hardness;
pub mod judge_spectra;
pub mod judge_trials;
pub mod judge_truth;
pub mod layer_trials;
pub mod models;
pub mod pictures;
pub mod pressing;
pub mod programme;
pub mod ratios;
pub mod refit;
pub mod sections;
pub mod spectra;
pub mod statistics;
pub mod window_law;
pub mod windows;

pub use error::TrialError;
