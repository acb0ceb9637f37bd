#![doc = include_str!("../README.md")]
//!
//! Modules by subject:
//! * [`GapField`]: the gap between two surfaces, point by point;
//! * [`flow`]: flow factors of a gap by Reynolds' equation;
//! * [`spots`]: electrical resistance of the spots of a contact.
#![deny(missing_docs)]

pub mod flow;
mod gap_field;
pub mod spots;

pub use gap_field::{GapField, GapFieldError};
