#![doc = include_str!("../README.md")]
//!
//! Modules by subject:
//! * [`conductance`]: heat and current by Barber's analogy and by correlations for plastic contact, one circular
//!   spot, and the effects that none of them includes;
//! * [`finite_elements`]: contact and conductance laws as finite element codes read them;
//! * [`flatness`]: parts that are not flat, and two limits of what that does;
//! * [`gas`]: heat through the gas in the gaps, and its gas parameter;
//! * [`leak`]: the range of the leak rate of a seal; [`sealed_fluid`]: the fluid that leaks, and units of its rate;
//! * [`friction`]: friction of a contact of known area;
//! * [`tangential`]: displacement, slip and energy lost under a tangential load;
//! * [`adhesion`]: Fuller & Tabor's parameter, and the left side of Pastewka & Robbins' criterion.
#![deny(missing_docs)]

pub mod adhesion;
pub mod conductance;
pub mod finite_elements;
pub mod flatness;
pub mod friction;
pub mod gas;
pub mod leak;
pub mod sealed_fluid;
pub mod tangential;

pub use units::{Bound, OutOfBounds};
