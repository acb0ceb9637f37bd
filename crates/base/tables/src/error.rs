//! Errors of input tables.

use std::io;

use units::OutOfBounds;

/// Largest number of bad cells that one message lists.
const MOST_PROBLEMS_LISTED: usize = 10;

/// Errors of reading a table. `table` is its name in messages, such as its file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// The bytes cannot be read.
    #[error("reading {table}: {error}")]
    Reading {
        /// The table.
        table: String,
        /// The system's error.
        error: io::Error,
    },
    /// The bytes are not UTF-8 text.
    #[error("{table}, line {line}: not UTF-8 text; save the table as UTF-8")]
    NotText {
        /// The table.
        table: String,
        /// The first line that is not text.
        line: usize,
    },
    /// The header row is missing.
    #[error("{table}: no header row; the first line must name the columns")]
    NoHeader {
        /// The table.
        table: String,
    },
    /// Two columns have the same name.
    #[error("{table}: column {column:?} appears twice; keep one")]
    NamedTwice {
        /// The table.
        table: String,
        /// The name.
        column: String,
    },
    /// A column is in the table and is also given for all rows.
    #[error("{table}: column {column} is in the table and is also given for all rows; keep one")]
    GivenTwice {
        /// The table.
        table: String,
        /// The column.
        column: &'static str,
    },
    /// A row has more or fewer fields than there are columns.
    #[error("{table}, line {line}: {fields} fields, but the header has {columns}")]
    UnequalRow {
        /// The table.
        table: String,
        /// The line that the row ends on.
        line: u64,
        /// The fields of the row.
        fields: u64,
        /// The columns that the header names.
        columns: u64,
    },
    /// A row is not valid CSV.
    #[error("{table}, line {line}: {error}")]
    Csv {
        /// The table.
        table: String,
        /// The line that the row ends on.
        line: u64,
        /// The CSV reader's error.
        error: csv::Error,
    },
    /// The text is not a JSON array of row objects.
    #[error("{table}: expected a JSON array of row objects: {error}")]
    Json {
        /// The table.
        table: String,
        /// The JSON reader's error.
        error: serde_json::Error,
    },
    /// A value outside the range of every law.
    #[error(transparent)]
    Value(#[from] OutOfBounds),
    /// A column is missing or cells are invalid.
    #[error(transparent)]
    Refused(#[from] Refusal),
}

/// Problems with columns and cells: the first ten, and the number of further ones.
#[derive(Debug, Default, Clone, PartialEq, Eq, thiserror::Error)]
// Aligns the lines behind the word `error: `.
#[error("{}", self.lines().join("\n       "))]
pub struct Refusal {
    listed: Vec<String>,
    more: usize,
    /// A missing column, which later blocks of rows need not report again.
    of_every_row: bool,
}

impl Refusal {
    /// Refuses every row, as for a missing column.
    pub(crate) fn of_every_row(problem: String) -> Self {
        Refusal { listed: vec![problem], more: 0, of_every_row: true }
    }

    /// Adds the problems of the next block of rows.
    pub fn extend(&mut self, next: Refusal) {
        if self.of_every_row {
            return;
        }
        if next.of_every_row {
            *self = next;
            return;
        }
        self.more += next.more;
        for problem in next.listed {
            self.add(|| problem);
        }
    }

    pub(crate) fn add(&mut self, problem: impl FnOnce() -> String) {
        if self.listed.len() < MOST_PROBLEMS_LISTED {
            self.listed.push(problem());
        } else {
            self.more += 1;
        }
    }

    /// Returns `Ok` if nothing is listed.
    ///
    /// # Errors
    /// The refusal itself if it lists a problem.
    pub fn into_result(self) -> Result<(), Refusal> {
        if self.listed.is_empty() { Ok(()) } else { Err(self) }
    }

    /// Problems with file, line or row, column, value and bound, one per line; a last line counts unlisted ones.
    pub fn lines(&self) -> Vec<String> {
        let more = (self.more > 0).then(|| format!("and {} more", self.more));
        self.listed.iter().cloned().chain(more).collect()
    }
}
