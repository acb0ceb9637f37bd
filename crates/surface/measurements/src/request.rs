//! Which scans, each with what its file does not say.

use std::str::FromStr;

use topography::{BandLimits, Direction, GapTreatment, Recipe};
use units::{Length, LengthUnit};

use crate::calibration::{Instrument, SlopeUncertainty, ZCalibration};

/// A file of scans, and what is known of them besides.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScanRequest {
    /// The file, as typed.
    pub path: String,
    /// Unit of lengths and heights where neither the file nor metadata beside it tell.
    pub unit: Option<LengthUnit>,
    /// The channel, where the file has several; its first one of heights where absent.
    pub channel: Option<String>,
    /// The measurement, by its name, of containers that have several; all of them where absent.
    pub measurement: Option<String>,
    /// Size along the scan lines \[m\], where the file gives none.
    pub size_m: Option<f64>,
    /// Radius of the tip, which limits the wavelengths that are trusted.
    pub tip_radius: Option<TipRadius>,
    /// The shortest wavelength \[m\] that is trusted.
    pub shortest_m: Option<f64>,
    /// What becomes of points without a height; as for all scans, where absent.
    pub gaps: Option<GapTreatment>,
    /// Along which axis of a map its spectrum is taken; as for all scans, where absent.
    pub direction: Option<Direction>,
    /// The instrument that it was made with, which scans of one share the errors of.
    pub instrument: Option<String>,
    /// One standard uncertainty of the height scale of that instrument, as a share above 0 and at most 1.
    pub z_calibration: Option<f64>,
    /// One standard uncertainty of the exponent of its spectrum, at least 0.
    pub slope_uncertainty: Option<f64>,
}

/// What is told of the radius of a tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TipRadius {
    /// It is so many m.
    Known(f64),
    /// It stands in the file or in what lies beside it, in a field or in free text.
    Auto,
}

impl FromStr for TipRadius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "auto" => Ok(Self::Auto),
            length => length.parse::<Length>().map(|length| Self::Known(length.m)).map_err(|error| {
                format!("{error}; or write auto, to take the radius that the file speaks of")
            }),
        }
    }
}

impl TipRadius {
    /// The radius \[m\], where it is given.
    #[must_use]
    pub fn known_m(self) -> Option<f64> {
        match self {
            Self::Known(radius_m) => Some(radius_m),
            Self::Auto => None,
        }
    }
}

impl ScanRequest {
    /// What is known of the instrument besides the file.
    pub(crate) fn limits(&self) -> BandLimits {
        BandLimits { tip_radius_m: self.tip_radius.and_then(TipRadius::known_m), shortest_m: self.shortest_m }
    }

    /// The recipe for this scan: that for all of them but for what is asked for here.
    pub(crate) fn recipe(&self, for_all: &Recipe) -> Recipe {
        Recipe {
            gaps: self.gaps.unwrap_or(for_all.gaps),
            direction: self.direction.unwrap_or(for_all.direction),
            tip_radius_auto: for_all.tip_radius_auto || self.tip_radius == Some(TipRadius::Auto),
            ..*for_all
        }
    }
}

/// Options of a single file that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RequestError {
    /// No such option.
    #[error(
        "{file}: there is no option '{key}' of a scan; there are unit, channel, size, tip-radius, shortest, gaps, direction, instrument, z-calibration and slope-uncertainty"
    )]
    UnknownKey {
        /// The file.
        file: String,
        /// What was typed.
        key: String,
    },
    /// A value that does not do.
    #[error("{file}: option {key}: {problem}")]
    BadValue {
        /// The file.
        file: String,
        /// The option.
        key: String,
        /// What is wrong.
        problem: String,
    },
}

impl FromStr for ScanRequest {
    type Err = RequestError;

    /// Reads `scan.asc`, or `scan.asc:unit=nm,channel=Height,tip-radius=20nm,shortest=46nm`.
    fn from_str(text: &str) -> Result<Self, RequestError> {
        // A colon may belong to the path: options are what follows the last one and looks like them.
        let (path, options) = match text.rsplit_once(':') {
            Some((path, options))
                if !path.is_empty() && options.split(',').all(|part| part.contains('=')) =>
            {
                (path, options)
            }
            _ => (text, ""),
        };
        let mut request = ScanRequest { path: path.to_owned(), ..ScanRequest::default() };
        for (key, value) in options.split(',').filter_map(|part| part.split_once('=')) {
            request.set(key.trim(), value.trim())?;
        }
        Ok(request)
    }
}

impl ScanRequest {
    /// Sets an option by its name on the command line.
    pub(crate) fn set(&mut self, key: &str, value: &str) -> Result<(), RequestError> {
        let bad = |problem: String| RequestError::BadValue {
            file: self.path.clone(),
            key: key.to_owned(),
            problem,
        };
        let length_m =
            || value.parse::<Length>().map(|length| length.m).map_err(|error| bad(error.to_string()));
        match key {
            "unit" => self.unit = Some(value.parse::<LengthUnit>().map_err(|error| bad(error.to_string()))?),
            "channel" => self.channel = Some(value.to_owned()),
            "size" => self.size_m = Some(length_m()?),
            "tip-radius" => self.tip_radius = Some(value.parse().map_err(bad)?),
            "shortest" => self.shortest_m = Some(length_m()?),
            "gaps" => {
                self.gaps = Some(value.parse::<GapTreatment>().map_err(|error| bad(error.to_string()))?);
            }
            "direction" => {
                self.direction = Some(value.parse::<Direction>().map_err(|error| bad(error.to_string()))?);
            }
            "instrument" => {
                let Instrument(name) = value.parse().map_err(bad)?;
                self.instrument = Some(name);
            }
            "z-calibration" => {
                let ZCalibration { share } = value.parse().map_err(bad)?;
                self.z_calibration = Some(share);
            }
            "slope-uncertainty" => {
                let SlopeUncertainty { of_exponent } = value.parse().map_err(bad)?;
                self.slope_uncertainty = Some(of_exponent);
            }
            _ => {
                return Err(RequestError::UnknownKey { file: self.path.clone(), key: key.to_owned() });
            }
        }
        Ok(())
    }
}
