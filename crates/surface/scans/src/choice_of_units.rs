//! Choice of units and scales.

use crate::error::{ScanReadError, Unitless};
use crate::format::ScanFormat;
use crate::options::{IGNORED, ScanOptions};
use units::LengthUnit;

/// Units of a file whose numbers carry none of their own: those of the options, else of the file, else of the metadata,
/// else those to fall back on.
pub(crate) struct Units {
    pub(crate) lateral: Option<LengthUnit>,
    pub(crate) height: Option<LengthUnit>,
    /// Factor to heights in `height`.
    pub(crate) height_scale: f64,
}

impl Units {
    pub(crate) fn choose(
        options: &ScanOptions,
        lateral: Option<LengthUnit>,
        height: Option<LengthUnit>,
        notes: &mut Vec<String>,
    ) -> Self {
        let metadata = options.metadata.as_ref();
        let mut counting = |what: &str, wanted: Option<LengthUnit>, stated: Option<LengthUnit>, fallback| {
            if let (Some(wanted), Some(stated)) = (wanted, stated)
                && wanted != stated
            {
                notes.push(format!(
                    "the unit {wanted} of {what} asked for replaces that of the file, {stated}"
                ));
            }
            let known = wanted.or(stated).or_else(|| metadata.and_then(|metadata| metadata.unit));
            if let (Some(known), Some(unused)) = (known, fallback)
                && known != unused
            {
                notes.push(format!("{IGNORED}the unit {unused} of {what}: they are known to be in {known}"));
            }
            known.or(fallback)
        };
        let height_fallback = options.fallback_height_unit.or(options.fallback_unit);
        let lateral_unit = counting("lengths", options.unit, lateral, options.fallback_unit);
        let height_unit = counting("heights", options.height_unit(), height, height_fallback);
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

    /// Refuses points of which neither positions nor heights have a unit: the two may differ.
    pub(crate) fn refuse_bare_points(&self, format: ScanFormat) -> Result<(), ScanReadError> {
        match (self.lateral, self.height) {
            (None, None) => Err(ScanReadError::NoUnit { format, what: Unitless::LengthsAndHeights }),
            _ => Ok(()),
        }
    }

    pub(crate) fn height_to_m(
        &self,
        format: ScanFormat,
    ) -> Result<impl Fn(f64) -> f64 + use<>, ScanReadError> {
        let what = if self.lateral.is_some() { Unitless::HeightsAlone } else { Unitless::Heights };
        let unit = self.height.ok_or(ScanReadError::NoUnit { format, what })?;
        let scale = self.height_scale;
        Ok(move |value| unit.to_m(value * scale))
    }

    pub(crate) fn length_to_m(
        &self,
        format: ScanFormat,
    ) -> Result<impl Fn(f64) -> f64 + use<>, ScanReadError> {
        let unit = self.lateral.ok_or(ScanReadError::NoUnit { format, what: Unitless::Lengths })?;
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
