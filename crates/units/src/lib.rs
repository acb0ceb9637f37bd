#![doc = include_str!("../README.md")]

pub mod display;
mod named;
mod number;
mod pressure_range;
mod quantity;
mod roughness;

pub use named::UnknownName;
pub use number::{number, write_number};
pub use pressure_range::{PressureRange, PressureRangeError, log_spaced};
pub use quantity::{Area, Force, Length, Modulus, Pressure, QuantityError, SignedLength};
pub use roughness::Scale;
