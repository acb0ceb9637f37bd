//! The header of NetCDF classic files (CDF-1, CDF-2 and CDF-5) and the values of their variables.
//!
//! The `netcdf3` crate was tried: it reserves memory for as many entries as the header claims, is marked experimental,
//! and does not know CDF-5.

use std::borrow::Cow;

use units::printable::listed;

use super::cursor::{Cursor, FORMAT, bad};
use super::kind::{Kind, default_fill, read_into};
use crate::error::{ScanReadError, quoted};

const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
/// Most dimensions of a variable, as `netcdf.h` limits them.
const MOST_AXES: usize = 1024;

/// Bytes of the variables, with their description in the header.
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
    /// Place of its description in the header.
    pub(crate) offset: u64,
}

impl<'b> Classic<'b> {
    pub(crate) fn read(bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let version = bytes.get(3).copied().unwrap_or(0);
        if ![1, 2, 5].contains(&version) {
            return Err(bad(3, "the version", version, "1, 2 or 5"));
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
        listed(named, "")
    }

    /// All values of a variable, the last dimension fastest, scaled as its attributes say; fill values, those of the
    /// format where no attribute gives one, are NaN.
    pub(crate) fn values(&self, variable: &Variable) -> Result<Vec<f64>, ScanReadError> {
        let Kind::Number(stored) = variable.kind else {
            let field = format!("the type of '{}'", variable.name);
            return Err(bad(variable.offset, &field, "text", "a number"));
        };
        let number = |name| variable.attribute(name).and_then(Attribute::number);
        let scale = number("scale_factor").unwrap_or(1.0);
        let shift = number("add_offset").unwrap_or(0.0);
        let fills = [number("_FillValue").or(default_fill(stored)), number("missing_value")];
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
            read_into(&mut values, stored, block);
        }
        values.iter_mut().for_each(|value| *value = scaled(*value));
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
        return Err(bad(count_offset, &field, count, &format!("at most {MOST_AXES}")));
    }
    for _ in 0..count {
        let offset = cursor.offset();
        let index = cursor.count("a dimension of a variable")?;
        if index >= known {
            let bound = format!("below {known}, the number of dimensions");
            return Err(bad(offset, &format!("a dimension of '{name}'"), index, &bound));
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
        (self.kind == Kind::Text).then(|| String::from_utf8_lossy(self.raw).trim_end_matches('\0').to_owned())
    }

    /// The first number.
    pub(crate) fn number(&self) -> Option<f64> {
        let Kind::Number(stored) = self.kind else { return None };
        let mut first = Vec::new();
        read_into(&mut first, stored, self.raw.get(..stored.bytes())?);
        first.pop()
    }

    pub(crate) fn bad(&self, name: &str, bound: &str) -> ScanReadError {
        let value = self.text().map(|text| quoted(&text));
        let value = value.or_else(|| self.number().map(|number| number.to_string())).unwrap_or_default();
        bad(self.offset, &format!("attribute '{name}'"), &value, bound)
    }
}
