//! Conversion of stored numbers to values.

use super::half::half;
use super::{Decoded, MissingMark, NumberType, Order, Raster};
use crate::cursor::ByteOrder;
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::missing_points::MissingPoints;

impl NumberType {
    /// Appends so many numbers that are `stride` bytes apart, each times a factor and plus a summand.
    pub(crate) fn read(
        self,
        byte_order: ByteOrder,
        bytes: &[u8],
        [stride, count]: [usize; 2],
        line: [f64; 2],
        values: &mut Vec<f64>,
    ) {
        let row = StoredRow { bytes, stride, first: 0, step: 1, columns: count };
        self.reader(byte_order)(&row, line, values);
    }

    fn reader(self, byte_order: ByteOrder) -> ReadRow {
        macro_rules! reader {
            ($number:expr) => {
                |row, line, values| read_row(row, line, values, $number)
            };
            ($type:ty, $finished:expr) => {
                match byte_order {
                    ByteOrder::Little => reader!(|bytes| $finished(<$type>::from_le_bytes(bytes))),
                    ByteOrder::Big => reader!(|bytes| $finished(<$type>::from_be_bytes(bytes))),
                }
            };
        }
        match self {
            Self::I8 => reader!(i8, f64::from),
            Self::U8 => reader!(u8, f64::from),
            Self::I16 => reader!(i16, f64::from),
            Self::U16 => reader!(u16, f64::from),
            Self::I32 => reader!(i32, f64::from),
            Self::U32 => reader!(u32, f64::from),
            Self::I64 => reader!(i64, |number| number as f64),
            Self::U64 => reader!(u64, |number| number as f64),
            Self::F16 => reader!(u16, half),
            Self::F32 => reader!(f32, f64::from),
            Self::F64 => reader!(f64, f64::from),
        }
    }
}

impl Raster<'_> {
    /// The values.
    ///
    /// # Errors
    /// [`ScanReadError::Truncated`] where the file ends too soon.
    pub(crate) fn decode(&self, format: ScanFormat) -> Result<Decoded, ScanReadError> {
        self.check(format)?;
        // Without columns there may be any number of rows, all of them void.
        if self.columns == 0 || self.rows == 0 {
            return Ok(Decoded::default());
        }
        let decoded = self.decoded(self.number.reader(self.byte_order));
        Ok(if self.is_mirrored { mirrored(decoded, self.columns) } else { decoded })
    }

    fn decoded(&self, read: ReadRow) -> Decoded {
        let (_, run) = self.runs();
        let size = self.number.bytes();
        let stride = self.stride.unwrap_or(run * size).max(run * size);
        let is_from_top = matches!(self.order, Order::RowsFromTop | Order::ColumnsFromTop);
        let mut decoded = Decoded {
            values: Vec::with_capacity(self.columns * self.rows),
            missing: MissingPoints::default(),
        };
        for row in 0..self.rows {
            let stored = if is_from_top { row } else { self.rows - 1 - row };
            let row = match self.order {
                Order::RowsFromTop | Order::RowsFromBottom => StoredRow {
                    bytes: &self.bytes[stored * stride..],
                    stride: size,
                    first: stored * run,
                    step: 1,
                    columns: self.columns,
                },
                Order::ColumnsFromTop | Order::ColumnsFromBottom => StoredRow {
                    bytes: &self.bytes[stored * size..],
                    stride,
                    first: stored,
                    step: run,
                    columns: self.columns,
                },
            };
            self.decode_row(read, &row, &mut decoded);
        }
        decoded
    }

    /// Decodes a row. Values come first and missing points after them, so that rows without any, the rule, are decoded many
    /// points at a time.
    fn decode_row(&self, read: ReadRow, row: &StoredRow<'_>, decoded: &mut Decoded) {
        let start = decoded.values.len();
        read(row, [self.scale, self.zero], &mut decoded.values);
        let numbers = || {
            let mut numbers = Vec::with_capacity(row.columns);
            read(row, [1.0, 0.0], &mut numbers);
            numbers
        };
        match &self.missing {
            MissingMark::None => {}
            MissingMark::Equal(mark) => mark_numbers(&numbers(), |number| number == *mark, start, decoded),
            MissingMark::AtLeast(least) => {
                mark_numbers(&numbers(), |number| number >= *least, start, decoded);
            }
            MissingMark::AtMost(most) => mark_numbers(&numbers(), |number| number <= *most, start, decoded),
            MissingMark::Flagged(flags) => {
                let flagged = (0..row.columns).filter(|at| flags[row.first + at * row.step] != 0);
                flagged.for_each(|at| decoded.set_missing(start + at));
            }
        }
        if !decoded.values[start..].iter().fold(true, |all, value| all & value.is_finite()) {
            for index in start..decoded.values.len() {
                if !decoded.values[index].is_finite() {
                    decoded.set_missing(index);
                }
            }
        }
    }
}

