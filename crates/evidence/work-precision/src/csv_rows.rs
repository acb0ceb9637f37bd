//! Rows of measured numbers as CSV.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// Parses the rows of a file, or those that a script has printed.
///
/// # Errors
/// A message if a column or a number is missing.
pub fn parse<T: DeserializeOwned>(printed: &str) -> Result<Vec<T>, String> {
    let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(printed.as_bytes());
    let rows: Result<Vec<T>, csv::Error> = reader.into_deserialize().collect();
    rows.map_err(|error| error.to_string())
}

/// Writes rows as CSV.
///
/// # Errors
/// A message if a row cannot be written.
pub fn write<T: Serialize>(rows: &[T]) -> Result<String, String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row)).map_err(|error| error.to_string())?;
    let bytes = writer.into_inner().map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}
