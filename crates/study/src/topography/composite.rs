//! Several spectra become one.

use spectrum::{Convention, Psd};
use topography::{BinMean, Composite, CompositeOptions, Overlap, composite, overlaps};

use super::error::{ScanProblem, TopographyError};
use super::measure::ScanSpectrum;
use super::request::{Average, Recipe, ScanRequest};
use crate::files::Files;
use tables::Table;
use units::display::{length, three_digits};
use units::number;

/// Instruments that differ by more than this factor where they overlap hardly show the same surface in the same units.
const DISAGREEMENT: f64 = 3.0;
/// In fewer shared bins the scatter of single lines may look like such a factor.
const TELLING_BINS: usize = 3;

/// Two instruments that do not show the same surface.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct InstrumentsDisagree {
    /// The names of the scans.
    pub names: [String; 2],
    /// The spectrum of the first over that of the second, on average where they overlap.
    pub ratio: f64,
    /// The longest wavelength they share \[m\].
    pub longest_m: f64,
    /// The shortest.
    pub shortest_m: f64,
}

/// The spectra of some scans and their composite.
#[derive(Debug, Clone)]
pub struct CompositeSpectrum {
    /// How they were made.
    pub recipe: Recipe,
    /// Each scan.
    pub scans: Vec<ScanSpectrum>,
    /// What neighbouring instruments say of the wavelengths that they share.
    pub overlaps: Vec<Overlap>,
    /// The composite.
    pub composite: Composite,
}