/// A row in a file.
struct StoredRow<'f> {
    /// The file from the first number of the row on.
    bytes: &'f [u8],
    /// Bytes from one number to the next.
    stride: usize,
    /// Place of the first number among all numbers, and numbers from one to the next.
    first: usize,
    step: usize,
    columns: usize,
}

/// Appends the numbers of a row, times a factor and plus a summand. This alone is compiled for every type.
type ReadRow = fn(&StoredRow<'_>, [f64; 2], &mut Vec<f64>);

#[inline(always)]
fn read_row<const N: usize>(
    &StoredRow { bytes, stride, columns, .. }: &StoredRow<'_>,
    [factor, summand]: [f64; 2],
    values: &mut Vec<f64>,
    number: impl Fn([u8; N]) -> f64,
) {
    if stride == N {
        let (stored, _) = bytes[..columns * N].as_chunks();
        values.extend(stored.iter().map(|bytes| number(*bytes) * factor + summand));
    } else {
        let at = |column: usize| bytes[column * stride..].first_chunk();
        let stored = (0..columns).map(|column| at(column).map_or(f64::NAN, |bytes| number(*bytes)));
        values.extend(stored.map(|number| number * factor + summand));
    }
}

/// Takes away the values of those numbers of a row that mark missing points; its first value stands at `start`.
fn mark_numbers(numbers: &[f64], is_missing: impl Fn(f64) -> bool, start: usize, decoded: &mut Decoded) {
    // Without an early end this looks at many points at a time as well.
    if numbers.iter().fold(false, |any, number| any | is_missing(*number)) {
        let marks = numbers.iter().enumerate().filter(|(_, number)| is_missing(**number));
        marks.for_each(|(at, _)| decoded.set_missing(start + at));
    }
}

/// Reverses every row.
fn mirrored(decoded: Decoded, columns: usize) -> Decoded {
    let Decoded { mut values, missing } = decoded;
    values.chunks_exact_mut(columns).for_each(<[f64]>::reverse);
    let opposite = |index: usize| index - index % columns + (columns - 1 - index % columns);
    Decoded { values, missing: missing.indices().map(opposite).collect() }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

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
            missing: MissingMark::Equal(4.0),
            ..Raster::new(NumberType::I16, 3, 2, &bytes[..], 0)
        };
        let values = |order| raster(order).decode(FORMAT).unwrap().values;
        assert_eq!(values(Order::RowsFromTop), [3.0, 5.0, 7.0, 0.0, 11.0, -11.0]);
        assert_eq!(values(Order::RowsFromBottom), [0.0, 11.0, -11.0, 3.0, 5.0, 7.0]);
        assert_eq!(values(Order::ColumnsFromTop), [3.0, 7.0, 11.0, 5.0, 0.0, -11.0]);
        assert_eq!(values(Order::ColumnsFromBottom), [5.0, 0.0, -11.0, 3.0, 7.0, 11.0]);
        let missing = raster(Order::RowsFromBottom).decode(FORMAT).unwrap().missing;
        assert_eq!(missing.indices().collect::<Vec<_>>(), [0]);
        let turned = Raster { is_mirrored: true, ..raster(Order::RowsFromTop) }.decode(FORMAT).unwrap();
        assert_eq!(turned.values, [7.0, 5.0, 3.0, -11.0, 11.0, 0.0]);
        assert_eq!(turned.missing.indices().collect::<Vec<_>>(), [5]);
    }

    #[test]
    fn flags_strides_and_missing_bytes_count() {
        let raster = Raster {
            stride: Some(3),
            missing: MissingMark::Flagged(Cow::Borrowed(&[0, 0, 1, 0])),
            ..Raster::new(NumberType::U8, 2, 2, &[1u8, 2, 99, 3, 4][..], 0)
        };
        let decoded = raster.decode(FORMAT).unwrap();
        assert_eq!((decoded.values, decoded.missing.count()), (vec![1.0, 2.0, 0.0, 4.0], 1));
        let short = Raster { rows: 3, ..raster.clone() };
        assert!(short.decode(FORMAT).unwrap_err().to_string().contains("takes 8 bytes, but the file ends 5"));
        assert!(Raster { rows: usize::MAX, ..raster.clone() }.decode(FORMAT).is_err());
        let void = Raster {
            columns: 0,
            rows: usize::MAX,
            stride: None,
            missing: MissingMark::None,
            ..raster.clone()
        };
        assert_eq!(void.decode(FORMAT).unwrap(), Decoded::default());
        let not_finite = Raster::new(NumberType::F32, 2, 1, f32::NAN.to_le_bytes().repeat(2), 0);
        assert_eq!(not_finite.decode(FORMAT).unwrap().missing.count(), 2);
    }
}
