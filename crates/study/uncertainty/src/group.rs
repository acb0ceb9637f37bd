//! The groups of inputs that variance is shared out to, and their indices.

use serde::Serialize;
use units::named;

/// Inputs whose draws are made together.
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
}

named!(Group, "group of inputs", {
    Scans => "scans",
    Instruments => "instruments",
    Material => "material",
    Strength => "strength",
});

/// A share of the variance of ln A, with its own error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Index {
    /// The share, about 0 to 1; its own error may carry it beyond either.
    pub value: f64,
    /// One standard error of it.
    pub standard_error: f64,
}

/// The indices of one group for one output, as [`crate::sobol::indices`] estimates them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Indices {
    /// Of the group alone.
    pub first_order: Index,
    /// Of the group and all in which it takes part.
    pub total: Index,
}
