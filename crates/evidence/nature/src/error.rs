//! Errors of the comparison with measured contacts.

use thiserror::Error;

/// Reason why a measured contact cannot be read or predicted.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum NatureError {
    /// A table cannot be read or written.
    #[error("a table: {0}")]
    Table(#[from] csv::Error),
    /// A material, a gas, or a property that the rules do not know.
    #[error("the rules know no {0} '{1}'")]
    Unknown(&'static str, String),
    /// A gas pressure, as stored and as decoded \[Pa\], whose unit cannot be told.
    #[error("a gas pressure stored as {0} cannot be {1} Pa, which is neither the same nor a thousandth")]
    GasPressure(f64, f64),
    /// A number is out of its bounds.
    #[error(transparent)]
    OutOfBounds(#[from] units::OutOfBounds),
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
