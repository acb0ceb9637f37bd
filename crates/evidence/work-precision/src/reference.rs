//! Tables of `tests/reference`, whose values have 20 digits and are read as doubles.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

/// Row of a table, by column; cells that are not numbers are left out.
pub type Columns = HashMap<String, f64>;

/// Reads a table whose columns are numbers.
///
/// # Errors
/// A message with the file if it cannot be read.
pub fn columns(table: &str) -> Result<Vec<Columns>, String> {
    let rows: Vec<HashMap<String, String>> = rows(table)?;
    let numbers = |row: HashMap<String, String>| {
        row.into_iter().filter_map(|(name, cell)| Some((name, cell.parse().ok()?))).collect()
    };
    Ok(rows.into_iter().map(numbers).collect())
}

/// Reads the rows of a table.
///
/// # Errors
/// A message with the file if it cannot be read.
pub fn rows<T: DeserializeOwned>(table: &str) -> Result<Vec<T>, String> {
    let path = repository("tests/reference").join(table);
    let failed = |error: csv::Error| format!("{table}: {error}");
    let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).map_err(failed)?;
    reader.into_deserialize().collect::<Result<_, _>>().map_err(failed)
}

/// Path of a file of this repository, from its top.
pub fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(path)
}