impl CompositeSpectrum {
    /// Reads the scans, transforms them and averages them.
    ///
    /// # Errors
    /// [`TopographyError`] that names the file, and place, value and bound where they are to blame.
    pub fn of_files(
        requests: &[ScanRequest],
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Self, TopographyError> {
        let of_files = parallel::map(requests, |request| ScanSpectrum::of_file(request, files, recipe));
        let mut scans = Vec::new();
        for (at, of_file) in of_files.into_iter().enumerate() {
            scans.extend(of_file.map_err(|error| TopographyError { request: Some(at), ..error })?);
        }
        let reliable: Vec<_> = scans.iter().map(|scan| scan.reliable.clone()).collect();
        let options = CompositeOptions {
            bins_per_decade: recipe.bins_per_decade,
            across: match recipe.average {
                Average::Log => BinMean::Geometric,
                Average::Arithmetic => BinMean::Arithmetic,
            },
            ..CompositeOptions::default()
        };
        let overlaps = overlaps(&reliable, recipe.bins_per_decade);
        let composite = composite(&reliable, &options)
            .map_err(|error| TopographyError::of_all(ScanProblem::Transform { scan: None, error }))?;
        Ok(CompositeSpectrum { recipe: *recipe, scans, overlaps, composite })
    }

    /// The composite as a spectrum with standard errors.
    ///
    /// # Errors
    /// [`TopographyError`] where its bins are too few to be one.
    pub fn psd(&self) -> Result<Psd, TopographyError> {
        let bins = self.composite.bins();
        let wavelengths_m = bins.iter().map(|bin| bin.wavelength_m).collect();
        let values = bins.iter().map(|bin| bin.c1d_m3).collect();
        let errors = bins.iter().map(|bin| bin.standard_error_m3).collect();
        Psd::new(wavelengths_m, values, Convention::C1D)
            .and_then(|psd| psd.with_standard_errors(errors))
            .map_err(|error| TopographyError::of_all(ScanProblem::TooFewBins { error, bins: bins.len() }))
    }

    /// The composite: `wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3, measurements`, a row per bin from long to short
    /// wavelengths.
    pub fn table(&self) -> Table {
        let bins = self.composite.bins();
        Table::default()
            .with_numbers("wavelength_m", bins.iter().map(|bin| bin.wavelength_m))
            .with_numbers("wavevector_rad_per_m", bins.iter().map(|bin| wavevector(bin.wavelength_m)))
            .with_numbers("C1D_m3", bins.iter().map(|bin| bin.c1d_m3))
            .with_numbers("C1D_se_m3", bins.iter().map(|bin| bin.standard_error_m3))
            .with_numbers("measurements", bins.iter().map(|bin| bin.measurements as f64))
    }

    /// Every spectrum in blocks: `series, wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3`. Each scan stands where it is
    /// trusted under its name, and whole under its name and `(incl. unreliable data)`; the composite comes last.
    pub fn series_table(&self) -> Table {
        let mut rows: Vec<(String, f64, f64, Option<f64>)> = Vec::new();
        for (scan, name) in self.scans.iter().zip(self.series_names()) {
            let reliable = scan.reliable.wavelengths_m().iter().zip(scan.reliable.c1d_m3());
            rows.extend(reliable.map(|(wavelength_m, c1d_m3)| (name.clone(), *wavelength_m, *c1d_m3, None)));
            let whole = scan.spectrum.wavelengths_m().zip(scan.spectrum.c1d_m3());
            rows.extend(whole.filter(|(_, c1d_m3)| **c1d_m3 > 0.0).map(|(wavelength_m, c1d_m3)| {
                (format!("{name} (incl. unreliable data)"), wavelength_m, *c1d_m3, None)
            }));
        }
        let bins = self.composite.bins().iter();
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

    /// The names of the scans, told apart where two are the same.
    pub fn series_names(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for scan in &self.scans {
            let taken = |name: &String| name == "composite" || names.contains(name);
            let numbered = (2..).map(|number| format!("{} ({number})", scan.name));
            let name = std::iter::once(scan.name.clone()).chain(numbered).find(|name| !taken(name));
            names.extend(name);
        }
        names
    }

    /// How the composite was made: the recipe, and the files with their SHA-256.
    pub fn provenance(&self) -> Vec<String> {
        let mut lines = vec![format!("composite of {} scans; {}", self.scans.len(), self.recipe.describe())];
        for scan in &self.scans {
            let channel =
                scan.channel.as_ref().map_or(String::new(), |channel| format!(", channel {channel}"));
            lines.push(format!(
                "scan: {} ({}{channel}), SHA-256 {}, detrend {}, window {}, trusted from {} m on",
                scan.file,
                scan.format,
                scan.sha256,
                scan.preparation.detrend,
                scan.preparation.window,
                number(scan.band.shortest_m)
            ));
        }
        lines
    }

    /// The two instruments that are farthest apart, where that is too far for one surface in the same units: no composite of
    /// theirs is its spectrum.
    pub fn instruments_disagree(&self) -> Option<InstrumentsDisagree> {
        let telling = |overlap: &&Overlap| overlap.bins >= TELLING_BINS && disagree(overlap);
        let apart = |overlap: &&Overlap| overlap.ratio.ln().abs();
        let worst = self.overlaps.iter().filter(telling).max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        let names = self.series_names();
        Some(InstrumentsDisagree {
            names: [worst.first, worst.second].map(|scan| names[scan].clone()),
            ratio: worst.ratio,
            longest_m: worst.longest_m,
            shortest_m: worst.shortest_m,
        })
    }

    /// What reading took for granted, and how far each spectrum and their overlaps can be believed.
    pub fn notes(&self) -> Vec<String> {
        let names = self.series_names();
        let mut notes = Vec::new();
        for (scan, name) in self.scans.iter().zip(&names) {
            notes.extend(scan.notes.iter().map(|note| format!("{name}: {note}")));
            let wavelengths_m = scan.reliable.wavelengths_m();
            notes.push(format!(
                "{name}: {} to {}; {}",
                length(wavelengths_m[0]),
                length(wavelengths_m[wavelengths_m.len() - 1]),
                scan.checks.sentences().join("; ")
            ));
        }
        for second in 1..self.scans.len() {
            let same = |first: &usize| self.scans[*first].spectrum == self.scans[second].spectrum;
            if let Some(first) = (0..second).find(same) {
                notes.push(format!(
                    "WARNING: {} and {} are the same data, which counts twice; leave one of them out",
                    names[first], names[second]
                ));
            }
        }
        for overlap in &self.overlaps {
            let warning = if disagree(overlap) { "WARNING: " } else { "" };
            notes.push(format!(
                "{warning}{} over {}: {} in the mean of {} shared bins from {} to {}",
                names[overlap.first],
                names[overlap.second],
                three_digits(overlap.ratio),
                overlap.bins,
                length(overlap.longest_m),
                length(overlap.shortest_m)
            ));
        }
        notes
    }
}

fn disagree(overlap: &Overlap) -> bool {
    overlap.ratio.ln().abs() > DISAGREEMENT.ln()
}

fn wavevector(wavelength_m: f64) -> f64 {
    std::f64::consts::TAU / wavelength_m
}
