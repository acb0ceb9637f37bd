//! Binary waves of Igor Pro, as WaveMetrics' technical note 003 describes them, with what Asylum Research adds to them.
//!
//! Versions 1, 2 and 3, which hold lines, and 5, which holds images, in both orders of bytes; complex numbers and texts
//! are not read.

mod asylum;
mod wave;

use crate::channel::{
    Channel, Lateral, MOST_TEXT, Quantity, Samples, ScanAxis, is_named_after_height, is_named_after_signal,
    shortened,
};
use crate::error::{FilePlace, ScanReadError};
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::readers::Reader;
use asylum::Note;
use units::LengthUnit;
use wave::{FORMAT, Wave};

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    wave::version(bytes).is_some()
}

/// Instruments have some dozens of channels; a wave of more layers is something else, such as a map of force curves.
const MOST_CHANNELS: usize = 256;

/// Use of the dimensions of a wave.
struct Shape {
    columns: usize,
    /// None for a line.
    rows: Option<usize>,
    channels: usize,
    /// The dimension whose elements are the channels.
    channel_dimension: usize,
}

/// The channels: layers of a stack of images, columns of a table of lines, or the whole wave.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let wave = Wave::read(bytes)?;
    let shape = shape(&wave)?;
    let note = Note::parse(&wave.note);
    (0..shape.channels).map(|layer| channel(bytes, &wave, &shape, note.as_ref(), layer)).collect()
}

fn shape(wave: &Wave) -> Result<Shape, ScanReadError> {
    let shape = match wave.points {
        [columns, 0, ..] => Shape { columns, rows: None, channels: 1, channel_dimension: 1 },
        [columns, count, 0, _] if is_table(wave) => {
            Shape { columns, rows: None, channels: count, channel_dimension: 1 }
        }
        [columns, rows, 0, _] => Shape { columns, rows: Some(rows), channels: 1, channel_dimension: 2 },
        [columns, rows, channels, 0] => Shape { columns, rows: Some(rows), channels, channel_dimension: 2 },
        _ => return Err(unsupported("a wave of four dimensions".to_owned())),
    };
    if shape.channels > MOST_CHANNELS {
        return Err(unsupported(format!("a wave of {} layers", shape.channels)));
    }
    Ok(shape)
}

/// Returns true if the columns of a wave of two dimensions are separate lines: they have names, or there is a length
/// along the first dimension but none along the second, and not as many columns as points.
fn is_table(wave: &Wave) -> bool {
    let is_length = |dimension: usize| LengthUnit::parse(&wave.step_units[dimension]).is_some();
    !wave.labels[1].is_empty() || (is_length(0) && !is_length(1) && wave.points[0] != wave.points[1])
}

fn unsupported(found: String) -> ScanReadError {
    FORMAT.unsupported(FilePlace::File, found, "save an image of heights")
}

fn channel<'b>(
    bytes: &'b [u8],
    wave: &Wave,
    shape: &Shape,
    note: Option<&Note>,
    layer: usize,
) -> Result<Channel<'b>, ScanReadError> {
    let label = wave.labels.get(shape.channel_dimension).and_then(|labels| labels.get(layer));
    let is_named = label.is_some_and(|label| !label.is_empty());
    let name = label.filter(|_| is_named).or(Some(&wave.name).filter(|_| shape.channels == 1)).cloned();
    let name = name.unwrap_or_else(|| format!("layer {}", layer + 1));
    let named = note.filter(|_| is_named);
    let unit = named.map_or(wave.value_unit.as_str(), |note| note.unit(&name));
    let quantity = quantity(unit, &name, named.is_some(), &wave.step_units[0]);
    let raster = wave.raster(bytes, shape.columns, shape.rows.unwrap_or(1), layer)?;
    let channel = Channel::new(Some(name), quantity, lateral(wave, shape), Samples::Raster(raster));
    Ok(Channel {
        probe: note.map(|_| Probe::Tip),
        fast_axis: note.filter(|note| note.has_fast_axis() && shape.rows.is_some()).map(|_| ScanAxis::X),
        free_text: match note {
            Some(note) => shortened(note.free_text(), MOST_TEXT),
            None => wave.note[..wave.note.floor_char_boundary(MOST_TEXT)].to_owned(),
        },
        ..channel
    })
}

/// Classifies a channel by its unit and name. Units are SI here: A is the ampere.
fn quantity(unit: &str, name: &str, is_scan: bool, step_unit: &str) -> Quantity {
    let is_over_length = step_unit.is_empty() || LengthUnit::parse(step_unit).is_some();
    match LengthUnit::parse(unit) {
        _ if !is_over_length => Quantity::Other(unit.to_owned()),
        Some(unit) if is_named_after_signal(name) || (is_scan && !is_named_after_height(name)) => {
            Quantity::OtherLength(unit)
        }
        Some(unit) => Quantity::Heights(Some(unit)),
        None if unit.is_empty() && !is_scan => Quantity::Heights(None),
        None => Quantity::Other(unit.to_owned()),
    }
}

/// A step is the distance of neighbours, whose sign tells only where the scan began.
fn lateral(wave: &Wave, shape: &Shape) -> Lateral {
    let [x, y, ..] = &wave.step_units;
    let along = |unit: &str, step: f64| numbers::positive(LengthUnit::parse(unit)?.to_m(step.abs()));
    let x_m = along(x, wave.steps[0]);
    let y_m = along(if y.is_empty() { x } else { y }, wave.steps[1]);
    match (x_m, y_m, shape.rows) {
        (Some(x_m), _, None) => Lateral::Spacing { x_m, y_m: None },
        (Some(x_m), Some(y_m), Some(_)) => Lateral::Spacing { x_m, y_m: Some(y_m) },
        _ => Lateral::Unknown,
    }
}
