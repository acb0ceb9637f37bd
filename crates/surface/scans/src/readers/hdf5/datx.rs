//! Zygo's `.datx`, as SurfaceTopography reads it: a dataset below `Data/Surface` with its unit, the number for no
//! height, and how its indices become lengths as attributes.

use hdf5_reader::Datatype;

use super::content::{Content, Entry};
use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::error::ScanReadError;
use crate::format::UNCHECKED;
use crate::metadata::Probe;
use crate::numbers;
use crate::raster::{MissingMark, Raster};
use units::LengthUnit;

const FOLDER: &str = "Data/Surface/";
const CONVERTERS: [&str; 2] = ["X Converter", "Y Converter"];

pub(super) fn is_surface(entry: &Entry) -> bool {
    entry.path.starts_with(FOLDER) && CONVERTERS.iter().all(|name| entry.attribute(name).is_some())
}

pub(super) fn channels<'b>(content: &mut Content) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let surfaces: Vec<usize> =
        (0..content.entries.len()).filter(|&at| is_surface(&content.entries[at])).collect();
    surfaces.into_iter().map(|at| channel(content, at)).collect()
}

fn channel<'b>(content: &mut Content, at: usize) -> Result<Channel<'b>, ScanReadError> {
    let raster = content.raster(at)?;
    let entry = &content.entries[at];
    let lengths_m = CONVERTERS.map(|name| pixel_m(entry, name));
    let [x_m, y_m] = lengths_m;
    let lateral = Lateral::Spacing { x_m: x_m?, y_m: Some(y_m?) };
    let name = entry.text_of("Unit").unwrap_or_default();
    let unit = LengthUnit::parse_instrument(&name).ok_or_else(|| {
        entry.bad("the unit", format!("'{name}'"), &format!("one of {}", LengthUnit::accepted()))
    })?;
    let missing = entry.number_of("No Data").map_or(MissingMark::None, MissingMark::Equal);
    let samples = Samples::Raster(Raster { missing, ..raster });
    let quantity = Quantity::Heights(Some(unit));
    // Other layouts of HDF5 were checked, this one was not.
    let (probe, notes) = (Some(Probe::Microscope), vec![UNCHECKED.to_owned()]);
    Ok(Channel { probe, notes, ..Channel::new(Some("Surface".to_owned()), quantity, lateral, samples) })
}

/// The length of a pixel in m, the second of the parameters of a converter.
fn pixel_m(entry: &Entry, name: &str) -> Result<f64, ScanReadError> {
    let bad = |found: &str| {
        entry.bad(&format!("'{name}'"), found, "a category, the unit 'Pixels' and their length in m")
    };
    let attribute = entry.attribute(name).ok_or_else(|| bad("nothing"))?;
    let Datatype::Compound { fields, .. } = &attribute.datatype else { return Err(bad("no compound")) };
    let raw = |at: usize| {
        let field = fields.get(at)?;
        Some((&field.datatype, attribute.raw_data.get(field.byte_offset as usize..)?))
    };
    let unit = raw(1).and_then(|(kind, raw)| text(entry, kind, raw)).unwrap_or_default();
    if unit != "Pixels" {
        return Err(bad(&format!("in '{unit}'")));
    }
    let last = fields.len().saturating_sub(1);
    let parameters = raw(last).and_then(|(kind, raw)| numbers(entry, kind, raw)).unwrap_or_default();
    let length_m = parameters.get(1).copied().and_then(numbers::positive);
    length_m.ok_or_else(|| bad(&format!("{parameters:?}")))
}

/// A text of fixed length or elsewhere in the file.
fn text(entry: &Entry, kind: &Datatype, raw: &[u8]) -> Option<String> {
    let bytes = match kind {
        Datatype::VarLen { .. } => elsewhere(entry, raw, 1)?,
        Datatype::String { .. } => raw.to_vec(),
        _ => return None,
    };
    Some(crate::cursor::latin1(&bytes))
}

/// Doubles in an array of fixed length or elsewhere in the file.
fn numbers(entry: &Entry, kind: &Datatype, raw: &[u8]) -> Option<Vec<f64>> {
    let bytes = match kind {
        Datatype::VarLen { .. } => elsewhere(entry, raw, size_of::<f64>())?,
        Datatype::Array { .. } => raw.to_vec(),
        _ => return None,
    };
    let (numbers, _) = bytes.as_chunks();
    Some(numbers.iter().map(|number| f64::from_le_bytes(*number)).collect())
}

/// Returns the text that a reference of variable length points to.
fn elsewhere(entry: &Entry, raw: &[u8], element: usize) -> Option<Vec<u8>> {
    let reference = raw.get(..entry.dataset.vlen_reference_size())?;
    entry.dataset.resolve_vlen_reference_bytes(reference, element).ok()
}
