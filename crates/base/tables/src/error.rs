//! What can be wrong with a table that comes in.

use std::fmt;
use std::io;

use units::OutOfBounds;

/// How many bad cells one message lists.
const MOST_PROBLEMS_LISTED: usize = 10;

/// Why a table cannot be read. `table` stands for it, such as the name of its file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// Its bytes cannot be had.
    #[error("reading {table}: {error}")]
    Reading {
        /// The table.
        table: String,
        /// Why.
        error: io::Error,
    },
    /// Its bytes are no text.
    #[error("{table}, line {line}: not UTF-8 text; save the table as UTF-8")]
    NotText {
        /// The table.
        table: String,
        /// The first line that is none.
        line: usize,
    },
    /// Nothing names its columns.
    #[error("{table}: no header row; the first line must name the columns")]
    NoHeader {
        /// The table.
        table: String,
    },
    /// Two columns have one name.
    #[error("{table}: column {column:?} stands twice; keep one")]
    NamedTwice {
        /// The table.
        table: String,
        /// The name.
        column: String,
    },
    /// A column is given for all rows at once, and stands in the table too.
    #[error("{table}: column {column} stands in the table, and is given for all rows besides; keep one")]
    GivenTwice {
        /// The table.
        table: String,
        /// The column.
        column: &'static str,
    },
    /// A row has more or fewer fields than there are columns.
    #[error(
        "{table}, line {line}: {fields} fields; the header has {columns}, and every row must have as many"
    )]
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
    /// A row is no CSV.
    #[error("{table}, line {line}: {error}")]
    Csv {
        /// The table.
        table: String,
        /// The line that the row ends on.
        line: u64,
        /// What is wrong.
        error: csv::Error,
    },
    /// The text is no array of row objects.
    #[error("{table}: reading an array of row objects: {error}")]
    Json {
        /// The table.
        table: String,
        /// What is wrong.
        error: serde_json::Error,
    },
    /// A value that no law takes.
    #[error(transparent)]
    Value(#[from] OutOfBounds),
    /// A column is missing, or cells are bad.
    #[error(transparent)]
    Refused(#[from] Refusal),
}

/// What is wrong with columns and cells: the first problems, and how many more there are.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Refusal {
    listed: Vec<String>,
    more: usize,
    /// A missing column, which need not be told again of the next block of rows.
    of_every_row: bool,
}

impl Refusal {
    /// A refusal of every row, whatever it holds.
    pub(crate) fn of_every_row(problem: String) -> Self {
        Refusal { listed: vec![problem], more: 0, of_every_row: true }
    }

    /// Goes on with what is wrong with the next block of rows.
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

    /// Whether there is anything wrong.
    ///
    /// # Errors
    /// The refusal itself, where it lists something.
    pub fn into_result(self) -> Result<(), Refusal> {
        if self.listed.is_empty() { Ok(()) } else { Err(self) }
    }

    /// What is wrong, with file, line or row, column, value and bound; a last line counts what is not listed.
    pub fn lines(&self) -> Vec<String> {
        let more = (self.more > 0).then(|| format!("and {} more", self.more));
        self.listed.iter().cloned().chain(more).collect()
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Lines stand under each other behind the word that an error is reported with.
        f.write_str(&self.lines().join("\n       "))
    }
}

impl std::error::Error for Refusal {}
