//! A file of scans: recognised, read, and joined with what is said about it elsewhere.

use crate::scan::error::ScanReadError;
use crate::scan::format::{Magic, ScanFormat};
use crate::scan::heights::{HeightMap, Scan, UniformLineScan};
use crate::scan::length::LengthUnit;
use crate::scan::options::{ScanOptions, ScanSize};
use crate::scan::{nanoscope, netcdf, text};

/// How far the size in the metadata may lie from that of the file before a note says so.
const SIZE_AGREEMENT: f64 = 1e-4;

/// A scan with what its file says about it.
#[derive(Clone, Debug, PartialEq)]
pub struct ScanFile {
    /// Name of the measurement where metadata give one, else that of the file.
    pub name: String,
    /// Format it was read from; within a container, that of the data file.
    pub format: ScanFormat,
    /// The heights.
    pub scan: Scan,
    /// The channel read, where the file names it.
    pub channel: Option<String>,
    /// The channels with heights that the file offers.
    pub channels: Vec<String>,
    /// Whether the heights repeat themselves beyond the scan.
    pub is_periodic: bool,
    /// Radius of the tip of the instrument, in m, above 0.
    pub tip_radius_m: Option<f64>,
    /// Smallest length that the instrument resolves, in m, above 0.
    pub resolution_m: Option<f64>,
    /// Assumptions made, and contradictions between the file, the options and the metadata, a sentence each.
    pub notes: Vec<String>,
}

/// What a reader finds in a file.
pub(crate) struct Reading {
    pub(crate) scan: Scan,
    pub(crate) channel: Option<String>,
    pub(crate) channels: Vec<String>,
    pub(crate) is_periodic: Option<bool>,
    pub(crate) tip_radius_m: Option<f64>,
    pub(crate) resolution_m: Option<f64>,
    pub(crate) notes: Vec<String>,
}

impl Reading {
    pub(crate) fn new(scan: Scan, notes: Vec<String>) -> Self {
        Self {
            scan,
            channel: None,
            channels: Vec::new(),
            is_periodic: None,
            tip_radius_m: None,
            resolution_m: None,
            notes,
        }
    }
}

