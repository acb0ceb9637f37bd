//! Requests for scans: a file and its options.

use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

use topography::{BandLimits, Detrend, Direction, GapTreatment, Recipe};
use units::display::length;
use units::{Length, LengthUnit};

use crate::calibration::{Instrument, SlopeUncertainty, ZCalibration};
use crate::error::{ScanProblem, TopographyError};

/// A scan file with options for what the file does not state.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScanRequest {
    /// File name as typed.
    pub path: String,
    /// Unit of lengths and heights, used if neither the file nor metadata beside it state one.
    pub unit: Option<LengthUnit>,
    /// Unit of heights where it is another than that of lengths, used if neither the file nor metadata beside it state
    /// one.
    pub height_unit: Option<LengthUnit>,
    /// Channel to read; defaults to the first height channel.
    pub channel: Option<String>,
    /// Name of the measurement to read from a container; defaults to all.
    pub measurement: Option<String>,
    /// Size along the scan lines \[m\], used if the file states none.
    pub size_m: Option<f64>,
    /// Radius of the tip, which limits the reliable band.
    pub tip_radius: Option<TipRadius>,
    /// The shortest reliable wavelength \[m\].
    pub shortest_m: Option<f64>,
    /// Treatment of missing points; defaults to the recipe for all scans.
    pub gaps: Option<GapTreatment>,
    /// Axis of a map along which its spectrum is taken; defaults to the recipe for all scans.
    pub direction: Option<Direction>,
    /// Trend subtracted from the heights; defaults to the recipe for all scans.
    pub detrend: Option<Detrend>,
    /// Name of the instrument; scans with equal names share its calibration errors.
    pub instrument: Option<String>,
    /// Relative standard uncertainty of the height scale of the instrument, above 0 and at most 1.
    pub z_calibration: Option<f64>,
    /// Standard uncertainty of the exponent of its spectrum, at least 0.
    pub slope_uncertainty: Option<f64>,
}

/// Radius \[m\] from which on no tip of an instrument is known: those of contour probes end at half of it.
const BALL_M: f64 = 1e-3;

/// The radius of a tip: given, or taken from the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TipRadius {
    /// A given radius \[m\]; 0 if no tip touched the heights.
    Known(f64),
    /// The radius that the file or its metadata states, in a field or in free text; so it is where none is given.
    Auto,
}

impl FromStr for TipRadius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "auto" => Ok(Self::Auto),
            "none" => Ok(Self::Known(0.0)),
            typed => match typed.parse::<Length>() {
                Ok(radius) if radius.m < BALL_M => Ok(Self::Known(radius.m)),
                Ok(Length { m }) => Err(format!(
                    "{typed} is the radius of a ball, not of a tip; did you mean {}? Of a ball give the shortest wavelength that it \
                     follows, as shortest=1mm",
                    length(1e-3 * m)
                )),
                Err(error) => Err(format!(
                    "{error}; or write auto for that of the file, none for heights that no tip touched"
                )),
            },
        }
    }
}

impl Display for TipRadius {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Auto => f.write_str("auto"),
            Self::Known(0.0) => f.write_str("none"),
            Self::Known(radius_m) => write!(f, "{radius_m:e} m"),
        }
    }
}

impl TipRadius {
    /// Returns the radius \[m\] if it is given.
    #[must_use]
    pub fn known_m(self) -> Option<f64> {
        match self {
            Self::Known(radius_m) => Some(radius_m),
            Self::Auto => None,
        }
    }
}

