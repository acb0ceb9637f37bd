//! The scans in some files become one spectrum, which remembers its files.

use parallel::{Progress, Unobserved};
use scans::{Axis, HeightMap, Scan, ScanFile};
use topography::{CompositeSpectrum, ScanSpectrum, TransformError, without_gaps};
use units::number;

use crate::agreement::{self, Asked};
use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::instrument::InstrumentOfScan;
use crate::load::{Loaded, load};
use crate::request::ScanRequest;
use topography::Recipe;

/// The composite spectrum of the scans in some files.
#[derive(Debug, Clone)]
pub struct CompositeOfFiles {
    /// The spectra of the scans and their composite.
    pub spectrum: CompositeSpectrum,
    /// Where each scan comes from.
    pub sources: Vec<Source>,
    /// What of its maps can be pressed.
    pub maps: Vec<MapPatch>,
}

/// The middle of a map, for whoever presses it.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPatch {
    /// The name of the measurement.
    pub name: String,
    /// Its heights, as measured.
    pub map: HeightMap,
    /// Whether the map meets itself at its edges; its middle then does only where it is the whole of it.
    pub is_periodic: bool,
}

/// What a composite is to be made of.
#[derive(Debug, Clone)]
pub enum AskedScan {
    /// The scans of a file, which is yet to be read.
    File(ScanRequest),
    /// Scans that are in memory, and what is known of them besides; what the request says of reading a file does not count.
    InMemory(ScanRequest, Loaded),
}

/// A file is read, and what is in it transformed.
pub const STEPS_PER_FILE: usize = 2;

/// Points along a side of a patch: what the boundary elements of a judge take.
const MOST_POINTS: usize = 256;

impl MapPatch {
    fn of(file: &ScanFile<Scan>) -> Option<Self> {
        let Scan::Map(map) = &file.scan else { return None };
        let whole = map.columns() <= MOST_POINTS && map.rows() <= MOST_POINTS;
        Some(MapPatch {
            name: file.name.clone(),
            map: map.middle(MOST_POINTS),
            is_periodic: file.is_periodic && whole,
        })
    }
}

/// The file of a scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    /// Its name, as typed.
    pub file: String,
    /// Its SHA-256, in hexadecimal digits.
    pub sha256: String,
    /// The instrument that made it.
    pub instrument: InstrumentOfScan,
}

impl CompositeOfFiles {
    /// Reads the scans, transforms them and averages them.
    ///
    /// # Errors
    /// [`TopographyError`] that names the file, and place, value and bound where they are to blame.
    pub fn read(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Self, TopographyError> {
        Self::read_observed(requests, files, recipe, &Unobserved)
    }

    /// The same, told how far it is: [`STEPS_PER_FILE`] steps for each file.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    pub fn read_observed(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
        progress: &dyn Progress,
    ) -> Result<Self, TopographyError> {
        let asked = requests.iter().cloned().map(AskedScan::File).collect();
        Self::of_scans(asked, files, recipe, progress)
    }

    /// The same of scans some of which are in memory already; their heights are taken and not copied.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    pub fn of_scans(
        asked: Vec<AskedScan>,
        files: &dyn Files,
        recipe: &Recipe,
        progress: &dyn Progress,
    ) -> Result<Self, TopographyError> {
        let of_files = parallel::map_taken(asked, |asked| of_asked(asked, files, recipe, progress));
        let (mut scans, mut maps) = (Vec::new(), Vec::new());
        let mut sources: Vec<Source> = Vec::new();
        let mut request_of = Vec::new();
        for (at, of_file) in of_files.into_iter().enumerate() {
            let of_file = of_file.map_err(|error| TopographyError { request: Some(at), ..error })?;
            request_of.extend(of_file.sources.iter().map(|_| at));
            scans.extend(of_file.scans);
            sources.extend(of_file.sources);
            maps.extend(of_file.maps);
        }
        let asked: Vec<Asked<'_>> = sources
            .iter()
            .zip(&request_of)
            .map(|(source, &request)| Asked { request, path: &source.file, instrument: &source.instrument })
            .collect();
        agreement::check(&asked)?;
        let spectrum = CompositeSpectrum::of(scans, recipe)
            .map_err(|error| TopographyError::of_all(ScanProblem::Transform { scan: None, error }))?;
        Ok(CompositeOfFiles { spectrum, sources, maps })
    }

    /// How the composite was made: the recipe, and the files with their SHA-256.
    #[must_use]
    pub fn provenance(&self) -> Vec<String> {
        let (scans, recipe) = (&self.spectrum.scans, self.spectrum.recipe.describe());
        let mut lines = vec![format!("composite of {} scans; {recipe}", scans.len())];
        for (scan, source) in scans.iter().zip(&self.sources) {
            let channel =
                scan.channel.as_ref().map_or(String::new(), |channel| format!(", channel {channel}"));
            let along = match scan.axis {
                Some(Axis::X) => ", along x",
                Some(Axis::Y) => ", along y",
                None => "",
            };
            lines.push(format!(
                "scan: {} ({}{channel}{along}), SHA-256 {}, detrend {}, window {}, used down to {} m",
                source.file,
                scan.format,
                source.sha256,
                scan.preparation.detrend,
                scan.preparation.window,
                number(scan.band.shortest_m)
            ));
        }
        lines
    }
}

/// What a file brings, a source for each spectrum.
struct OfFile {
    scans: Vec<ScanSpectrum>,
    sources: Vec<Source>,
    maps: Vec<MapPatch>,
}

/// Reads a file, where one is asked for, and transforms every scan in it.
fn of_asked(
    asked: AskedScan,
    files: &dyn Files,
    recipe: &Recipe,
    progress: &dyn Progress,
) -> Result<OfFile, TopographyError> {
    let (request, Loaded { scans, sha256 }) = match asked {
        AskedScan::File(request) => {
            let loaded = load(&request, files)?;
            (request, loaded)
        }
        AskedScan::InMemory(request, loaded) => (request, loaded),
    };
    let request = &request;
    progress.advance(1);
    let recipe = request.recipe(recipe);
    let mut found = OfFile { scans: Vec::new(), sources: Vec::new(), maps: Vec::new() };
    for scan in scans {
        let name = (scan.name != request.path).then(|| scan.name.clone());
        let blame = |error: TransformError| {
            TopographyError::of_file(&request.path, ScanProblem::Transform { scan: name.clone(), error })
        };
        let scan = without_gaps(scan, recipe.gaps).map_err(blame)?;
        let instrument = InstrumentOfScan::of(request, &scan);
        found.maps.extend(MapPatch::of(&scan));
        let spectra = ScanSpectrum::of_directions(scan, request.limits(), &recipe).map_err(blame)?;
        let source = Source { file: request.path.clone(), sha256: sha256.clone(), instrument };
        found.sources.extend(spectra.iter().map(|_| source.clone()));
        found.scans.extend(spectra);
    }
    progress.advance(1);
    Ok(found)
}
