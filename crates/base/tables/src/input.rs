//! Input tables, CSV or JSON, and the numbers in them.

use std::borrow::Cow;

use units::Bound;
use units::printable::listed;

use crate::error::Refusal;
use crate::table::{Cells, Table};

/// An input table with the origin of each row.
pub struct InputTable {
    /// The cells as typed.
    pub table: Table,
    /// Comments of the file without those that this program wrote.
    pub comments: Vec<String>,
    source: String,
    /// `line 12` or `row 3`.
    row_names: Vec<String>,
    /// Columns that are not in the table, with the one value of all rows.
    constants: Constants,
}

/// Columns with one value for all rows, as (name, text).
pub(crate) type Constants = Vec<(&'static str, String)>;

impl InputTable {
    pub(crate) fn new(table: Table, source: String, row_names: Vec<String>, constants: Constants) -> Self {
        InputTable { table, comments: Vec::new(), source, row_names, constants }
    }

    /// Parses the named columns as numbers within their bounds, row by row.
    ///
    /// # Errors
    /// [`Refusal`] for a missing column, or for bad cells with line, column, value and bound.
    pub fn numbers<const N: usize>(&self, columns: [(&str, Bound); N]) -> Result<Vec<[f64; N]>, Refusal> {
        let mut values = vec![[0.0; N]; self.row_names.len()];
        let mut problems = Vec::new();
        for (at, (name, bound)) in columns.into_iter().enumerate() {
            if !self.has(name) {
                // A table without rows and columns is valid.
                if self.row_names.is_empty() && self.table.columns().next().is_none() {
                    continue;
                }
                return Err(self.missing_column(name));
            }
            for (row, values) in values.iter_mut().enumerate() {
                match read_number(&self.text(name, row), bound) {
                    Ok(value) => values[at] = value,
                    Err(problem) => problems.push((row, format!("column {name}: {problem}"))),
                }
            }
        }
        problems.sort_by_key(|(row, _)| *row);
        if problems.is_empty() { Ok(values) } else { Err(self.bad_rows(problems)) }
    }

    /// Applies `read` to every row.
    ///
    /// # Errors
    /// [`Refusal`] if one of the `required` columns is missing, or for the bad rows.
    pub fn rows<T>(
        &self,
        required: &[&str],
        read: impl Fn(&Row<'_>) -> Result<T, String>,
    ) -> Result<Vec<T>, Refusal> {
        if let Some(missing) = required.iter().find(|name| !self.has(name)) {
            return Err(self.missing_column(missing));
        }
        let mut values = Vec::with_capacity(self.row_names.len());
        let mut problems = Vec::new();
        for at in 0..self.row_names.len() {
            match read(&Row { table: self, at }) {
                Ok(value) => values.push(value),
                Err(problem) => problems.push((at, problem)),
            }
        }
        if problems.is_empty() { Ok(values) } else { Err(self.bad_rows(problems)) }
    }

    /// Names a row in messages, such as `spheres.csv, line 12`.
    pub fn row_name(&self, row: usize) -> String {
        format!("{}, {}", self.source, self.row_names[row])
    }

    /// Returns true if the column is in the table or is given for all rows.
    #[must_use]
    pub fn has(&self, column: &str) -> bool {
        self.table.column(column).is_some() || self.constants.iter().any(|(name, _)| *name == column)
    }

    /// Returns true if a cell of the column is filled, or if it is given for all rows.
    #[must_use]
    pub fn is_filled(&self, column: &str) -> bool {
        (0..self.row_names.len()).any(|row| !self.text(column, row).trim().is_empty())
    }

    /// Text of a cell, or the value given for all rows; empty if there is no such column.
    fn text(&self, column: &str, row: usize) -> Cow<'_, str> {
        let constant = || self.constants.iter().find(|(name, _)| *name == column);
        match self.table.column(column) {
            Some(Cells::Typed(cells)) => cells[row].text(),
            _ => constant().map_or("", |(_, text)| text).into(),
        }
    }

    fn missing_column(&self, name: &str) -> Refusal {
        let found: Vec<&str> = self.table.columns().map(|(name, _)| name).collect();
        let columns = listed(found, "");
        let message = format!("{}: column {name} is missing; the columns are {columns}", self.source);
        Refusal::of_every_row(message)
    }

    fn bad_rows(&self, problems: Vec<(usize, String)>) -> Refusal {
        let mut refusal = Refusal::default();
        for (row, problem) in problems {
            refusal.add(|| format!("{}, {problem}", self.row_name(row)));
        }
        refusal
    }
}

/// One row of an input table.
pub struct Row<'t> {
    table: &'t InputTable,
    at: usize,
}

impl Row<'_> {
    /// Text of a cell; empty if there is no such column.
    pub fn text(&self, column: &str) -> Cow<'_, str> {
        self.table.text(column, self.at)
    }

    /// Parses a cell as a number within a bound.
    ///
    /// # Errors
    /// The problem with the name of the column.
    pub fn number(&self, column: &str, bound: Bound) -> Result<f64, String> {
        read_number(&self.text(column), bound).map_err(|problem| format!("column {column}: {problem}"))
    }

    /// Parses a cell as a number within a bound; `None` for an empty cell or a missing column.
    ///
    /// # Errors
    /// The problem with the name of the column.
    pub fn optional_number(&self, column: &str, bound: Bound) -> Result<Option<f64>, String> {
        if self.text(column).trim().is_empty() { Ok(None) } else { self.number(column, bound).map(Some) }
    }
}

fn read_number(text: &str, bound: Bound) -> Result<f64, String> {
    let text = text.trim();
    let Ok(value) = text.parse::<f64>() else {
        return Err(if text.is_empty() {
            "the cell is empty; enter a number".to_owned()
        } else {
            format!("{text:?} is not a number")
        });
    };
    // `check` reports the simplest bound that is violated.
    bound.check("the cell", value).map_err(|error| format!("{text} must be {}", error.bound))
}
