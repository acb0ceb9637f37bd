//! Files of Gwyddion, as its user guide describes them: a container of objects under keys such as `/0/data`.
//!
//! Images are read, with their titles and masks, and the curves of graphs whose axes are both lengths: into these
//! Gwyddion puts the profiles of other formats. Volume data, spectra and clouds of points are not.

mod damage;
mod field;
mod graph;
mod mask;
mod object;

use std::collections::BTreeMap;

use crate::channel::{
    Channel, Lateral, MOST_TEXT, Quantity, Samples, is_named_after_height, is_named_after_signal,
    refuse_many, shortened,
};
use crate::error::{FilePlace, ScanReadError};
use crate::options::ScanOptions;
use crate::raster::MissingMark;
use crate::readers::Reader;
use field::Field;
use mask::Mask;
use object::{FORMAT, Object, Value, utf8};
use units::LengthUnit;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

const MARK: &[u8] = b"GWYP";
/// First bytes of files of versions before 2.0.
const OLD_MARK: &[u8] = b"GWYO";

fn recognises(bytes: &[u8]) -> bool {
    [MARK, OLD_MARK]
        .iter()
        .any(|mark| bytes.strip_prefix(*mark).is_some_and(|rest| rest.starts_with(b"GwyContainer\0")))
}

/// Key prefix of graphs, whatever they were made from.
const GRAPHS: &str = "/0/graph/graph/";

/// Objects of a file under one number.
#[derive(Default)]
struct Entry<'b> {
    data: Option<Object<'b>>,
    mask: Option<Object<'b>>,
    title: Option<String>,
    meta: Option<Object<'b>>,
}

/// The images in the order of their numbers, then the lines.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut entries: BTreeMap<u32, Entry> = BTreeMap::new();
    let mut graphs: BTreeMap<u32, Object> = BTreeMap::new();
    for component in Object::of_file(bytes)?.components() {
        let component = component?;
        if let (Some(number), Value::Object(object)) = (number_of_graph(component.name), &component.value) {
            graphs.insert(number, *object);
            continue;
        }
        let Some((number, key)) = numbered(component.name) else { continue };
        refuse_many(FORMAT, entries.len())?;
        let entry = entries.entry(number).or_default();
        match (key, component.value) {
            (b"data", Value::Object(object)) => entry.data = Some(object),
            (b"mask", Value::Object(object)) => entry.mask = Some(object),
            (b"data/title", Value::Text(text)) => {
                entry.title = Some(utf8(text));
            }
            (b"meta", Value::Object(object)) => entry.meta = Some(object),
            _ => {}
        }
    }
    let mut channels: Vec<_> = entries
        .into_iter()
        .filter_map(|(number, entry)| entry.data.map(|data| channel(number, data, &entry, bytes)))
        .collect();
    for (number, graph) in graphs {
        graph::add_lines(&mut channels, graph, &format!("{GRAPHS}{number}"), bytes)?;
    }
    if channels.is_empty() {
        return Err(FORMAT.unsupported(
            FilePlace::File,
            "a file without any image or profile, such as one of volume data",
            "save an image of heights, or a graph of heights over a length",
        ));
    }
    Ok(channels)
}

/// The number in a key, and what follows it: `/0/data/title`.
fn numbered(key: &[u8]) -> Option<(u32, &[u8])> {
    let key = key.strip_prefix(b"/")?;
    let slash = key.iter().position(|&byte| byte == b'/')?;
    Some((number(key.get(..slash)?)?, key.get(slash + 1..)?))
}

/// The number of the graph under a key: `/0/graph/graph/1`.
fn number_of_graph(key: &[u8]) -> Option<u32> {
    number(key.strip_prefix(GRAPHS.as_bytes())?)
}

fn number(digits: &[u8]) -> Option<u32> {
    let digits =
        std::str::from_utf8(digits).ok().filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()));
    digits?.parse().ok()
}

fn channel<'b>(number: u32, data: Object<'b>, entry: &Entry<'b>, bytes: &'b [u8]) -> Channel<'b> {
    let key = format!("/{number}/data");
    let name = entry.title.clone();
    let free_text = entry.meta.map(free_text).unwrap_or_default();
    let channel = match read(data, &key, entry, bytes) {
        Ok((field, missing, notes)) => {
            let quantity = quantity(&field, name.as_deref().unwrap_or_default());
            let lateral = field.lateral();
            let samples = Samples::Raster(crate::raster::Raster { missing, ..field.raster });
            Channel { notes, ..Channel::new(name, quantity, lateral, samples) }
        }
        Err(error) => {
            Channel::new(name, Quantity::HEIGHTS_IN_M, Lateral::Unknown, Samples::Unreadable(Box::new(error)))
        }
    };
    Channel { free_text, ..channel }
}

/// The image, its missing points, and the notes on it.
fn read<'b>(
    data: Object<'b>,
    key: &str,
    entry: &Entry<'b>,
    bytes: &'b [u8],
) -> Result<(Field<'b>, MissingMark<'b>, Vec<String>), ScanReadError> {
    let field = Field::read(data, key, bytes)?;
    let Some(mask) = entry.mask else { return Ok((field, MissingMark::None, Vec::new())) };
    let mask = Field::read(mask, &key.replace("data", "mask"), bytes)?;
    let (missing, note) = match Mask::read(&mask.raster, &field.raster)? {
        Mask::Void => (MissingMark::None, None),
        Mask::MissingPoints { flags, count } => {
            let note = format!(
                "{count} points under the mask of the file hold values that were filled in: they count as points without a height"
            );
            (MissingMark::Flagged(flags.into()), Some(note))
        }
        Mask::Marks { count } => {
            let note =
                format!("{count} points are marked by the mask of the file; they have heights, which count");
            (MissingMark::None, Some(note))
        }
    };
    Ok((field, missing, note.into_iter().collect()))
}

/// Classifies an image. Images from elsewhere may have no units at all: then they may be heights.
fn quantity(field: &Field, name: &str) -> Quantity {
    match LengthUnit::parse(&field.value_unit) {
        Some(unit) if is_named_after_signal(name) => Quantity::OtherLength(unit),
        Some(unit) => Quantity::Heights(Some(unit)),
        None if field.value_unit.is_empty() && (is_named_after_height(name) || !field.has_lateral_unit()) => {
            Quantity::Heights(None)
        }
        None => Quantity::Other(field.value_unit.clone()),
    }
}

/// The entries of the metadata, a line each; what is damaged there ends them.
fn free_text(meta: Object) -> String {
    let mut text = String::new();
    for component in meta.components().map_while(Result::ok) {
        if let Value::Text(value) = component.value
            && !value.is_empty()
        {
            text +=
                &format!("{}: {}\n", String::from_utf8_lossy(component.name), String::from_utf8_lossy(value));
        }
    }
    shortened(text, MOST_TEXT)
}
