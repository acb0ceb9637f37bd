//! Tables that come in, CSV or JSON, and the numbers in them.

use asperity::Bound;

use super::{Cell, Cells, Table, csv_text, json_text};
use crate::failure::Failure;
use crate::output::{Place, utf8};

/// How many bad cells one message lists.
const MOST_PROBLEMS_LISTED: usize = 10;
/// What begins the comment lines that this program writes itself.
pub const OWN_COMMENT: &str = "truearea ";

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
    /// Reads a table from a place, as JSON where it begins like an array and else as CSV.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file, and the line and column where it has them.
    pub fn read(place: &Place) -> Result<Self, Failure> {
        let source = match place {
            Place::Standard => "standard input".to_owned(),
            Place::File(path) => path.display().to_string(),
        };
        let bytes = place.read()?;
        let text = utf8(&bytes, &source, "table")?;
        if text.trim_start().starts_with('[') {
            Self::from_json(text, source)
        } else {
            Self::from_csv(text, source)
        }
    }

    fn from_csv(text: &str, source: String) -> Result<Self, Failure> {
        let fields = csv_text::read(text, &source)?;
        if fields.names.iter().all(String::is_empty) {
            return Err(Failure::input(format!(
                "{source}: no header row; the first line must name the columns"
            )));
        }
        if let Some(twice) =
            fields.names.iter().enumerate().find(|(i, name)| fields.names[..*i].contains(name))
        {
            return Err(Failure::input(format!("{source}: column {:?} stands twice; keep one", twice.1)));
        }
        let mut table = Table::default();
        for (at, name) in fields.names.iter().enumerate() {
            table.set(name, Cells::Typed(fields.rows.iter().map(|(_, row)| Cell::from(&row[at])).collect()));
        }
        let comments = text
            .lines()
            .filter_map(|line| line.strip_prefix('#').map(str::trim))
            .filter(|comment| !comment.starts_with(OWN_COMMENT))
            .map(str::to_owned)
            .collect();
        let row_names = fields.rows.iter().map(|(line, _)| format!("line {line}")).collect();
        Ok(InputTable { table, comments, source, row_names })
    }

    /// Reads an array of row objects; `source` stands for it in messages.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the source.
    pub fn from_json(text: &str, source: String) -> Result<Self, Failure> {
        let (names, rows) = json_text::read(text, &source)?;
        let null = serde_json::value::to_raw_value(&()).map_err(Failure::input)?;
        let mut table = Table::default();
        for name in &names {
            let cell =
                |row: &indexmap::IndexMap<String, _>| Cell::Json(row.get(name).unwrap_or(&null).clone());
            table.set(name, Cells::Typed(rows.iter().map(cell).collect()));
        }
        let row_names = (1..=rows.len()).map(|row| format!("row {row}")).collect();
        Ok(InputTable { table, comments: Vec::new(), source, row_names })
    }

    /// The named columns as numbers within their bounds, row by row.
    ///
    /// # Errors
    /// [`Failure::Input`] for a missing column, or listing the first bad cells with line, column, value and bound.
    pub fn numbers<const N: usize>(&self, columns: [(&str, Bound); N]) -> Result<Vec<[f64; N]>, Failure> {
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
                    Err(problem) => {
                        problems.push((row, format!("{}, column {name}: {problem}", self.row_names[row])))
                    }
                }
            }
        }
        problems.sort_by_key(|(row, _)| *row);
        if problems.is_empty() { Ok(values) } else { Err(self.bad_cells(problems)) }
    }

    /// What `read` makes of every row.
    ///
    /// # Errors
    /// [`Failure::Input`] where one of the `required` columns is missing, or listing the first bad rows.
    pub fn rows<T>(
        &self,
        required: &[&str],
        read: impl Fn(&Row<'_>) -> Result<T, String>,
    ) -> Result<Vec<T>, Failure> {
        if let Some(missing) = required.iter().find(|name| self.table.column(name).is_none()) {
            return Err(self.missing_column(missing));
        }
        let mut values = Vec::with_capacity(self.row_names.len());
        let mut problems = Vec::new();
        for (at, name) in self.row_names.iter().enumerate() {
            match read(&Row { table: &self.table, at }) {
                Ok(value) => values.push(value),
                Err(problem) => problems.push((at, format!("{name}, {problem}"))),
            }
        }
        if problems.is_empty() { Ok(values) } else { Err(self.bad_cells(problems)) }
    }

    /// The name of a row in messages.
    pub fn row_name(&self, row: usize) -> String {
        format!("{}, {}", self.source, self.row_names[row])
    }

    fn missing_column(&self, name: &str) -> Failure {
        let found: Vec<&str> = self.table.columns().map(|(name, _)| name).collect();
        Failure::input(format!(
            "{}: column {name} is missing; the columns are {}",
            self.source,
            found.join(", ")
        ))
    }

    fn bad_cells(&self, problems: Vec<(usize, String)>) -> Failure {
        let more = problems.len().saturating_sub(MOST_PROBLEMS_LISTED);
        let mut lines: Vec<String> = problems
            .into_iter()
            .take(MOST_PROBLEMS_LISTED)
            .map(|(_, problem)| format!("{}, {problem}", self.source))
            .collect();
        if more > 0 {
            lines.push(format!("and {more} more"));
        }
        Failure::input(lines.join("\n       "))
    }
}

/// One row of a table that came in.
pub struct Row<'t> {
    table: &'t Table,
    at: usize,
}

impl Row<'_> {
    /// The cell as a person would read it; empty where there is no such column.
    pub fn text(&self, column: &str) -> String {
        match self.table.column(column) {
            Some(Cells::Typed(cells)) => cells[self.at].text().into_owned(),
            _ => String::new(),
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
        if self.text(column).trim().is_empty() { Ok(None) } else { self.number(column, bound).map(Some) }
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
