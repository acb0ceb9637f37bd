//! Digital Surf, the format of MountainsMap that many instruments write: `.sur` of maps, `.pro` of profiles.
//!
//! A file is a sequence of objects, each with a header of 512 bytes, a comment, a private zone, and counts of 16 or 32
//! bits, as the description of the format in the guide of MountainsMap lays it down and the readers of Gwyddion,
//! RosettaSciIO and SurfaceTopography take it.

mod counts;
mod header;

use header::Header;

use crate::channel::{Channel, Lateral, Quantity, Samples, refuse_many};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::numbers;
use crate::options::ScanOptions;
use crate::readers::Reader;
use crate::room::Room;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::DigitalSurf;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(header::PLAIN) || bytes.starts_with(header::PACKED)
}

/// A channel an object: the surfaces of a series, the layers of one measurement.
fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut channels = Vec::new();
    let mut room = Room::new(options.unpacked_bound());
    let (first, mut end) = object(bytes, 0, &mut room)?;
    let announced = first.objects;
    channels.push(first.channel);
    while bytes.get(end..).is_some_and(recognises) {
        refuse_many(FORMAT, channels.len() + 1)?;
        match object(bytes, end, &mut room) {
            Ok((next, next_end)) => {
                channels.push(next.channel);
                end = next_end;
            }
            Err(error) => {
                channels.push(unreadable(error));
                break;
            }
        }
    }
    number(&mut channels);
    let found = channels.len();
    if found < announced {
        let note = format!("the file announces {announced} objects, but holds {found}");
        channels.iter_mut().for_each(|channel| channel.notes.push(note.clone()));
    }
    Ok(channels)
}

/// An object with the fields of its header that concern the whole file.
struct Object<'b> {
    channel: Channel<'b>,
    objects: usize,
}

/// The object that begins at a byte of the file, and where the next one begins.
fn object<'b>(bytes: &'b [u8], offset: usize, room: &mut Room) -> Result<(Object<'b>, usize), ScanReadError> {
    let header = Header::read(bytes, offset)?;
    let (samples, end) = counts::samples(&header, bytes, room)?;
    let mut notes = Vec::new();
    if header.inversion.turns_heights() {
        notes.push("the file marks its heights as inverted; they are turned back".to_owned());
    }
    let quantity = quantity(&header);
    let lateral = lateral(&header, &mut notes);
    let channel = Channel {
        probe: header.probe(),
        free_text: header.comment.clone(),
        notes,
        ..Channel::new(Some(header.axis.clone()), quantity, lateral, samples)
    };
    Ok((Object { channel, objects: header.objects }, end))
}

/// Counts with a unit of length are heights, unless the object is an image.
fn quantity(header: &Header) -> Quantity {
    let unit = &header.units[2];
    match LengthUnit::parse_instrument(unit) {
        _ if header.is_image() => Quantity::Other(unit.clone()),
        Some(unit) => Quantity::Heights(Some(unit)),
        None if unit.is_empty() => Quantity::Heights(None),
        None => Quantity::Other(unit.clone()),
    }
}

fn lateral(header: &Header, notes: &mut Vec<String>) -> Lateral {
    let mut spacing_m = |axis: usize| {
        let (spacing, unit) = (f64::from(header.spacings[axis]), &header.units[axis]);
        let found = LengthUnit::parse_instrument(unit).map(|unit| unit.to_m(spacing.abs()));
        let found = found.and_then(numbers::positive);
        if found.is_none() {
            notes.push(format!("the spacing {spacing} '{unit}' of points in the file is not above 0"));
        }
        found
    };
    match spacing_m(0) {
        None => Lateral::Unknown,
        Some(x_m) if header.rows == 1 => Lateral::Spacing { x_m, y_m: None },
        Some(x_m) => match spacing_m(1) {
            None => Lateral::Unknown,
            y_m => Lateral::Spacing { x_m, y_m },
        },
    }
}

fn unreadable<'b>(error: ScanReadError) -> Channel<'b> {
    let samples = Samples::Unreadable(Box::new(error));
    Channel::new(None, Quantity::HEIGHTS_IN_M, Lateral::Unknown, samples)
}

/// Tells objects apart that have the same axis or none.
fn number(channels: &mut [Channel]) {
    if channels.len() < 2 {
        return;
    }
    for (index, channel) in channels.iter_mut().enumerate() {
        let name = channel.name.take().unwrap_or_else(|| "object".to_owned());
        channel.name = Some(format!("{name} {}", index + 1));
    }
}
