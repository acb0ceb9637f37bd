//! The surface a scene or a command names: its spectrum, and what its file says about itself.

use std::io;

use scans::ScanFormat;
use spectrum::{ConversionError, ProfilePsd, PsdFile, ReadError, ReadOptions, read_psd, superpose};
use units::display::length;

use crate::files::Files;
use crate::topography::{CompositeSpectrum, Recipe, ScanRequest, TopographyError};

/// Spectra that come with the program, under the names by which they are asked for, as the text of their files; origin
/// and licence stand in their comments.
pub const BUILTIN: [(&str, &str); 2] = [
    ("builtin:uncd-measured", include_str!("../../../data/uncd_psd_measured.csv")),
    ("builtin:uncd-reconstructed", include_str!("../../../data/uncd_psd_reconstructed.csv")),
];

/// What is said wherever the second of them is used.
const RECONSTRUCTION: (&str, &str) =
    ("builtin:uncd-reconstructed", "this spectrum is a reconstruction, not the published one");

/// Why there is no spectrum to work with.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// No spectrum of this name comes with the program.
    #[error("{name}: there is no such spectrum; the built-in ones are {}", BUILTIN.map(|(name, _)| name).join(", "))]
    NoSuchBuiltin {
        /// The name.
        name: String,
    },
    /// The file cannot be had.
    #[error("reading {name}: {error}")]
    Reading {
        /// The file.
        name: String,
        /// Why.
        error: io::Error,
    },
    /// The file cannot be read as a spectrum.
    #[error("{name}: {error}")]
    Spectrum {
        /// The file.
        name: String,
        /// Why.
        error: ReadError,
    },
    /// The file holds heights.
    #[error("{name}: this is a scan ({format}), not its spectrum")]
    Scan {
        /// The file.
        name: String,
        /// The format of the scan.
        format: ScanFormat,
    },
    /// The spectrum is of a convention that cannot become that of a profile.
    #[error("{name}: {error}")]
    Conversion {
        /// The file.
        name: String,
        /// Why.
        error: ConversionError,
    },
    /// Scans yield no spectrum.
    #[error(transparent)]
    Scans(#[from] TopographyError),
}

/// A spectrum ready to be worked with.
#[derive(Debug, Clone)]
pub struct Surface {
    /// The spectrum's file or built-in name, as given.
    pub name: String,
    /// The spectrum in the working convention.
    pub psd: ProfilePsd,
    /// The comment lines of the file: origin, licence, what it is.
    pub remarks: Vec<String>,
    /// What reading took for granted.
    pub notes: Vec<String>,
    /// The scans it is the composite of, where it is not given as a spectrum.
    pub made_from: Option<CompositeSpectrum>,
}

impl Surface {
    /// Reads the spectrum `name`: a built-in one, or a file.
    ///
    /// # Errors
    /// [`SurfaceError`] that names the file, and line, column, value and bound where they are to blame.
    pub fn load(name: &str, files: &dyn Files, options: &ReadOptions) -> Result<Self, SurfaceError> {
        let bytes = if name.starts_with("builtin:") {
            let (_, text) = BUILTIN
                .iter()
                .find(|(builtin, _)| *builtin == name)
                .ok_or_else(|| SurfaceError::NoSuchBuiltin { name: name.to_owned() })?;
            text.as_bytes().to_vec()
        } else {
            files.read(name).map_err(|error| SurfaceError::Reading { name: name.to_owned(), error })?
        };
        let PsdFile { psd, comments, mut notes } =
            read_psd(&bytes[..], options).map_err(|error| match ScanFormat::of_binary(&bytes) {
                Some(format) => SurfaceError::Scan { name: name.to_owned(), format },
                None => SurfaceError::Spectrum { name: name.to_owned(), error },
            })?;
        let psd = psd.profile().map_err(|error| SurfaceError::Conversion { name: name.to_owned(), error })?;
        if name == RECONSTRUCTION.0 {
            notes.push(RECONSTRUCTION.1.to_owned());
        }
        Ok(Surface { name: name.to_owned(), psd, remarks: comments, notes, made_from: None })
    }

    /// The composite spectrum of scans.
    ///
    /// # Errors
    /// [`SurfaceError`] that names the file, and place, value and bound where they are to blame.
    pub fn from_scans(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Self, SurfaceError> {
        let scans = CompositeSpectrum::of_files(requests, files, recipe)?;
        let names: Vec<&str> = requests.iter().map(|request| request.path.as_str()).collect();
        let name = names.join(" + ");
        let psd = scans.psd()?;
        let psd = psd.profile().map_err(|error| SurfaceError::Conversion { name: name.clone(), error })?;
        Ok(Surface { name, psd, remarks: scans.provenance(), notes: scans.notes(), made_from: Some(scans) })
    }

    /// The sum of two surfaces that know nothing of each other: their spectra add where both have one, and elsewhere the
    /// one that does stands alone.
    pub fn against(self, other: Surface) -> Self {
        let sum = superpose(&self.psd, &other.psd);
        let shared = match sum.shared_m {
            Some([longest_m, shortest_m]) => format!(
                "both surfaces have a spectrum from {} to {}, where the two add; elsewhere one stands alone",
                length(longest_m),
                length(shortest_m)
            ),
            None => "the two spectra share no wavelength: each stands alone on its own".to_owned(),
        };
        let of_each = |what: fn(&Surface) -> &Vec<String>| -> Vec<String> {
            // What is said of scans begins with their names.
            let prefixed = |surface: &Surface| -> Vec<String> {
                let named = |line: &String| match surface.made_from {
                    Some(_) => line.clone(),
                    None => format!("{}: {line}", surface.name),
                };
                what(surface).iter().map(named).collect()
            };
            [prefixed(&self), prefixed(&other)].concat()
        };
        let mut notes = of_each(|surface| &surface.notes);
        notes.push(shared);
        Surface {
            name: format!("{} against {}", self.name, other.name),
            psd: sum.psd,
            remarks: of_each(|surface| &surface.remarks),
            notes,
            made_from: None,
        }
    }
}
