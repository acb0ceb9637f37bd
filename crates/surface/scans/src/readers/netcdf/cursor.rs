//! Counts, lists and names as the header of a NetCDF file writes them, big-endian.

use std::borrow::Cow;

use crate::cursor::{ByteOrder, Cursor as Fields};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;

/// The format whose reader this is, for messages.
pub(crate) const FORMAT: ScanFormat = ScanFormat::NetCdf;

/// Longest list of dimensions, attributes or variables; `netcdf.h` sets the same limit for programs that are portable.
const MOST_ENTRIES: usize = 8192;

/// A position in a file. Counts are four bytes long, in CDF-5 eight.
pub(crate) struct Cursor<'b> {
    fields: Fields<'b>,
    is_cdf5: bool,
}

impl<'b> Cursor<'b> {
    pub(crate) fn new(bytes: &'b [u8], at: usize, is_cdf5: bool) -> Self {
        Self { fields: Fields::new(FORMAT, bytes, ByteOrder::Big).at(at), is_cdf5 }
    }

    pub(crate) fn offset(&self) -> u64 {
        self.fields.at as u64
    }

    pub(crate) fn u32(&mut self, what: &str) -> Result<u32, ScanReadError> {
        self.fields.u32(what)
    }

    pub(crate) fn u64(&mut self, what: &str) -> Result<u64, ScanReadError> {
        self.fields.u64(what)
    }

    /// A count, which cannot exceed the size of memory.
    pub(crate) fn count(&mut self, what: &str) -> Result<usize, ScanReadError> {
        let offset = self.offset();
        let count = if self.is_cdf5 { self.u64(what)? } else { u64::from(self.u32(what)?) };
        usize::try_from(count).map_err(|_| bad(offset, what, count, &format!("at most {}", usize::MAX)))
    }

    /// The number of entries of a list that begins with `tag`. Each takes four bytes or more, so that no list is longer
    /// than the file.
    pub(crate) fn list(&mut self, tag: u32, what: &str) -> Result<usize, ScanReadError> {
        let offset = self.offset();
        let found = self.u32(what)?;
        let count = self.count(what)?;
        if found != tag && (found, count) != (0, 0) {
            return Err(bad(offset, &format!("the tag of {what}"), found, &format!("{tag}, or 0 twice")));
        }
        let most = MOST_ENTRIES.min(self.fields.rest().len() / 4);
        if count > most {
            let bound = format!("at most {most}, as many as a list, and the rest of the file, can hold");
            return Err(bad(offset + 4, &format!("the number of {what}"), count, &bound));
        }
        Ok(count)
    }

    /// A name or other text, padded to four bytes.
    pub(crate) fn name(&mut self, what: &str) -> Result<Cow<'b, str>, ScanReadError> {
        let length = self.count(what)?;
        Ok(String::from_utf8_lossy(self.padded(length, what)?))
    }

    /// Bytes with the padding after them taken off.
    pub(crate) fn padded(&mut self, count: usize, what: &str) -> Result<&'b [u8], ScanReadError> {
        let taken = self.fields.take(count, what)?;
        self.fields.skip(count.wrapping_neg() % 4, what)?;
        Ok(taken)
    }
}

pub(crate) fn bad(offset: u64, field: &str, value: impl ToString, bound: &str) -> ScanReadError {
    FORMAT.bad(FilePlace::Byte(offset), field, value, bound, "the file is damaged: write it again")
}
