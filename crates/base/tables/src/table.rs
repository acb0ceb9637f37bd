//! A table as columns of equal length.

use serde_json::value::RawValue;
use units::number;
use units::printable::printable;

/// A table as columns of equal length.
#[derive(Debug, Clone, Default)]
pub struct Table {
    columns: Vec<(String, Cells)>,
}

/// The cells of one column.
#[derive(Debug, Clone)]
pub enum Cells {
    /// Cells of the input, written unchanged.
    Typed(Vec<Cell>),
    /// Computed numbers; `None` is an empty cell.
    Numbers(Vec<Option<f64>>),
    /// Computed words.
    Words(Vec<&'static str>),
}

/// A cell of the input, or a number filled in beside such cells.
#[derive(Debug, Clone)]
pub enum Cell {
    /// A CSV field.
    Field(String),
    /// A JSON value; `null` if a row lacks the key.
    Json(Box<RawValue>),
    /// A computed number in a column of typed cells.
    Computed(f64),
}

impl From<&str> for Cell {
    fn from(field: &str) -> Self {
        Cell::Field(field.to_owned())
    }
}

impl Cell {
    /// The text of the cell; empty for an empty cell, null and numbers that are not finite.
    pub fn text(&self) -> std::borrow::Cow<'_, str> {
        match self {
            Cell::Field(text) => text.as_str().into(),
            Cell::Computed(value) if !value.is_finite() => "".into(),
            Cell::Computed(value) => number(*value).into(),
            Cell::Json(raw) if raw.get() == "null" => "".into(),
            Cell::Json(raw) => serde_json::from_str::<String>(raw.get()).map_or(raw.get().into(), Into::into),
        }
    }
}

impl Cells {
    fn len(&self) -> usize {
        match self {
            Cells::Typed(cells) => cells.len(),
            Cells::Numbers(cells) => cells.len(),
            Cells::Words(cells) => cells.len(),
        }
    }
}

impl Table {
    /// Sets a column: replaces the one of this name in place, or appends it.
    pub fn set(&mut self, name: &str, cells: Cells) {
        debug_assert!(self.columns.is_empty() || cells.len() == self.rows());
        match self.columns.iter_mut().find(|(existing, _)| existing == name) {
            Some((_, existing)) => *existing = cells,
            None => self.columns.push((name.to_owned(), cells)),
        }
    }

    /// Makes a table of columns that all have different names.
    pub(crate) fn of_distinct(columns: Vec<(String, Cells)>) -> Self {
        Table { columns }
    }

    /// Appends a column; a name that is taken gets a number, so that no column replaces another.
    fn append(&mut self, name: &str, cells: Cells) {
        debug_assert!(self.columns.is_empty() || cells.len() == self.rows());
        let is_taken = |name: &str| self.columns.iter().any(|(existing, _)| existing == name);
        let numbered = (2..).map(|number| format!("{name} ({number})"));
        let name = std::iter::once(name.to_owned()).chain(numbered).find(|name| !is_taken(name));
        self.columns.extend(name.map(|name| (name, cells)));
    }

    /// Appends a column of numbers.
    pub fn with_numbers(
        mut self,
        name: &str,
        values: impl IntoIterator<Item = impl Into<Option<f64>>>,
    ) -> Self {
        self.append(name, Cells::Numbers(values.into_iter().map(Into::into).collect()));
        self
    }

    /// Appends a column of fixed words.
    pub fn with_words(mut self, name: &str, words: impl IntoIterator<Item = &'static str>) -> Self {
        self.append(name, Cells::Words(words.into_iter().collect()));
        self
    }

    /// Appends a column of text, which may come from a file: what terminals would obey is replaced.
    pub fn with_text(mut self, name: &str, texts: impl IntoIterator<Item = String>) -> Self {
        self.append(
            name,
            Cells::Typed(texts.into_iter().map(|text| Cell::Field(printable(&text).into_owned())).collect()),
        );
        self
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, cells)| cells.len())
    }

    /// The columns in order.
    pub fn columns(&self) -> impl Iterator<Item = (&str, &Cells)> {
        self.columns.iter().map(|(name, cells)| (name.as_str(), cells))
    }

    /// The cells of a column.
    pub fn column(&self, name: &str) -> Option<&Cells> {
        self.columns().find(|(existing, _)| *existing == name).map(|(_, cells)| cells)
    }

    /// Counts computed numbers that are not finite; their cells are written empty.
    pub fn unrepresentable(&self) -> usize {
        let unrepresentable = |value: &f64| !value.is_finite();
        let count = |cells: &Cells| match cells {
            Cells::Numbers(numbers) => {
                numbers.iter().flatten().filter(|value| unrepresentable(value)).count()
            }
            Cells::Typed(cells) => cells
                .iter()
                .filter(|cell| matches!(cell, Cell::Computed(value) if unrepresentable(value)))
                .count(),
            Cells::Words(_) => 0,
        };
        self.columns().map(|(_, cells)| count(cells)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_computed_column_never_replaces_another() {
        let table = Table::default().with_numbers("a", [1.0]).with_numbers("a", [2.0]).with_words("a", ["w"]);
        let names: Vec<&str> = table.columns().map(|(name, _)| name).collect();
        assert_eq!(names, ["a", "a (2)", "a (3)"]);
    }
}
