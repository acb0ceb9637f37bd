//! An input table read in blocks of rows, as often as needed: first to check all of it, then to compute.

use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};

use crate::error::TableError;
use crate::input::{Constants, InputTable};
use crate::table::{Cell, Cells, Table};
use crate::{OWN_COMMENT, csv_text, json_text};

trait Rereadable: Read + Seek {}

impl<T: Read + Seek> Rereadable for T {}

/// A table to read, CSV or JSON.
pub struct TableSource {
    name: String,
    bytes: Box<dyn Rereadable>,
    /// Offset of the text, after a byte-order mark.
    start: u64,
    is_json: bool,
    columns: Vec<String>,
    constants: Constants,
    /// Comments of the file without those that this program wrote.
    pub comments: Vec<String>,
}

impl TableSource {
    /// Opens the table in `bytes` and reads its columns; `name` stands for it in messages.
    ///
    /// A text that begins with `[` is JSON, any other CSV.
    ///
    /// # Errors
    /// [`TableError`] with the line if there is one.
    pub fn new(name: &str, bytes: impl Read + Seek + 'static) -> Result<Self, TableError> {
        let mut source = TableSource {
            name: name.to_owned(),
            bytes: Box::new(bytes),
            start: 0,
            is_json: false,
            columns: Vec::new(),
            constants: Constants::new(),
            comments: Vec::new(),
        };
        source.start = source.checked_start()?;
        source.is_json = source.begins_like_an_array()?;
        source.with_columns()
    }

    /// Sets the value of all rows for a column that the table lacks. It is read but not written.
    ///
    /// # Errors
    /// [`TableError::GivenTwice`] if the table has that column.
    pub fn set_constant(&mut self, column: &'static str, text: String) -> Result<(), TableError> {
        if self.columns.iter().any(|other| other == column) {
            return Err(TableError::GivenTwice { table: self.name.clone(), column });
        }
        self.constants.push((column, text));
        Ok(())
    }

    /// Reads all rows at once.
    ///
    /// # Errors
    /// [`TableError`] with the line if there is one.
    pub fn whole(mut self) -> Result<InputTable, TableError> {
        let mut whole =
            InputTable::new(Table::default(), self.name.clone(), Vec::new(), self.constants.clone());
        self.blocks(usize::MAX, |block| {
            whole = block;
            Ok::<(), TableError>(())
        })?;
        whole.comments = self.comments;
        Ok(whole)
    }

    fn with_columns(self) -> Result<Self, TableError> {
        let mut source = self;
        if source.is_json {
            let mut columns = indexmap::IndexSet::new();
            let name = source.name.clone();
            json_text::each_row(source.reader()?, &name, &mut |row| {
                columns.extend(row.into_keys());
                Ok::<(), TableError>(())
            })?;
            source.columns = columns.into_iter().collect();
        } else {
            source.comments = source.foreign_comments()?;
            let name = source.name.clone();
            let columns = csv_text::Rows::begin(source.reader()?, &name)?.names;
            source.columns = columns;
        }
        Ok(source)
    }

    /// Reads all rows from the first, in blocks of at most `most_rows`. A table without rows is one empty block.
    ///
    /// # Errors
    /// Errors of `each`, and [`TableError`] with file and line.
    pub fn blocks<E: From<TableError>>(
        &mut self,
        most_rows: usize,
        mut each: impl FnMut(InputTable) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut block = Block {
            columns: self.columns.clone(),
            source: self.name.clone(),
            constants: self.constants.clone(),
            ..Block::default()
        };
        let mut any = false;
        let mut push = |row_name: String, cells: Vec<Cell>, block: &mut Block| -> Result<(), E> {
            block.push(row_name, cells);
            if block.row_names.len() == most_rows {
                any = true;
                each(block.taken())?;
            }
            Ok(())
        };
        if self.is_json {
            let null = serde_json::value::RawValue::NULL.to_owned();
            let (columns, name) = (self.columns.clone(), self.name.clone());
            let mut rows = 0;
            json_text::each_row(self.reader()?, &name, &mut |mut row| {
                rows += 1;
                let cell =
                    |column: &String| Cell::Json(row.swap_remove(column).unwrap_or_else(|| null.clone()));
                push(format!("row {rows}"), columns.iter().map(cell).collect(), &mut block)
            })?;
        } else {
            let name = self.name.clone();
            let mut rows = csv_text::Rows::begin(self.reader()?, &name)?;
            while let Some((line, record)) = rows.next()? {
                push(format!("line {line}"), record.iter().map(Cell::from).collect(), &mut block)?;
            }
        }
        if !any || !block.row_names.is_empty() {
            each(block.taken())?;
        }
        Ok(())
    }

    fn reader(&mut self) -> Result<impl BufRead, TableError> {
        self.bytes
            .seek(SeekFrom::Start(self.start))
            .map_err(|error| TableError::Reading { table: self.name.clone(), error })?;
        Ok(BufReader::new(&mut self.bytes))
    }

    /// Checks that all of it is UTF-8 and returns the offset of the text.
    fn checked_start(&mut self) -> Result<u64, TableError> {
        let name = self.name.clone();
        let (mut line, mut held, mut first) = (1, Vec::new(), true);
        let mut start = 0;
        let mut reader = self.reader()?;
        loop {
            let read =
                reader.fill_buf().map_err(|error| TableError::Reading { table: name.clone(), error })?;
            let (taken, ended) = (read.len(), read.is_empty());
            held.extend_from_slice(read);
            reader.consume(taken);
            if first && held.starts_with("\u{feff}".as_bytes()) {
                start = 3;
            }
            first = false;
            let valid = match std::str::from_utf8(&held) {
                Ok(text) => text.len(),
                // A character may continue in the next block.
                Err(error) if error.error_len().is_none() && !ended => error.valid_up_to(),
                Err(error) => {
                    let before = &held[..error.valid_up_to()];
                    line += before.iter().filter(|&&byte| byte == b'\n').count();
                    return Err(TableError::NotText { table: name, line });
                }
            };
            line += held[..valid].iter().filter(|&&byte| byte == b'\n').count();
            held.drain(..valid);
            if ended {
                return Ok(start);
            }
        }
    }

