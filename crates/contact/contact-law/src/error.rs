//! Why there is no law, or no table of it.

use units::OutOfBounds;
use units::display::{length, pressure};

use crate::UnitSystem;

/// Why a law cannot be sampled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SamplingError<E> {
    /// What the law is taken from has failed.
    #[error(transparent)]
    Source(E),
    /// A pressure or a tolerance out of its bounds.
    #[error(transparent)]
    Value(#[from] OutOfBounds),
    /// The range of pressures does not rise.
    #[error("the pressures go from {} to {}; give the smaller one first", pressure(*.from_pa), pressure(*.to_pa))]
    EmptyRange {
        /// The first pressure \[Pa\].
        from_pa: f64,
        /// The last pressure \[Pa\].
        to_pa: f64,
    },
    /// No gap is known at a pressure.
    #[error("there is no mean gap at {}; end the range of pressures before", pressure(*.pressure_pa))]
    NoGap {
        /// The pressure \[Pa\].
        pressure_pa: f64,
    },
    /// More pressure does not close the gap.
    #[error(
        "from {} to {} the mean gap does not close; end the range of pressures before",
        pressure(*.from_pa), pressure(*.to_pa)
    )]
    NotClosing {
        /// The smaller pressure \[Pa\].
        from_pa: f64,
        /// The larger one \[Pa\].
        to_pa: f64,
    },
}

/// Why a law cannot be written in the words of a code.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactLawError {
    /// More rows than the code has room for.
    #[error(
        "the table has {rows} rows, and {code} has room for {most}; take a larger tolerance or a narrower range of pressures"
    )]
    TooManyRows {
        /// The code.
        code: &'static str,
        /// How many rows there are.
        rows: usize,
        /// How many it takes.
        most: usize,
    },
    /// Overclosures nearer to each other than the code tells apart.
    #[error(
        "at {} the overclosures of two rows differ by {}, and {code} moves rows apart that differ by less than \
         {least:e} {unit}; take a smaller unit of length{}",
        pressure(*.pressure_pa), length(*.step_m), mend(.unit)
    )]
    TooClose {
        /// The code.
        code: &'static str,
        /// The pressure of the second row \[Pa\].
        pressure_pa: f64,
        /// What they differ by \[m\].
        step_m: f64,
        /// The least difference, in units of length.
        least: f64,
        /// The unit of length.
        unit: &'static str,
    },
    /// A code that has no words for the law.
    #[error(
        "the exponential form is one of calculix alone, and Abaqus' own is another curve; take the table for {0}"
    )]
    NoExponential(&'static str),
    /// A name that not every code takes.
    #[error("a name begins with a letter and has at most {most} letters, digits, _ and -")]
    Name {
        /// How many letters it may have.
        most: usize,
    },
    /// Columns that only a plain table has.
    #[error("{0} has no room for further columns; take csv")]
    NoColumns(&'static str),
    /// A column of another length than the table.
    #[error("the column {name} has {values} values for {rows} rows")]
    ColumnLength {
        /// Its name.
        name: String,
        /// How many values it has.
        values: usize,
        /// How many rows there are.
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
