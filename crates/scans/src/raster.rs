//! Numbers at even distances in the bytes of a file, as nearly every instrument stores them.

use std::borrow::Cow;

use crate::cursor::ByteOrder;
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::gaps::Gaps;

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
    F32,
    F64,
}

impl NumberType {
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
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

/// How a point without a height is marked. Floating-point numbers that are not finite always mark one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum GapMark<'b> {
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

/// Where the numbers of a channel stand and what they mean. Nothing is decoded yet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Raster<'b> {
    pub(crate) columns: usize,
    /// 1 for a line.
    pub(crate) rows: usize,
    pub(crate) number: NumberType,
    pub(crate) byte_order: ByteOrder,
    pub(crate) order: Order,
    /// The bytes of the numbers, from the first one on; what follows the last is not looked at.
    pub(crate) bytes: Cow<'b, [u8]>,
    /// Where they begin in the file, for messages.
    pub(crate) offset: usize,
    /// Bytes from one stored row (or column) to the next; those of its numbers where absent.
    pub(crate) stride: Option<usize>,
    /// A stored number times this ...
    pub(crate) scale: f64,
    /// ... plus this is the value.
    pub(crate) zero: f64,
    pub(crate) gap: GapMark<'b>,
}

/// Values row after row from the top, with 0 where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Decoded {
    pub(crate) values: Vec<f64>,
    pub(crate) gaps: Gaps,
}

impl Decoded {
    /// Adds a point; a value that is not finite is none.
    pub(crate) fn push(&mut self, value: Option<f64>) {
        match value.filter(|value| value.is_finite()) {
            Some(value) => self.values.push(value),
            None => {
                self.gaps.insert(self.values.len());
                self.values.push(0.0);
            }
        }
    }
}

impl FromIterator<Option<f64>> for Decoded {
    fn from_iter<I: IntoIterator<Item = Option<f64>>>(values: I) -> Self {
        let values = values.into_iter();
        let mut decoded = Self { values: Vec::with_capacity(values.size_hint().0), gaps: Gaps::default() };
        values.for_each(|value| decoded.push(value));
        decoded
    }
}

impl<'b> Raster<'b> {
    /// Packed little-endian numbers from the top, in this unit and without gaps.
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
            bytes: bytes.into(),
            offset,
            stride: None,
            scale: 1.0,
            zero: 0.0,
            gap: GapMark::None,
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