/// Reads the scan in a file, or those in a container.
///
/// The format is told by the content: text (profiles `x h`, one column of heights, points `x y h`, matrices; decimal
/// commas where unambiguous), Nanoscope files with binary data, NetCDF-3 as contact.engineering writes it, X3P, and the
/// containers of contact.engineering. `name` is the name of the file, for messages. Memory is bounded by a small
/// multiple of the file, or of what a ZIP file unpacks to.
///
/// ```
/// use spectrum::{Scan, ScanOptions, read_scans};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let options = ScanOptions { unit: Some("µm".parse()?), ..ScanOptions::default() };
/// let scans = read_scans(b"0.0 0.125\n0.5 0.25\n1.0 0.125\n", "stylus.txt", &options)?;
/// let Scan::UniformLine(line) = &scans[0].scan else { panic!("evenly spaced") };
/// assert_eq!((line.spacing_m(), line.heights_m()[1]), (0.5e-6, 0.25e-6));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`ScanReadError`], with the place in the file, the value and the bound, for the first thing that is wrong.
pub fn read_scans(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Vec<ScanFile>, ScanReadError> {
    #[cfg(feature = "container")]
    if Magic::of(bytes) == Magic::Zip {
        let mut archive = crate::scan::archive::Archive::open(bytes, options.unpacked_bound())?;
        if let Some(index) = crate::scan::container::index_path(&archive) {
            return crate::scan::container::read(&mut archive, &index, options);
        }
    }
    Ok(vec![read_one(bytes, name, options)?])
}

/// Reads a file with one scan: anything but a container.
pub(crate) fn read_one(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<ScanFile, ScanReadError> {
    let (format, reading) = match Magic::of(bytes) {
        Magic::Text => (ScanFormat::Text, text::read(bytes, options)?),
        Magic::Nanoscope => (ScanFormat::Nanoscope, nanoscope::read(bytes, options)?),
        Magic::NetCdf => (ScanFormat::NetCdf, netcdf::read(bytes, options)?),
        Magic::Zip => (ScanFormat::X3p, read_zip(bytes, name, options)?),
        Magic::Foreign(hint) => return Err(unknown(bytes, name, hint)),
    };
    Ok(joined(format, reading, name, options))
}

#[cfg(feature = "x3p")]
fn read_zip(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Reading, ScanReadError> {
    let mut archive = crate::scan::archive::Archive::open(bytes, options.unpacked_bound())?;
    if crate::scan::x3p::is_x3p(&archive) {
        return crate::scan::x3p::read(&mut archive, options);
    }
    let hint = ": this ZIP file holds neither an X3P ('main.xml') nor a container ('meta.yml' or 'index.json'); unpack it";
    Err(unknown(bytes, name, hint))
}

#[cfg(not(feature = "x3p"))]
fn read_zip(bytes: &[u8], name: &str, _: &ScanOptions) -> Result<Reading, ScanReadError> {
    Err(unknown(bytes, name, ": this is a ZIP file, perhaps X3P, which this build does not read"))
}

fn unknown(bytes: &[u8], name: &str, hint: &'static str) -> ScanReadError {
    let start = match bytes {
        [] => "nothing (it is empty)".to_owned(),
        _ => format!("'{}'", bytes[..bytes.len().min(16)].escape_ascii()),
    };
    ScanReadError::UnknownFormat { name: name.to_owned(), start, hint }
}

fn joined(format: ScanFormat, reading: Reading, name: &str, options: &ScanOptions) -> ScanFile {
    let metadata = options.metadata.as_ref();
    let mut notes = reading.notes;
    if options.size.is_none() {
        notes.extend(metadata.and_then(|metadata| size_note(&reading.scan, metadata.size()?)));
    }
    ScanFile {
        name: metadata.map_or(name, |metadata| &metadata.name).to_owned(),
        format,
        scan: reading.scan,
        channel: reading.channel,
        channels: reading.channels,
        is_periodic: metadata.map(|metadata| metadata.is_periodic).or(reading.is_periodic).unwrap_or(false),
        tip_radius_m: metadata.and_then(|metadata| metadata.tip_radius_m).or(reading.tip_radius_m),
        resolution_m: metadata.and_then(|metadata| metadata.resolution_m).or(reading.resolution_m),
        notes,
    }
}

/// Tells of a size in the metadata that is not that of the file.
fn size_note(scan: &Scan, stated: ScanSize) -> Option<String> {
    let (x_m, y_m) = match scan {
        Scan::UniformLine(line) => (line.length_m(), None),
        Scan::NonuniformLine(line) => (line.length_m(), None),
        Scan::Map(map) => {
            (map.spacing_x_m() * map.columns() as f64, Some(map.spacing_y_m() * map.rows() as f64))
        }
    };
    let agrees = |found: f64, stated: f64| (found - stated).abs() <= SIZE_AGREEMENT * stated.abs();
    let y_agrees = y_m.zip(stated.y_m).is_none_or(|(found, stated)| agrees(found, stated));
    (!agrees(x_m, stated.x_m) || !y_agrees).then(|| {
        let found = ScanSize { x_m, y_m };
        format!("the metadata give the size as {stated}, the file as {found}: the file counts")
    })
}

impl ScanSize {
    /// The size that counts: that of the options, else that of the file, else that of the metadata.
    pub(crate) fn of(options: &ScanOptions, stated: Option<Self>, notes: &mut Vec<String>) -> Option<Self> {
        if let (Some(wanted), Some(stated)) = (options.size, stated)
            && wanted != stated
        {
            notes.push(format!("the size {wanted} asked for replaces that of the file, {stated}"));
        }
        options.size.or(stated).or_else(|| options.metadata_size())
    }

    /// The line with this size.
    pub(crate) fn line(self, heights_m: Vec<f64>) -> Result<Scan, ScanReadError> {
        let spacing_m = self.x_m / heights_m.len() as f64;
        Ok(Scan::UniformLine(UniformLineScan::new(spacing_m, heights_m)?))
    }

    /// The map with this size, from heights row after row.
    pub(crate) fn map(
        self,
        columns: usize,
        heights_m: Vec<f64>,
        notes: &mut Vec<String>,
    ) -> Result<Scan, ScanReadError> {
        let spacing_x_m = self.x_m / columns as f64;
        let spacing_y_m = match self.y_m {
            Some(y_m) => y_m / (heights_m.len() / columns.max(1)) as f64,
            None => {
                notes.push("only the size along x is given: rows are as far apart as columns".to_owned());
                spacing_x_m
            }
        };
        Ok(Scan::Map(HeightMap::new(columns, spacing_x_m, spacing_y_m, heights_m)?))
    }
}

impl std::fmt::Display for ScanSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.y_m {
            None => write!(f, "{:e} m", self.x_m),
            Some(y_m) => write!(f, "{:e} m x {y_m:e} m", self.x_m),
        }
    }
}

/// Units of a file whose numbers carry none of their own: those of the options, else of the file, else of the metadata.
pub(crate) struct Units {
    pub(crate) lateral: Option<LengthUnit>,
    pub(crate) height: Option<LengthUnit>,
    /// Factor to heights in `height`.
    pub(crate) height_scale: f64,
}

impl Units {
    pub(crate) fn of(
        options: &ScanOptions,
        lateral: Option<LengthUnit>,
        height: Option<LengthUnit>,
        notes: &mut Vec<String>,
    ) -> Self {
        let metadata = options.metadata.as_ref();
        let mut counting = |what: &str, wanted: Option<LengthUnit>, stated: Option<LengthUnit>| {
            if let (Some(wanted), Some(stated)) = (wanted, stated)
                && wanted != stated
            {
                notes.push(format!(
                    "the unit {wanted} of {what} asked for replaces that of the file, {stated}"
                ));
            }
            wanted.or(stated).or_else(|| metadata.and_then(|metadata| metadata.unit))
        };
        let lateral_unit = counting("lengths", options.unit, lateral);
        let height_unit = counting("heights", options.height_unit(), height);
        let scale = metadata.and_then(|metadata| metadata.height_scale);
        // A file that states the unit of its heights, or a caller who does, leaves nothing to scale.
        let is_stated = height.is_some() || options.height_unit().is_some();
        let height_scale = match scale {
            Some(scale) if !is_stated => scale,
            Some(scale) if scale != 1.0 => {
                notes.push(format!(
                    "height_scale {scale} of the metadata is not applied: the heights have their unit"
                ));
                1.0
            }
            _ => 1.0,
        };
        Self { lateral: lateral_unit, height: height_unit, height_scale }
    }

    pub(crate) fn height_to_m(
        &self,
        format: ScanFormat,
    ) -> Result<impl Fn(f64) -> f64 + use<>, ScanReadError> {
        let unit = self.height.ok_or(ScanReadError::NoUnit { format, what: "heights" })?;
        let scale = self.height_scale;
        Ok(move |value| unit.to_m(value * scale))
    }

    pub(crate) fn length_to_m(
        &self,
        format: ScanFormat,
    ) -> Result<impl Fn(f64) -> f64 + use<>, ScanReadError> {
        let unit = self.lateral.ok_or(ScanReadError::NoUnit { format, what: "lengths" })?;
        Ok(move |value| unit.to_m(value))
    }
}

/// Refuses a unit asked for where the format fixes its own.
pub(crate) fn refuse_unit(format: ScanFormat, options: &ScanOptions) -> Result<(), ScanReadError> {
    match options.unit.or(options.height_unit) {
        None => Ok(()),
        Some(unit) => Err(ScanReadError::UnitIsFixed { format, unit }),
    }
}

/// Notes a scale of the metadata that an instrument's own scale makes void.
pub(crate) fn own_scale_note(options: &ScanOptions) -> Option<String> {
    let scale = options.metadata.as_ref()?.height_scale.filter(|&scale| scale != 1.0)?;
    Some(format!("height_scale {scale} of the metadata is not applied: the file carries its own scale"))
}
