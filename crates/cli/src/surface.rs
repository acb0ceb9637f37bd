//! The surface a scene or a command names: its spectrum, and what its file says about itself.

use std::path::Path;

use spectrum::{ProfilePsd, PsdFile, ReadOptions, read_psd, superpose};

use crate::failure::Failure;
use crate::output::{Place, utf8};
use crate::table::{Format, InputTable};
use crate::topography::{CompositeSpectrum, Recipe, ScanFailure, ScanRequest};
use units::display::length;

/// Spectra that come with the program, under the names by which they are asked for, as the text of their files; origin
/// and licence stand in their comments.
pub const BUILTIN: [(&str, &str); 2] = [
    ("builtin:uncd-measured", include_str!("../../../data/uncd_psd_measured.csv")),
    ("builtin:uncd-reconstructed", include_str!("../../../data/uncd_psd_reconstructed.csv")),
];

/// What is said wherever the second of them is used.
const RECONSTRUCTION: (&str, &str) =
    ("builtin:uncd-reconstructed", "this spectrum is a reconstruction, not the published one");

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
    /// Reads the spectrum `name`: a built-in one, `-` for standard input, or a file, relative to `folder`.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file, and line, column, value and bound where they are to blame.
    pub fn load(name: &str, folder: &Path, options: &ReadOptions) -> Result<Self, Failure> {
        let blame = |error: &dyn std::fmt::Display| Failure::Input(format!("{name}: {error}"));
        let PsdFile { psd, comments, notes } = if name.starts_with("builtin:") {
            let (_, text) = BUILTIN.iter().find(|(builtin, _)| *builtin == name).ok_or_else(|| {
                let names = BUILTIN.map(|(builtin, _)| builtin).join(", ");
                Failure::Input(format!("{name}: there is no such spectrum; the built-in ones are {names}"))
            })?;
            read_psd(text.as_bytes(), options).map_err(|error| blame(&error))?
        } else {
            let place = match Place::from(name) {
                Place::File(path) => Place::File(folder.join(path)),
                Place::Standard => Place::Standard,
            };
            let bytes = place.read()?;
            let csv = json_as_csv(&bytes, name)?;
            read_psd(csv.as_deref().unwrap_or(&bytes), options).map_err(|error| blame(&error))?
        };
        let psd = psd.profile().map_err(|error| blame(&error))?;
        let mut notes = notes;
        if name == RECONSTRUCTION.0 {
            notes.push(RECONSTRUCTION.1.to_owned());
        }
        Ok(Surface { name: name.to_owned(), psd, remarks: comments, notes, made_from: None })
    }

    /// The composite spectrum of scans, relative to `folder`.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file, and place, value and bound where they are to blame.
    pub fn from_scans(requests: &[ScanRequest], folder: &Path, recipe: &Recipe) -> Result<Self, ScanFailure> {
        let scans = CompositeSpectrum::of_files(requests, folder, recipe)?;
        let psd = scans.psd()?.profile().map_err(Failure::input)?;
        let files: Vec<&str> = requests.iter().map(|request| request.path.as_str()).collect();
        Ok(Surface {
            name: files.join(" + "),
            psd,
            remarks: scans.provenance(),
            notes: scans.notes(),
            made_from: Some(scans),
        })
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

/// A spectrum given as an array of row objects, as CSV; its row n is then line n + 1. Anything else is no JSON table.
fn json_as_csv(bytes: &[u8], name: &str) -> Result<Option<Vec<u8>>, Failure> {
    if bytes.trim_ascii_start().first() != Some(&b'[') {
        return Ok(None);
    }
    let rows = InputTable::from_json(utf8(bytes, name, "spectrum")?, name.to_owned())?;
    // An array of series, each with its points, is not one of rows.
    if rows.table.column("x").is_some() && rows.table.column("y").is_some() {
        return Ok(None);
    }
    let mut csv = Vec::new();
    rows.table.write(Format::Csv, &[], &mut csv).map_err(|error| Failure::reading(name, &error))?;
    Ok(Some(csv))
}