    /// The same with bytes of its own.
    #[cfg(feature = "archives")]
    pub(crate) fn into_owned<'o>(self) -> Raster<'o> {
        Raster {
            columns: self.columns,
            rows: self.rows,
            number: self.number,
            byte_order: self.byte_order,
            order: self.order,
            bytes: Cow::Owned(self.bytes.into_owned()),
            offset: self.offset,
            stride: self.stride,
            scale: self.scale,
            zero: self.zero,
            gap: match self.gap {
                GapMark::None => GapMark::None,
                GapMark::Equal(mark) => GapMark::Equal(mark),
                GapMark::AtLeast(mark) => GapMark::AtLeast(mark),
                GapMark::AtMost(mark) => GapMark::AtMost(mark),
                GapMark::Flagged(flags) => GapMark::Flagged(Cow::Owned(flags.into_owned())),
            },
        }
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
        let flags = match &self.gap {
            GapMark::Flagged(flags) => points.is_some_and(|points| flags.len() >= points),
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

    /// How many runs of neighbouring numbers are stored, and how long each is.
    fn runs(&self) -> (usize, usize) {
        match self.order {
            Order::RowsFromTop | Order::RowsFromBottom => (self.rows, self.columns),
            Order::ColumnsFromTop | Order::ColumnsFromBottom => (self.columns, self.rows),
        }
    }

    /// The values.
    ///
    /// # Errors
    /// [`ScanReadError::Truncated`] where the file ends too soon.
    pub(crate) fn decode(&self, format: ScanFormat) -> Result<Decoded, ScanReadError> {
        self.check(format)?;
        macro_rules! decode {
            ($type:ty) => {
                match self.byte_order {
                    ByteOrder::Little => self.decoded(|bytes| <$type>::from_le_bytes(bytes) as f64),
                    ByteOrder::Big => self.decoded(|bytes| <$type>::from_be_bytes(bytes) as f64),
                }
            };
        }
        Ok(match self.number {
            NumberType::I8 => decode!(i8),
            NumberType::U8 => decode!(u8),
            NumberType::I16 => decode!(i16),
            NumberType::U16 => decode!(u16),
            NumberType::I32 => decode!(i32),
            NumberType::U32 => decode!(u32),
            NumberType::I64 => decode!(i64),
            NumberType::U64 => decode!(u64),
            NumberType::F32 => decode!(f32),
            NumberType::F64 => decode!(f64),
        })
    }

    fn decoded<const N: usize>(&self, number: impl Fn([u8; N]) -> f64 + Copy) -> Decoded {
        let (_, run) = self.runs();
        let stride = self.stride.unwrap_or(run * N).max(run * N);
        let mut decoded =
            Decoded { values: Vec::with_capacity(self.columns * self.rows), gaps: Gaps::default() };
        for row in 0..self.rows {
            let is_from_top = matches!(self.order, Order::RowsFromTop | Order::ColumnsFromTop);
            let stored = if is_from_top { row } else { self.rows - 1 - row };
            match self.order {
                Order::RowsFromTop | Order::RowsFromBottom => {
                    let (numbers, _) = self.bytes[stored * stride..][..run * N].as_chunks();
                    self.decode_row(
                        numbers.iter().map(|bytes| number(*bytes)),
                        stored * run,
                        1,
                        &mut decoded,
                    );
                }
                Order::ColumnsFromTop | Order::ColumnsFromBottom => {
                    let at = |column: usize| self.bytes[column * stride + stored * N..].first_chunk();
                    let numbers =
                        (0..self.columns).map(|column| at(column).map_or(f64::NAN, |bytes| number(*bytes)));
                    self.decode_row(numbers, stored, run, &mut decoded);
                }
            }
        }
        decoded
    }

    /// Decodes a row whose first number is stored at `first`, its neighbours every `step` numbers from there on. Values come
    /// first and gaps after them, so that rows without any, the rule, are decoded many points at a time.
    fn decode_row(
        &self,
        numbers: impl Iterator<Item = f64> + Clone,
        first: usize,
        step: usize,
        decoded: &mut Decoded,
    ) {
        let start = decoded.values.len();
        let (scale, zero) = (self.scale, self.zero);
        decoded.values.extend(numbers.clone().map(|number| number * scale + zero));
        let mut mark = |is_gap: &dyn Fn(usize, f64) -> bool| {
            for (at, number) in numbers.clone().enumerate() {
                if is_gap(at, number) {
                    decoded.gaps.insert(start + at);
                    decoded.values[start + at] = 0.0;
                }
            }
        };
        match &self.gap {
            GapMark::None => {}
            GapMark::Equal(value) if numbers.clone().any(|number| number == *value) => {
                mark(&|_, number| number == *value);
            }
            GapMark::AtLeast(least) if numbers.clone().any(|number| number >= *least) => {
                mark(&|_, number| number >= *least);
            }
            GapMark::AtMost(most) if numbers.clone().any(|number| number <= *most) => {
                mark(&|_, number| number <= *most);
            }
            GapMark::Equal(_) | GapMark::AtLeast(_) | GapMark::AtMost(_) => {}
            GapMark::Flagged(flags) => mark(&|at, _| flags[first + at * step] != 0),
        }
        if !decoded.values[start..].iter().all(|value| value.is_finite()) {
            for index in start..decoded.values.len() {
                if !decoded.values[index].is_finite() {
                    decoded.gaps.insert(index);
                    decoded.values[index] = 0.0;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMAT: ScanFormat = ScanFormat::Nanoscope;

    #[test]
    fn numbers_are_decoded_in_every_order() {
        let bytes: Vec<u8> = [1i16, 2, 3, 4, 5, -6].iter().flat_map(|value| value.to_be_bytes()).collect();
        let raster = |order| Raster {
            byte_order: ByteOrder::Big,
            order,
            scale: 2.0,
            zero: 1.0,
            gap: GapMark::Equal(4.0),
            ..Raster::new(NumberType::I16, 3, 2, &bytes[..], 0)
        };
        let values = |order| raster(order).decode(FORMAT).unwrap().values;
        assert_eq!(values(Order::RowsFromTop), [3.0, 5.0, 7.0, 0.0, 11.0, -11.0]);
        assert_eq!(values(Order::RowsFromBottom), [0.0, 11.0, -11.0, 3.0, 5.0, 7.0]);
        assert_eq!(values(Order::ColumnsFromTop), [3.0, 7.0, 11.0, 5.0, 0.0, -11.0]);
        assert_eq!(values(Order::ColumnsFromBottom), [5.0, 0.0, -11.0, 3.0, 7.0, 11.0]);
        let gaps = raster(Order::RowsFromBottom).decode(FORMAT).unwrap().gaps;
        assert_eq!(gaps.indices().collect::<Vec<_>>(), [0]);
    }

    #[test]
    fn flags_strides_and_missing_bytes_count() {
        let raster = Raster {
            stride: Some(3),
            gap: GapMark::Flagged(Cow::Borrowed(&[0, 0, 1, 0])),
            ..Raster::new(NumberType::U8, 2, 2, &[1u8, 2, 99, 3, 4][..], 0)
        };
        let decoded = raster.decode(FORMAT).unwrap();
        assert_eq!((decoded.values, decoded.gaps.count()), (vec![1.0, 2.0, 0.0, 4.0], 1));
        let short = Raster { rows: 3, ..raster.clone() };
        assert!(short.decode(FORMAT).unwrap_err().to_string().contains("takes 8 bytes, but the file ends 5"));
        assert!(Raster { rows: usize::MAX, ..raster }.decode(FORMAT).is_err());
        let not_finite = Raster::new(NumberType::F32, 2, 1, f32::NAN.to_le_bytes().repeat(2), 0);
        assert_eq!(not_finite.decode(FORMAT).unwrap().gaps.count(), 2);
    }
}
