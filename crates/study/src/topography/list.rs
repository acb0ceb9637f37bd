//! A list of scans with their options, a row each.

use tables::{InputTable, Refusal, Row};

use super::request::{RequestError, ScanRequest};

/// The columns of a list and the options of a scan that they hold; the file stands in `file`.
const COLUMNS: [(&str, &str); 5] = [
    ("unit", "unit"),
    ("channel", "channel"),
    ("size", "size"),
    ("tip_radius", "tip-radius"),
    ("shortest", "shortest"),
];

/// Why a table is no list of scans.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ListError {
    /// A column that says nothing about scans.
    #[error(
        "{list}: column {column} says nothing about a scan; the columns are file, unit, channel, size, tip_radius and shortest"
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

/// The scans of a list, which `name` stands for in messages: columns `file, unit, channel, size, tip_radius, shortest`, all
/// but the first one optional; an empty cell says nothing.
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

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use tables::TableSource;

    use super::*;

    fn read(text: &'static str) -> Result<Vec<ScanRequest>, String> {
        let list = TableSource::new("scans.csv", Cursor::new(text)).unwrap().whole().unwrap();
        requests_of_list("scans.csv", &list).map_err(|error| error.to_string())
    }

    #[test]
    fn a_row_says_what_options_after_a_file_say() {
        let requests = read("file,unit,tip_radius,shortest\na.txt,nm,20 nm,\nb.001,,,46nm\n").unwrap();
        let typed = ["a.txt:unit=nm,tip-radius=20 nm", "b.001:shortest=46nm"];
        assert_eq!(requests, typed.map(|text| text.parse::<ScanRequest>().unwrap()));
    }

    #[test]
    fn bad_lists_are_refused_with_their_place() {
        assert_eq!(
            read("file,width\na.txt,3nm\n").unwrap_err(),
            "scans.csv: column width says nothing about a scan; the columns are file, unit, channel, size, tip_radius and \
             shortest"
        );
        let bad = read("file,size\na.txt,3\n").unwrap_err();
        assert!(bad.starts_with("scans.csv, line 2, column size: '3' has no unit"), "{bad}");
        assert_eq!(read("file\n").unwrap_err(), "scans.csv: there is no scan in this list");
    }
}
