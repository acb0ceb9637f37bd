//! Every contact model of the program held against boundary elements on the same surfaces: the study behind
//! `docs/which-model.md`.
#![deny(missing_docs)]

pub mod elements;
mod error;
pub mod pressing;
pub mod programme;
pub mod spectra;
pub mod statistics;

pub use error::TrialError;
