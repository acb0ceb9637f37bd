//! Quantities with units, as people type and read them, and choices by name: what every other crate may share.
//!
//! ```
//! use units::{Length, Pressure, number};
//!
//! let cutoff: Length = "5.65 nm".parse()?;
//! assert_eq!(cutoff.m, 5.65e-9);
//! let load: Pressure = "1e-3 H".parse()?;
//! assert_eq!(load.pascals(Some(5.4e9)), Some(5.4e6));
//! assert_eq!(number(5.4e6), "5400000");
//! assert_eq!(units::display::length(cutoff.m), "5.65 nm");
//! # Ok::<(), units::QuantityError>(())
//! ```

pub mod display;
mod named;
mod number;
mod pressure_range;
mod quantity;
mod scale;

pub use named::UnknownName;
pub use number::{number, write_number};
pub use pressure_range::{PressureRange, PressureRangeError, log_spaced};
pub use quantity::{Area, Force, Length, Modulus, Pressure, QuantityError, SignedLength};
pub use scale::Scale;
