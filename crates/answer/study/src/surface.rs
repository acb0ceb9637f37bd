//! The surface that a scene or a command names: its spectrum, and information from its file.

use std::collections::BTreeSet;
use std::io;

use data::SPECTRA;
use scans::{ForeignFile, ScanFormat};
use sha2::{Digest, Sha256};
use spectrum::{
    Convention, ConversionError, Hole, LineProblem, ProfilePsd, Psd, PsdError, PsdFile, ReadError,
    ReadOptions, read_psd, superpose,
};
use tables::Table;
use topography::Recipe;
use units::printable::{hexadecimal, short_paths, shown_path};
use units::{Remark, RemarkCode};

use crate::bodies::Body;
use crate::given_roughness::GivenRoughness;
use measurements::{
    CompositeOfFiles, Files, MapPatch, ScanProblem, ScanRequest, ScansInFolders, TopographyError, heights_in,
};

/// Columns of the two faces in the table of a sum: spectrum and standard errors.
const FACES: [[&str; 2]; 2] = [["C1D_face_1_m3", "C1D_face_1_se_m3"], ["C1D_face_2_m3", "C1D_face_2_se_m3"]];

/// The built-in spectrum that is a reconstruction.
const RECONSTRUCTION: &str = "builtin:uncd-reconstructed";

/// Why there is no spectrum to work with.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// No spectrum of this name comes with the program.
    #[error("{name}: there is no such spectrum; the built-in ones are {}", SPECTRA.map(|(name, _)| name).join(", "))]
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
        error: Box<ReadError>,
    },
    /// The file holds heights.
    #[error("{name}: this is a scan ({format}), not its spectrum")]
    Scan {
        /// The file.
        name: String,
        /// The format of the scan.
        format: ScanFormat,
    },
    /// The file is of a kind that holds no numbers.
    #[error("{name}: this is {kind}; {}", kind.advice())]
    Foreign {
        /// The file.
        name: String,
        /// Its kind.
        kind: ForeignFile,
    },
    /// The convention of the spectrum cannot be converted to that of a profile.
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

impl SurfaceError {
    /// The error of a file that cannot be read as a spectrum, by what it holds instead.
    fn unread(name: String, bytes: &[u8], error: ReadError) -> Self {
        // Texts and workbooks hold anything. A number up to 0 is neither a wavelength nor a spectrum.
        let is_certain = |format: &ScanFormat| *format != ScanFormat::Workbook;
        let may_be_heights = || match error {
            ReadError::AtLine { problem: LineProblem::NoHeader, .. } => has_number_up_to_0(bytes),
            _ => error.names_no_spectrum(),
        };
        let found = ScanFormat::recognise(bytes).filter(is_certain).or_else(|| {
            let of_text = || Some(heights_in(&name, bytes)?.format);
            may_be_heights().then(of_text).flatten()
        });
        match (found, ForeignFile::recognise(bytes)) {
            (Some(format), _) => SurfaceError::Scan { name, format },
            // Workbooks are ZIP files, whose errors are worded by their reader.
            (None, None | Some(ForeignFile::Zip)) => SurfaceError::Spectrum { name, error: Box::new(error) },
            (None, Some(kind)) => SurfaceError::Foreign { name, kind },
        }
    }

    /// Returns true if the cause is a missing file.
    #[must_use]
    pub fn is_missing_file(&self) -> bool {
        let error = match self {
            SurfaceError::Reading { error, .. } => error,
            SurfaceError::Scans(TopographyError { problem: ScanProblem::Reading(error), .. }) => error,
            _ => return false,
        };
        error.kind() == io::ErrorKind::NotFound
    }
}

/// The remark on an assumption that was made in reading a file.
fn reading(text: String) -> Remark {
    Remark::new(RemarkCode::Reading).with("text", text)
}

/// Returns true if a word of a text is a number of 0 or below.
fn has_number_up_to_0(bytes: &[u8]) -> bool {
    let is_separator = |c: char| c.is_whitespace() || ";,".contains(c);
    let text = String::from_utf8_lossy(bytes);
    text.split(is_separator).any(|word| word.parse::<f64>().is_ok_and(|number| number <= 0.0))
}

