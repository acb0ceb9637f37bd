//! Contact laws row by row of a table: the laws of one asperity, and populations of asperities at a separation or a pressure.
//! All rows are checked before the first is computed.

pub mod asperity_table;
mod contact_states;
mod flattened;
mod populations;
mod state_counts;
mod strength_columns;

pub use asperity_table::Asperities;
pub use contact_states::{ContactStates, Roughness, STATE_COLUMNS, StateRequest, StatesFound};
pub use flattened::Flattened;
pub use populations::{GivenColumn, Populations};
pub use state_counts::{NarrowSpectra, StateCounts};

use asperity::AsperityError;
use numerics::parallel::Progress;
use study::material::MaterialError;
use tables::{InputTable, Refusal};

/// A computation on the rows of a table.
pub trait RowByRow {
    /// Checks rows: those that pass are computed without an error.
    ///
    /// # Errors
    /// [`Refusal`] of the bad rows, with line, column, value and bound.
    fn check(&self, block: &InputTable) -> Result<(), Refusal>;

    /// Sets the computed columns of checked rows, and returns the notes on single rows. `progress` advances once for
    /// each row that takes long.
    ///
    /// # Errors
    /// [`RowsError`], of rows that have not been checked, or where `progress` is cancelled.
    fn fill_in(
        &mut self,
        block: &mut InputTable,
        progress: &dyn Progress,
    ) -> Result<Vec<RowsNote>, RowsError>;

    /// The notes on all rows so far.
    fn notes(&self) -> Vec<RowsNote>;
}

/// The reason why rows cannot be computed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RowsError {
    /// A column is missing, or cells are bad.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// A value that no law takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
    /// The request of a row of arrays cannot be met.
    #[error("row {row}: {problem}")]
    Row {
        /// The row, counted from 0.
        row: usize,
        /// The problem.
        problem: MaterialError,
    },
    /// The work was cancelled.
    #[error("ended before all rows were computed")]
    Cancelled,
}

/// A note on rows.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum RowsNote {
    /// A pressure beyond complete contact, which no separation carries.
    BeyondCompleteContact {
        /// The row, e.g. `rows.csv, line 2`.
        row: String,
        /// The pressure requested \[Pa\].
        pressure_pa: f64,
        /// The pressure \[Pa\] below which every pressure has a separation.
        highest_pressure_pa: f64,
    },
    /// Rows whose request cannot be met: their results are empty.
    Bad {
        /// The number of such rows.
        rows: usize,
        /// The first of them, counted from 0.
        first: usize,
        /// The number of all rows.
        all: usize,
    },
    /// Rows that hold no asperities: their results are empty.
    WithoutAsperities {
        /// The number of such rows.
        rows: usize,
        /// The number of all rows.
        all: usize,
    },
    /// Rows of a spectrum too narrow for any surface, for a model of its summits: their results are empty.
    NarrowSpectra {
        /// The number of such rows and their alpha.
        narrow: NarrowSpectra,
        /// The number of all rows.
        all: usize,
    },
    /// States at a bound, or outside the range of their law.
    States(StateCounts),
    /// Rows with a hardness and no yield strength, for which a third of the hardness was taken.
    AssumedStrengths {
        /// The number of such rows.
        rows: usize,
        /// The number of all rows.
        all: usize,
    },
    /// Rows whose pressure is not below their hardness: the whole area touches and yields.
    FlowingEverywhere {
        /// The number of such rows.
        rows: usize,
        /// The number of all rows.
        all: usize,
    },
    /// Rows outside the range that a law was fitted in.
    BeyondRange {
        /// The number of such rows.
        rows: usize,
        /// The number of all rows.
        all: usize,
        /// The range.
        range: &'static str,
    },
}
