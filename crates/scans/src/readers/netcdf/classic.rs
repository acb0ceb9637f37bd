//! The header of NetCDF classic files (CDF-1, CDF-2 and CDF-5) and the values of their variables.
//!
//! The `netcdf3` crate was tried: it reserves memory for as many entries as the header claims, is marked experimental,
//! and does not know CDF-5.

use std::borrow::Cow;

use super::cursor::FORMAT;
use super::cursor::{Cursor, bad};
use crate::error::{ScanReadError, quoted};

const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
/// Most dimensions of a variable, as `netcdf.h` limits them.
const MOST_AXES: usize = 1024;

/// Bytes that hold variables, with what the header says about them.
pub(crate) struct Classic<'b> {
    bytes: &'b [u8],
    pub(crate) dimensions: Vec<Dimension<'b>>,
    attributes: Vec<Attribute<'b>>,
    pub(crate) variables: Vec<Variable<'b>>,
}

pub(crate) struct Dimension<'b> {
    pub(crate) name: Cow<'b, str>,
    /// Number of records for the one dimension that may grow.
    pub(crate) length: usize,
    is_record: bool,
}

pub(crate) struct Attribute<'b> {
    name: Cow<'b, str>,
    kind: Kind,
    raw: &'b [u8],
    offset: u64,
}

pub(crate) struct Variable<'b> {
    pub(crate) name: Cow<'b, str>,
    /// Indices of dimensions, all within bounds.
    pub(crate) dimensions: Vec<usize>,
    attributes: Vec<Attribute<'b>>,
    kind: Kind,
    begin: u64,
    /// Where the header describes it.
    pub(crate) offset: u64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    I8,
    Char,
    I16,
    I32,
    F32,
    F64,
    U8,
    U16,
    U32,
    I64,
    U64,
}

impl<'b> Classic<'b> {
    pub(crate) fn read(bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let version = bytes.get(3).copied().unwrap_or(0);
        if ![1, 2, 5].contains(&version) {
            return Err(bad(3, "the version", &version.to_string(), "1, 2 or 5"));
        }
        let mut cursor = Cursor::new(bytes, 4, version == 5);
        let offset = cursor.offset();
        let records = cursor.count("the number of records")?;
        let mut file = Self { bytes, dimensions: Vec::new(), attributes: Vec::new(), variables: Vec::new() };
        for _ in 0..cursor.list(DIMENSIONS, "dimensions")? {
            let name = cursor.name("a dimension")?;
            let length = cursor.count("a dimension")?;
            file.dimensions.push(Dimension { name, length, is_record: length == 0 });
        }
        let streaming = if version == 5 { u64::MAX } else { u64::from(u32::MAX) };
        for dimension in file.dimensions.iter_mut().filter(|dimension| dimension.is_record) {
            if records as u64 == streaming {
                return Err(bad(offset, "the number of records", "left open", "written down"));
            }
            dimension.length = records;
        }
        file.attributes = attributes(&mut cursor)?;
        for _ in 0..cursor.list(VARIABLES, "variables")? {
            file.variables.push(variable(&mut cursor, version, file.dimensions.len())?);
        }
        Ok(file)
    }

    pub(crate) fn variable(&self, name: &str) -> Option<&Variable<'b>> {
        self.variables.iter().find(|variable| variable.name == name)
    }

    pub(crate) fn attribute(&self, name: &str) -> Option<&Attribute<'b>> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    /// The dimensions of a variable as messages name them: `x: 6, y: 4`.
    pub(crate) fn dimensions_of(&self, variable: &Variable) -> String {
        let named = variable.dimensions.iter().map(|&index| {
            let dimension = &self.dimensions[index];
            format!("{}: {}", dimension.name, dimension.length)
        });
        named.collect::<Vec<_>>().join(", ")
    }

    /// All values of a variable, the last dimension fastest, scaled as its attributes say; fill values, those of the
    /// format where no attribute gives one, are NaN.
    pub(crate) fn values(&self, variable: &Variable) -> Result<Vec<f64>, ScanReadError> {
        if variable.kind == Kind::Char {
            return Err(bad(
                variable.offset,
                &format!("the type of '{}'", variable.name),
                "text",
                "a number",
            ));
        }
        let number = |name| variable.attribute(name).and_then(Attribute::number);
        let scale = number("scale_factor").unwrap_or(1.0);
        let shift = number("add_offset").unwrap_or(0.0);
        let fills = [number("_FillValue").or(variable.kind.default_fill()), number("missing_value")];
        let scaled = |raw: f64| if fills.contains(&Some(raw)) { f64::NAN } else { raw * scale + shift };
        let records =
            if self.is_record(variable) { self.dimensions[variable.dimensions[0]].length } else { 1 };
        let (size, stride) = (self.record_size(variable), self.stride(variable));
        let mut values = Vec::new();
        if size == Some(0) {
            return Ok(values);
        }
        let block = |record: usize| {
            let begin = usize::try_from(variable.begin).ok()?;
            let start = begin.checked_add(stride?.checked_mul(record)?)?;
            self.bytes.get(start..)?.get(..size?)
        };
        for record in 0..records {
            let block = block(record).ok_or_else(|| self.truncated(variable, records))?;
            values.extend(
                block.chunks_exact(variable.kind.size()).map(|raw| scaled(variable.kind.number(raw))),
            );
        }
        Ok(values)
    }

    fn truncated(&self, variable: &Variable, records: usize) -> ScanReadError {
        let needed = self.record_size(variable).and_then(|size| size.checked_mul(records));
        ScanReadError::Truncated {
            format: FORMAT,
            offset: variable.begin,
            what: format!("variable '{}'", variable.name),
            needed: needed.map_or(u64::MAX, |needed| needed as u64),
            available: (self.bytes.len() as u64).saturating_sub(variable.begin),
        }
    }

    fn is_record(&self, variable: &Variable) -> bool {
        variable.dimensions.first().is_some_and(|&index| self.dimensions[index].is_record)
    }

    /// Bytes of one record, or of the whole variable; none where the number overflows.
    fn record_size(&self, variable: &Variable) -> Option<usize> {
        let fixed = variable.dimensions.iter().skip(usize::from(self.is_record(variable)));
        fixed.map(|&index| self.dimensions[index].length).try_fold(variable.kind.size(), usize::checked_mul)
    }

    /// Bytes from one record to the next: those of all variables with records, each padded unless it is alone.
    fn stride(&self, variable: &Variable) -> Option<usize> {
        let with_records = || self.variables.iter().filter(|variable| self.is_record(variable));
        if with_records().count() <= 1 {
            return self.record_size(variable);
        }
        let padded = |variable| self.record_size(variable)?.checked_next_multiple_of(4);
        with_records().map(padded).try_fold(0usize, |sum, size| sum.checked_add(size?))
    }
}