/// Splits the table of a sum into those of its two faces; `None` for any other file.
fn faces_of_sum(bytes: &[u8]) -> Option<[String; 2]> {
    let lines = std::str::from_utf8(bytes).ok()?.lines().filter(|line| !line.starts_with('#'));
    let mut rows = lines.map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next()?;
    let column = |name: &str| header.iter().position(|column| *column == name);
    let columns = FACES.map(|names| Some([column("wavelength_m")?, column(names[0])?, column(names[1])?]));
    let [Some(own), Some(other)] = columns else { return None };
    let mut faces = [own, other].map(|columns| (columns, "wavelength_m,C1D_m3,C1D_se_m3\n".to_owned()));
    for row in rows {
        for (columns, text) in &mut faces {
            let cells = columns.map(|column| row.get(column).copied().unwrap_or_default());
            if !cells[1].is_empty() {
                *text += &(cells.join(",") + "\n");
            }
        }
    }
    Some(faces.map(|(_, text)| text))
}

/// A file that a surface was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceFile {
    /// Its name, as given.
    pub name: String,
    /// The SHA-256 of its bytes, in hexadecimal digits.
    pub sha256: String,
}

/// A spectrum ready to be worked with.
#[derive(Debug, Clone)]
pub struct Surface {
    /// The spectrum's file or built-in name, as given.
    pub name: String,
    /// The spectrum in the working convention.
    pub psd: ProfilePsd,
    /// The comment lines of the file: origin, licence, description.
    pub remarks: Vec<String>,
    /// Assumptions made in reading, and doubts.
    pub notes: Vec<Remark>,
    /// The scans behind the spectrum, if it is a composite.
    pub made_from: Option<CompositeOfFiles>,
    /// The roughness parameters behind the spectrum, if only they were given.
    pub roughness: Option<GivenRoughness>,
    /// The files that were read. Files of scans are in the remarks.
    pub sources: Vec<SourceFile>,
    /// The two surfaces, if this is the sum of two.
    pub parts: Option<Box<[Surface; 2]>>,
    /// The sum of the two maps, if it is the sum of two surfaces that were scanned as one map each.
    facing: Option<MapPatch>,
    /// The wavelengths that were not measured, from long to short. There neighbouring samples of the spectrum
    /// are a factor of [`spectrum::HOLE_FACTOR`] or more apart. For the sum of two surfaces, these are the holes of
    /// either.
    pub holes: Vec<Hole>,
}

impl Surface {
    /// Reads the spectrum `name`: a built-in one, or a file.
    ///
    /// # Errors
    /// [`SurfaceError`] with the file, and line, column, value and bound if they are at fault.
    pub fn load(name: &str, files: &dyn Files, options: &ReadOptions) -> Result<Self, SurfaceError> {
        let bytes = if name.starts_with("builtin:") {
            let (_, text) = SPECTRA
                .iter()
                .find(|(builtin, _)| *builtin == name)
                .ok_or_else(|| SurfaceError::NoSuchBuiltin { name: name.to_owned() })?;
            text.as_bytes().to_vec()
        } else {
            files.read(name).map_err(|error| SurfaceError::Reading { name: name.to_owned(), error })?
        };
        let read = |bytes: &[u8]| {
            let unread = |error| SurfaceError::unread(name.to_owned(), bytes, error);
            let PsdFile { psd, comments, notes } = read_psd(bytes, options).map_err(unread)?;
            Ok::<_, SurfaceError>((Self::of_psd(shown_path(name).to_owned(), psd)?, comments, notes))
        };
        let (mut surface, comments, notes) = read(&bytes)?;
        if let Some([own, other]) = faces_of_sum(&bytes).filter(|_| *options == ReadOptions::default()) {
            // The waves of two faces add, which their sum alone does not tell.
            let both = read(own.as_bytes())?.0.against(read(other.as_bytes())?.0);
            surface = Surface { name: surface.name, ..both };
        }
        surface.remarks = comments;
        let mut notes: Vec<Remark> = notes.into_iter().map(reading).collect();
        if name == RECONSTRUCTION {
            notes.push(Remark::new(RemarkCode::Reconstruction));
        }
        surface.notes.splice(..0, notes);
        surface.sources =
            vec![SourceFile { name: name.to_owned(), sha256: hexadecimal(Sha256::digest(&bytes)) }];
        Ok(surface)
    }

