//! A graph of Gwyddion, `GwyGraphModel`: curves of two arrays each, whose units and title they share.

use super::damage::{bad, missing};
use super::object::{FORMAT, Object, Objects, Value, utf8};
use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, Samples, refuse_many, shortened};
use crate::error::ScanReadError;
use crate::raster::{Decoded, NumberType, Raster};
use crate::readers::measured_line::MeasuredLine;
use units::LengthUnit;

/// A graph as its components describe it.
struct Graph<'b> {
    x_unit: String,
    y_unit: String,
    title: String,
    curves: Option<Objects<'b>>,
}

impl<'b> Graph<'b> {
    fn read(object: Object<'b>) -> Result<Self, ScanReadError> {
        let mut graph =
            Self { x_unit: String::new(), y_unit: String::new(), title: String::new(), curves: None };
        for component in object.components() {
            let component = component?;
            match (component.name, component.value) {
                (b"x_unit", Value::Object(unit)) => graph.x_unit = unit.unit_text()?,
                (b"y_unit", Value::Object(unit)) => graph.y_unit = unit.unit_text()?,
                (b"title", Value::Text(text)) => graph.title = shortened(utf8(text), MOST_TEXT),
                (b"curves", Value::Objects(curves)) => graph.curves = Some(curves),
                _ => {}
            }
        }
        Ok(graph)
    }
}

/// Adds the curves of the graph under a key that are lines of heights. Graphs of anything else, such as distributions,
/// spectra and force curves, add none; what is damaged stands in the way of no other channel.
pub(super) fn add_lines<'b>(
    channels: &mut Vec<Channel<'b>>,
    object: Object<'b>,
    key: &str,
    bytes: &'b [u8],
) -> Result<(), ScanReadError> {
    if object.class != b"GwyGraphModel" {
        return Ok(());
    }
    let graph = match Graph::read(object) {
        Ok(graph) => graph,
        Err(error) => {
            refuse_many(FORMAT, channels.len() + 1)?;
            channels.push(unreadable("", error));
            return Ok(());
        }
    };
    let (Some(x_unit), Some(y_unit)) = (LengthUnit::parse(&graph.x_unit), LengthUnit::parse(&graph.y_unit))
    else {
        return Ok(());
    };
    for (index, curve) in graph.curves.into_iter().flatten().enumerate() {
        refuse_many(FORMAT, channels.len() + 1)?;
        let key = format!("{key}, curve {}", index + 1);
        channels.push(match curve.and_then(Curve::read) {
            Ok(curve) => curve.channel(&graph.title, &key, [x_unit, y_unit], bytes),
            Err(error) => unreadable(&graph.title, error),
        });
    }
    Ok(())
}

fn unreadable<'b>(name: &str, error: ScanReadError) -> Channel<'b> {
    let samples = Samples::Unreadable(Box::new(error));
    Channel::new(Some(name.to_owned()), Quantity::HEIGHTS_IN_M, Lateral::Unknown, samples)
}

/// A curve as its components describe it.
struct Curve {
    description: String,
    /// Offset and count of the numbers of each.
    x: Option<(usize, usize)>,
    y: Option<(usize, usize)>,
}

impl Curve {
    fn read(object: Object) -> Result<Self, ScanReadError> {
        let mut curve = Self { description: String::new(), x: None, y: None };
        for component in object.components() {
            let component = component?;
            match (component.name, component.value) {
                (b"description", Value::Text(text)) => curve.description = shortened(utf8(text), MOST_TEXT),
                (b"xdata", Value::Reals { offset, count }) => curve.x = Some((offset, count)),
                (b"ydata", Value::Reals { offset, count }) => curve.y = Some((offset, count)),
                _ => {}
            }
        }
        Ok(curve)
    }

    fn channel<'b>(
        &self,
        title: &str,
        key: &str,
        [x_unit, y_unit]: [LengthUnit; 2],
        bytes: &'b [u8],
    ) -> Channel<'b> {
        let quantity = Quantity::named(&format!("{title} {}", self.description), "", Some(y_unit));
        let name = if self.description.is_empty() { title } else { &self.description };
        let (lateral, samples, notes) = match self.line(key, x_unit, bytes) {
            Ok(line) => (line.lateral, line.samples, line.notes),
            Err(error) => (Lateral::Unknown, Samples::Unreadable(Box::new(error)), Vec::new()),
        };
        Channel { notes, ..Channel::new(Some(name.to_owned()), quantity, lateral, samples) }
    }

    /// The points at positions in m.
    fn line(&self, key: &str, x_unit: LengthUnit, bytes: &[u8]) -> Result<MeasuredLine, ScanReadError> {
        let (x_offset, points) = self.x.ok_or_else(|| missing(key, "xdata"))?;
        let (y_offset, heights) = self.y.ok_or_else(|| missing(key, "ydata"))?;
        if heights != points {
            let bound = format!("an array of {points} values, as 'xdata' is");
            return Err(bad(key, "'ydata'", format!("an array of {heights} values"), bound));
        }
        let array = |offset| Raster::within(NumberType::F64, points, 1, bytes, offset).decode(FORMAT);
        let positions: Decoded = array(x_offset)?;
        if let Some(point) = positions.missing.indices().next() {
            let found = format!("no number at point {}", point + 1);
            return Err(bad(key, "'xdata'", &found, "an array of finite numbers".to_owned()));
        }
        let Decoded { values, missing } = array(y_offset)?;
        let height = |(point, height): (usize, f64)| (!missing.contains(point)).then_some(height);
        let heights = values.into_iter().enumerate().map(height).collect();
        let positions_m = positions.values.into_iter().map(|position| x_unit.to_m(position)).collect();
        Ok(MeasuredLine::new(positions_m, heights))
    }
}
