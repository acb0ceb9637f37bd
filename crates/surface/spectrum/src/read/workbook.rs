//! Excel workbooks: every sheet with a table is a series.
//!
//! contact.engineering describes a series above its table, a name and a value per row. The header is the first row that
//! names an abscissa and a spectrum: row 6 until mid 2023, row 10 since. Other sheets (`INDEX`, `INFORMATION`) have no
//! such row and are skipped.

use thiserror::Error;
use units::printable::listed;

/// Largest size of an unpacked workbook in bytes.
#[cfg(feature = "xlsx")]
const LIMIT: u64 = 128 << 20;

/// Errors of reading a workbook.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum WorkbookError {
    /// The ZIP archive is damaged.
    #[error("reading the workbook: {message}; save or export it again, or as CSV")]
    Damaged {
        /// The damage.
        message: String,
    },
    /// The ZIP archive is not a workbook.
    #[error(
        "reading the workbook: the file is a ZIP archive without a workbook; unpack it and give one \
         of its files"
    )]
    NotAWorkbook,
    /// The unpacked workbook is too large.
    #[error(
        "reading the workbook: unpacked, it exceeds {limit_mib} MiB; export the series as CSV, which has no limit"
    )]
    TooLarge {
        /// The bound in MiB.
        limit_mib: u64,
    },
    /// No sheet has a table.
    #[error(
        "reading the workbook: no sheet has a row that names an abscissa (wavelength, wavevector or frequency) and a \
         spectrum (c1d, psd or ciso); the sheets are {}",
        listed(sheets, "")
    )]
    NoTable {
        /// The names of the sheets, quoted.
        sheets: Vec<String>,
    },
    /// This build cannot read workbooks.
    #[error("reading the workbook: this build reads no XLSX (feature `xlsx`); save the sheet as CSV")]
    NotBuiltIn,
}

