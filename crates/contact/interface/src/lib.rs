#![doc = include_str!("../README.md")]
//!
//! A formula is found by its subject:
//! * [`conductance`]: heat and current by Barber's analogy and by correlations for plastic contact, one circular spot, and
//!   what none of them knows;
//! * [`leak`]: what a seal lets through, to an order of magnitude;
//! * [`friction`]: what shearing the contact takes;
//! * [`adhesion`]: Fuller & Tabor's parameter, and the left side of Pastewka & Robbins' criterion.
#![deny(missing_docs)]

pub mod adhesion;
pub mod conductance;
pub mod friction;
pub mod leak;

pub use units::{Bound, OutOfBounds};
