//! Numbers at even distances in the bytes of a file, as nearly every instrument stores them.

mod decode;
mod half;

use std::borrow::Cow;

use crate::cursor::ByteOrder;
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::missing_points::MissingPoints;

/// The type of a stored number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NumberType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    /// Half precision, two bytes.
    F16,
    F32,
    F64,
}

impl NumberType {
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 | Self::F16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }
}

/// In which order the numbers of a map follow each other; row 0 is the uppermost as the instrument shows it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Order {
    #[default]
    RowsFromTop,
    RowsFromBottom,
    /// Column after column from the left, each from the top.
    ColumnsFromTop,
    /// Column after column from the left, each from the bottom.
    ColumnsFromBottom,
}

/// Mark of a missing point. Floating-point numbers that are not finite always mark one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum MissingMark<'b> {
    #[default]
    None,
    /// By this number, before scale and offset.
    Equal(f64),
    /// By this number or any above it.
    AtLeast(f64),
    /// By this number or any below it.
    AtMost(f64),
    /// By a byte other than 0 beside each point, in the order of the numbers.
    Flagged(Cow<'b, [u8]>),
}

/// Place and meaning of the numbers of a channel. Nothing is decoded yet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Raster<'b> {
    pub(crate) columns: usize,
    /// 1 for a line.
    pub(crate) rows: usize,
    pub(crate) number: NumberType,
    pub(crate) byte_order: ByteOrder,
    pub(crate) order: Order,
    /// True if each row is stored from its right end.
    pub(crate) is_mirrored: bool,
    /// The bytes of the numbers, from the first one on; what follows the last is not looked at.
    pub(crate) bytes: Cow<'b, [u8]>,
    /// Offset in the file, for messages.
    pub(crate) offset: usize,
    /// Bytes from one stored row (or column) to the next; those of its numbers where absent.
    pub(crate) stride: Option<usize>,
    /// A stored number times this ...
    pub(crate) scale: f64,
    /// ... plus this is the value.
    pub(crate) zero: f64,
    pub(crate) missing: MissingMark<'b>,
}

/// Values row after row from the top, with 0 where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Decoded {
    pub(crate) values: Vec<f64>,
    pub(crate) missing: MissingPoints,
}

impl Decoded {
    /// Adds a point; a value that is not finite is none.
    pub(crate) fn push(&mut self, value: Option<f64>) {
        match value.filter(|value| value.is_finite()) {
            Some(value) => self.values.push(value),
            None => {
                self.missing.insert(self.values.len());
                self.values.push(0.0);
            }
        }
    }

    /// Takes the value of a point away.
    pub(crate) fn set_missing(&mut self, index: usize) {
        if let Some(value) = self.values.get_mut(index) {
            *value = 0.0;
            self.missing.insert(index);
        }
    }
}

impl FromIterator<Option<f64>> for Decoded {
    fn from_iter<I: IntoIterator<Item = Option<f64>>>(values: I) -> Self {
        let values = values.into_iter();
        let mut decoded =
            Self { values: Vec::with_capacity(values.size_hint().0), missing: MissingPoints::default() };
        values.for_each(|value| decoded.push(value));
        decoded
    }
}

impl<'b> Raster<'b> {
    /// Packed little-endian numbers from the top, in this unit and without missing points.
    pub(crate) fn new(
        number: NumberType,
        columns: usize,
        rows: usize,
        bytes: impl Into<Cow<'b, [u8]>>,
        offset: usize,
    ) -> Self {
        Self {
            columns,
            rows,
            number,
            byte_order: ByteOrder::Little,
            order: Order::default(),
            is_mirrored: false,
            bytes: bytes.into(),
            offset,
            stride: None,
            scale: 1.0,
            zero: 0.0,
            missing: MissingMark::None,
        }
    }

    /// Packed little-endian numbers from a byte of a file on; the file may end too soon, which [`Raster::check`] tells.
    pub(crate) fn within(
        number: NumberType,
        columns: usize,
        rows: usize,
        file: &'b [u8],
        offset: usize,
    ) -> Self {
        Self::new(number, columns, rows, file.get(offset..).unwrap_or_default(), offset)
    }

    /// Refuses numbers that are not all there, before any memory is set aside for them.
    pub(crate) fn check(&self, format: ScanFormat) -> Result<(), ScanReadError> {
        let points = self.columns.checked_mul(self.rows);
        let (runs, run) = self.runs();
        let packed = run.checked_mul(self.number.bytes());
        let stride = packed.map(|packed| self.stride.unwrap_or(packed).max(packed));
        let needed = match (runs, stride, packed, points) {
            (0, ..) => Some(0),
            (_, Some(stride), Some(packed), Some(_)) => {
                stride.checked_mul(runs - 1).and_then(|before| before.checked_add(packed))
            }
            _ => None,
        };
        let flags = match &self.missing {
            MissingMark::Flagged(flags) => points.is_some_and(|points| flags.len() >= points),
            _ => true,
        };
        if needed.is_some_and(|needed| self.bytes.len() >= needed) && flags {
            return Ok(());
        }
        Err(ScanReadError::Truncated {
            format,
            offset: self.offset as u64,
            what: format!("a channel of {} x {} points", self.columns, self.rows),
            needed: needed.map_or(u64::MAX, |needed| needed as u64),
            available: self.bytes.len() as u64,
        })
    }

    /// Number of runs of neighbouring numbers, and the length of each.
    fn runs(&self) -> (usize, usize) {
        match self.order {
            Order::RowsFromTop | Order::RowsFromBottom => (self.rows, self.columns),
            Order::ColumnsFromTop | Order::ColumnsFromBottom => (self.columns, self.rows),
        }
    }
}
