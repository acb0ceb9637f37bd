//! Images of WSxM, `.stp`, `.top`, `.tom`: a header in sections, then the numbers of one channel.
//!
//! The layout is that which Gwyddion's importer and SurfaceTopography's reader follow.

use crate::channel::{Channel, Lateral, Quantity, Samples, ScanAxis};
use crate::cursor::latin1;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use crate::readers::sections::Sections;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Wsxm;
const INFO: &str = "General Info";
const CONTROL: &str = "Control";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// Its texts are read as any text is.
fn recognises(bytes: &[u8]) -> bool {
    let is_text =
        || bytes.split(|&byte| byte == b'\n').nth(1).is_some_and(|line| line.starts_with(b"WSxM ASCII"));
    bytes.starts_with(b"WSxM file copyright") && !is_text()
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    refuse_other_kinds(bytes)?;
    let header = Sections::read(FORMAT, bytes, ':', b"[Header end]")?;
    let name = header.get(INFO, "Acquisition channel").unwrap_or_default();
    let amplitude = Amount::parse(&header, INFO, "Z Amplitude")?;
    let quantity = Quantity::named(name, amplitude.unit, LengthUnit::parse(amplitude.unit));
    let columns = header.count(INFO, "Number of columns")?;
    let rows = header.count(INFO, "Number of rows")?;
    let raster = raster(&header, bytes, columns, rows, amplitude.value)?;
    let mut notes = Vec::new();
    let lateral = size(&header, &mut notes)?.map_or(Lateral::Unknown, Lateral::Size);
    let samples = Samples::Raster(raster);
    Ok(vec![Channel {
        probe: Some(Probe::Tip),
        fast_axis: (rows > 1).then_some(ScanAxis::X),
        free_text: header.get("Miscellaneous", "Comments").unwrap_or_default().to_owned(),
        notes,
        ..Channel::new(Some(name.to_owned()), quantity, lateral, samples)
    }])
}

/// The second line separates images from curves and movies.
fn refuse_other_kinds(bytes: &[u8]) -> Result<(), ScanReadError> {
    let line = bytes.split(|&byte| byte == b'\n').nth(1).map(latin1).unwrap_or_default();
    if line == "SxM Image file" {
        return Ok(());
    }
    let mend = "export an image of heights";
    Err(FORMAT.unsupported(FilePlace::Line(2), format!("a file of kind {}", quoted(&line)), mend))
}

/// A number with its unit.
struct Amount<'h> {
    value: f64,
    unit: &'h str,
}

impl<'h> Amount<'h> {
    fn parse(header: &'h Sections, section: &str, key: &str) -> Result<Self, ScanReadError> {
        let text = header.require(section, key)?;
        let (number, unit) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let value = number.parse().ok().filter(|value: &f64| value.is_finite() && *value >= 0.0);
        let value =
            value.ok_or_else(|| header.bad(section, key, text, "a number of at least 0 with its unit"))?;
        Ok(Self { value, unit: unit.trim() })
    }
}

/// The numbers, from the last point of the image to its first; their scale is in the unit of the amplitude.
fn raster<'b>(
    header: &Sections,
    bytes: &'b [u8],
    columns: usize,
    rows: usize,
    amplitude: f64,
) -> Result<Raster<'b>, ScanReadError> {
    const TYPE: &str = "Image Data Type";
    let number = match header.get(INFO, TYPE).unwrap_or("short") {
        "short" | "integer" => NumberType::I16,
        "float" => NumberType::F32,
        "double" => NumberType::F64,
        other => return Err(header.bad(INFO, TYPE, other, "short, integer, float or double")),
    };
    let rest = bytes.get(header.end..).unwrap_or_default();
    let line_end = if rest.starts_with(b"\r\n") { 2 } else { usize::from(rest.starts_with(b"\n")) };
    let raster = Raster {
        order: Order::RowsFromBottom,
        is_mirrored: true,
        ..Raster::within(number, columns, rows, bytes, header.end + line_end)
    };
    // Counts spread over the amplitude; other numbers have its unit already.
    let scale = if number == NumberType::I16 {
        let values = raster.decode(FORMAT)?.values;
        let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
        let range = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - lowest;
        if range > 0.0 { amplitude / range } else { 0.0 }
    } else {
        1.0
    };
    Ok(Raster { scale, ..raster })
}

/// Sizes along x and y; a scan of which only one is given is square.
fn size(header: &Sections, notes: &mut Vec<String>) -> Result<Option<ScanSize>, ScanReadError> {
    let along = |key: &str| -> Result<Option<f64>, ScanReadError> {
        let amount = Amount::parse(header, CONTROL, key)?;
        let length_m = LengthUnit::parse(amount.unit).map(|unit| unit.to_m(amount.value));
        Ok(length_m.filter(|length_m| *length_m > 0.0))
    };
    if header.get(CONTROL, "X Amplitude").is_none() {
        return Ok(None);
    }
    let x_m = along("X Amplitude")?;
    let y_m = if header.get(CONTROL, "Y Amplitude").is_some() {
        along("Y Amplitude")?
    } else {
        notes.push("the file does not give the size along y: the scan is taken to be square".to_owned());
        x_m
    };
    Ok(x_m.zip(y_m).map(|(x_m, y_m)| ScanSize { x_m, y_m: Some(y_m) }))
}