    /// Makes a surface from a spectrum with a name, without a file.
    ///
    /// # Errors
    /// [`SurfaceError::Conversion`] if its convention cannot be converted to that of a profile.
    pub fn of_psd(name: String, psd: Psd) -> Result<Self, SurfaceError> {
        let psd = psd.profile().map_err(|error| SurfaceError::Conversion { name: name.clone(), error })?;
        let holes = psd.holes();
        let notes = Hole::remark(RemarkCode::Holes, &holes).into_iter().collect();
        Ok(Surface { notes, holes, ..Self::plain(name, psd) })
    }

    /// A spectrum with a name, of which nothing else is known.
    fn plain(name: String, psd: ProfilePsd) -> Self {
        Surface {
            name,
            psd,
            remarks: Vec::new(),
            notes: Vec::new(),
            made_from: None,
            roughness: None,
            sources: Vec::new(),
            parts: None,
            facing: None,
            holes: Vec::new(),
        }
    }

    /// Makes the composite spectrum of scans.
    ///
    /// # Errors
    /// [`SurfaceError`] with the file, and place, value and bound if they are at fault.
    pub fn from_scans(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Self, SurfaceError> {
        let paths = || requests.iter().map(|request| request.path.as_str());
        let short = short_paths(paths());
        let names: Vec<&str> = paths().map(|path| short[path].as_str()).collect();
        let found = ScansInFolders::find(requests, files)?;
        let composite = CompositeOfFiles::read(&found.requests, files, recipe).map_err(|error| {
            let request = error.request.map(|request| found.origins[request]);
            TopographyError { request, ..error }
        })?;
        let mut surface = Self::of_composite(composite, names.join(" + "))?;
        surface.notes.extend(found.note().map(reading));
        Ok(surface)
    }

    /// Makes a surface from a composite spectrum with a name.
    ///
    /// # Errors
    /// [`SurfaceError`] if a spectrum may not have its values.
    pub fn of_composite(scans: CompositeOfFiles, name: String) -> Result<Self, SurfaceError> {
        let psd = scans
            .spectrum
            .psd()
            .map_err(|error| TopographyError::for_all(ScanProblem::Transform { scan: None, error }))?;
        let psd = psd.profile().map_err(|error| SurfaceError::Conversion { name: name.clone(), error })?;
        let notes = scans.spectrum.remarks();
        let (remarks, holes) = (scans.provenance(), scans.spectrum.holes());
        Ok(Surface { remarks, notes, made_from: Some(scans), holes, ..Self::plain(name, psd) })
    }

    /// The spectrum of roughness parameters.
    ///
    /// # Errors
    /// None: a spectrum of profiles needs no conversion.
    pub fn of_roughness(given: GivenRoughness) -> Result<Self, SurfaceError> {
        let name = given.name();
        let psd = given.profile.psd();
        let psd = psd.profile().map_err(|error| SurfaceError::Conversion { name: name.clone(), error })?;
        Ok(Surface { notes: vec![given.remark()], roughness: Some(given), ..Self::plain(name, psd) })
    }

    /// Returns the words for the surface whose spectrum is made of roughness parameters; `None` if all were measured.
    #[must_use]
    pub fn assumed(&self) -> Option<&'static str> {
        let is_assumed = |part: &Surface| part.assumed().is_some();
        match self.parts.as_deref().map(|[rough, counterface]| [rough, counterface].map(is_assumed)) {
            None => self.roughness.as_ref().map(|_| "the surface"),
            Some([true, true]) => Some("both surfaces"),
            Some([true, false]) => Some(Body::Rough.words()),
            Some([false, true]) => Some(Body::Counterface.words()),
            Some([false, false]) => None,
        }
    }

