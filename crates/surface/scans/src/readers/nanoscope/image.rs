//! One image of a Nanoscope file: what it measures, and what its counts are worth.

use super::grid::Grid;
use super::header::{Header, Section, Value};
use super::scaled::{Scaled, volt};
use crate::channel::{MOST_TEXT, is_named_after_height, shortened};
use crate::error::ScanReadError;
use units::LengthUnit;

/// An image section with the header it belongs to.
pub(crate) struct Image<'h> {
    header: &'h Header<'h>,
    section: &'h Section<'h>,
}

impl<'h> Image<'h> {
    pub(crate) fn new(header: &'h Header<'h>, section: &'h Section<'h>) -> Self {
        Self { header, section }
    }

    /// Quantity measured: `Height` in `S [Height] "Height"`.
    pub(crate) fn name(&self) -> String {
        let keys = ["@2:Image Data", "@3:Image Data", "@4:Image Data", "Image Data"];
        let Some(value) = keys.iter().find_map(|key| self.section.get(key)) else {
            return "unnamed".to_owned();
        };
        let bracketed = Scaled::parse(&value.text).and_then(|scaled| scaled.soft_scale);
        bracketed.unwrap_or_else(|| value.text.trim_start_matches("S ").trim().trim_matches('"').to_owned())
    }

    /// Name with the direction of the scan, trace or retrace.
    pub(crate) fn label(&self) -> String {
        match self.section.get("Line direction") {
            Some(direction) => format!("{} ({})", self.name(), direction.text),
            None => self.name(),
        }
    }

    /// Deflections and errors may be in nm as well, but are not heights.
    pub(crate) fn is_named_after_height(&self) -> bool {
        is_named_after_height(&self.name())
    }

    /// Returns the comments of the user on image and file.
    pub(crate) fn note(&self) -> String {
        let of_file = ["Note", "Sample description"].map(|key| self.header.file_list(key));
        let values = of_file.into_iter().chain([self.section.get("Note")]).flatten();
        let lines = values.filter(|value| !value.text.is_empty()).map(|value| format!("{}\n", value.text));
        shortened(lines.collect(), MOST_TEXT)
    }

    /// The unit of what is not a length, as the sensitivity names it; that of the full scale where there is none.
    pub(crate) fn unit(&self) -> String {
        let scaled = |value: Value| Scaled::parse(&value.text);
        let full_scale = self.z_scale().ok().and_then(scaled);
        let soft = full_scale.as_ref().and_then(|scale| self.header.sensitivity(scale.soft_scale.as_ref()?));
        let unit = |scaled: Scaled| scaled.number().map(|(_, unit)| unit);
        let per_volt =
            soft.and_then(scaled).and_then(unit).and_then(|unit| Some(unit.split_once('/')?.0.to_owned()));
        per_volt.or_else(|| full_scale.and_then(unit)).unwrap_or_default()
    }

    /// Value of one count in [`Image::unit`].
    pub(crate) fn scale_per_count(&self) -> Option<f64> {
        let full_scale = Scaled::parse(&self.z_scale().ok()?.text)?;
        let (full, _) = full_scale.number()?;
        let soft = full_scale.soft_scale.as_ref().and_then(|name| self.header.sensitivity(name));
        let sensitivity =
            soft.and_then(|value| Scaled::parse(&value.text)?.number()).map_or(1.0, |(value, _)| value);
        Some(full / 256f64.powi(self.bytes_per_pixel().ok()? as i32) * sensitivity)
    }

    fn z_scale(&self) -> Result<Value, ScanReadError> {
        match self.section.get("@4:Z scale") {
            Some(value) => Ok(value),
            None => self.section.require("@2:Z scale"),
        }
    }

    /// Height of one count in m: full scale in V over the number of counts, times the sensitivity in nm/V.
    pub(crate) fn scale_m_per_count(&self) -> Result<f64, ScanReadError> {
        let value = self.z_scale()?;
        let bad = || value.bad("a full scale such as 'V [Sens. Zsens] (0.0067 V/LSB) 2.125 V'");
        let full_scale = Scaled::parse(&value.text).ok_or_else(bad)?;
        let (volts, unit) = full_scale.number().ok_or_else(bad)?;
        let counts = 256f64.powi(self.bytes_per_pixel()? as i32);
        let soft = full_scale.soft_scale.as_ref().and_then(|name| self.header.sensitivity(name));
        let soft = soft.ok_or_else(|| value.bad("scaled by a sensitivity of the scanner in the header"))?;
        let bad = || soft.bad("a sensitivity in a unit of length per V, such as 'V 22.5 nm/V'");
        let (sensitivity, ratio) =
            Scaled::parse(&soft.text).and_then(|scaled| scaled.number()).ok_or_else(bad)?;
        let (length, per) = ratio.split_once('/').ok_or_else(bad)?;
        let length = LengthUnit::parse_instrument(length).ok_or_else(bad)?;
        let volts = volts * volt(&unit).zip(volt(per)).map(|(unit, per)| unit / per).ok_or_else(bad)?;
        let scale = length.to_m(volts / counts * sensitivity);
        if scale.is_finite() && scale != 0.0 { Ok(scale) } else { Err(bad()) }
    }

    fn bytes_per_pixel(&self) -> Result<usize, ScanReadError> {
        let Some(value) = self.section.get("Bytes/pixel") else { return Ok(2) };
        value.count().ok().filter(|count| [2, 4].contains(count)).ok_or_else(|| value.bad("2 or 4"))
    }

    pub(crate) fn grid(&self) -> Result<Grid, ScanReadError> {
        Grid::read(self.header, self.section, self.bytes_per_pixel()?)
    }
}
