//! Errors of sampling and writing laws.

use units::OutOfBounds;
use units::display::{length, pressure};

use crate::finite_elements::UnitSystem;

/// Reason why a law cannot be sampled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SamplingError<E> {
    /// The source of the law has failed.
    #[error(transparent)]
    Source(E),
    /// A pressure or a tolerance is out of its bounds.
    #[error(transparent)]
    Value(#[from] OutOfBounds),
    /// The range of pressures does not rise.
    #[error("the pressures go from {} to {}; give the smaller one first", pressure(*.from_pa), pressure(*.to_pa))]
    EmptyRange {
        /// First pressure \[Pa\].
        from_pa: f64,
        /// Last pressure \[Pa\].
        to_pa: f64,
    },
    /// The gap at a pressure is unknown.
    #[error("there is no mean gap at {}, where contact is complete, or flows at a hardness that grows (strain_gradient, hardness_law); end \
         the range of pressures before", pressure(*.pressure_pa))]
    NoGap {
        /// Pressure \[Pa\].
        pressure_pa: f64,
    },
    /// The gap does not close as the pressure rises.
    #[error(
        "from {} to {} the mean gap does not close; end the range of pressures before",
        pressure(*.from_pa), pressure(*.to_pa)
    )]
    NotClosing {
        /// Smaller pressure \[Pa\].
        from_pa: f64,
        /// Larger pressure \[Pa\].
        to_pa: f64,
    },
}

/// Reason why a law cannot be written for a code.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactLawError {
    /// The table has more rows than the code takes.
    #[error(
        "the table has {rows} rows, and {code} has room for {most}; take a larger tolerance or a narrower range of pressures"
    )]
    TooManyRows {
        /// Name of the code.
        code: &'static str,
        /// Number of rows.
        rows: usize,
        /// Largest number of rows.
        most: usize,
    },
    /// Two overclosures are too close for the code to distinguish.
    #[error(
        "at {} the overclosures of two rows differ by {}, and {code} moves rows apart that differ by less than \
         {least:e} {unit}; take a smaller unit of length{}",
        pressure(*.pressure_pa), length(*.step_m), mend(.unit)
    )]
    TooClose {
        /// Name of the code.
        code: &'static str,
        /// Pressure of the second row \[Pa\].
        pressure_pa: f64,
        /// Difference of the overclosures \[m\].
        step_m: f64,
        /// Smallest difference, in units of length.
        least: f64,
        /// Unit of length.
        unit: &'static str,
    },
    /// The code has no form for the law.
    #[error(
        "the exponential form is one of calculix alone, and Abaqus' own is another curve; take the table for {0}"
    )]
    NoExponential(&'static str),
    /// The name is not valid in every code.
    #[error("a name begins with a letter and has at most {most} letters, digits, _ and -")]
    Name {
        /// Largest number of letters.
        most: usize,
    },
    /// Additional columns were given for a format other than a plain table.
    #[error("{0} has no room for further columns; take csv")]
    NoColumns(&'static str),
    /// A column has another length than the table.
    #[error("the column {name} has {values} values for {rows} rows")]
    ColumnLength {
        /// Name of the column.
        name: String,
        /// Number of values.
        values: usize,
        /// Number of rows.
        rows: usize,
    },
}

fn mend(unit: &str) -> String {
    if unit == UnitSystem::Micrometres.length_symbol() {
        String::new()
    } else {
        format!(", as {} has", UnitSystem::Micrometres)
    }
}
