//! Tables that come in, CSV or JSON, and the numbers in them.

use std::borrow::Cow;

use units::Bound;

use crate::error::Refusal;
use crate::table::{Cells, Table};

/// A table, and where each of its rows came from.
pub struct InputTable {
    /// The cells as typed.
    pub table: Table,
    /// The comments of the file, without the program's own.
    pub comments: Vec<String>,
    source: String,
    /// `line 12` or `row 3`.
    row_names: Vec<String>,
    /// Columns that are not in the table, and what every row has there.
    constants: Constants,
}

/// Columns of one value, the text of their cells behind each name.
pub(crate) type Constants = Vec<(&'static str, String)>;

impl InputTable {
    pub(crate) fn new(table: Table, source: String, row_names: Vec<String>, constants: Constants) -> Self {
        InputTable { table, comments: Vec::new(), source, row_names, constants }
    }

    /// The named columns as numbers within their bounds, row by row.
    ///
    /// # Errors
    /// [`Refusal`] for a missing column, or of the bad cells with line, column, value and bound.
    pub fn numbers<const N: usize>(&self, columns: [(&str, Bound); N]) -> Result<Vec<[f64; N]>, Refusal> {
        let mut values = vec![[0.0; N]; self.row_names.len()];
        let mut problems = Vec::new();
        for (at, (name, bound)) in columns.into_iter().enumerate() {
            if !self.has(name) {
                // No rows at all are no mistake.
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

    /// What `read` makes of every row.
    ///
    /// # Errors
    /// [`Refusal`] where one of the `required` columns is missing, or of the bad rows.
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

    /// The name of a row in messages.
    pub fn row_name(&self, row: usize) -> String {
        format!("{}, {}", self.source, self.row_names[row])
    }

    /// Whether the table has the column, or all of its rows the one value of it.
    #[must_use]
    pub fn has(&self, column: &str) -> bool {
        self.table.column(column).is_some() || self.constants.iter().any(|(name, _)| *name == column)
    }

    /// The cell as a person would read it, or what every row has; empty where there is no such column.
    fn text(&self, column: &str, row: usize) -> Cow<'_, str> {
        let constant = || self.constants.iter().find(|(name, _)| *name == column);
        match self.table.column(column) {
            Some(Cells::Typed(cells)) => cells[row].text(),
            _ => constant().map_or("", |(_, text)| text).into(),
        }
    }

    fn missing_column(&self, name: &str) -> Refusal {
        let found: Vec<&str> = self.table.columns().map(|(name, _)| name).collect();
        let columns = found.join(", ");
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

/// One row of a table that came in.
pub struct Row<'t> {
    table: &'t InputTable,
    at: usize,
}

impl Row<'_> {
    /// The cell as a person would read it; empty where there is no such column.
    pub fn text(&self, column: &str) -> Cow<'_, str> {
        self.table.text(column, self.at)
    }

    /// The cell as a number within its bound, or what is wrong with it.
    ///
    /// # Errors
    /// The problem, with the column.
    pub fn number(&self, column: &str, bound: Bound) -> Result<f64, String> {
        read_number(&self.text(column), bound).map_err(|problem| format!("column {column}: {problem}"))
    }

    /// The same, where an empty cell or an absent column is no number.
    ///
    /// # Errors
    /// The problem, with the column.
    pub fn optional_number(&self, column: &str, bound: Bound) -> Result<Option<f64>, String> {
        let text = self.text(column);
        if text.trim().is_empty() {
            return Ok(None);
        }
        let number = read_number(&text, bound).map_err(|problem| format!("column {column}: {problem}"))?;
        Ok(Some(number))
    }
}

fn read_number(text: &str, bound: Bound) -> Result<f64, String> {
    let text = text.trim();
    let Ok(value) = text.parse::<f64>() else {
        return Err(if text.is_empty() {
            "the cell is empty; a number is needed".to_owned()
        } else {
            format!("{text:?} is not a number")
        });
    };
    // Of what is wrong with the value the plainest bound is told.
    bound.check("the cell", value).map_err(|error| format!("{text} must be {}", error.bound))
}
