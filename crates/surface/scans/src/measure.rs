//! Quantities that a channel may measure.

use std::fmt;

/// The quantity that a channel measures.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Measure {
    /// Heights of the surface.
    Height,
    /// Lengths that are not heights of the surface: a deflection, an amplitude, an error signal.
    Length,
    /// Anything else, such as a phase, in the unit that the file gives.
    Other(String),
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Height => "height",
            Self::Length => "length",
            Self::Other(unit) if unit.is_empty() => "no length",
            Self::Other(unit) => unit,
        })
    }
}