fn attributes<'b>(cursor: &mut Cursor<'b>) -> Result<Vec<Attribute<'b>>, ScanReadError> {
    let mut attributes = Vec::new();
    for _ in 0..cursor.list(ATTRIBUTES, "attributes")? {
        let offset = cursor.offset();
        let name = cursor.name("an attribute")?;
        let kind = Kind::read(cursor)?;
        let count = cursor.count("an attribute")?;
        let size = count.saturating_mul(kind.size());
        attributes.push(Attribute { name, kind, raw: cursor.padded(size, "an attribute")?, offset });
    }
    Ok(attributes)
}

fn variable<'b>(cursor: &mut Cursor<'b>, version: u8, known: usize) -> Result<Variable<'b>, ScanReadError> {
    let offset = cursor.offset();
    let name = cursor.name("a variable")?;
    let mut dimensions = Vec::new();
    let count_offset = cursor.offset();
    let count = cursor.count("the dimensions of a variable")?;
    if count > MOST_AXES {
        let field = format!("the number of dimensions of '{name}'");
        return Err(bad(count_offset, &field, &count.to_string(), &format!("at most {MOST_AXES}")));
    }
    for _ in 0..count {
        let offset = cursor.offset();
        let index = cursor.count("a dimension of a variable")?;
        if index >= known {
            let bound = format!("below {known}, the number of dimensions");
            return Err(bad(offset, &format!("a dimension of '{name}'"), &index.to_string(), &bound));
        }
        dimensions.push(index);
    }
    let attributes = attributes(cursor)?;
    let kind = Kind::read(cursor)?;
    // Sizes follow from the dimensions; the one written here is rounded up, and void for large variables.
    cursor.count("the size of a variable")?;
    let begin = match version {
        1 => u64::from(cursor.u32("the place of a variable")?),
        _ => cursor.u64("the place of a variable")?,
    };
    Ok(Variable { name, dimensions, attributes, kind, begin, offset })
}

impl<'b> Variable<'b> {
    pub(crate) fn attribute(&self, name: &str) -> Option<&Attribute<'b>> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }
}

impl Attribute<'_> {
    /// The text, without zero bytes at its end.
    pub(crate) fn text(&self) -> Option<String> {
        let is_text = self.kind == Kind::Char;
        is_text.then(|| String::from_utf8_lossy(self.raw).trim_end_matches('\0').to_owned())
    }

    /// The first number.
    pub(crate) fn number(&self) -> Option<f64> {
        let raw = self.raw.get(..self.kind.size()).filter(|_| self.kind != Kind::Char)?;
        Some(self.kind.number(raw))
    }

    pub(crate) fn bad(&self, name: &str, bound: &str) -> ScanReadError {
        let value = self.text().map(|text| quoted(&text));
        let value = value.or_else(|| self.number().map(|number| number.to_string())).unwrap_or_default();
        bad(self.offset, &format!("attribute '{name}'"), &value, bound)
    }
}

impl Kind {
    fn read(cursor: &mut Cursor) -> Result<Self, ScanReadError> {
        let offset = cursor.offset();
        Ok(match cursor.u32("a type")? {
            1 => Self::I8,
            2 => Self::Char,
            3 => Self::I16,
            4 => Self::I32,
            5 => Self::F32,
            6 => Self::F64,
            7 => Self::U8,
            8 => Self::U16,
            9 => Self::U32,
            10 => Self::I64,
            11 => Self::U64,
            other => return Err(bad(offset, "a type", &other.to_string(), "between 1 and 11")),
        })
    }

    /// What the NetCDF library writes where nobody has (NC_FILL_... of netcdf.h); bytes and text have none.
    fn default_fill(self) -> Option<f64> {
        Some(match self {
            Self::I8 | Self::U8 | Self::Char => return None,
            Self::I16 => -32_767.0,
            Self::I32 => -2_147_483_647.0,
            Self::I64 => -9_223_372_036_854_775_806_i64 as f64,
            Self::F32 | Self::F64 => 9.969_209_968_386_869e36,
            Self::U16 => 65_535.0,
            Self::U32 => 4_294_967_295.0,
            Self::U64 => 18_446_744_073_709_551_614_u64 as f64,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::Char | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 | Self::I64 | Self::U64 => 8,
        }
    }

    /// The number in as many bytes as the type takes.
    fn number(self, raw: &[u8]) -> f64 {
        let bits = raw.iter().fold(0u64, |bits, &byte| bits << 8 | u64::from(byte));
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::I16 => f64::from(bits as i16),
            Self::I32 => f64::from(bits as i32),
            Self::I64 => bits as i64 as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
            Self::Char | Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
        }
    }
}
