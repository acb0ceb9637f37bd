//! Fast scans of JPK, `.h5-jpk`: a group a measurement with the size of the grid, and a group a channel with counts, a
//! column a frame, and what a count is worth. AFMReader reads it so; a real file showed the rest.

use hdf5_reader::group::Group;

use super::FORMAT;
use super::content::{Content, Entry};
use crate::channel::{Channel, Lateral, Quantity, Samples, ScanAxis, refuse_many};
use crate::error::{FilePlace, ScanReadError};
use crate::metadata::Probe;
use crate::numbers;
use crate::raster::{Order, Raster};
use crate::scan_size::ScanSize;
use units::LengthUnit;

const POINTS: [&str; 2] = ["position-pattern.grid.ilength", "position-pattern.grid.jlength"];
const LENGTHS: [&str; 2] = ["position-pattern.grid.ulength", "position-pattern.grid.vlength"];
const THUMBNAIL: &str = "thumbnail";

pub(super) fn is_measurement(group: &Group) -> bool {
    POINTS.iter().all(|name| group.attribute(name).is_ok())
}

pub(super) fn channels<'b>(content: &mut Content) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut channels = Vec::new();
    for at in 0..content.entries.len() {
        let Some((path, _)) = content.entries[at].path.rsplit_once('/') else { continue };
        let Some((of_measurement, _)) = path.rsplit_once('/') else { continue };
        let group = |path: &str| content.groups.iter().find(|(own, _)| own == path).map(|(_, group)| group);
        let (Some(own), Some(measurement)) = (group(path), group(of_measurement)) else { continue };
        let is_thumbnail = content.entries[at].path.ends_with(THUMBNAIL);
        if is_thumbnail || !is_measurement(measurement) || own.attribute("channel.name").is_err() {
            continue;
        }
        let header = Header::read(own, measurement, &content.entries[at])?;
        let frames = frames(content, at, &header)?;
        refuse_many(FORMAT, channels.len() + frames.len())?;
        let count = frames.len();
        channels.extend(
            frames.into_iter().enumerate().map(|(frame, raster)| header.channel(frame, count, raster)),
        );
    }
    Ok(channels)
}

/// The images of a channel: the numbers of a point stand beside each other, one a frame.
fn frames<'b>(content: &mut Content, at: usize, header: &Header) -> Result<Vec<Raster<'b>>, ScanReadError> {
    let [columns, rows] = header.points;
    let whole = content.raster(at)?;
    let points = columns.saturating_mul(rows);
    let frames = (whole.columns.saturating_mul(whole.rows)).checked_div(points).unwrap_or(0);
    if frames == 0 || frames.saturating_mul(points) != whole.columns * whole.rows {
        let found = format!("{} x {}", whole.rows, whole.columns);
        let bound = format!("{columns} x {rows} for each frame, as the grid has");
        return Err(content.entries[at].bad("the number of points", found, &bound));
    }
    let size = whole.number.bytes();
    let image = |frame: usize| {
        let numbers = whole.bytes.chunks_exact(size * frames).map(|point| &point[frame * size..][..size]);
        Raster {
            byte_order: whole.byte_order,
            order: if header.is_reflected { Order::RowsFromTop } else { Order::RowsFromBottom },
            scale: header.scale,
            zero: header.zero,
            ..Raster::new(whole.number, columns, rows, numbers.collect::<Vec<_>>().concat(), 0)
        }
    };
    Ok((0..frames).map(image).collect())
}

/// Attributes of a channel and of its measurement.
struct Header {
    name: String,
    direction: &'static str,
    unit: String,
    scale: f64,
    zero: f64,
    points: [usize; 2],
    size: ScanSize,
    is_reflected: bool,
}

impl Header {
    fn read(channel: &Group, measurement: &Group, entry: &Entry) -> Result<Self, ScanReadError> {
        let missing = |name: &str| {
            let place = FilePlace::Element(entry.path.clone());
            FORMAT.missing(place, format!("attribute '{name}'"), "export the file again")
        };
        let number = |group: &Group, name: &str| {
            let attribute = group.attribute(name).ok()?;
            attribute.read_as_f64().ok().filter(|number| number.is_finite())
        };
        let text = |group: &Group, name: &str| group.attribute(name).ok()?.read_string().ok();
        let positive =
            |name: &str| number(measurement, name).and_then(numbers::positive).ok_or_else(|| missing(name));
        let net = |what: &str| format!("net-encoder.scaling.{what}");
        let kind = text(channel, &net("type")).unwrap_or_default();
        if kind != "linear" {
            return Err(entry.bad("the scaling", format!("'{kind}'"), "'linear'"));
        }
        let is = |group: &Group, name: &str| text(group, name).is_some_and(|flag| flag == "true");
        let name = text(channel, "channel.fancy-name").or_else(|| text(channel, "channel.name"));
        Ok(Self {
            name: name.ok_or_else(|| missing("channel.name"))?,
            direction: if is(channel, "retrace") { "Retrace" } else { "Trace" },
            unit: text(channel, &net("unit.unit")).unwrap_or_default(),
            scale: number(channel, &net("multiplier")).ok_or_else(|| missing(&net("multiplier")))?,
            zero: number(channel, &net("offset")).unwrap_or(0.0),
            points: [positive(POINTS[0])? as usize, positive(POINTS[1])? as usize],
            size: ScanSize { x_m: positive(LENGTHS[0])?, y_m: Some(positive(LENGTHS[1])?) },
            is_reflected: is(measurement, "position-pattern.grid.reflect"),
        })
    }

    fn channel<'b>(&self, frame: usize, frames: usize, raster: Raster<'b>) -> Channel<'b> {
        let frame = if frames > 1 { format!(" frame {}", frame + 1) } else { String::new() };
        let quantity = Quantity::named(&self.name, &self.unit, LengthUnit::parse(&self.unit));
        let name = Some(format!("{} ({}{frame})", self.name, self.direction));
        Channel {
            probe: Some(Probe::Tip),
            fast_axis: Some(ScanAxis::X),
            ..Channel::new(name, quantity, Lateral::Size(self.size), Samples::Raster(raster))
        }
    }
}
