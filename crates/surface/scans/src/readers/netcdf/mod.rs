//! Scans in NetCDF classic files, in the layout of contact.engineering: a variable `heights` over `x` and `y`, `x`
//! alone, or `n` with the positions in `x`. The gap of a pressed surface is a variable `gap` in the same layout.

mod classic;
mod cursor;
mod kind;

use crate::channel::{Channel, Lateral, Quantity, Samples, UnitsBy};
use crate::choice_of_units::Units;
use crate::error::{FilePlace, ScanReadError};
use crate::heights::transposed;
use crate::metadata::{instrument_length_m, probe};
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use classic::{Classic, Variable};
use cursor::FORMAT;
use units::LengthUnit;

/// Most bytes of a description of an instrument, which takes some kilobytes.
const LONGEST_JSON: usize = 1 << 20;

/// Shape of `heights`, by its dimensions.
enum Layout {
    /// Row after row of so many columns.
    Rows(usize),
    /// Column after column of so many rows.
    Columns(usize),
    Line,
    Points,
}

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(b"CDF") && bytes.get(3).is_some_and(|version| *version < b' ')
}

/// The one channel, `heights` unless the gap is asked for; the index of a row is that of `y`.
fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let file = Classic::read(bytes)?;
    let name = if options.channel.as_deref() == Some("gap") { "gap" } else { "heights" };
    let Some(variable) = file.variable(name) else {
        let names = file.variables.iter().map(|variable| variable.name.to_string()).collect();
        return Err(ScanReadError::NoChannel {
            format: FORMAT,
            wanted: format!("variable '{name}'"),
            channels: names,
        });
    };
    let layout = Layout::read(&file, variable)?;
    let mut notes = Vec::new();
    let units = units(&file, variable, options, &mut notes)?;
    let height_to_m = units.height_to_m(FORMAT)?;
    let by_rows = |values: Vec<f64>| match layout {
        Layout::Columns(rows) => transposed(&values, rows),
        _ => values,
    };
    let heights = by_rows(file.values(variable)?);
    let is_masked = mask(&file, variable)?.map(by_rows);
    let height_m = |index: usize| match &is_masked {
        Some(mask) if mask[index] != 0.0 => None,
        _ => Some(height_to_m(heights[index])),
    };
    let points = heights.len();
    let columns = match layout {
        Layout::Points | Layout::Line => points,
        Layout::Rows(columns) => columns,
        Layout::Columns(rows) => points / rows,
    };
    let decoded: Decoded = (0..points).map(height_m).collect();
    let lateral = match layout {
        Layout::Points => positions(&file, &units)?,
        Layout::Line => size(&file, false, &units)?,
        Layout::Rows(_) | Layout::Columns(_) => size(&file, true, &units)?,
    };
    let info = instrument(&file);
    let length_m = |name: &str| info.as_ref().and_then(|info| instrument_length_m(info, name));
    let samples = Samples::Decoded { columns, decoded };
    Ok(vec![Channel {
        units: UnitsBy::Reader,
        is_periodic: is_periodic(&file),
        probe: info.as_ref().and_then(probe),
        tip_radius_m: length_m("tip_radius"),
        resolution_m: length_m("resolution"),
        notes,
        ..Channel::new(Some(name.to_owned()), Quantity::HEIGHTS_IN_M, lateral, samples)
    }])
}

impl Layout {
    fn read(file: &Classic, heights: &Variable) -> Result<Self, ScanReadError> {
        let dimensions: Vec<_> = heights.dimensions.iter().map(|&index| &file.dimensions[index]).collect();
        let names: Vec<&str> = dimensions.iter().map(|dimension| &*dimension.name).collect();
        match (names.as_slice(), dimensions.as_slice()) {
            (["x", "y"], [_, y]) if y.length > 0 => Ok(Self::Columns(y.length)),
            (["y", "x"], [_, x]) if x.length > 0 => Ok(Self::Rows(x.length)),
            (["x"], _) => Ok(Self::Line),
            (["n"], _) => Ok(Self::Points),
            _ => Err(FORMAT.bad(
                FilePlace::Byte(heights.offset),
                "the list of dimensions of 'heights'",
                file.dimensions_of(heights),
                "x and y (both above 0), x, or n",
                "name them as contact.engineering does",
            )),
        }
    }
}

fn units(
    file: &Classic,
    heights: &Variable,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Units, ScanReadError> {
    let of = |variable: Option<&Variable>| match variable.and_then(|variable| variable.attribute("unit")) {
        None => Ok(None),
        Some(attribute) => match attribute.text().as_deref().and_then(LengthUnit::parse_instrument) {
            Some(unit) => Ok(Some(unit)),
            None => Err(attribute.bad("unit", &format!("one of {}", LengthUnit::accepted()))),
        },
    };
    let (x, y, height) = (of(file.variable("x"))?, of(file.variable("y"))?, of(Some(heights))?);
    if let Some((x, y)) = x.zip(y)
        && x != y
    {
        return Err(FORMAT.bad(
            FilePlace::File,
            "the unit of 'y'",
            y.to_string(),
            format!("that of 'x', {x}"),
            "write both in one unit",
        ));
    }
    Ok(Units::choose(options, x.or(y), height.or(x), notes))
}

fn size(file: &Classic, is_map: bool, units: &Units) -> Result<Lateral, ScanReadError> {
    let length_m = |name: &str| -> Result<Option<f64>, ScanReadError> {
        let Some(attribute) = file.variable(name).and_then(|variable| variable.attribute("length")) else {
            return Ok(None);
        };
        let length = attribute.number().and_then(numbers::positive);
        let length = length.ok_or_else(|| attribute.bad("length", "a finite number above 0"))?;
        Ok(Some(units.length_to_m(FORMAT)?(length)))
    };
    Ok(match (length_m("x")?, if is_map { length_m("y")? } else { None }) {
        (Some(x_m), y_m) if y_m.is_some() == is_map => Lateral::Size(ScanSize { x_m, y_m }),
        _ => Lateral::Unknown,
    })
}

fn positions(file: &Classic, units: &Units) -> Result<Lateral, ScanReadError> {
    let x = file.variable("x").ok_or_else(|| {
        let mend = "export the line again";
        FORMAT.missing(FilePlace::File, "variable 'x' with the positions of the points", mend)
    })?;
    let to_m = units.length_to_m(FORMAT)?;
    Ok(Lateral::Positions(file.values(x)?.into_iter().map(to_m).collect()))
}

/// Other than 0 for each point that the variable `mask` leaves out.
fn mask(file: &Classic, heights: &Variable) -> Result<Option<Vec<f64>>, ScanReadError> {
    let Some(mask) = file.variable("mask") else { return Ok(None) };
    if mask.dimensions != heights.dimensions {
        return Err(FORMAT.bad(
            FilePlace::Byte(mask.offset),
            "the list of dimensions of 'mask'",
            file.dimensions_of(mask),
            format!("that of 'heights', {}", file.dimensions_of(heights)),
            "write both over the same dimensions",
        ));
    }
    file.values(mask).map(Some)
}

fn is_periodic(file: &Classic) -> Option<bool> {
    let of_x = file.variable("x").and_then(|x| x.attribute("periodic"));
    let flag = of_x.or_else(|| file.attribute("periodic"))?.number()?;
    Some(flag != 0.0)
}

/// Returns a global attribute that describes the instrument as JSON.
fn instrument(file: &Classic) -> Option<serde_json::Value> {
    serde_json::from_str(&file.attribute("json")?.text().filter(|text| text.len() <= LONGEST_JSON)?).ok()
}
