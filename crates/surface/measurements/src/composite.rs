//! The composite spectrum of the scans in files, with its provenance.

use std::collections::{BTreeSet, HashMap};

use numerics::parallel::{Progress, Unobserved};
use scans::ScanAxis;
use tables::Table;
use topography::{CompositeSpectrum, ScanSpectrum, TransformError, without_gaps, without_spikes};
use units::number;
use units::printable::short_paths;

use crate::agreement::{self, InstrumentUse};
use crate::error::{ScanProblem, TopographyError};
use crate::files::{Files, file_name};
use crate::instrument::InstrumentOfScan;
use crate::load::{Loaded, load};
use crate::map_patch::MapPatch;
use crate::request::ScanRequest;
use crate::sketch::ScanSketch;
use topography::Recipe;

/// The composite spectrum of the scans in files.
#[derive(Debug, Clone)]
pub struct CompositeOfFiles {
    /// The spectra of the scans and their composite.
    pub spectrum: CompositeSpectrum,
    /// Origin of each scan.
    pub sources: Vec<ScanSource>,
    /// Middles of its maps, for boundary elements.
    pub maps: Vec<MapPatch>,
    /// The scans in short, where they were asked for; a map has one, also if it has a spectrum along each axis.
    pub sketches: Vec<ScanSketch>,
}

/// Input of a composite: a file or scans in memory.
#[derive(Debug, Clone)]
pub enum ScanInput {
    /// The scans of a file to read.
    File(ScanRequest),
    /// Scans in memory; options of the request about reading a file are ignored.
    InMemory(ScanRequest, Loaded),
}

/// Progress steps per file: reading it and transforming its scans.
pub const STEPS_PER_FILE: usize = 2;

/// Largest number of points along a side of a patch, for the boundary elements of the judge.
const MOST_POINTS: usize = 1024;
/// That among more than [`FEW_FILES`] files, so that patches of many maps take little memory.
const MOST_POINTS_OF_MANY: usize = 256;
/// Files that may all be maps to press.
const FEW_FILES: usize = 3;

/// The origin of a scan.
#[derive(Debug, Clone, PartialEq)]
pub struct ScanSource {
    /// File name as typed.
    pub file: String,
    /// SHA-256 in hexadecimal digits.
    pub sha256: String,
    /// The instrument of the scan.
    pub instrument: InstrumentOfScan,
}

impl CompositeOfFiles {
    /// Reads scans, transforms them and averages their spectra.
    ///
    /// # Errors
    /// [`TopographyError`] with the file, and with place, value and bound where they apply.
    pub fn read(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Self, TopographyError> {
        let inputs = requests.iter().cloned().map(ScanInput::File).collect();
        Self::from_scans(inputs, files, recipe, &Unobserved)
    }

    /// Reads scans as [`read`](Self::read) does, but makes no sketches of them, which take as long as the
    /// transform. Reports progress, [`STEPS_PER_FILE`] steps per file.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_spectrum(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
        progress: &dyn Progress,
    ) -> Result<Self, TopographyError> {
        let inputs = requests.iter().cloned().map(ScanInput::File).collect();
        Self::averaged(inputs, files, recipe, Sketches::None, progress)
    }

