//! Writer of NetCDF classic files: dimensions, attributes and variables of doubles, without a growing dimension.
//!
//! The format is that of the NetCDF users' guide, "Classic format specification"; offsets have 32 bits while they fit
//! (CDF-1) and 64 beyond (CDF-2). The `netcdf3` crate calls itself experimental and writes to paths only.

use std::io::{self, Write};

const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
const TEXT: u32 = 2;
const DOUBLE: u32 = 6;

/// NetCDF file to be written.
#[derive(Debug, Default)]
pub(crate) struct NetcdfFile<'v> {
    /// Names and lengths of the dimensions.
    pub(crate) dimensions: Vec<(&'static str, usize)>,
    /// Attributes of the file.
    pub(crate) attributes: Vec<(&'static str, Attribute)>,
    /// Variables of the file.
    pub(crate) variables: Vec<Variable<'v>>,
}

/// Value of an attribute: a number or a text.
#[derive(Debug)]
pub(crate) enum Attribute {
    Number(f64),
    Text(String),
}

/// Variable with its values.
#[derive(Debug)]
pub(crate) struct Variable<'v> {
    pub(crate) name: &'static str,
    /// Indices of its dimensions, the slowest first.
    pub(crate) dimensions: Vec<usize>,
    /// Attributes of the variable.
    pub(crate) attributes: Vec<(&'static str, Attribute)>,
    /// Values, as many as the dimensions require.
    pub(crate) values: std::borrow::Cow<'v, [f64]>,
}

impl NetcdfFile<'_> {
    /// Writes the whole file.
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        // The length of the header does not depend on the offsets, so that they follow from it.
        let unknown = vec![0; self.variables.len()];
        let sizes = || self.variables.iter().map(|variable| 8 * variable.values.len() as u64);
        let wide = self.header(&unknown, false).len() as u64 + sizes().sum::<u64>() > i32::MAX as u64;
        let mut begin = self.header(&unknown, wide).len() as u64;
        let mut offsets = Vec::new();
        for size in sizes() {
            offsets.push(begin);
            begin += size;
        }
        out.write_all(&self.header(&offsets, wide))?;
        for variable in &self.variables {
            for value in variable.values.iter() {
                out.write_all(&value.to_be_bytes())?;
            }
        }
        Ok(())
    }

    fn header(&self, offsets: &[u64], wide: bool) -> Vec<u8> {
        let mut header = Header(b"CDF".to_vec());
        header.0.push(if wide { 2 } else { 1 });
        header.number(0); // no records
        header.list(DIMENSIONS, self.dimensions.len());
        for (name, length) in &self.dimensions {
            header.text(name);
            header.number(*length as u32);
        }
        header.attributes(&self.attributes);
        header.list(VARIABLES, self.variables.len());
        for (variable, offset) in self.variables.iter().zip(offsets) {
            header.text(variable.name);
            header.number(variable.dimensions.len() as u32);
            variable.dimensions.iter().for_each(|dimension| header.number(*dimension as u32));
            header.attributes(&variable.attributes);
            header.number(DOUBLE);
            // A size beyond 32 bits is written as the largest number, and readers take it from the dimensions.
            header.number(u32::try_from(8 * variable.values.len()).unwrap_or(u32::MAX));
            match wide {
                true => header.0.extend(offset.to_be_bytes()),
                false => header.number(*offset as u32),
            }
        }
        header.0
    }
}

/// Bytes of a header, with everything aligned to four of them.
struct Header(Vec<u8>);

impl Header {
    fn number(&mut self, number: u32) {
        self.0.extend(number.to_be_bytes());
    }

    fn list(&mut self, tag: u32, count: usize) {
        self.number(if count == 0 { 0 } else { tag });
        self.number(count as u32);
    }

    fn text(&mut self, text: &str) {
        self.number(text.len() as u32);
        self.0.extend(text.bytes());
        self.0.resize(self.0.len().next_multiple_of(4), 0);
    }

    fn attributes(&mut self, attributes: &[(&'static str, Attribute)]) {
        self.list(ATTRIBUTES, attributes.len());
        for (name, attribute) in attributes {
            self.text(name);
            match attribute {
                Attribute::Text(text) => {
                    self.number(TEXT);
                    self.text(text);
                }
                Attribute::Number(value) => {
                    self.number(DOUBLE);
                    self.number(1);
                    self.0.extend(value.to_be_bytes());
                }
            }
        }
    }
}
