//! A list of scans with their options, a row each.

use tables::{InputTable, Refusal, Row};

use crate::request::{RequestError, ScanRequest};

/// The columns of a list and the options of a scan that they hold; the file stands in `file`.
const COLUMNS: [(&str, &str); 10] = [
    ("unit", "unit"),
    ("channel", "channel"),
    ("size", "size"),
    ("tip_radius", "tip-radius"),
    ("shortest", "shortest"),
    ("gaps", "gaps"),
    ("direction", "direction"),
    ("instrument", "instrument"),
    ("z_calibration", "z-calibration"),
    ("slope_uncertainty", "slope-uncertainty"),
];

/// Why a table is no list of scans.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ListError {
    /// A column that says nothing about scans.
    #[error(
        "{list}: column {column} says nothing about a scan; the columns are file, unit, channel, size, tip_radius, shortest, gaps, direction, instrument, z_calibration and slope_uncertainty"
    )]
    UnknownColumn {
        /// The list.
        list: String,
        /// The column.
        column: String,
    },
    /// No rows.
    #[error("{list}: there is no scan in this list")]
    Empty {
        /// The list.
        list: String,
    },
    /// Rows that cannot be read, or no column of files.
    #[error(transparent)]
    Rows(#[from] Refusal),
}

/// The scans of a list, which `name` stands for in messages: columns `file, unit, channel, size, tip_radius, shortest,
/// gaps, direction, instrument, z_calibration, slope_uncertainty`, all but the first one optional; an empty cell says nothing.
///
/// # Errors
/// [`ListError`] with line, column and value where they are to blame.
pub fn requests_of_list(name: &str, list: &InputTable) -> Result<Vec<ScanRequest>, ListError> {
    let is_known = |column: &str| column == "file" || COLUMNS.iter().any(|(known, _)| *known == column);
    if let Some((column, _)) = list.table.columns().find(|(column, _)| !is_known(column)) {
        return Err(ListError::UnknownColumn { list: name.to_owned(), column: column.to_owned() });
    }
    let requests = list.rows(&["file"], request)?;
    if requests.is_empty() { Err(ListError::Empty { list: name.to_owned() }) } else { Ok(requests) }
}

fn request(row: &Row<'_>) -> Result<ScanRequest, String> {
    let path = row.text("file").trim().to_owned();
    if path.is_empty() {
        return Err("column file: the cell is empty; a file is needed".to_owned());
    }
    let mut request = ScanRequest { path, ..ScanRequest::default() };
    for (column, option) in COLUMNS {
        let cell = row.text(column);
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
