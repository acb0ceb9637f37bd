//! Surfaces read from files: heights as measured, or a spectrum.

use std::io;

use scans::ScanReadError;
use spectrum::{ReadOptions, read_psd};
use topography::Recipe;
use units::named;

use crate::surface::{Surface, SurfaceError};
use measurements::Files;
use measurements::{MapOfFile, ScanProblem, ScanRequest, TopographyError, holds_a_spectrum};

/// The content of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Heights.
    Scan,
    /// A power spectrum.
    Spectrum,
}

named!(Kind, "kind of file", { Scan => "scan", Spectrum => "spectrum" });

/// A surface by its heights or by its spectrum.
#[derive(Debug, Clone)]
pub enum Measured {
    /// The heights of a map.
    Map(Box<MapOfFile>),
    /// A spectrum, which many surfaces share.
    Spectrum(Box<Surface>),
}

/// Options for reading a file.
#[derive(Debug, Clone, Default)]
pub struct MeasuredOptions {
    /// The content of the file; found from the file itself if absent.
    pub kind: Option<Kind>,
    /// Options for reading a spectrum.
    pub spectrum: ReadOptions,
    /// The recipe, including the trend to subtract from heights.
    pub recipe: Recipe,
    /// True if heights repeat themselves, whatever the file says.
    pub repeats: bool,
    /// The map that faces a map; nothing to a spectrum.
    pub facing: Option<ScanRequest>,
}

impl Measured {
    /// Reads a file, or a built-in spectrum.
    ///
    /// # Errors
    /// [`SurfaceError`] with the file, and place, value and bound if they are at fault.
    pub fn load(
        request: &ScanRequest,
        files: &dyn Files,
        options: &MeasuredOptions,
    ) -> Result<Self, SurfaceError> {
        let name = request.path.as_str();
        if name.starts_with("builtin:") {
            return Surface::load(name, files, &options.spectrum)
                .map(|found| Self::Spectrum(Box::new(found)));
        }
        let bytes =
            files.read(name).map_err(|error| SurfaceError::Reading { name: name.to_owned(), error })?;
        let files = &Held { name, bytes: &bytes, others: files };
        let is_spectrum = || holds_a_spectrum(&bytes, &options.spectrum);
        let kind = options.kind.unwrap_or_else(|| if is_spectrum() { Kind::Spectrum } else { Kind::Scan });
        if kind == Kind::Spectrum {
            return Surface::load(name, files, &options.spectrum)
                .map(|found| Self::Spectrum(Box::new(found)));
        }
        let (recipe, repeats) = (&options.recipe, options.repeats);
        let found = match &options.facing {
            Some(other) => MapOfFile::read_facing([request, other], &bytes, files, recipe, repeats),
            None => MapOfFile::read(request, &bytes, files, recipe, repeats),
        };
        match (found, options.kind) {
            (Ok(map), _) => Ok(Self::Map(Box::new(map))),
            // A text that is neither may have been meant as either.
            (Err(TopographyError { problem: ScanProblem::Format(error), file, request }), None)
                if std::str::from_utf8(&bytes).is_ok() && !matches!(*error, ScanReadError::Foreign(_)) =>
            {
                let as_spectrum =
                    read_psd(&bytes[..], &options.spectrum).err().map(|error| error.to_string());
                let problem = ScanProblem::NeitherKind { as_scan: error, as_spectrum };
                Err(TopographyError { file, request, problem }.into())
            }
            (Err(error), _) => Err(error.into()),
        }
    }
}

/// Files of which one was already read, because a stream can be read only once.
struct Held<'f> {
    name: &'f str,
    bytes: &'f [u8],
    others: &'f dyn Files,
}

impl Files for Held<'_> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        if name == self.name { Ok(self.bytes.to_vec()) } else { self.others.read(name) }
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        self.others.read_beside(name, sibling)
    }
}
