//! Synthetic study: scans of a known surface by instruments with inexact height scales.

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, ScanRequest};
use topography::{CompositeSpectrum, Recipe};

use super::instrument::{AFM, GAIN_SD, INSTRUMENTS, Instrument, Shape};
use super::lines::LineMaker;
use super::maps::MapMaker;
use super::npy;
use super::random::Normals;
use super::surface::KnownSurface;
use crate::TrialError;

/// Upper limit of the scan numbers within a study.
const MOST_SCANS: u64 = 1 << 10;

/// Generator of synthetic studies of one surface.
#[derive(Debug, Clone)]
pub struct Laboratory {
    /// Surface that is measured.
    pub surface: KnownSurface,
    instruments: Vec<(Instrument, Maker)>,
    seed: u64,
}

/// Generator of the scans of one instrument.
#[derive(Debug, Clone)]
enum Maker {
    Lines(LineMaker),
    Maps(MapMaker),
}

/// Files of a study.
#[derive(Debug, Clone)]
pub struct SyntheticStudy {
    /// Contents of the files by name.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Scans, each with its instrument.
    pub scans: Vec<(Instrument, ScanRequest)>,
}

impl Laboratory {
    /// Creates a surface of this Hurst exponent, with both instruments.
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] for an exponent out of range.
    pub fn new(hurst_exponent: f64, seed: u64) -> Result<Self, TrialError> {
        let surface = KnownSurface::new(hurst_exponent, 2.0 * AFM.spacing_m())?;
        Self::of_surface(surface, &INSTRUMENTS, seed)
    }

    /// Puts a surface under the given instruments.
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] if the band of an instrument does not fit the surface.
    pub fn of_surface(
        surface: KnownSurface,
        instruments: &[Instrument],
        seed: u64,
    ) -> Result<Self, TrialError> {
        let maker = |instrument: &Instrument| -> Result<(Instrument, Maker), TrialError> {
            let maker = match instrument.shape {
                Shape::Line => Maker::Lines(LineMaker::new(&surface, instrument)?),
                Shape::Map => Maker::Maps(MapMaker::new(&surface, instrument)?),
            };
            Ok((*instrument, maker))
        };
        let instruments = instruments.iter().map(maker).collect::<Result<_, _>>()?;
        Ok(Laboratory { surface, instruments, seed })
    }

    /// Returns the study of a number, with `scans` by each instrument, below a thousand. The first scans do not
    /// depend on how many there are.
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] if the band of an instrument does not fit the surface.
    pub fn study(&self, number: u64, scans: &[u32]) -> Result<SyntheticStudy, TrialError> {
        let (mut files, mut requests) = (BTreeMap::new(), Vec::new());
        for (place, (instrument, scans)) in self.instruments.iter().zip(scans).enumerate() {
            let (instrument, maker) = instrument;
            let first = (number * self.instruments.len() as u64 + place as u64) * MOST_SCANS;
            let gain = 1.0 + GAIN_SD * Normals::new(self.seed, first).next();
            for scan in 1..=u64::from(*scans) {
                let mut heights_m = self.heights_m(maker, first + scan)?;
                heights_m.iter_mut().for_each(|height_m| *height_m *= gain);
                let path = format!("{}-{scan}.npy", instrument.name);
                files.insert(path.clone(), npy::array(&heights_m, instrument.points));
                requests.push((*instrument, request(path, instrument)));
            }
        }
        Ok(SyntheticStudy { files, scans: requests })
    }

    fn heights_m(&self, maker: &Maker, number: u64) -> Result<Vec<f64>, TrialError> {
        let mut normals = Normals::new(self.seed, number);
        match maker {
            Maker::Lines(lines) => Ok(lines.line(&mut normals)),
            Maker::Maps(maps) => maps.map(self.seed, number, &mut normals),
        }
    }
}

fn request(path: String, instrument: &Instrument) -> ScanRequest {
    ScanRequest {
        path,
        unit: "m".parse().ok(),
        size_m: Some(instrument.length_m),
        shortest_m: Some(instrument.shortest_m),
        ..ScanRequest::default()
    }
}

impl SyntheticStudy {
    /// Composite of all scans.
    ///
    /// # Errors
    /// [`TrialError::Scans`] if the files cannot be read.
    pub fn composite(&self) -> Result<CompositeSpectrum, TrialError> {
        let requests: Vec<ScanRequest> = self.scans.iter().map(|(_, request)| request.clone()).collect();
        Ok(CompositeOfFiles::read(&requests, &self.files, &Recipe::default())?.spectrum)
    }
}