    /// Transforms and averages scans from files and from memory; heights in memory are moved, not copied.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn from_scans(
        inputs: Vec<ScanInput>,
        files: &dyn Files,
        recipe: &Recipe,
        progress: &dyn Progress,
    ) -> Result<Self, TopographyError> {
        Self::averaged(inputs, files, recipe, Sketches::PerScan, progress)
    }

    fn averaged(
        inputs: Vec<ScanInput>,
        files: &dyn Files,
        recipe: &Recipe,
        wanted: Sketches,
        progress: &dyn Progress,
    ) -> Result<Self, TopographyError> {
        let most_points = if inputs.len() > FEW_FILES { MOST_POINTS_OF_MANY } else { MOST_POINTS };
        let transform = |input| transform_input(input, files, recipe, (wanted, most_points), progress);
        let of_files = numerics::parallel::map_owned(inputs, transform);
        let (mut scans, mut maps, mut sketches) = (Vec::new(), Vec::new(), Vec::new());
        let mut sources: Vec<ScanSource> = Vec::new();
        let mut request_of = Vec::new();
        for (at, of_file) in of_files.into_iter().enumerate() {
            let of_file = of_file.map_err(|error| TopographyError { request: Some(at), ..error })?;
            request_of.extend(of_file.sources.iter().map(|_| at));
            scans.extend(of_file.scans);
            sources.extend(of_file.sources);
            maps.extend(of_file.maps);
            sketches.extend(of_file.sketches);
        }
        name_instruments_of_texts(&mut sources);
        let uses: Vec<InstrumentUse<'_>> = sources
            .iter()
            .zip(&request_of)
            .map(|(source, &request)| InstrumentUse {
                request,
                path: &source.file,
                instrument: &source.instrument,
            })
            .collect();
        agreement::check(&uses)?;
        let spectrum = CompositeSpectrum::new(scans, recipe)
            .map_err(|error| TopographyError::for_all(ScanProblem::Transform { scan: None, error }))?;
        Ok(CompositeOfFiles { spectrum, sources, maps, sketches })
    }

    /// Provenance of the composite: the recipe, and the files with their SHA-256.
    #[must_use]
    pub fn provenance(&self) -> Vec<String> {
        let (scans, recipe) = (&self.spectrum.scans, self.spectrum.recipe.describe());
        let mut lines = vec![format!("composite of {} scans; {recipe}", scans.len())];
        let names = short_paths(self.sources.iter().map(|source| source.file.as_str()));
        for (scan, source) in scans.iter().zip(&self.sources) {
            let channel =
                scan.channel.as_ref().map_or(String::new(), |channel| format!(", channel {channel}"));
            let along = match scan.axis {
                Some(ScanAxis::X) => ", along x",
                Some(ScanAxis::Y) => ", along y",
                None => "",
            };
            lines.push(format!(
                "scan: {} ({}{channel}{along}), SHA-256 {}, detrend {}, window {}, used down to {} m",
                names[&source.file],
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

/// Names the instruments that wrote plain texts: files of one length and spacing are taken to share one, and any other
/// file has one of its own. The maker of a format names the others.
fn name_instruments_of_texts(sources: &mut [ScanSource]) {
    let mut files: HashMap<String, BTreeSet<String>> = HashMap::new();
    for source in sources.iter() {
        if let Some(layout) = &source.instrument.layout {
            files.entry(layout.clone()).or_default().insert(source.file.clone());
        }
    }
    let names = short_paths(sources.iter().map(|source| source.file.as_str()));
    for source in sources {
        if let Some(layout) = &source.instrument.layout {
            source.instrument.name = match files[layout].len() {
                1 => names[&source.file].clone(),
                _ => format!("text of {layout}"),
            };
        }
    }
}

/// Spectra of one file, with one source per spectrum.
struct FileSpectra {
    scans: Vec<ScanSpectrum>,
    sources: Vec<ScanSource>,
    maps: Vec<MapPatch>,
    sketches: Vec<ScanSketch>,
}

/// Sketches to make of scans, for pages that show them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sketches {
    None,
    PerScan,
}

/// Reads the file, if the scans are not in memory, and transforms every scan in it.
fn transform_input(
    input: ScanInput,
    files: &dyn Files,
    recipe: &Recipe,
    (wanted, most_points): (Sketches, usize),
    progress: &dyn Progress,
) -> Result<FileSpectra, TopographyError> {
    let (request, Loaded { scans, sha256 }) = match input {
        ScanInput::File(request) => {
            let loaded = load(&request, files)?;
            (request, loaded)
        }
        ScanInput::InMemory(request, loaded) => (request, loaded),
    };
    let request = &request;
    progress.advance(1);
    let recipe = request.recipe(recipe);
    let mut found =
        FileSpectra { scans: Vec::new(), sources: Vec::new(), maps: Vec::new(), sketches: Vec::new() };
    for scan in scans {
        let name = (scan.name != file_name(&request.path)).then(|| scan.name.clone());
        let blame = |error: TransformError| {
            TopographyError::for_file(&request.path, ScanProblem::Transform { scan: name.clone(), error })
        };
        if wanted == Sketches::PerScan {
            found.sketches.push(ScanSketch::new(&scan));
        }
        let scan = if recipe.remove_spikes { without_spikes(scan).map_err(blame)? } else { scan };
        let scan = without_gaps(scan, recipe.gaps).map_err(blame)?;
        let instrument = InstrumentOfScan::new(request, &scan);
        found.maps.extend(MapPatch::from_file(&scan, &recipe, most_points));
        let spectra = ScanSpectrum::per_direction(scan, request.limits(), &recipe).map_err(blame)?;
        let source = ScanSource { file: request.path.clone(), sha256: sha256.clone(), instrument };
        found.sources.extend(spectra.iter().map(|_| source.clone()));
        found.scans.extend(spectra);
    }
    progress.advance(1);
    Ok(found)
}

impl CompositeOfFiles {
    /// Makes a table of the composite, one row per bin from long to short wavelengths, with the columns `wavelength_m,
    /// wavevector_rad_per_m, C1D_m3, C1D_se_m3, measurements, degrees_of_freedom`.
    #[must_use]
    pub fn table(&self) -> Table {
        let bins = &self.spectrum.composite.bins;
        Table::default()
            .with_numbers("wavelength_m", bins.iter().map(|bin| bin.wavelength_m))
            .with_numbers("wavevector_rad_per_m", bins.iter().map(|bin| wavevector(bin.wavelength_m)))
            .with_numbers("C1D_m3", bins.iter().map(|bin| bin.c1d_m3))
            .with_numbers("C1D_se_m3", bins.iter().map(|bin| bin.standard_error_m3))
            .with_numbers("measurements", bins.iter().map(|bin| bin.measurements as f64))
            .with_numbers("degrees_of_freedom", bins.iter().map(|bin| bin.degrees_of_freedom))
    }

    /// Makes a table of all spectra with the columns `series, wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3`.
    ///
    /// Each scan has two series: its reliable band under its name, and the whole under its name with `(incl. unreliable
    /// data)`. The composite comes last.
    #[must_use]
    pub fn series_table(&self) -> Table {
        let found = &self.spectrum;
        let mut rows: Vec<(String, f64, f64, Option<f64>)> = Vec::new();
        for (scan, name) in found.scans.iter().zip(found.series_names()) {
            let reliable = scan.reliable.wavelengths_m().iter().zip(scan.reliable.c1d_m3());
            rows.extend(reliable.map(|(wavelength_m, c1d_m3)| (name.clone(), *wavelength_m, *c1d_m3, None)));
            let whole = scan.spectrum.wavelengths_m().zip(&scan.spectrum.c1d_m3);
            rows.extend(whole.filter(|(_, c1d_m3)| **c1d_m3 > 0.0).map(|(wavelength_m, c1d_m3)| {
                (format!("{name} (incl. unreliable data)"), wavelength_m, *c1d_m3, None)
            }));
        }
        let bins = found.composite.bins.iter();
        rows.extend(
            bins.map(|bin| ("composite".to_owned(), bin.wavelength_m, bin.c1d_m3, bin.standard_error_m3)),
        );
        Table::default()
            .with_text("series", rows.iter().map(|row| row.0.clone()))
            .with_numbers("wavelength_m", rows.iter().map(|row| row.1))
            .with_numbers("wavevector_rad_per_m", rows.iter().map(|row| wavevector(row.1)))
            .with_numbers("C1D_m3", rows.iter().map(|row| row.2))
            .with_numbers("C1D_se_m3", rows.iter().map(|row| row.3))
    }
}

fn wavevector(wavelength_m: f64) -> f64 {
    std::f64::consts::TAU / wavelength_m
}
