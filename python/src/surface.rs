//! Spectra, from numbers or files.

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use questions::{Note, SpectrumQuantity, SpectrumQuestion};
use report::{plot, spectrum_words};
use spectrum::{Convention, Psd, ReadOption, ReadOptions};
use study::figure::{Figure, Shows};
use study::measurements::NoFiles;
use study::plan::{Needs, Plan, Sampling};
use study::surface::{Surface, SurfaceError};
use tables::Format;

use crate::answer::{PyAnswer, Told, refused, words};
use crate::arguments::{Arguments, named};
use crate::errors::input;
use crate::work::{carry_out, light};

/// A spectrum as the core has it.
#[pyclass(frozen, name = "Surface", module = "truearea._native")]
pub struct PySurface {
    pub surface: Surface,
}

/// The bytes of one file, under its name.
type OneFile = std::collections::BTreeMap<String, Vec<u8>>;

#[pymethods]
impl PySurface {
    /// A spectrum from its samples in SI units, of a convention.
    #[staticmethod]
    fn of_samples(
        name: String,
        wavelengths_m: PyReadonlyArray1<'_, f64>,
        values: PyReadonlyArray1<'_, f64>,
        standard_errors: Option<PyReadonlyArray1<'_, f64>>,
        convention: &str,
    ) -> PyResult<Self> {
        let convention: Convention = named("convention", convention)?;
        let psd = Psd::new(to_vec(&wavelengths_m), to_vec(&values), convention).map_err(input)?;
        let psd = match standard_errors {
            None => psd,
            Some(errors) => {
                let known = |error: f64| (!error.is_nan()).then_some(error);
                psd.with_standard_errors(to_vec(&errors).into_iter().map(known).collect()).map_err(input)?
            }
        };
        Ok(PySurface { surface: Surface::of_psd(name, psd).map_err(input)? })
    }

    /// The spectrum in the bytes of a file; of a built-in one where there are none.
    #[staticmethod]
    fn of_file(
        py: Python<'_>,
        name: String,
        bytes: Option<Vec<u8>>,
        arguments: Arguments<'_>,
    ) -> PyResult<Self> {
        let options = ReadOptions {
            column: arguments.text("column")?,
            convention: arguments.named("convention")?,
            x: arguments.named("x")?,
            series: arguments.text("series")?,
            subject: arguments.text("subject")?,
            x_unit: arguments.text("x_unit")?,
            psd_unit: arguments.text("psd_unit")?,
        };
        let surface = light(py, || match bytes {
            Some(bytes) => Surface::load(&name, &OneFile::from([(name.clone(), bytes)]), &options),
            None => Surface::load(&name, &NoFiles, &options),
        });
        Ok(PySurface { surface: surface.map_err(|error| unreadable(&error))? })
    }

    /// The sum of two surfaces that know nothing of each other.
    fn against(&self, other: &PySurface) -> Self {
        PySurface { surface: self.surface.clone().against(other.surface.clone()) }
    }

    #[getter]
    fn name(&self) -> &str {
        &self.surface.name
    }

    #[getter]
    fn wavelengths_m<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.surface.psd.wavelengths_m())
    }

    #[getter]
    fn c1d_m3<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.surface.psd.c1d_m3())
    }

    /// Standard errors, NaN where one is not known.
    #[getter]
    fn standard_errors_m3<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let errors_m3 = self.surface.psd.standard_errors_m3()?;
        Some(PyArray1::from_iter(py, errors_m3.iter().map(|error_m3| error_m3.unwrap_or(f64::NAN))))
    }

    /// Wavelengths \[m\] at the long and the short end of each hole of the spectrum.
    #[getter]
    fn holes_m(&self) -> Vec<(f64, f64)> {
        self.surface.holes().iter().map(|hole| (hole.longest_m, hole.shortest_m)).collect()
    }

    /// Assumptions made in reading, and doubts.
    #[getter]
    fn notes(&self) -> Vec<Told> {
        notes(&self.surface)
    }

    /// The comments of its file, and what it is made of.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.surface.remarks.clone()
    }

    /// Moments, amplitudes or a fit.
    fn quantity(&self, py: Python<'_>, quantity: &str, arguments: Arguments<'_>) -> PyResult<PyAnswer> {
        let quantity = match quantity {
            "moments" => SpectrumQuantity::Moments {
                normalisation: arguments.named("normalisation")?.unwrap_or_default(),
            },
            "amplitudes" => {
                SpectrumQuantity::Amplitude { definition: arguments.named("definition")?.unwrap_or_default() }
            }
            _ => SpectrumQuantity::Fit {
                from_m: arguments.length_m("longest")?,
                to_m: arguments.length_m("shortest")?,
            },
        };
        let question = SpectrumQuestion { quantity, sampling: arguments.sampling()?, figure: false };
        let found = carry_out(py, None, |progress| question.answer(&self.surface, progress))?;
        let found = found.map_err(refused)?;
        PyAnswer::new(py, &found.table, found.notes)
    }

    /// The part between two wavelengths.
    fn between(&self, arguments: Arguments<'_>) -> PyResult<Self> {
        let (longest_m, shortest_m) = (arguments.length_m("longest")?, arguments.length_m("shortest")?);
        let surface = self.surface.between(longest_m, shortest_m).map_err(input)?;
        Ok(PySurface { surface })
    }

    /// A file of the spectrum, from which it is read back.
    fn csv<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let mut bytes = Vec::new();
        let written = self.surface.table().write(Format::Csv, &self.surface.remarks, &mut bytes);
        written.expect("memory takes everything");
        PyBytes::new(py, &bytes)
    }

    /// The spectrum drawn.
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        light(py, || {
            let needs = Needs::default();
            let results =
                Plan { psd: &self.surface.psd, sampling: Sampling::default(), needs: needs.clone() }
                    .compute()?;
            let figure = Figure { shows: Shows::Psd, ..Figure::area_of_all(Vec::new()) };
            let data = figure.data(&results, &needs, None).with_holes(self.surface.holes());
            Ok(plot::svg(&data, &self.surface.name, &report::provenance::of_surface(&self.surface)))
        })
        .map_err(|error: study::plan::PlanError| input(error))
    }
}

/// Returns the notes and warnings on a surface; checks that were passed are left out.
pub fn notes(surface: &Surface) -> Vec<Told> {
    let notes: Vec<Note> = surface.notes.iter().cloned().map(Note::Surface).collect();
    words(&notes)
}

fn to_vec(array: &PyReadonlyArray1<'_, f64>) -> Vec<f64> {
    array.as_array().to_vec()
}

/// Converts an error of a spectrum, with the argument that mends it.
pub fn unreadable(error: &SurfaceError) -> PyErr {
    match error {
        SurfaceError::Scan { .. } => input(format!("{error}; use read_scan and composite")),
        SurfaceError::Spectrum { error: reading, .. } => {
            let argument = |option: ReadOption| option.key().to_owned();
            let mend = reading.mend().map(|mend| spectrum_words::mend(&mend, argument));
            input(format!("{error}{}", mend.unwrap_or_default()))
        }
        error => input(error),
    }
}
