//! An image of Gwyddion, `GwyDataField`: a grid, its size, the units, the values.

use super::damage::{bad, missing};
use super::object::{Object, Value};
use crate::channel::Lateral;
use crate::cursor::latin1;
use crate::error::ScanReadError;
use crate::raster::{NumberType, Raster};
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// An image as its components describe it.
pub(super) struct Field<'b> {
    /// Along x and y, in the unit of lengths.
    size: [f64; 2],
    lateral_unit: String,
    /// Empty where it has none.
    pub(super) value_unit: String,
    pub(super) raster: Raster<'b>,
}

impl<'b> Field<'b> {
    /// Reads the image under a key of the file.
    pub(super) fn read(object: Object<'b>, key: &str, bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        if object.class != b"GwyDataField" {
            let found = format!("an object of class '{}'", latin1(object.class));
            return Err(bad(key, "the image", &found, "an object of class 'GwyDataField'".to_owned()));
        }
        let (mut columns, mut rows, mut values) = (None, None, None);
        let mut size = [1.0; 2];
        let (mut lateral_unit, mut value_unit) = (String::new(), String::new());
        for component in object.components() {
            let component = component?;
            match (component.name, component.value) {
                (b"xres", Value::Integer(count)) => columns = Some(count),
                (b"yres", Value::Integer(count)) => rows = Some(count),
                (b"xreal", Value::Real(length)) => size[0] = length,
                (b"yreal", Value::Real(length)) => size[1] = length,
                (b"si_unit_xy", Value::Object(unit)) => lateral_unit = unit.unit_text()?,
                (b"si_unit_z", Value::Object(unit)) => value_unit = unit.unit_text()?,
                (b"data", Value::Reals { offset, count }) => values = Some((offset, count)),
                _ => {}
            }
        }
        let columns = points(key, "xres", columns)?;
        let rows = points(key, "yres", rows)?;
        let (offset, count) = values.ok_or_else(|| missing(key, "data"))?;
        if columns.checked_mul(rows) != Some(count) {
            let bound = format!("an array of the {columns} x {rows} values of 'xres' and 'yres'");
            return Err(bad(key, "'data'", format!("an array of {count} values"), bound));
        }
        let raster = Raster::within(NumberType::F64, columns, rows, bytes, offset);
        Ok(Self { size, lateral_unit, value_unit, raster })
    }

    /// Returns the places of the points; images without a unit of length may count in anything, such as pixels.
    /// Gwyddion itself takes a negative size for its amount.
    pub(super) fn lateral(&self) -> Lateral {
        let Some(unit) = LengthUnit::parse(&self.lateral_unit) else { return Lateral::Unknown };
        let [x_m, y_m] = self.size.map(|length| unit.to_m(length.abs()));
        if [x_m, y_m].iter().all(|length| length.is_finite() && *length > 0.0) {
            Lateral::Size(ScanSize { x_m, y_m: Some(y_m) })
        } else {
            Lateral::Unknown
        }
    }

    pub(super) fn has_lateral_unit(&self) -> bool {
        !self.lateral_unit.is_empty()
    }
}

fn points(key: &str, name: &str, found: Option<i64>) -> Result<usize, ScanReadError> {
    let found = found.ok_or_else(|| missing(key, name))?;
    let count = usize::try_from(found).ok().filter(|&count| count > 0);
    count.ok_or_else(|| bad(key, &format!("'{name}'"), found, "a whole number above 0"))
}
