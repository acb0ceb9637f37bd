//! Spectra, from numbers or files.

use std::collections::BTreeMap;

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyDict, PyTuple};
use questions::{SpectrumQuantity, SpectrumQuestion};
use report::spectrum_words;
use spectrum::{Convention, Psd, ReadOption, ReadOptions};
use study::surface::{Surface, SurfaceError};
use tables::Format;

use crate::answer::{PyAnswer, Told, words};
use crate::arguments::{Arguments, choice, length_m, named, text};
use crate::errors::input;
use crate::work::light;

/// A spectrum as the core has it.
#[pyclass(frozen, name = "Surface", module = "truearea._native")]
pub struct PySurface {
    pub surface: Surface,
}

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
        bytes: Option<PyBackedBytes>,
        arguments: Arguments<'_>,
    ) -> PyResult<Self> {
        let options = ReadOptions {
            column: arguments.get("column", text)?,
            convention: arguments.get("convention", choice)?,
            x: arguments.get("x", choice)?,
            series: arguments.get("series", text)?,
            subject: arguments.get("subject", text)?,
            x_unit: arguments.get("x_unit", text)?,
            psd_unit: arguments.get("psd_unit", text)?,
        };
        let files: BTreeMap<_, _> = bytes.map(|bytes| (name.clone(), bytes)).into_iter().collect();
        let surface = light(py, || Surface::load(&name, &files, &options));
        Ok(PySurface { surface: surface.map_err(|error| unreadable(&error))? })
    }

    /// The sum of two surfaces that know nothing of each other.
    fn against(&self, other: &PySurface) -> Self {
        PySurface { surface: self.surface.clone().against(other.surface.clone()) }
    }

    /// Facts by their names: samples with their standard errors, NaN where one is not known, wavelengths at the long and the short
    /// end of each hole, notes, and remarks: the comments of its file, and what it is made of.
    #[getter]
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let Surface { name, psd, remarks, .. } = &self.surface;
        let errors_m3 = psd.standard_errors_m3().map(|errors_m3| {
            PyArray1::from_iter(py, errors_m3.iter().map(|error_m3| error_m3.unwrap_or(f64::NAN)))
        });
        let holes_m = self.surface.holes.iter().map(|hole| (hole.longest_m, hole.shortest_m));
        let facts = PyDict::new(py);
        facts.set_item("name", name)?;
        facts.set_item("wavelengths_m", PyArray1::from_slice(py, psd.wavelengths_m()))?;
        facts.set_item("c1d_m3", PyArray1::from_slice(py, psd.c1d_m3()))?;
        facts.set_item("c1d_se_m3", errors_m3)?;
        facts.set_item("holes_m", PyTuple::new(py, holes_m.collect::<Vec<_>>())?)?;
        facts.set_item("notes", notes(&self.surface))?;
        facts.set_item("remarks", PyTuple::new(py, remarks)?)?;
        Ok(facts)
    }

    /// Moments, amplitudes or a fit.
    fn quantity(&self, py: Python<'_>, quantity: &str, arguments: Arguments<'_>) -> PyResult<PyAnswer> {
        let quantity = match quantity {
            "moments" => SpectrumQuantity::Moments {
                normalisation: arguments.get("normalisation", choice)?.unwrap_or_default(),
            },
            "amplitudes" => SpectrumQuantity::Amplitude {
                definition: arguments.get("amplitude", choice)?.unwrap_or_default(),
            },
            _ => SpectrumQuantity::Fit {
                from_m: arguments.get("longest", length_m)?,
                to_m: arguments.get("shortest", length_m)?,
            },
        };
        let question = SpectrumQuestion { quantity, sampling: arguments.sampling()?, figure: false };
        PyAnswer::carry_out(py, None, |watch| question.answer(&self.surface, watch))
    }

    /// The part between two wavelengths.
    fn between(&self, arguments: Arguments<'_>) -> PyResult<Self> {
        let ends_m = (arguments.get("longest", length_m)?, arguments.get("shortest", length_m)?);
        Ok(PySurface { surface: self.surface.between(ends_m.0, ends_m.1).map_err(input)? })
    }

    /// A file of the spectrum, from which it is read back.
    fn csv(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let written = self.surface.table().write(Format::Csv, &self.surface.remarks, &mut bytes);
        written.expect("memory takes everything");
        bytes
    }
}

/// Returns the notes and warnings on a surface; checks that were passed are left out.
pub fn notes(surface: &Surface) -> Vec<Told> {
    words(&surface.notes)
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
