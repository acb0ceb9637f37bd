//! Text files of columns: comments, separators, rows with their physical line numbers.

use csv::{ReaderBuilder, StringRecord};

use crate::read::contact_engineering::{blocks, grouped, has_columns_comment};
use crate::read::error::ReadError;
use crate::read::gwyddion;
use crate::read::header::{Heading, Quantity};
use crate::read::lines::{comment, is_blank_or_comment, is_number};
use crate::read::series::{ColumnKind, Columns, Row, Series, SeriesName};

/// A text file cut into comments, a possible header and rows.
pub(crate) struct Table<'t> {
    /// Comment lines before the first other line, without `#` and surrounding blanks.
    pub(crate) comments: Vec<String>,
    /// The first line that is not a comment.
    first_line: usize,
    /// Names in the first line, or its numbers if there is no header.
    first_row: Vec<String>,
    text: &'t str,
    separator: Separator,
}

#[derive(Clone, Copy)]
enum Separator {
    Character(u8),
    Blanks,
}

impl<'t> Table<'t> {
    /// Reads a file up to its first row.
    pub(crate) fn open(text: &'t str) -> Result<Self, ReadError> {
        let comments = leading_comments(text).map(str::to_owned).collect();
        let content = text.lines().find(|line| !is_blank_or_comment(line)).ok_or(ReadError::Empty)?;
        let separator = Separator::in_line(content);
        let mut table = Self { comments, first_line: 0, first_row: Vec::new(), text, separator };
        let mut record = StringRecord::new();
        let first = table.rows().read(&mut record)?.ok_or(ReadError::Empty)?;
        table.first_line = first;
        table.first_row = match separator {
            Separator::Character(_) => record.iter().map(|name| name.trim().to_owned()).collect(),
            Separator::Blanks if is_number(record.get(0)) => record.iter().map(str::to_owned).collect(),
            Separator::Blanks => join_units(&record),
        };
        Ok(table)
    }

    /// Reads the series of the file, mostly one.
    pub(crate) fn series(&self) -> Result<Vec<Series>, ReadError> {
        if let Some(curves) = gwyddion::series(self.text)? {
            return Ok(curves);
        }
        let mut rows = self.all_rows()?;
        let line = self.first_line;
        if !self.is_headerless() {
            rows.remove(0);
            return grouped(self.first_row.clone(), line, rows);
        }
        if has_columns_comment(self.text) {
            return Ok(blocks(self.text, rows));
        }
        let columns = self.commented_header().unwrap_or_else(|| {
            let names = (1..=self.first_row.len()).map(|number| number.to_string()).collect();
            Columns { names, line, kind: ColumnKind::Numbered }
        });
        Ok(vec![Series::new(SeriesName::default(), columns, rows)])
    }

    /// Parses a comment right above the numbers as a header, such as `# q (1/m) C (m^4)`; it must name every column,
    /// with an abscissa and a spectrum among them.
    fn commented_header(&self) -> Option<Columns> {
        let above = self.text.lines().enumerate().take(self.first_line - 1);
        let (i, text) = above.filter_map(|(i, line)| Some((i, comment(line)?))).last()?;
        let names = match Separator::in_line(text) {
            Separator::Character(separator) => {
                text.split(char::from(separator)).map(|name| name.trim().to_owned()).collect()
            }
            Separator::Blanks => join_units(&text.split_whitespace().collect()),
        };
        let has = |is_meant: fn(Quantity) -> bool| {
            names.iter().filter_map(|name| Heading::parse(name)).any(|heading| is_meant(heading.quantity))
        };
        let is_header = names.len() == self.first_row.len()
            && has(|quantity| matches!(quantity, Quantity::Abscissa(_)))
            && has(|quantity| matches!(quantity, Quantity::Density(_)));
        is_header.then_some(Columns { names, line: i + 1, kind: ColumnKind::Named })
    }

    fn all_rows(&self) -> Result<Vec<Row>, ReadError> {
        let mut lines = self.rows();
        let mut record = StringRecord::new();
        let mut rows = Vec::new();
        while let Some(line) = lines.read(&mut record)? {
            rows.push(Row { line, fields: record.clone() });
        }
        Ok(rows)
    }

    /// Returns true if the first row holds numbers rather than names.
    fn is_headerless(&self) -> bool {
        is_number(self.first_row.first().map(String::as_str))
    }

