#![doc = include_str!("../README.md")]

mod bound;
pub mod display;
mod hardness_scale;
mod length_unit;
mod named;
mod number;
mod number_text;
mod pressure_range;
pub mod printable;
mod quantity;
mod quantity_error;
mod quantity_kind;
mod remark;
mod remark_codes;
mod roughness;
mod share;
mod standard_uncertainty;
mod typed_spread;
mod unit_scale;

pub use bound::{Bound, OutOfBounds};
pub use length_unit::{LengthUnit, UnknownLengthUnit};
pub use named::UnknownName;
pub use number::{number, write_number};
pub use number_text::without_comma;
pub use pressure_range::{PressureRange, PressureRangeError, log_spaced};
pub use quantity::{
    Area, Force, ForcePerLength, IndentationHardness, Length, Modulus, Pressure, Resistivity, SignedLength,
    SpecificResistance, Temperature, ThermalConductivity, Viscosity, WorkOfAdhesion,
};
pub use quantity_error::QuantityError;
pub use remark::{Remark, RemarkCode, RemarkLevel, RemarkPlace, RemarkValue, SceneKeys, Spelling};
pub use roughness::Scale;
pub use share::{Share, ShareError};
pub use standard_uncertainty::standard_uncertainty;
pub use typed_spread::TypedSpread;
pub use unit_scale::UnitScale;
