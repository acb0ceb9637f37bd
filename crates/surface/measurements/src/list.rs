//! Lists of scans with their options, one row each.

use tables::{InputTable, Refusal, Row};

use crate::request::{RequestError, ScanRequest};

/// Columns of a list, each with the scan option in it; the column `file` holds the file.
fn columns() -> impl Iterator<Item = (String, &'static str)> {
    ScanRequest::OPTIONS.into_iter().map(|(option, _)| (option.replace('-', "_"), option))
}

/// Errors of reading a list of scans.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ListError {
    /// A column that is not an option of a scan.
    #[error(
        "{list}: column {column} is not an option of a scan; use file, unit, height_unit, channel, size, tip_radius, shortest, gaps, \
         direction, detrend, instrument, z_calibration or slope_uncertainty"
    )]
    UnknownColumn {
        /// The list.
        list: String,
        /// The column.
        column: String,
    },
    /// The list has no rows.
    #[error("{list}: the list has no rows; give a row for each scan")]
    Empty {
        /// The list.
        list: String,
    },
    /// Rows cannot be read, or the column `file` is missing.
    #[error(transparent)]
    Rows(#[from] Refusal),
}

/// Parses a list of scans; `name` is its name in messages.
///
/// The columns are `file, unit, height_unit, channel, size, tip_radius, shortest, gaps, direction, detrend, instrument,
/// z_calibration, slope_uncertainty`. All but the first are optional; an empty cell leaves the option open.
///
/// # Errors
/// [`ListError`] with line, column and value where they apply.
pub fn requests_of_list(name: &str, list: &InputTable) -> Result<Vec<ScanRequest>, ListError> {
    let is_known = |column: &str| column == "file" || columns().any(|(known, _)| known == column);
    if let Some((column, _)) = list.table.columns().find(|(column, _)| !is_known(column)) {
        return Err(ListError::UnknownColumn { list: name.to_owned(), column: column.to_owned() });
    }
    let requests = list.rows(&["file"], request)?;
    if requests.is_empty() { Err(ListError::Empty { list: name.to_owned() }) } else { Ok(requests) }
}

fn request(row: &Row<'_>) -> Result<ScanRequest, String> {
    let path = row.text("file").trim().to_owned();
    if path.is_empty() {
        return Err("column file: the cell is empty; enter a file".to_owned());
    }
    let mut request = ScanRequest { path, ..ScanRequest::default() };
    for (column, option) in columns() {
        let cell = row.text(&column);
        let value = cell.trim();
        if !value.is_empty() {
            request.set(option, value).map_err(|error| match error {
                RequestError::BadValue { problem, .. } => format!("column {column}: {problem}"),
                other => other.to_string(),
            })?;
        }
    }
    Ok(request)
}
