//! A table that comes in, read in blocks of rows as often as needed: first to check all of it, then to compute.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};

use tempfile::SpooledTempFile;

use super::input::{InputTable, OWN_COMMENT};
use super::{Cell, Cells, Table, csv_text, json_text};
use crate::failure::Failure;
use crate::output::Place;

/// What comes from a stream and is read more than once is held up to this many bytes, and beyond in a temporary file.
const MOST_BYTES_HELD: usize = 1 << 24;

trait Rereadable: Read + Seek {}

impl<T: Read + Seek> Rereadable for T {}

/// A table to read, CSV or JSON.
pub struct TableSource {
    name: String,
    bytes: Box<dyn Rereadable>,
    /// Behind a byte-order mark.
    start: u64,
    is_json: bool,
    columns: Vec<String>,
    /// The comments of the file, without the program's own.
    pub comments: Vec<String>,
}

impl TableSource {
    /// Opens the table at a place, as JSON where it begins like an array and else as CSV, and finds its columns.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file, and the line where it has one.
    pub fn open(place: &Place) -> Result<Self, Failure> {
        let (name, opened) = match place {
            Place::Standard => ("standard input".to_owned(), spooled(&mut io::stdin().lock())),
            Place::File(path) => (path.display().to_string(), File::open(path).and_then(rereadable)),
        };
        let bytes = opened.map_err(|error| Failure::reading(&name, &error))?;
        Self::of(bytes, name)
    }

    /// A JSON array of row objects; `name` stands for it in messages.
    ///
    /// # Errors
    /// [`Failure::Input`] that names it.
    pub(super) fn of_json(text: &str, name: String) -> Result<Self, Failure> {
        let bytes = Box::new(io::Cursor::new(text.as_bytes().to_vec()));
        TableSource { is_json: true, ..Self::unread(bytes, name) }.with_columns()
    }

    fn of(bytes: Box<dyn Rereadable>, name: String) -> Result<Self, Failure> {
        let mut source = Self::unread(bytes, name);
        source.start = source.checked_start()?;
        source.is_json = source.begins_like_an_array()?;
        source.with_columns()
    }

    fn unread(bytes: Box<dyn Rereadable>, name: String) -> Self {
        TableSource { name, bytes, start: 0, is_json: false, columns: Vec::new(), comments: Vec::new() }
    }

