//! Errors of the comparison with measured contacts.

use thiserror::Error;

/// Reason why a measured contact cannot be read or predicted.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum NatureError {
    /// A table cannot be read or written.
    #[error("a table: {0}")]
    Table(#[from] csv::Error),
    /// A material that the rules do not know.
    #[error("the rules know no material '{0}'; add it to `Solid`")]
    Material(String),
    /// A gas that the rules do not know.
    #[error("the rules know no gas '{0}'; they know air, n2 and he")]
    Gas(String),
    /// A gas pressure whose unit cannot be told.
    #[error(
        "a gas pressure of {stored} is decoded as {decoded_pa} Pa, which is neither the same nor a thousandth"
    )]
    GasPressure {
        /// Number in the data base.
        stored: f64,
        /// Number after decoding \[Pa\].
        decoded_pa: f64,
    },
    /// A number is out of its bounds.
    #[error(transparent)]
    OutOfBounds(#[from] units::OutOfBounds),
    /// The table of materials lacks a property.
    #[error("the table of materials has no {property} of {material}")]
    Property {
        /// Name of the material.
        material: &'static str,
        /// Name of the property.
        property: &'static str,
    },
    /// A map of apertures cannot be read.
    #[error("reading a map of apertures: {0}")]
    Scan(#[from] scans::ScanReadError),
    /// A file of apertures holds no map.
    #[error("the file of apertures holds no single map")]
    NoMap,
    /// A closure has too few steps of loading.
    #[error("the closure has {0} steps of loading; it needs at least 3")]
    Closure(usize),
    /// A map cannot be pressed.
    #[error(transparent)]
    Elements(#[from] elements::half_space::HalfSpaceError),
    /// The page has no section for a table.
    #[error("{0}")]
    Page(String),
}
