//! Groups of inputs and their indices of variance.

use serde::Serialize;
use units::named;

/// A group of inputs that are drawn together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Group {
    /// The scatter of scans between places, or the standard errors of a spectrum (type A).
    Scans,
    /// The height scales of instruments (type B).
    Instruments,
    /// The elastic constants of both bodies.
    Material,
    /// The yield strength or the hardness, and the strain-gradient length.
    Strength,
    /// The slope of the spectrum in its holes.
    Holes,
}

named!(Group, "group of inputs", {
    Scans => "scans",
    Instruments => "instruments",
    Material => "material",
    Strength => "strength",
    Holes => "holes",
});

/// A share of the variance of ln A, with its own error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Index {
    /// The share, about 0 to 1; its own error may put it outside.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
}

/// The indices of one group for one output, as [`crate::sobol::indices`] estimates them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Indices {
    /// The index of the group alone.
    pub first_order: Index,
    /// The index of the group with all its interactions.
    pub total: Index,
}
