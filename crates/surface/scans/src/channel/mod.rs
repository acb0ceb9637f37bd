//! A channel of a file as its header describes it.

mod names;

pub(crate) use crate::texts::{MOST_TEXT, shortened};
pub(crate) use names::{UNNAMED, is_named_after_height, is_named_after_signal, numbered};

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::measure::Measure;
use crate::metadata::Probe;
use crate::raster::{Decoded, Raster};
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// Most channels of a file whose header may claim any number of them; instruments write some dozens.
pub(crate) const MOST_CHANNELS: usize = 1024;
/// Most bytes of a name or unit.
const LONGEST_NAME: usize = 256;

/// A channel as the header describes it. Its numbers are decoded when it is read.
#[derive(Debug)]
pub(crate) struct Channel<'b> {
    /// Name in the file, if any.
    pub(crate) name: Option<String>,
    pub(crate) quantity: Quantity,
    pub(crate) lateral: Lateral,
    /// Size in m along x and y that the file states beside the places of its points.
    pub(crate) stated_m: [Option<f64>; 2],
    pub(crate) samples: Samples<'b>,
    pub(crate) units: UnitsBy,
    /// Axis of the map along which the instrument scanned its lines, where the file states it.
    pub(crate) fast_axis: Option<ScanAxis>,
    pub(crate) is_periodic: Option<bool>,
    pub(crate) probe: Option<Probe>,
    pub(crate) tip_radius_m: Option<f64>,
    pub(crate) resolution_m: Option<f64>,
    /// Comments and descriptions in the file, where a user may have written what no field holds.
    pub(crate) free_text: String,
    /// Assumptions made, a sentence each.
    pub(crate) notes: Vec<String>,
}

/// An axis of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScanAxis {
    /// Along its rows.
    X,
    /// Across them.
    Y,
}

/// Meaning of the numbers of a channel.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Quantity {
    /// Heights of the surface, in a unit that the file may leave open.
    Heights(Option<LengthUnit>),
    /// Lengths that are not heights: deflection, amplitude, error.
    OtherLength(LengthUnit),
    /// Anything else: phase, current, friction; with its unit as the file writes it.
    Other(String),
}

impl Quantity {
    /// Heights in m.
    pub(crate) const HEIGHTS_IN_M: Self = Self::Heights(Some(LengthUnit::METRE));
}

/// Source of the units of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnitsBy {
    /// The format: another unit cannot be asked for.
    Format,
    /// Its reader, from options and file.
    Reader,
    /// The caller; the file has none.
    Asker,
}

/// Lateral places of the points of a channel.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Lateral {
    /// The file does not say.
    Unknown,
    /// Size: as many spacings as there are points.
    Size(ScanSize),
    /// Distances of neighbours in m, along x and, where there are rows, along y.
    Spacing { x_m: f64, y_m: Option<f64> },
    /// The position of every point of a line; in m, rising.
    Positions(Vec<f64>),
}

/// The numbers of a channel.
#[derive(Debug)]
pub(crate) enum Samples<'b> {
    Raster(Raster<'b>),
    /// Decoded numbers, row after row of so many columns.
    Decoded {
        columns: usize,
        decoded: Decoded,
    },
    /// The error of a channel that cannot be read; others of the file may be readable.
    Unreadable(Box<ScanReadError>),
}

impl<'b> Channel<'b> {
    /// A channel of heights of a format that fixes all units.
    pub(crate) fn heights_in_m(name: impl Into<String>, size: ScanSize, raster: Raster<'b>) -> Self {
        Self::new(Some(name.into()), Quantity::HEIGHTS_IN_M, Lateral::Size(size), Samples::Raster(raster))
    }

    /// Creates a channel without further facts; its units are fixed where it has any.
    pub(crate) fn new(
        name: Option<String>,
        quantity: Quantity,
        lateral: Lateral,
        samples: Samples<'b>,
    ) -> Self {
        let units = if quantity == Quantity::Heights(None) { UnitsBy::Asker } else { UnitsBy::Format };
        Self {
            name: name.filter(|name| !name.is_empty()).map(|name| shortened(name, LONGEST_NAME)),
            quantity: match quantity {
                Quantity::Other(unit) => Quantity::Other(shortened(unit, LONGEST_NAME)),
                length => length,
            },
            lateral,
            stated_m: [None; 2],
            samples,
            units,
            fast_axis: None,
            is_periodic: None,
            probe: None,
            tip_radius_m: None,
            resolution_m: None,
            free_text: String::new(),
            notes: Vec::new(),
        }
    }

    /// Returns what the channel measures.
    pub(crate) fn measure(&self) -> Measure {
        match &self.quantity {
            Quantity::Heights(_) => Measure::Height,
            Quantity::OtherLength(_) => Measure::Length,
            Quantity::Other(unit) => Measure::Other(unit.clone()),
        }
    }

    /// Returns true if no error is known yet.
    pub(crate) fn is_readable(&self) -> bool {
        !matches!(self.samples, Samples::Unreadable(_))
    }

    /// Returns true if it holds heights of the surface.
    pub(crate) fn is_heights(&self) -> bool {
        matches!(self.quantity, Quantity::Heights(_))
    }
}

impl Lateral {
    /// The spacings of a line or of a map of so many rows, where all that it needs are known.
    pub(crate) fn spacings(x_m: Option<f64>, y_m: Option<f64>, rows: usize) -> Self {
        match (x_m, y_m) {
            (Some(x_m), _) if rows == 1 => Self::Spacing { x_m, y_m: None },
            (Some(x_m), Some(y_m)) => Self::Spacing { x_m, y_m: Some(y_m) },
            _ => Self::Unknown,
        }
    }
}

impl<'b> From<Result<Raster<'b>, ScanReadError>> for Samples<'b> {
    fn from(raster: Result<Raster<'b>, ScanReadError>) -> Self {
        raster.map_or_else(|error| Self::Unreadable(Box::new(error)), Self::Raster)
    }
}

impl Samples<'_> {
    /// Number of points along x, and the values.
    pub(crate) fn decode(self, format: ScanFormat) -> Result<(usize, Decoded), ScanReadError> {
        match self {
            Self::Raster(raster) => Ok((raster.columns, raster.decode(format)?)),
            Self::Decoded { columns, decoded } => Ok((columns, decoded)),
            Self::Unreadable(error) => Err(*error),
        }
    }
}

/// Refuses more channels than a file may have: their descriptions would take more memory than the file does.
pub(crate) fn refuse_many(format: ScanFormat, channels: usize) -> Result<(), ScanReadError> {
    if channels <= MOST_CHANNELS {
        return Ok(());
    }
    Err(format.bad(
        FilePlace::File,
        "the number of channels",
        format!("at least {channels}"),
        format!("at most {MOST_CHANNELS}"),
        "the file is damaged, or has to be exported in parts",
    ))
}
