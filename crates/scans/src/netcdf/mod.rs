//! Scans in NetCDF classic files, in the layout of contact.engineering: a variable `heights` over `x` and `y`, `x`
//! alone, or `n` with the positions in `x`.

mod classic;
mod cursor;

use crate::choice_of_size;
use crate::choice_of_size::refuse_size;
use crate::choice_of_units::Units;
use crate::error::{Place, ScanReadError};
use crate::file::Reading;
use crate::heights::{NonuniformLineScan, Scan, transposed};
use crate::metadata::{instrument_length_m, probe};
use crate::options::ScanOptions;
use crate::scan_size::ScanSize;
use classic::{Classic, Variable};
use cursor::FORMAT;
use units::LengthUnit;

/// What the dimensions of `heights` make of it.
enum Layout {
    /// Row after row of so many columns.
    Rows(usize),
    /// Column after column of so many rows.
    Columns(usize),
    Line,
    Points,
}

/// Reads the heights; the index of a row is that of `y`.
pub(crate) fn read(bytes: &[u8], options: &ScanOptions) -> Result<Reading, ScanReadError> {
    let file = Classic::read(bytes)?;
    let Some(variable) = file.variable("heights") else {
        let names = file.variables.iter().map(|variable| variable.name.to_string()).collect();
        return Err(ScanReadError::NoChannel {
            format: FORMAT,
            wanted: "variable 'heights', the only one read as such".to_owned(),
            channels: names,
        });
    };
    if let Some(wanted) = options.channel.as_ref().filter(|wanted| *wanted != "heights") {
        let channels = vec!["heights".to_owned()];
        return Err(ScanReadError::NoChannel {
            format: FORMAT,
            wanted: format!("channel '{wanted}'"),
            channels,
        });
    }
    let layout = Layout::of(&file, variable)?;
    let mut notes = Vec::new();
    let units = units(&file, variable, options, &mut notes)?;
    let height_to_m = units.height_to_m(FORMAT)?;
    let mut heights_m = file.values(variable)?;
    heights_m.iter_mut().for_each(|height| *height = height_to_m(*height));
    blank_masked(&file, variable, &mut heights_m)?;
    let scan = match layout {
        Layout::Points => points(&file, &units, options, heights_m)?,
        Layout::Line => size(&file, false, &units, options, &mut notes)?.line(heights_m)?,
        Layout::Rows(columns) => {
            size(&file, true, &units, options, &mut notes)?.map(columns, heights_m, &mut notes)?
        }
        Layout::Columns(rows) => {
            let columns = heights_m.len() / rows;
            let rowwise = transposed(&heights_m, rows);
            size(&file, true, &units, options, &mut notes)?.map(columns, rowwise, &mut notes)?
        }
    };
    let mut reading = Reading::new(scan, notes);
    reading.channels = vec!["heights".to_owned()];
    reading.channel = Some("heights".to_owned());
    reading.is_periodic = is_periodic(&file);
    if let Some(info) = instrument(&file) {
        reading.probe = probe(&info);
        reading.tip_radius_m = instrument_length_m(&info, "tip_radius");
        reading.resolution_m = instrument_length_m(&info, "resolution");
    }
    Ok(reading)
}

impl Layout {
    fn of(file: &Classic, heights: &Variable) -> Result<Self, ScanReadError> {
        let dimensions: Vec<_> = heights.dimensions.iter().map(|&index| &file.dimensions[index]).collect();
        let names: Vec<&str> = dimensions.iter().map(|dimension| &*dimension.name).collect();
        match (names.as_slice(), dimensions.as_slice()) {
            (["x", "y"], [_, y]) if y.length > 0 => Ok(Self::Columns(y.length)),
            (["y", "x"], [_, x]) if x.length > 0 => Ok(Self::Rows(x.length)),
            (["x"], _) => Ok(Self::Line),
            (["n"], _) => Ok(Self::Points),
            _ => Err(ScanReadError::BadField {
                format: FORMAT,
                place: Place::Byte(heights.offset),
                field: "the list of dimensions of 'heights'".to_owned(),
                value: file.dimensions_of(heights),
                bound: "x and y (both above 0), x, or n".to_owned(),
                mend: "name them as contact.engineering does",
            }),
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
        return Err(ScanReadError::BadField {
            format: FORMAT,
            place: Place::File,
            field: "the unit of 'y'".to_owned(),
            value: y.to_string(),
            bound: format!("that of 'x', {x}"),
            mend: "write both in one unit",
        });
    }
    Ok(Units::of(options, x.or(y), height.or(x), notes))
}

fn size(
    file: &Classic,
    is_map: bool,
    units: &Units,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<ScanSize, ScanReadError> {
    let length_m = |name: &str| -> Result<Option<f64>, ScanReadError> {
        let Some(attribute) = file.variable(name).and_then(|variable| variable.attribute("length")) else {
            return Ok(None);
        };
        let length = attribute.number().filter(|length| length.is_finite() && *length > 0.0);
        let length = length.ok_or_else(|| attribute.bad("length", "a finite number above 0"))?;
        Ok(Some(units.length_to_m(FORMAT)?(length)))
    };
    let stated = match (length_m("x")?, if is_map { length_m("y")? } else { None }) {
        (Some(x_m), y_m) if y_m.is_some() == is_map => Some(ScanSize { x_m, y_m }),
        _ => None,
    };
    let what = "the size of the scan (attribute 'length' of 'x' and 'y')";
    choice_of_size::size(options, stated, notes).ok_or(ScanReadError::NoSize { format: FORMAT, what })
}

fn points(
    file: &Classic,
    units: &Units,
    options: &ScanOptions,
    heights_m: Vec<f64>,
) -> Result<Scan, ScanReadError> {
    refuse_size(FORMAT, Place::File, options)?;
    let x = file.variable("x").ok_or_else(|| ScanReadError::MissingField {
        format: FORMAT,
        place: Place::File,
        field: "variable 'x' with the positions of the points".to_owned(),
        mend: "export the line again",
    })?;
    let to_m = units.length_to_m(FORMAT)?;
    let positions_m = file.values(x)?.into_iter().map(to_m).collect();
    Ok(Scan::NonuniformLine(NonuniformLineScan::new(positions_m, heights_m)?))
}

/// Marks the points that the variable `mask` leaves out as undefined.
fn blank_masked(file: &Classic, heights: &Variable, heights_m: &mut [f64]) -> Result<(), ScanReadError> {
    let Some(mask) = file.variable("mask") else { return Ok(()) };
    if mask.dimensions != heights.dimensions {
        return Err(ScanReadError::BadField {
            format: FORMAT,
            place: Place::Byte(mask.offset),
            field: "the list of dimensions of 'mask'".to_owned(),
            value: file.dimensions_of(mask),
            bound: format!("that of 'heights', {}", file.dimensions_of(heights)),
            mend: "write both over the same dimensions",
        });
    }
    let mask = file.values(mask)?;
    for (height, masked) in heights_m.iter_mut().zip(mask) {
        if masked != 0.0 {
            *height = f64::NAN;
        }
    }
    Ok(())
}

fn is_periodic(file: &Classic) -> Option<bool> {
    let of_x = file.variable("x").and_then(|x| x.attribute("periodic"));
    let flag = of_x.or_else(|| file.attribute("periodic"))?.number()?;
    Some(flag != 0.0)
}

/// What a global attribute holds as JSON of the instrument.
fn instrument(file: &Classic) -> Option<serde_json::Value> {
    serde_json::from_str(&file.attribute("json")?.text()?).ok()
}
