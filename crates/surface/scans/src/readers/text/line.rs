//! Heights along a line without positions.

use super::Found;
use super::header::Header;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// Heights at unknown places along a line.
pub(super) fn line_of_heights(
    mut values: Decoded,
    height_unit: Option<LengthUnit>,
    length_m: Option<f64>,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let factor = header.map_heights().1;
    let units = Units::choose(options, header.lateral_unit, height_unit, notes);
    let to_m = units.height_to_m(FORMAT)?;
    let columns = values.values.len();
    notes.extend(header.length_note(columns));
    let stated = length_m.map(|x_m| ScanSize { x_m, y_m: None });
    let size = header.size(columns, 0, &units)?.or(stated);
    values.values.iter_mut().for_each(|value| *value = to_m(*value * factor));
    Ok(Found { columns, lateral: size.map_or(Lateral::Unknown, Lateral::Size), heights_m: values })
}
