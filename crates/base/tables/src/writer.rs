//! Tables written block by block, so that they need not fit into memory.

use std::io::{self, Write};

use crate::table::Table;
use crate::{csv_text, json_text};

/// File format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Comma-separated values with a header row.
    #[default]
    Csv,
    /// An array of row objects; empty cells are null.
    Json,
}

units::named!(Format, "format of a table", { Csv => "csv", Json => "json" });

impl Format {
    /// File extension of this format.
    pub fn extension(self) -> &'static str {
        self.name()
    }
}

impl Table {
    /// Writes the table, after `comments` as `#` lines if the format has comments.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, format: Format, comments: &[String], out: &mut dyn Write) -> io::Result<()> {
        let mut writer = TableWriter::begin(format, comments, out)?;
        writer.block(self)?;
        writer.end().map(|_| ())
    }
}

/// Writer of a table in blocks of rows with the same columns.
pub struct TableWriter<'o> {
    out: &'o mut dyn Write,
    format: Format,
    begun: bool,
    rows: usize,
    unrepresentable: usize,
}

impl<'o> TableWriter<'o> {
    /// Begins a table, after `comments` as `#` lines if the format has comments.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn begin(format: Format, comments: &[String], out: &'o mut dyn Write) -> io::Result<Self> {
        match format {
            Format::Csv => csv_text::write_comments(comments, out)?,
            Format::Json => out.write_all(b"[")?,
        }
        Ok(TableWriter { out, format, begun: false, rows: 0, unrepresentable: 0 })
    }

    /// Writes more rows. The first block names the columns, even if it has no rows.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn block(&mut self, block: &Table) -> io::Result<()> {
        match self.format {
            Format::Csv => csv_text::write(block, !self.begun, self.out)?,
            Format::Json => json_text::write(block, self.rows == 0, self.out)?,
        }
        self.begun = true;
        self.rows += block.rows();
        self.unrepresentable += block.unrepresentable();
        Ok(())
    }

    /// Ends the table; returns the number of computed numbers that were not finite and were left empty.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn end(self) -> io::Result<usize> {
        match self.format {
            Format::Csv => {}
            Format::Json => self.out.write_all(b"\n]\n")?,
        }
        Ok(self.unrepresentable)
    }
}