/// An option, and whether a request gives it.
type RequestOption = (&'static str, fn(&ScanRequest) -> bool);

impl ScanRequest {
    /// All options, as the command line names them, and whether a request gives each; in lists and scenes they have underscores.
    pub const OPTIONS: [RequestOption; 12] = [
        ("unit", |request| request.unit.is_some()),
        ("height-unit", |request| request.height_unit.is_some()),
        ("channel", |request| request.channel.is_some()),
        ("size", |request| request.size_m.is_some()),
        ("tip-radius", |request| request.tip_radius.is_some()),
        ("shortest", |request| request.shortest_m.is_some()),
        ("gaps", |request| request.gaps.is_some()),
        ("direction", |request| request.direction.is_some()),
        ("detrend", |request| request.detrend.is_some()),
        ("instrument", |request| request.instrument.is_some()),
        ("z-calibration", |request| request.z_calibration.is_some()),
        ("slope-uncertainty", |request| request.slope_uncertainty.is_some()),
    ];

    /// Options of a scan that is read for its heights alone.
    pub(crate) const OF_HEIGHTS: [&str; 4] = ["unit", "height-unit", "channel", "size"];

    /// Options of a spectrum without its uncertainty.
    pub const OF_SPECTRA: [&str; 9] =
        ["unit", "height-unit", "channel", "size", "tip-radius", "shortest", "gaps", "direction", "detrend"];

    /// Options of a map that is pressed.
    pub(crate) const OF_MAPS: [&str; 7] =
        ["unit", "height-unit", "channel", "size", "gaps", "direction", "detrend"];

    /// Options of a map that faces one that is pressed: the trend is that of their sum.
    pub(crate) const OF_FACING_MAPS: [&str; 6] =
        ["unit", "height-unit", "channel", "size", "gaps", "direction"];

    /// Refuses the first option that is given and not among these.
    ///
    /// # Errors
    /// [`TopographyError`] with the file and the option.
    pub fn check_takes(&self, options: &[&str]) -> Result<(), TopographyError> {
        let idle = Self::OPTIONS.into_iter().find(|(option, given)| given(self) && !options.contains(option));
        idle.map_or(Ok(()), |(option, _)| {
            Err(TopographyError::for_file(&self.path, ScanProblem::UnusedOption(option)))
        })
    }

    /// Its options for the heights and their band, as the command line takes them, each with a comma behind it.
    #[must_use]
    pub fn options(&self) -> String {
        let metres = |length_m: f64| format!("{length_m:e}m");
        let typed = [
            ("unit", self.unit.map(|unit| unit.ascii().to_owned())),
            ("height-unit", self.height_unit.map(|unit| unit.ascii().to_owned())),
            ("channel", self.channel.clone()),
            ("size", self.size_m.map(metres)),
            ("tip-radius", self.tip_radius.map(|radius| radius.to_string().replace(' ', ""))),
            ("shortest", self.shortest_m.map(metres)),
        ];
        typed.into_iter().filter_map(|(key, value)| Some(format!("{key}={},", value?))).collect()
    }

    /// Limits of the reliable band that the request gives.
    pub(crate) fn limits(&self) -> BandLimits {
        BandLimits { tip_radius_m: self.tip_radius.and_then(TipRadius::known_m), shortest_m: self.shortest_m }
    }

    /// Returns the recipe for this scan: the one for all scans with this request's changes.
    pub(crate) fn recipe(&self, for_all: &Recipe) -> Recipe {
        Recipe {
            gaps: self.gaps.unwrap_or(for_all.gaps),
            direction: self.direction.unwrap_or(for_all.direction),
            detrend: self.detrend.or(for_all.detrend),
            ..*for_all
        }
    }
}

/// Errors of parsing the options of a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RequestError {
    /// An unknown option.
    #[error(
        "{file}: unknown option '{key}' of a scan; use unit, height-unit, channel, size, tip-radius, shortest, gaps, direction, detrend, \
         instrument, z-calibration or slope-uncertainty"
    )]
    UnknownKey {
        /// The file.
        file: String,
        /// The unknown name.
        key: String,
    },
    /// A unit without the name of its option.
    #[error("a unit needs its name; write {file}:unit={unit}")]
    BareUnit {
        /// The file.
        file: String,
        /// The unit.
        unit: String,
    },
    /// An invalid value.
    #[error("{file}: option {key}: {problem}")]
    BadValue {
        /// The file.
        file: String,
        /// The option.
        key: String,
        /// The problem with the value.
        problem: String,
    },
}

impl FromStr for ScanRequest {
    type Err = RequestError;

    /// Parses `scan.asc`, or `scan.asc:unit=nm,channel=Height,tip-radius=20nm,shortest=46nm`.
    fn from_str(text: &str) -> Result<Self, RequestError> {
        // A colon may belong to the path: options follow the last one and all contain `=`.
        let (path, options) = match text.rsplit_once(':') {
            Some((path, options)) if path.is_empty() || is_on_drive(path, options) => (text, ""),
            Some((path, options)) if options.split(',').all(|part| part.contains('=')) => (path, options),
            Some((path, unit)) if unit.parse::<LengthUnit>().is_ok() => {
                let file = path.strip_suffix(":unit").unwrap_or(path).to_owned();
                return Err(RequestError::BareUnit { file, unit: unit.to_owned() });
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

/// Returns true for the two parts of a path on a drive of Windows, `C:\scans`.
fn is_on_drive(drive: &str, path: &str) -> bool {
    drive.len() == 1 && drive.starts_with(|c: char| c.is_ascii_alphabetic()) && path.starts_with(['\\', '/'])
}

impl ScanRequest {
    /// Returns the request with an option set by its name on the command line.
    ///
    /// # Errors
    /// [`RequestError`] for an unknown option or an invalid value.
    pub fn with_option(&self, key: &str, value: &str) -> Result<Self, RequestError> {
        let mut changed = self.clone();
        changed.set(key, value)?;
        Ok(changed)
    }

    /// Sets an option by its name on the command line, or in a scene.
    pub(crate) fn set(&mut self, key: &str, value: &str) -> Result<(), RequestError> {
        let bad = |problem: String| RequestError::BadValue {
            file: self.path.clone(),
            key: key.to_owned(),
            problem,
        };
        match key.replace('_', "-").as_str() {
            "unit" => self.unit = Some(parsed(value).map_err(bad)?),
            "height-unit" => self.height_unit = Some(parsed(value).map_err(bad)?),
            "channel" => self.channel = Some(value.to_owned()),
            "size" => self.size_m = Some(parsed::<Length>(value).map_err(bad)?.m),
            "tip-radius" => self.tip_radius = Some(parsed(value).map_err(bad)?),
            "shortest" | "shortest-wavelength" => {
                self.shortest_m = Some(parsed::<Length>(value).map_err(bad)?.m);
            }
            "gaps" => self.gaps = Some(parsed(value).map_err(bad)?),
            "direction" => self.direction = Some(parsed(value).map_err(bad)?),
            "detrend" => self.detrend = Some(parsed(value).map_err(bad)?),
            "instrument" => self.instrument = Some(parsed::<Instrument>(value).map_err(bad)?.0),
            "z-calibration" => self.z_calibration = Some(parsed::<ZCalibration>(value).map_err(bad)?.share),
            "slope-uncertainty" => {
                let SlopeUncertainty { standard_uncertainty } = parsed(value).map_err(bad)?;
                self.slope_uncertainty = Some(standard_uncertainty);
            }
            _ => {
                return Err(RequestError::UnknownKey { file: self.path.clone(), key: key.to_owned() });
            }
        }
        Ok(())
    }
}

/// Parses a value, and words the error.
fn parsed<T: FromStr<Err: Display>>(value: &str) -> Result<T, String> {
    value.parse().map_err(|error: T::Err| error.to_string())
}
