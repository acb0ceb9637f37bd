#![doc = include_str!("../README.md")]
//!
//! * [`ContactLaw`]: pressures and gaps as close together as linear interpolation needs, [`LawPoint`] by point.
//! * [`ExponentialLaw`]: the limit of light loads, which CalculiX takes as two numbers.
//! * [`ConductanceTable`]: thermal or electrical conductance against pressure.
//! * [`UnitSystem`]: the units of a finite element model.
//! * [`Dialect`]: the format of a code, and [`Heading`], the comments in front of the numbers.
#![deny(missing_docs)]

mod conductance;
mod conductance_sampling;
mod dialect;
mod error;
mod exponential;
mod fields;
mod heading;
mod law;
mod sampling;
mod unit_system;

pub use conductance::{ConductanceError, ConductancePoint, ConductanceTable, Flow};
pub use dialect::{Column, Dialect};
pub use error::{ContactLawError, SamplingError};
pub use exponential::ExponentialLaw;
pub use heading::Heading;
pub use law::{ContactLaw, LawPoint};
pub use unit_system::UnitSystem;
