//! The data of points, in a file of the archive or listed in the XML.

use super::FORMAT;
use super::axis::Coordinate;
use super::description::{Description, Points};
use crate::archive::Archive;
use crate::cursor::ByteOrder;
use crate::error::{FilePlace, ScanReadError};
use crate::raster::{Decoded, Raster};

/// The data in m, those of an even axis left out.
#[derive(Default)]
pub(super) struct Data {
    pub(super) x_m: Vec<f64>,
    pub(super) y_m: Vec<f64>,
    pub(super) z_m: Decoded,
}

impl Description {
    pub(super) fn data(&self, archive: &mut Archive) -> Result<Data, ScanReadError> {
        let fields = [self.x.given(), self.y.given(), Some(self.z)];
        match &self.points {
            Points::Binary { data, valid } => self.binary(fields, archive, data, valid.as_deref()),
            Points::Listed(points) => self.listed(fields, points),
        }
    }

    fn binary(
        &self,
        fields: [Option<Coordinate>; 3],
        archive: &mut Archive,
        path: &str,
        valid: Option<&str>,
    ) -> Result<Data, ScanReadError> {
        let points = self.columns.checked_mul(self.rows);
        let size: usize = fields.iter().flatten().map(|field| field.number.bytes()).sum();
        let bytes = archive.read(path)?;
        let needed = points.and_then(|points| points.checked_mul(size));
        let bytes = needed.and_then(|needed| bytes.get(..needed)).ok_or_else(|| {
            truncated(format!("{} x {} points in '{path}'", self.columns, self.rows), needed, bytes.len())
        })?;
        let bits = valid.map(|path| archive.read(path)).transpose()?;
        let needed = (bytes.len() / size).div_ceil(8);
        if let (Some(bits), Some(path)) = (&bits, valid)
            && bits.len() < needed
        {
            return Err(truncated(format!("a bit for each point in '{path}'"), Some(needed), bits.len()));
        }
        let is_valid =
            |index: usize| bits.as_ref().is_none_or(|bits| bits[index / 8] >> (index % 8) & 1 == 1);
        if let ([None, None, Some(z)], None) = (fields, &bits) {
            let raster = Raster::new(z.number, self.columns, self.rows, bytes, 0);
            let raster = Raster { scale: z.increment, zero: z.offset, ..raster };
            return Ok(Data { z_m: raster.decode(FORMAT)?, ..Data::default() });
        }
        let mut start = 0;
        let [x_m, y_m, values] = fields.map(|field| {
            let mut values_m = Vec::new();
            if let Some(Coordinate { number, increment, offset }) = field {
                let places = [size, bytes.len() / size];
                number.read(ByteOrder::Little, &bytes[start..], places, [increment, offset], &mut values_m);
                start += number.bytes();
            }
            values_m
        });
        let mut z_m = Decoded { values, ..Decoded::default() };
        for index in 0..z_m.values.len() {
            if !(is_valid(index) && z_m.values[index].is_finite()) {
                z_m.set_missing(index);
            }
        }
        Ok(Data { x_m, y_m, z_m })
    }

    fn listed(
        &self,
        fields: [Option<Coordinate>; 3],
        points: &[Option<Vec<f64>>],
    ) -> Result<Data, ScanReadError> {
        let bad = |field: &str, value: String, bound: String| {
            let mend = "export the file again";
            FORMAT.bad(FilePlace::Element("Record3/DataList".to_owned()), field, value, bound, mend)
        };
        if Some(points.len()) != self.columns.checked_mul(self.rows) {
            let bound = format!("{} x {}, as the dimensions say", self.columns, self.rows);
            return Err(bad("the number of points", points.len().to_string(), bound));
        }
        let expected = fields.iter().flatten().count();
        let mut data = Data::default();
        for point in points {
            if let Some(point) = point
                && point.len() != expected
            {
                return Err(bad(
                    "the number of values of a point",
                    point.len().to_string(),
                    expected.to_string(),
                ));
            }
            let mut values = point.iter().flatten();
            let mut next = |field: Coordinate| values.next().map(|&value| field.length_m(value));
            // An invalid point has no position either: the line leaves it out.
            data.x_m.extend(fields[0].map(|field| next(field).unwrap_or_default()));
            data.y_m.extend(fields[1].map(|field| next(field).unwrap_or_default()));
            data.z_m.push(next(self.z));
        }
        Ok(data)
    }
}

fn truncated(what: String, needed: Option<usize>, available: usize) -> ScanReadError {
    let needed = needed.map_or(u64::MAX, |needed| needed as u64);
    ScanReadError::Truncated { format: FORMAT, offset: 0, what, needed, available: available as u64 }
}