    fn begins_like_an_array(&mut self) -> Result<bool, TableError> {
        let name = self.name.clone();
        for byte in self.reader()?.bytes() {
            let byte = byte.map_err(|error| TableError::Reading { table: name.clone(), error })?;
            if !byte.is_ascii_whitespace() {
                return Ok(byte == b'[');
            }
        }
        Ok(false)
    }

    /// Collects comments anywhere in the file, without this program's own.
    fn foreign_comments(&mut self) -> Result<Vec<String>, TableError> {
        let name = self.name.clone();
        let mut comments = Vec::new();
        for line in self.reader()?.lines() {
            let line = line.map_err(|error| TableError::Reading { table: name.clone(), error })?;
            let comment = line.strip_prefix('#').map(str::trim);
            comments.extend(comment.filter(|comment| !comment.starts_with(OWN_COMMENT)).map(str::to_owned));
        }
        Ok(comments)
    }
}

/// Rows being collected into columns.
#[derive(Default)]
struct Block {
    columns: Vec<String>,
    source: String,
    constants: Constants,
    row_names: Vec<String>,
    cells: Vec<Vec<Cell>>,
}

impl Block {
    fn push(&mut self, row_name: String, row: Vec<Cell>) {
        self.row_names.push(row_name);
        self.cells.resize_with(self.columns.len(), Vec::new);
        for (column, cell) in self.cells.iter_mut().zip(row) {
            column.push(cell);
        }
    }

    fn taken(&mut self) -> InputTable {
        self.cells.resize_with(self.columns.len(), Vec::new);
        let cells = self.cells.drain(..).map(Cells::Typed);
        let table = Table::of_distinct(self.columns.iter().cloned().zip(cells).collect());
        InputTable::new(
            table,
            self.source.clone(),
            std::mem::take(&mut self.row_names),
            self.constants.clone(),
        )
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::*;

    fn opened(bytes: &[u8]) -> Result<TableSource, TableError> {
        TableSource::new("t", io::Cursor::new(bytes.to_vec()))
    }

    fn rows_in_blocks(source: &mut TableSource, most_rows: usize) -> Vec<Vec<(String, String)>> {
        let mut blocks = Vec::new();
        let each = |block: InputTable| {
            let cells = block.rows(&[], |row| Ok(row.text("b").into_owned())).unwrap();
            blocks.push(cells.into_iter().enumerate().map(|(row, b)| (block.row_name(row), b)).collect());
            Ok::<(), TableError>(())
        };
        source.blocks(most_rows, each).unwrap();
        blocks
    }

    #[test]
    fn blocks_of_any_size_hold_the_same_rows_and_may_be_read_again() {
        let csv = "\u{feff}# c\na,b\r\n1,x\r\n\n# d\n2,\"y\n# e\"\n3,z";
        let json = r#" [{"a":1,"b":"x"},{"a":2,"b":"y\n# e"},{"a":3,"b":"z"}]"#;
        for (text, names) in
            [(csv, ["t, line 3", "t, line 7", "t, line 8"]), (json, ["t, row 1", "t, row 2", "t, row 3"])]
        {
            let mut source = opened(text.as_bytes()).unwrap();
            let expected: Vec<(String, String)> = names
                .iter()
                .zip(["x", "y\n# e", "z"])
                .map(|(name, b)| ((*name).to_owned(), b.to_owned()))
                .collect();
            for most_rows in [1, 2, 3, usize::MAX] {
                let blocks = rows_in_blocks(&mut source, most_rows);
                assert!(blocks.iter().all(|block| (1..=most_rows).contains(&block.len())), "{blocks:?}");
                assert_eq!(blocks.concat(), expected);
            }
        }
    }

    #[test]
    fn a_table_without_rows_is_one_block_with_its_columns() {
        let mut source = opened(b"a,b\n").unwrap();
        assert_eq!(rows_in_blocks(&mut source, 2), [[]]);
        let mut source = opened(b"[]").unwrap();
        assert_eq!(rows_in_blocks(&mut source, 2), [[]]);
    }

    #[test]
    fn a_written_table_is_read_again_whatever_its_first_column_is_called() {
        for name in ["[m]", " [", "# a", "\"", "=1", "a"] {
            let mut written = Vec::new();
            let table = Table::default().with_text(name, ["1".to_owned()]);
            table.write(crate::Format::Csv, &[], &mut written).unwrap();
            let again = opened(&written).and_then(TableSource::whole).unwrap().table;
            assert_eq!((again.rows(), again.columns().count()), (1, 1), "{name}");
        }
    }

    #[test]
    fn invalid_text_is_located_across_the_ends_of_buffers() {
        // Two bytes to a character, and an odd one first: characters lie across the ends of any buffer.
        let long = format!("a\n{}\n", "é".repeat(40_000));
        for text in [long.clone(), format!("x{long}")] {
            assert!(opened(text.as_bytes()).is_ok());
            let cut = &text.as_bytes()[..text.len() - 2];
            let error = opened(cut).err().unwrap();
            assert_eq!(error.to_string(), "t, line 2: not UTF-8 text; save the table as UTF-8");
        }
    }
}
