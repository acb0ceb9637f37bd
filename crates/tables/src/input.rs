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
}

impl InputTable {
    pub(crate) fn new(table: Table, source: String, row_names: Vec<String>) -> Self {
        InputTable { table, comments: Vec::new(), source, row_names }
    }

    /// The named columns as numbers within their bounds, row by row.
    ///
    /// # Errors
    /// [`Refusal`] for a missing column, or of the bad cells with line, column, value and bound.
    pub fn numbers<const N: usize>(&self, columns: [(&str, Bound); N]) -> Result<Vec<[f64; N]>, Refusal> {
        let mut values = vec![[0.0; N]; self.row_names.len()];
        let mut problems = Vec::new();
        for (at, (name, bound)) in columns.into_iter().enumerate() {
            let Some(Cells::Typed(cells)) = self.table.column(name) else {
                // No rows at all are no mistake.
                if self.row_names.is_empty() && self.table.columns().next().is_none() {
                    continue;
                }
                return Err(self.missing_column(name));
            };
            for (row, cell) in cells.iter().enumerate() {
                match read_number(&cell.text(), bound) {
                    Ok(value) => values[row][at] = value,
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
        if let Some(missing) = required.iter().find(|name| self.table.column(name).is_none()) {
            return Err(self.missing_column(missing));
        }
        let mut values = Vec::with_capacity(self.row_names.len());
        let mut problems = Vec::new();
        for at in 0..self.row_names.len() {
            match read(&Row { table: &self.table, at }) {
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
    table: &'t Table,
    at: usize,
}

impl Row<'_> {
    /// The cell as a person would read it; empty where there is no such column.
    pub fn text(&self, column: &str) -> Cow<'_, str> {
        match self.table.column(column) {
            Some(Cells::Typed(cells)) => cells[self.at].text(),
            _ => Cow::Borrowed(""),
        }
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
    if bound.admits(value) { Ok(value) } else { Err(format!("{text} must be {bound}")) }
}
