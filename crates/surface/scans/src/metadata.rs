//! Metadata of one measurement of a container.

use crate::scan_size::ScanSize;
use units::LengthUnit;

/// The probe of an instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Probe {
    /// A tip of finite radius: stylus instruments, atomic force microscopes.
    Tip,
    /// None that has a radius: optical and electron microscopes.
    Microscope,
}

/// The entry of a measurement in the `meta.yml` or `index.json` of a container.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasurementMetadata {
    /// Name of the surface it belongs to.
    pub surface: Option<String>,
    /// Name of the measurement.
    pub name: String,
    /// Path of the instrument's own file.
    pub original: Option<String>,
    /// Path of the file with processed heights, a NetCDF file that carries its own units.
    pub squeezed: Option<String>,
    /// Sizes along x and y in `unit`: none, one or two, above 0.
    pub sizes: Vec<f64>,
    /// Unit of the sizes and, after multiplication with `height_scale`, of the heights of a file that states none.
    pub unit: Option<LengthUnit>,
    /// Factor to heights in `unit`, for files that do not state the unit of their heights; it must not be applied to
    /// instrument files that carry their own scale.
    pub height_scale: Option<f64>,
    /// True if the heights repeat themselves.
    pub is_periodic: Option<bool>,
    /// Number of the image chosen in an instrument's file, counted from 0.
    pub data_source: Option<usize>,
    /// The probe of the instrument.
    pub probe: Option<Probe>,
    /// Radius of the tip of the instrument, in m, above 0.
    pub tip_radius_m: Option<f64>,
    /// Smallest length that the instrument resolves, in m, above 0.
    pub resolution_m: Option<f64>,
    /// Description by the people who measured.
    pub description: Option<String>,
}

impl MeasurementMetadata {
    /// Returns true if a path ends in the name of one of the data files.
    pub fn names_file(&self, path: &str) -> bool {
        [&self.original, &self.squeezed].into_iter().flatten().any(|own| file_name(own) == file_name(path))
    }

    /// The size in m, where both numbers and a unit are given.
    pub(crate) fn size(&self) -> Option<ScanSize> {
        let unit = self.unit?;
        let x_m = unit.to_m(*self.sizes.first()?);
        Some(ScanSize { x_m, y_m: self.sizes.get(1).map(|&size| unit.to_m(size)) })
    }
}

/// The last part of a path, with either separator.
pub(crate) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// Returns the probe of the instrument of an entry, by its `type`; none where it is not given.
pub(crate) fn probe(entry: &serde_json::Value) -> Option<Probe> {
    match entry.get("instrument")?.get("type")?.as_str()? {
        "contact-based" => Some(Probe::Tip),
        "microscope-based" => Some(Probe::Microscope),
        _ => None,
    }
}

/// A length among the parameters of an instrument, `instrument.parameters.<name>` with `value` and `unit`; none where
/// it is not given or no length above 0.
pub(crate) fn instrument_length_m(entry: &serde_json::Value, name: &str) -> Option<f64> {
    let length = entry.get("instrument")?.get("parameters")?.get(name)?;
    let unit = LengthUnit::parse_instrument(length.get("unit")?.as_str()?)?;
    let length_m = unit.to_m(length.get("value")?.as_f64()?);
    (length_m.is_finite() && length_m > 0.0).then_some(length_m)
}
