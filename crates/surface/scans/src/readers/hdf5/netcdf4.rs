//! NetCDF-4 in the layout of contact.engineering: `heights` over `x` and `y`, over `x` alone, or over points whose
//! positions `x` gives.

use super::FORMAT;
use super::content::{Content, Entry};
use crate::channel::{Channel, Lateral, Quantity, Samples, UnitsBy};
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, Order, Raster};
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// Number that the NetCDF library writes where nobody has written one.
const UNWRITTEN: f64 = 9.969_209_968_386_869e36;

pub(super) fn channels<'b>(
    content: &mut Content,
    heights: usize,
    options: &ScanOptions,
) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut notes = Vec::new();
    let (x, y, mask) = (content.find("x"), content.find("y"), content.find("mask"));
    let unit = |entry: &Entry| match entry.text_of("unit") {
        None => Ok(None),
        Some(name) => match LengthUnit::parse_instrument(&name) {
            Some(unit) => Ok(Some(unit)),
            None => Err(entry.bad(
                "attribute 'unit'",
                format!("'{name}'"),
                &format!("one of {}", LengthUnit::accepted()),
            )),
        },
    };
    let unit_of = |at: Option<usize>| at.map_or(Ok(None), |at| unit(&content.entries[at]));
    let (lateral_unit, height_unit) = (unit_of(x)?.or(unit_of(y)?), unit_of(Some(heights))?);
    let units = Units::choose(options, lateral_unit, height_unit.or(lateral_unit), &mut notes);
    let (length_to_m, height_to_m) = (units.length_to_m(FORMAT)?, units.height_to_m(FORMAT)?);

    let entry = &content.entries[heights];
    let is_map = entry.axes().len() == 2;
    // Points at uneven distances are counted by an axis of their own.
    let is_uneven = !is_map && content.find("n").is_some();
    let length_m = |at: Option<usize>| {
        let length = content.entries[at?].number_of("length").filter(|&length| length > 0.0);
        length.map(&length_to_m)
    };
    let missing = entry.number_of("_FillValue").unwrap_or(UNWRITTEN);
    let (scale, zero) =
        (entry.number_of("scale_factor").unwrap_or(1.0), entry.number_of("add_offset").unwrap_or(0.0));
    let periodic = x.and_then(|x| content.entries[x].number_of("periodic")).map(|flag| flag != 0.0);
    let (x_m, y_m) = (length_m(x), length_m(y));
    let order = if is_map && is_x_slow(entry, content) { Order::ColumnsFromTop } else { Order::RowsFromTop };

    let raster = turned(content.raster(heights)?, order);
    let columns = raster.columns;
    let mut decoded =
        Raster { missing: MissingMark::Equal(missing), scale, zero, ..raster }.decode(FORMAT)?;
    decoded.values.iter_mut().for_each(|height| *height = height_to_m(*height));
    if let Some(mask) = mask {
        let masked = turned(content.raster(mask)?, order).decode(FORMAT)?.values;
        if masked.len() != decoded.values.len() {
            let bound = format!("{}, that of 'heights'", decoded.values.len());
            return Err(content.entries[mask].bad("the number of points", masked.len(), &bound));
        }
        let covered = masked.iter().enumerate().filter(|(_, mask)| **mask != 0.0);
        covered.for_each(|(index, _)| decoded.set_missing(index));
    }
    let lateral = match (is_map, x_m, y_m, x) {
        (true, Some(x_m), Some(y_m), _) => Lateral::Size(ScanSize { x_m, y_m: Some(y_m) }),
        (false, Some(x_m), ..) if !is_uneven => Lateral::Size(ScanSize { x_m, y_m: None }),
        (false, _, _, Some(x)) => {
            Lateral::Positions(content.values(x)?.into_iter().map(&length_to_m).collect())
        }
        _ => Lateral::Unknown,
    };
    let samples = Samples::Decoded { columns, decoded };
    let channel = Channel::new(Some("heights".to_owned()), Quantity::HEIGHTS_IN_M, lateral, samples);
    Ok(vec![Channel { units: UnitsBy::Reader, is_periodic: periodic, notes, ..channel }])
}

/// Returns true if the first axis of the heights is x, as contact.engineering writes them: by the place of the axis
/// among those of the file, else by its length.
fn is_x_slow(heights: &Entry, content: &Content) -> bool {
    let of = |name: &str| content.find(name).map(|at| &content.entries[at]);
    let linked = heights.attribute("DIMENSION_LIST").and_then(|list| {
        let reference = list.raw_data.get(..heights.dataset.vlen_reference_size())?;
        let address = heights.dataset.resolve_vlen_reference_bytes(reference, size_of::<u64>()).ok()?;
        Some(u64::from_le_bytes(*address.first_chunk()?))
    });
    match (linked, of("x"), of("y")) {
        (Some(first), _, Some(y)) if first == y.dataset.address() => false,
        (None, Some(x), Some(y)) => {
            let [first, _] = heights.axes()[..] else { return true };
            !(x.axes() != [first] && y.axes() == [first])
        }
        _ => true,
    }
}

/// A raster whose first index runs along x.
fn turned(raster: Raster<'_>, order: Order) -> Raster<'_> {
    match order {
        Order::RowsFromTop => raster,
        _ => Raster { columns: raster.rows, rows: raster.columns, order, ..raster },
    }
}
