//! Contact laws for finite element codes: nominal pressure over overclosure, in the units of the model and the format of
//! Abaqus, CalculiX, or CSV. The points are dense enough for linear interpolation.
//!
//! ```
//! use std::convert::Infallible;
//!
//! use interface::finite_elements::{ContactLaw, Dialect, Heading, LawPoint, UnitSystem};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Light loads: u = u0 ln(p00/p), with u0 = 0.5 um and p00 = 400 MPa.
//! let at = |pressure_pa: f64| {
//!     let mean_gap_m = 0.5e-6 * (400e6 / pressure_pa).ln();
//!     Ok::<_, Infallible>(Some(LawPoint { pressure_pa, mean_gap_m, area_fraction: pressure_pa / 2e9 }))
//! };
//! let law = ContactLaw::sample([10e3, 10e6], ContactLaw::TOLERANCE, at)?;
//! assert!(law.points.len() < 40);
//! // A pressure of 1 MPa at its overclosure, within 1 %.
//! let overclosure_m = law.overclosure_m(0.5e-6 * 400f64.ln());
//! assert!((law.pressure_pa(overclosure_m) / 1e6 - 1.0).abs() < 0.01);
//!
//! let heading = Heading { name: "ROUGH".to_owned(), provenance: vec!["lapped steel".to_owned()] };
//! let text = Dialect::Abaqus.table(&law, UnitSystem::Millimetres, &heading, &[])?;
//! assert!(text.contains("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0., 0.\n"));
//! # Ok(())
//! # }
//! ```
//!
//! * [`ContactLaw`]: pressures and gaps as close together as linear interpolation needs, [`LawPoint`] by point.
//! * [`ExponentialLaw`]: the limit of light loads, which CalculiX takes as two numbers.
//! * [`ConductanceTable`]: thermal or electrical conductance against pressure.
//! * [`UnitSystem`]: the units of a finite element model.
//! * [`Dialect`]: the format of a code, and [`Heading`], the comments in front of the numbers.

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
