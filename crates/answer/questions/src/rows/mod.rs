//! Contact laws row by row of a table: the laws of one asperity, and populations of asperities at a separation or a pressure.
//! All rows are checked before the first is computed.

pub mod asperity_table;
mod contact_states;
mod flattened;
mod populations;
mod state_counts;
mod strength_columns;

pub use asperity_table::Asperities;
pub use contact_states::{ContactStates, RowRoughness, STATE_COLUMNS, StateRequest, StatesFound};
pub use flattened::Flattened;
pub use populations::{GivenColumn, Populations};
pub use state_counts::{NarrowSpectra, StateCounts};

use asperity::AsperityError;
use numerics::parallel::Progress;
use study::material::MaterialError;
use tables::{InputTable, Refusal};
use units::{Remark, RemarkCode};

/// The input columns of all tables, those of populations first.
pub const INPUT_COLUMNS: [&str; 20] = [
    "model",
    "youngs_modulus_pa",
    "poisson_ratio",
    strength_columns::YIELD_STRENGTH,
    strength_columns::INDENTATION_HARDNESS,
    strength_columns::STRAIN_GRADIENT_LENGTH,
    "radius_m",
    "density_per_m2",
    "sigma_s_m",
    "m0_m2",
    "m2",
    "m4_per_m2",
    "separation_m",
    "pressure_pa",
    "rms_pressure_pa",
    "hardness_pa",
    "hardness_growth",
    "interference_m",
    "wavelength_m",
    "aspect_ratio",
];

/// A computation on the rows of a table.
pub trait RowByRow {
    /// Checks rows: those that pass are computed without an error.
    ///
    /// # Errors
    /// [`Refusal`] of the bad rows, with line, column, value and bound.
    fn check(&mut self, block: &InputTable) -> Result<(), Refusal>;

    /// Sets the computed columns of checked rows, and returns the notes on single rows. `progress` advances once for
    /// each row that takes long.
    ///
    /// # Errors
    /// [`RowsError`], of rows that have not been checked, or where `progress` is cancelled.
    fn fill_in(&mut self, block: &mut InputTable, progress: &dyn Progress) -> Result<Vec<Remark>, RowsError>;

    /// Returns true if tables of this kind may have an input column; those of other kinds pass as labels.
    fn knows(&self, column: &str) -> bool;

    /// Returns true if a row checked so far depends on an input column.
    fn depends_on(&self, column: &str) -> bool;

    /// The input columns of tables of this kind that no row checked so far depends on.
    fn unused(&self) -> Vec<&'static str> {
        INPUT_COLUMNS.into_iter().filter(|column| self.knows(column) && !self.depends_on(column)).collect()
    }

    /// The first option for all rows that none checked so far depends on.
    fn unused_option(&self) -> Option<&'static str> {
        None
    }

    /// The notes on all rows so far.
    fn notes(&self) -> Vec<Remark>;
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

/// Makes the remark on a number of rows out of all, if there are any.
#[must_use]
pub fn rows_of(code: RemarkCode, rows: usize, all: usize) -> Option<Remark> {
    (rows > 0).then(|| Remark::new(code).with("rows", rows).with("all", all))
}