    /// Returns a reader of the rows, including the first.
    fn rows(&self) -> Rows<'t> {
        match self.separator {
            Separator::Character(delimiter) => {
                Rows::Delimited(Box::new(DelimitedRows::new(self.text, delimiter)))
            }
            Separator::Blanks => Rows::Blanks(self.text.lines().enumerate()),
        }
    }
}

/// The rows of a table, one by one.
enum Rows<'t> {
    Delimited(Box<DelimitedRows<'t>>),
    Blanks(std::iter::Enumerate<std::str::Lines<'t>>),
}

impl Rows<'_> {
    /// Reads the next row into `record` and returns its line, counted from 1; `None` at the end.
    fn read(&mut self, record: &mut StringRecord) -> Result<Option<usize>, ReadError> {
        match self {
            Self::Delimited(rows) => rows.read(record),
            Self::Blanks(lines) => Ok(lines.find(|(_, line)| !is_blank_or_comment(line)).map(|(i, line)| {
                record.clear();
                line.split_whitespace().for_each(|field| record.push_field(field));
                i + 1
            })),
        }
    }
}

/// Rows of a CSV file with their lines, which the CSV reader does not count: it skips comments and empty lines.
struct DelimitedRows<'t> {
    reader: csv::Reader<&'t [u8]>,
    is_tabbed: bool,
    bytes: &'t [u8],
    byte: usize,
    line: usize,
}

impl<'t> DelimitedRows<'t> {
    fn new(text: &'t str, delimiter: u8) -> Self {
        let bytes = text.as_bytes();
        let reader = ReaderBuilder::new()
            .delimiter(delimiter)
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .from_reader(bytes);
        Self { reader, is_tabbed: delimiter == b'\t', bytes, byte: 0, line: 1 }
    }

    fn read(&mut self, record: &mut StringRecord) -> Result<Option<usize>, ReadError> {
        while self.reader.read_record(record).map_err(std::io::Error::from)? {
            let start = record.position().map_or(0, csv::Position::byte) as usize;
            let line = self.line_at(start);
            if !self.is_blank_or_comment(record) {
                return Ok(Some(line));
            }
        }
        Ok(None)
    }

    /// Returns true for lines that the reader mistakes for rows: indented comments, and lines of blanks or tabs. A
    /// quoted cell that begins with `#` is not a comment.
    fn is_blank_or_comment(&self, record: &StringRecord) -> bool {
        let is_comment = self.bytes[self.byte..].trim_ascii_start().first() == Some(&b'#');
        let may_be_blank = record.len() == 1 || self.is_tabbed;
        is_comment || may_be_blank && record.iter().all(|field| field.trim().is_empty())
    }

    /// Returns the line of the first row at or after a byte.
    fn line_at(&mut self, byte: usize) -> usize {
        // Lines skipped last time may reach beyond the reader's row, if that is itself blank.
        self.advance_to(byte.max(self.byte));
        while let Some(length) = self.skipped_line() {
            self.advance_to(self.byte + length);
        }
        self.line
    }

    /// Returns the length of a comment or empty line that begins here.
    fn skipped_line(&self) -> Option<usize> {
        let rest = &self.bytes[self.byte..];
        let is_comment = rest.first() == Some(&b'#');
        let stop = rest.iter().position(|&b| b == b'\n' || !is_comment && !b.is_ascii_whitespace())?;
        (rest[stop] == b'\n').then_some(stop + 1)
    }

    fn advance_to(&mut self, byte: usize) {
        self.line += self.bytes[self.byte..byte].iter().filter(|&&b| b == b'\n').count();
        self.byte = byte;
    }
}

impl Separator {
    fn in_line(line: &str) -> Self {
        let is_present = |separator: &&u8| line.as_bytes().contains(separator);
        [b';', b'\t', b',']
            .iter()
            .find(is_present)
            .map_or(Self::Blanks, |&separator| Self::Character(separator))
    }
}

fn leading_comments(text: &str) -> impl Iterator<Item = &str> {
    text.lines().take_while(|line| is_blank_or_comment(line)).filter_map(comment)
}

/// Joins the words of a blank-separated header into names, with units in brackets or after a slash.
fn join_units(words: &StringRecord) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for word in words {
        match names.last_mut() {
            Some(name) if is_open(name) || word.starts_with(['(', '[', '/']) => {
                name.push(' ');
                name.push_str(word);
            }
            _ => names.push(word.to_owned()),
        }
    }
    names
}

/// Returns true if the unit of a name is not complete.
fn is_open(name: &str) -> bool {
    let unclosed = |open, close| name.rfind(open) > name.rfind(close);
    name.ends_with('/') || unclosed('(', ')') || unclosed('[', ']')
}
