//! Which scans, each with what its file does not say.

use std::str::FromStr;

use topography::BandLimits;
use units::{Length, LengthUnit};

/// A file of scans, and what is known of them besides.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScanRequest {
    /// The file, as typed.
    pub path: String,
    /// Unit of lengths and heights where neither the file nor metadata beside it tell.
    pub unit: Option<LengthUnit>,
    /// The channel, where the file has several; its first one of heights where absent.
    pub channel: Option<String>,
    /// Size along the scan lines \[m\], where the file gives none.
    pub size_m: Option<f64>,
    /// Radius of the tip \[m\], which limits the wavelengths that are trusted.
    pub tip_radius_m: Option<f64>,
    /// The shortest wavelength \[m\] that is trusted.
    pub shortest_m: Option<f64>,
}

impl ScanRequest {
    /// What is known of the instrument besides the file.
    pub(super) fn limits(&self) -> BandLimits {
        BandLimits { tip_radius_m: self.tip_radius_m, shortest_m: self.shortest_m }
    }
}

/// Options of a single file that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RequestError {
    /// No such option.
    #[error(
        "{file}: there is no option '{key}' of a scan; there are unit, channel, size, tip-radius and shortest"
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
    pub(super) fn set(&mut self, key: &str, value: &str) -> Result<(), RequestError> {
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
            "tip-radius" => self.tip_radius_m = Some(length_m()?),
            "shortest" => self.shortest_m = Some(length_m()?),
            _ => {
                return Err(RequestError::UnknownKey { file: self.path.clone(), key: key.to_owned() });
            }
        }
        Ok(())
    }
}