/// Returns true if a file is a ZIP archive, as workbooks are.
pub(crate) fn is_archive(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

#[cfg(not(feature = "xlsx"))]
pub(crate) fn series(_: &[u8]) -> Result<Vec<crate::read::series::Series>, WorkbookError> {
    Err(WorkbookError::NotBuiltIn)
}

#[cfg(feature = "xlsx")]
pub(crate) use sheets::series;

#[cfg(feature = "xlsx")]
mod sheets {
    use std::collections::BTreeMap;
    use std::io::{Cursor, Read, copy, sink};

    use calamine::{DataRef, Reader, Xlsx, XlsxError};
    use csv::StringRecord;
    use zip::ZipArchive;

    use super::{LIMIT, WorkbookError};
    use crate::read::header::{Heading, Quantity};
    use crate::read::series::{ColumnKind, Columns, Row, Series, SeriesName};

    /// Largest number of columns of a table that is read.
    const WIDEST: usize = 64;

    /// Reads the tables of a workbook, one series for each sheet that has one.
    pub(crate) fn series(bytes: &[u8]) -> Result<Vec<Series>, WorkbookError> {
        refuse_large_archives(bytes)?;
        let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
        let mut series = Vec::new();
        let mut room = LIMIT;
        for sheet in workbook.sheet_names() {
            if let Some(cells) = Cells::read(&mut workbook, &sheet, &mut room)? {
                series.extend(cells.series(sheet));
            }
        }
        if series.is_empty() {
            let sheets = workbook.sheet_names().iter().map(|name| format!("'{name}'")).collect();
            return Err(WorkbookError::NoTable { sheets });
        }
        Ok(series)
    }

    /// Refuses archives that unpack to more than the limit, by unpacking them to nothing: calamine holds whole files in
    /// memory, and the sizes stated in an archive may be false.
    fn refuse_large_archives(bytes: &[u8]) -> Result<(), WorkbookError> {
        let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
        if ["_rels/.rels", "xl/workbook.xml"].iter().all(|name| archive.index_for_name(name).is_none()) {
            return Err(WorkbookError::NotAWorkbook);
        }
        let mut unpacked = 0;
        for i in 0..archive.len() {
            let file = archive.by_index(i).map_err(damaged)?;
            unpacked += copy(&mut file.take(LIMIT + 1 - unpacked), &mut sink()).map_err(damaged)?;
            if unpacked > LIMIT {
                return Err(too_large());
            }
        }
        Ok(())
    }

    fn too_large() -> WorkbookError {
        WorkbookError::TooLarge { limit_mib: LIMIT >> 20 }
    }

    fn damaged(error: impl std::fmt::Display) -> WorkbookError {
        WorkbookError::Damaged { message: error.to_string() }
    }

    /// The filled cells of a sheet by row and column, both from 0. A dense grid could be huge: its size follows from
    /// the last cell, not from the number of cells.
    struct Cells {
        rows: BTreeMap<u32, Vec<(usize, String)>>,
    }

    impl Cells {
        /// Reads the cells of a sheet; `None` if it has none, such as a chart. Cells may share one long text, so `room`
        /// bounds the sum of their lengths.
        fn read(
            workbook: &mut Xlsx<Cursor<&[u8]>>,
            sheet: &str,
            room: &mut u64,
        ) -> Result<Option<Self>, WorkbookError> {
            let mut reader = match workbook.worksheet_cells_reader(sheet) {
                Err(XlsxError::NotAWorksheet(_)) => return Ok(None),
                other => other.map_err(damaged)?,
            };
            let mut rows: BTreeMap<u32, Vec<(usize, String)>> = BTreeMap::new();
            while let Some(cell) = reader.next_cell().map_err(damaged)? {
                let text = text_of(cell.get_value());
                let text = text.trim();
                if text.is_empty() {
                    continue;
                }
                *room = room.checked_sub(text.len() as u64).ok_or_else(too_large)?;
                let (row, column) = cell.get_position();
                rows.entry(row).or_default().push((column as usize, text.to_owned()));
            }
            rows.values_mut().for_each(|cells| cells.sort_by_key(|cell| cell.0));
            Ok(Some(Self { rows }))
        }

        /// Finds the table of the sheet.
        fn series(&self, sheet: String) -> Option<Series> {
            let (&header_row, header) = self.rows.iter().find(|(_, cells)| is_header(cells))?;
            let first = header.first()?.0;
            let width = (header.last()?.0 - first + 1).min(WIDEST);
            let record = |cells: &[(usize, String)]| {
                let mut fields = vec![""; width];
                let inside = |column: usize| column.checked_sub(first).filter(|&place| place < width);
                for (place, text) in cells.iter().filter_map(|(column, text)| Some((inside(*column)?, text)))
                {
                    fields[place] = text;
                }
                StringRecord::from(fields)
            };
            let rows = self.rows.range(header_row + 1..).filter_map(|(&row, cells)| {
                let fields = record(cells);
                let is_blank = fields.iter().all(str::is_empty);
                (!is_blank).then(|| Row { line: row as usize + 1, fields })
            });
            let names = record(header).iter().map(str::to_owned).collect();
            let columns = Columns { names, line: header_row as usize + 1, kind: ColumnKind::Named };
            let mut series = Series::new(SeriesName::default(), columns, rows.collect());
            for (key, value) in self.pairs_above(header_row) {
                match key.to_lowercase().as_str() {
                    "subject" | "subject name" => series.name.subject = Some(value.to_owned()),
                    "subject type" => series.name.subject_type = Some(value.to_owned()),
                    "data series" | "series" => series.name.series = Some(value.to_owned()),
                    _ => {}
                }
                series.comments.push(format!("{key}: {value}"));
            }
            series.may_miss_values = series.name.series.is_some();
            series.sheet = Some(sheet);
            Some(series)
        }

        fn pairs_above(&self, row: u32) -> impl Iterator<Item = (&str, &str)> {
            self.rows.range(..row).filter_map(|(_, cells)| match &cells[..] {
                [(_, key), (_, value), ..] => Some((key.as_str(), value.as_str())),
                _ => None,
            })
        }
    }

    fn is_header(cells: &[(usize, String)]) -> bool {
        let quantities = || cells.iter().filter_map(|(_, text)| Some(Heading::parse(text)?.quantity));
        quantities().any(|quantity| matches!(quantity, Quantity::Abscissa(_)))
            && quantities().any(|quantity| matches!(quantity, Quantity::Density(_)))
    }

    /// Formats a cell as text, numbers with the fewest digits that read back.
    fn text_of(value: &DataRef<'_>) -> String {
        match value {
            DataRef::Empty => String::new(),
            DataRef::Float(value) if *value == 0.0 || (1e-4..1e15).contains(&value.abs()) => {
                value.to_string()
            }
            DataRef::Float(value) => format!("{value:e}"),
            DataRef::Int(value) => value.to_string(),
            DataRef::Bool(value) => value.to_string(),
            DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => text.clone(),
            DataRef::SharedString(text) => (*text).to_owned(),
            DataRef::DateTime(date) => date.as_f64().to_string(),
            DataRef::Error(error) => error.to_string(),
        }
    }
}