    fn with_columns(self) -> Result<Self, Failure> {
        let mut source = self;
        if source.is_json {
            let mut columns = indexmap::IndexSet::new();
            let name = source.name.clone();
            json_text::each_row(source.reader()?, &name, &mut |row| {
                columns.extend(row.into_keys());
                Ok::<(), Failure>(())
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

    /// Reads the rows from the first on, in blocks of at most so many; one block without rows where there are none.
    ///
    /// # Errors
    /// Those of `each`, and [`Failure::Input`] that names the file and the line.
    pub fn blocks<E: From<Failure>>(
        &mut self,
        most_rows: usize,
        mut each: impl FnMut(InputTable) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut block =
            Block { columns: self.columns.clone(), source: self.name.clone(), ..Block::default() };
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
            let null = serde_json::value::to_raw_value(&()).map_err(Failure::input)?;
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

    fn reader(&mut self) -> Result<impl BufRead, Failure> {
        self.bytes.seek(SeekFrom::Start(self.start)).map_err(|error| Failure::reading(&self.name, &error))?;
        Ok(BufReader::new(&mut self.bytes))
    }

    /// Where the text begins, once all of it is known to be text.
    fn checked_start(&mut self) -> Result<u64, Failure> {
        let name = self.name.clone();
        let (mut line, mut held, mut first) = (1, Vec::new(), true);
        let mut start = 0;
        let mut reader = self.reader()?;
        loop {
            let read = reader.fill_buf().map_err(|error| Failure::reading(&name, &error))?;
            let (taken, ended) = (read.len(), read.is_empty());
            held.extend_from_slice(read);
            reader.consume(taken);
            if first && held.starts_with("\u{feff}".as_bytes()) {
                start = 3;
            }
            first = false;
            let valid = match std::str::from_utf8(&held) {
                Ok(text) => text.len(),
                // A character may go on in what is read next.
                Err(error) if error.error_len().is_none() && !ended => error.valid_up_to(),
                Err(error) => {
                    let before = &held[..error.valid_up_to()];
                    line += before.iter().filter(|&&byte| byte == b'\n').count();
                    let message = format!("{name}, line {line}: not UTF-8 text; save the table as UTF-8");
                    return Err(Failure::Input(message));
                }
            };
            line += held[..valid].iter().filter(|&&byte| byte == b'\n').count();
            held.drain(..valid);
            if ended {
                return Ok(start);
            }
        }
    }

    fn begins_like_an_array(&mut self) -> Result<bool, Failure> {
        let name = self.name.clone();
        for byte in self.reader()?.bytes() {
            let byte = byte.map_err(|error| Failure::reading(&name, &error))?;
            if !byte.is_ascii_whitespace() {
                return Ok(byte == b'[');
            }
        }
        Ok(false)
    }

    /// The comments, wherever they stand.
    fn foreign_comments(&mut self) -> Result<Vec<String>, Failure> {
        let name = self.name.clone();
        let mut comments = Vec::new();
        for line in self.reader()?.lines() {
            let line = line.map_err(|error| Failure::reading(&name, &error))?;
            let comment = line.strip_prefix('#').map(str::trim);
            comments.extend(comment.filter(|comment| !comment.starts_with(OWN_COMMENT)).map(str::to_owned));
        }
        Ok(comments)
    }
}

/// A file as it is, if it can be read again, and else a copy.
fn rereadable(mut file: File) -> io::Result<Box<dyn Rereadable>> {
    if file.metadata()?.is_file() { Ok(Box::new(file)) } else { spooled(&mut file) }
}

fn spooled(from: &mut dyn Read) -> io::Result<Box<dyn Rereadable>> {
    let mut copy = SpooledTempFile::new(MOST_BYTES_HELD);
    io::copy(from, &mut copy)?;
    Ok(Box::new(copy))
}

/// Rows on their way into columns.
#[derive(Default)]
struct Block {
    columns: Vec<String>,
    source: String,
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
        let mut table = Table::default();
        for (name, cells) in self.columns.iter().zip(self.cells.drain(..)) {
            table.set(name, Cells::Typed(cells));
        }
        InputTable::new(table, self.source.clone(), std::mem::take(&mut self.row_names))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opened(bytes: &[u8]) -> Result<TableSource, Failure> {
        TableSource::of(Box::new(io::Cursor::new(bytes.to_vec())), "t".to_owned())
    }

    fn rows_in_blocks(source: &mut TableSource, most_rows: usize) -> Vec<Vec<(String, String)>> {
        let mut blocks = Vec::new();
        let each = |block: InputTable| {
            let cells = block.rows(&[], |row| Ok(row.text("b").into_owned())).unwrap();
            blocks.push(cells.into_iter().enumerate().map(|(row, b)| (block.row_name(row), b)).collect());
            Ok::<(), Failure>(())
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
    fn text_is_told_from_bytes_across_whatever_is_read_at_once() {
        // Two bytes to a character, and an odd one first: characters lie across the ends of any buffer.
        let long = format!("a\n{}\n", "é".repeat(40_000));
        for text in [long.clone(), format!("x{long}")] {
            assert!(opened(text.as_bytes()).is_ok());
            let cut = &text.as_bytes()[..text.len() - 2];
            let Err(Failure::Input(message)) = opened(cut) else { panic!() };
            assert_eq!(message, "t, line 2: not UTF-8 text; save the table as UTF-8");
        }
    }
}