    /// Adds the spectrum of another, uncorrelated surface. Where only one of the two has a spectrum, the sum is that
    /// one.
    pub fn against(self, other: Surface) -> Self {
        let sum = superpose(&self.psd, &other.psd);
        let mut holes = [self.holes.clone(), other.holes.clone(), sum.psd.holes()].concat();
        holes.sort_by(|a, b| b.longest_m.total_cmp(&a.longest_m));
        holes.dedup();
        let mut notes: Vec<Remark> = [&self, &other].into_iter().flat_map(Surface::named_notes).collect();
        let apart: Vec<Hole> =
            sum.psd.holes().into_iter().filter(|hole| !self.has(hole) && !other.has(hole)).collect();
        notes.extend(Hole::remark(RemarkCode::Holes, &apart));
        notes.push(match sum.shared_m {
            Some([longest_m, shortest_m]) => Remark::new(RemarkCode::Superposition)
                .with("longest_m", longest_m)
                .with("shortest_m", shortest_m),
            None => Remark::new(RemarkCode::NothingShared),
        });
        let facing = match (self.maps(), other.maps()) {
            ([own], [faced]) if self.is_one_scan() && other.is_one_scan() => own.facing(faced),
            _ => None,
        };
        let facing = facing.map(|(map, remarks)| {
            notes.extend(remarks);
            map
        });
        let remarks = [&self, &other].into_iter().flat_map(Surface::named_remarks).collect();
        let path = |of: &'_ Surface| match &of.sources[..] {
            [one] => one.name.clone(),
            _ => of.name.clone(),
        };
        let paths = [path(&self), path(&other)];
        let short = short_paths(paths.iter().map(String::as_str));
        let name = paths.map(|path| short[&path].clone()).join(" against ");
        let sources = [&self.sources[..], &other.sources[..]].concat();
        let parts = Some(Box::new([self, other]));
        Surface { remarks, notes, sources, parts, facing, holes, ..Self::plain(name, sum.psd) }
    }

    /// Returns the samples between two wavelengths \[m\], both included; the ends of the spectrum if absent. The part no longer
    /// knows the scans or parameters that the whole was made of.
    ///
    /// # Errors
    /// [`PsdError`] if no sample is left.
    pub fn between(&self, longest_m: Option<f64>, shortest_m: Option<f64>) -> Result<Self, PsdError> {
        let (longest_m, shortest_m) = (longest_m.unwrap_or(f64::INFINITY), shortest_m.unwrap_or(0.0));
        let wavelengths_m = self.psd.wavelengths_m();
        let is_kept = |at: &usize| (shortest_m..=longest_m).contains(&wavelengths_m[*at]);
        let kept: Vec<usize> = (0..wavelengths_m.len()).filter(is_kept).collect();
        let of = |values: &[f64]| kept.iter().map(|at| values[*at]).collect();
        let mut psd = Psd::new(of(wavelengths_m), of(self.psd.c1d_m3()), Convention::C1D)?;
        if let Some(errors_m3) = self.psd.standard_errors_m3() {
            psd = psd.with_standard_errors(kept.iter().map(|at| errors_m3[*at]).collect())?;
        }
        let psd =
            psd.profile().expect("a spectrum of profiles needs no conversion").with_surface_of(&self.psd);
        let holes = psd.holes();
        Ok(Surface {
            psd,
            made_from: None,
            roughness: None,
            parts: None,
            facing: None,
            holes,
            ..self.clone()
        })
    }

    /// Makes a table that reads back as this spectrum: of a composite that of [`CompositeOfFiles::table`], of others the columns
    /// `wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3`; of a sum those of its faces as well.
    #[must_use]
    pub fn table(&self) -> Table {
        if let Some(scans) = &self.made_from {
            return scans.table();
        }
        let wavelengths_m = self.psd.wavelengths_m();
        let table = Table::default()
            .with_numbers("wavelength_m", wavelengths_m.iter().copied())
            .with_numbers("wavevector_rad_per_m", wavelengths_m.iter().map(|m| std::f64::consts::TAU / m))
            .with_numbers("C1D_m3", self.psd.c1d_m3().iter().copied());
        let table = match self.psd.standard_errors_m3() {
            Some(errors_m3) => table.with_numbers("C1D_se_m3", errors_m3.iter().copied()),
            None => table,
        };
        self.parts.iter().flat_map(|faces| faces.iter().zip(FACES)).fold(table, |table, (face, names)| {
            let own_m = face.psd.wavelengths_m();
            let at = |wavelength_m: &f64| own_m.binary_search_by(|own_m| wavelength_m.total_cmp(own_m)).ok();
            let value = |wavelength_m| at(wavelength_m).map(|at| face.psd.c1d_m3()[at]);
            let error = |wavelength_m| face.psd.standard_errors_m3()?[at(wavelength_m)?];
            let table = table.with_numbers(names[0], wavelengths_m.iter().map(value));
            table.with_numbers(names[1], wavelengths_m.iter().map(error))
        })
    }

    /// The surfaces that it is the sum of, or itself.
    #[must_use]
    pub fn each(&self) -> Vec<&Surface> {
        match &self.parts {
            Some(parts) => parts.iter().flat_map(Surface::each).collect(),
            None => vec![self],
        }
    }

    /// Returns the maps behind the spectrum, for boundary elements; of a sum the sum of its maps, if each surface is one map.
    #[must_use]
    pub fn maps(&self) -> &[MapPatch] {
        match (&self.facing, &self.made_from) {
            (Some(facing), _) => std::slice::from_ref(facing),
            (None, Some(scans)) => &scans.maps,
            (None, None) => &[],
        }
    }

    /// Returns true if the spectrum is that of a single file.
    fn is_one_scan(&self) -> bool {
        self.files().len() == 1
    }

    /// Returns true if its spectrum has standard errors and is not made from scans.
    #[must_use]
    pub fn scatters_by_errors(&self) -> bool {
        let errors_m3 = self.psd.standard_errors_m3().unwrap_or_default();
        self.made_from.is_none() && errors_m3.iter().flatten().any(|error_m3| *error_m3 > 0.0)
    }

    /// Returns the names of the files behind this surface, as given.
    #[must_use]
    pub fn files(&self) -> BTreeSet<&str> {
        let scans = self.each().into_iter().filter_map(|surface| surface.made_from.as_ref());
        let scans = scans.flat_map(|scans| scans.sources.iter().map(|source| source.file.as_str()));
        scans.chain(self.sources.iter().map(|source| source.name.as_str())).collect()
    }

    /// Returns the text of a scene with file names in place of the paths of these files.
    #[must_use]
    pub fn without_folders(&self, scene: &str) -> String {
        let mut names: Vec<(String, String)> = short_paths(self.files()).into_iter().collect();
        names.sort_by_key(|(path, _)| std::cmp::Reverse(path.len()));
        names.iter().fold(scene.to_owned(), |text, (path, name)| text.replace(path, name))
    }

    fn has(&self, hole: &Hole) -> bool {
        self.holes.contains(hole)
    }

    /// Returns the notes with the name of the surface. Notes on scans already have names.
    fn named_notes(&self) -> Vec<Remark> {
        let mut notes = self.notes.clone();
        for note in notes.iter_mut().filter(|note| !note.code.is_about_scans()) {
            note.place.surface.get_or_insert_with(|| self.name.clone());
        }
        notes
    }

    /// Returns the remarks with the name of the surface, except for those that name scans.
    fn named_remarks(&self) -> Vec<String> {
        let named = |line: &String| match self.made_from {
            Some(_) => line.clone(),
            None => format!("{}: {line}", self.name),
        };
        self.remarks.iter().map(named).collect()
    }
}
