//! Reading of binary fields one after the other, each within the file.

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
pub(crate) use crate::texts::{latin1, latin1_at_most};

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ByteOrder {
    Little,
    Big,
}

/// A position in the bytes of a file.
#[derive(Clone, Copy)]
pub(crate) struct Cursor<'b> {
    format: ScanFormat,
    bytes: &'b [u8],
    pub(crate) at: usize,
    pub(crate) order: ByteOrder,
}

macro_rules! numbers {
    ($($type:ident)*) => { $(
        #[allow(dead_code, reason = "one of a family")]
        pub(crate) fn $type(&mut self, what: &str) -> Result<$type, ScanReadError> {
            let bytes = self.array(what)?;
            Ok(match self.order {
                ByteOrder::Little => $type::from_le_bytes(bytes),
                ByteOrder::Big => $type::from_be_bytes(bytes),
            })
        }
    )* };
}

impl<'b> Cursor<'b> {
    /// The beginning of a file.
    pub(crate) fn new(format: ScanFormat, bytes: &'b [u8], order: ByteOrder) -> Self {
        Self { format, bytes, at: 0, order }
    }

    /// Moves to another byte, which may lie beyond the end of the file: the next field then is truncated.
    pub(crate) fn at(self, offset: usize) -> Self {
        Self { at: offset, ..self }
    }

    /// Returns the rest of the file.
    pub(crate) fn rest(&self) -> &'b [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// The next bytes.
    pub(crate) fn take(&mut self, count: usize, what: &str) -> Result<&'b [u8], ScanReadError> {
        let taken = self.rest().get(..count).ok_or_else(|| self.truncated(count, what))?;
        self.at += count;
        Ok(taken)
    }

    pub(crate) fn skip(&mut self, count: usize, what: &str) -> Result<(), ScanReadError> {
        self.take(count, what).map(|_| ())
    }

    numbers! { u8 i8 u16 i16 u32 i32 u64 i64 f32 f64 }

    /// A count of four bytes, above 0.
    pub(crate) fn count(&mut self, what: &str) -> Result<usize, ScanReadError> {
        let offset = self.at;
        let count = self.u32(what)?;
        match usize::try_from(count) {
            Ok(count) if count > 0 => Ok(count),
            _ => Err(self.bad(offset, what, count, "a whole number above 0")),
        }
    }

    /// A text of a fixed number of bytes in Latin-1, which a zero byte may end early, without blanks around it.
    pub(crate) fn text(&mut self, bytes: usize, what: &str) -> Result<String, ScanReadError> {
        Ok(latin1(self.take(bytes, what)?))
    }

    /// The bytes up to a zero byte, which is passed over.
    pub(crate) fn zero_terminated(&mut self, what: &str) -> Result<&'b [u8], ScanReadError> {
        let rest = self.rest();
        let end = rest.iter().position(|&byte| byte == 0);
        let end = end.ok_or_else(|| self.truncated(rest.len().saturating_add(1), what))?;
        let text = self.take(end, what)?;
        self.skip(1, what)?;
        Ok(text)
    }

    fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], ScanReadError> {
        let found = self.rest().first_chunk().ok_or_else(|| self.truncated(N, what))?;
        self.at += N;
        Ok(*found)
    }

    fn truncated(&self, needed: usize, what: &str) -> ScanReadError {
        ScanReadError::Truncated {
            format: self.format,
            offset: self.at as u64,
            what: what.to_owned(),
            needed: needed as u64,
            available: self.rest().len() as u64,
        }
    }

    /// The error of a field that holds what it must not.
    pub(crate) fn bad(&self, offset: usize, field: &str, value: impl ToString, bound: &str) -> ScanReadError {
        let mend = "the file is damaged or of a variant that is not known: export it again";
        self.format.bad(FilePlace::Byte(offset as u64), field, value, bound, mend)
    }
}
