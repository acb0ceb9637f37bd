//! A scan as read, joined with what is said about it elsewhere.

use crate::format::ScanFormat;
use crate::heights::Scan;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::scan_size::ScanSize;

/// How far the size in the metadata may lie from that of the file before a note says so.
const SIZE_AGREEMENT: f64 = 1e-4;

/// A scan with what its file says about it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
    /// Whether the instrument has a tip, where the file says so or the format is that of instruments with one.
    pub probe: Option<Probe>,
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
    pub(crate) probe: Option<Probe>,
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
            probe: None,
            tip_radius_m: None,
            resolution_m: None,
            notes,
        }
    }
}

/// What a file says, completed by its metadata.
pub(crate) fn joined(format: ScanFormat, reading: Reading, name: &str, options: &ScanOptions) -> ScanFile {
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
        is_periodic: reading
            .is_periodic
            .or(metadata.and_then(|metadata| metadata.is_periodic))
            .unwrap_or(false),
        probe: reading.probe.or(metadata.and_then(|metadata| metadata.probe)),
        tip_radius_m: reading.tip_radius_m.or(metadata.and_then(|metadata| metadata.tip_radius_m)),
        resolution_m: reading.resolution_m.or(metadata.and_then(|metadata| metadata.resolution_m)),
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
