//! Gwyddion Simple Field, `.gsf`, as Gwyddion's user guide lays it down: lines of keys and values, then
//! single-precision numbers row after row from the top.

use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, Samples, shortened};
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Gsf;
/// The first line.
pub(crate) const TITLE: &str = "Gwyddion Simple Field 1.0\n";
/// The header ends in zero bytes, one at least, so that the numbers begin at a multiple of these bytes.
pub(crate) const ALIGNMENT: usize = 4;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(TITLE.as_bytes())
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let end = bytes.iter().position(|&byte| byte == 0);
    let end = end.ok_or_else(|| missing("zero byte behind the header"))?;
    let header = Header(String::from_utf8_lossy(&bytes[..end]).into_owned());
    let (columns, rows) = (header.count("XRes")?, header.count("YRes")?);
    let (x_m, y_m) = (header.length_m("XReal")?, header.length_m("YReal")?);
    let lateral = match (x_m, y_m) {
        (Some(x_m), Some(y_m)) => Lateral::Size(ScanSize { x_m, y_m: Some(y_m) }),
        _ => Lateral::Unknown,
    };
    let title = header.value("Title").unwrap_or_default();
    let quantity = match header.value("ZUnits") {
        None | Some("") => Quantity::Heights(None),
        Some(unit) => Quantity::named(title, unit, LengthUnit::parse(unit)),
    };
    let start = (end / ALIGNMENT + 1) * ALIGNMENT;
    let samples = Samples::Raster(Raster::within(NumberType::F32, columns, rows, bytes, start));
    let comment = header.value("Comment").unwrap_or_default().to_owned();
    let free_text = shortened(comment, MOST_TEXT);
    Ok(vec![Channel { free_text, ..Channel::new(Some(title.to_owned()), quantity, lateral, samples) }])
}

/// The lines with keys and values.
struct Header(String);

impl Header {
    fn value(&self, key: &str) -> Option<&str> {
        let entries = self.0.lines().filter_map(|line| line.split_once('='));
        entries
            .map(|(own, value)| (own.trim(), value.trim()))
            .find(|(own, _)| *own == key)
            .map(|(_, value)| value)
    }

    fn count(&self, key: &str) -> Result<usize, ScanReadError> {
        let text = self.value(key).ok_or_else(|| missing(key))?;
        numbers::count(text).ok_or_else(|| bad(key, text, "a whole number above 0"))
    }

    /// A lateral size; none where the file gives none, or in another unit than one of length.
    fn length_m(&self, key: &str) -> Result<Option<f64>, ScanReadError> {
        let unit = self.value("XYUnits").and_then(LengthUnit::parse);
        let (Some(text), Some(unit)) = (self.value(key), unit) else { return Ok(None) };
        let size = numbers::finite(text).and_then(numbers::positive);
        size.map(|size| Some(unit.to_m(size))).ok_or_else(|| bad(key, text, "a number above 0"))
    }
}

fn missing(field: &str) -> ScanReadError {
    FORMAT.missing(FilePlace::File, field, "export the file again")
}

fn bad(key: &str, text: &str, bound: &str) -> ScanReadError {
    FORMAT.bad(FilePlace::Element(key.to_owned()), "the value", quoted(text), bound, "export the file again")
}
