//! Spectra, from numbers or files.

use std::num::NonZeroU32;

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use report::{plot, scan_words, spectrum_words};
use spectrum::{AmplitudeDefinition, Convention, Normalisation, Psd, ReadOption, ReadOptions};
use study::figure::{Figure, Shows};
use study::measurements::NoFiles;
use study::plan::{Needs, Plan, Results, Sampling};
use study::result_tables;
use study::surface::{Surface, SurfaceError};
use tables::Table;
use topography::Severity;
use units::{Length, UnknownName};

use crate::errors::{input, of_argument};
use crate::quantities::{Given, optional};
use crate::tables::columns;
use crate::work::light;

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
        options: &Bound<'_, PyDict>,
    ) -> PyResult<Self> {
        let options = reading(options)?;
        let surface = light(py, || match bytes {
            Some(bytes) => Surface::load(&name, &OneFile::from([(name.clone(), bytes)]), &options),
            None => Surface::load(&name, &NoFiles, &options),
        });
        Ok(PySurface { surface: surface.map_err(|error| refused(&error))? })
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

    /// Assumptions made in reading, and doubts.
    #[getter]
    fn notes(&self) -> Vec<String> {
        notes(&self.surface)
    }

    /// The comments of its file, and what it is made of.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.surface.remarks.clone()
    }

    fn moments<'py>(
        &self,
        py: Python<'py>,
        normalisation: &str,
        cutoff: Option<&Given<'py>>,
        scales_per_decade: Option<i64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let moments = Some(named::<Normalisation>("normalisation", normalisation)?);
        let needs = Needs { moments, asperities: true, ..Needs::default() };
        self.table(py, needs, sampling(&self.surface, cutoff, scales_per_decade)?, result_tables::moments)
    }

    fn amplitudes<'py>(
        &self,
        py: Python<'py>,
        definition: &str,
        cutoff: Option<&Given<'py>>,
        scales_per_decade: Option<i64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let amplitudes = Some(named::<AmplitudeDefinition>("definition", definition)?);
        let needs = Needs { amplitudes, ..Needs::default() };
        self.table(py, needs, sampling(&self.surface, cutoff, scales_per_decade)?, result_tables::amplitude)
    }

    fn fit<'py>(
        &self,
        py: Python<'py>,
        longest: Option<&Given<'py>>,
        shortest: Option<&Given<'py>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let [longest, shortest]: [Option<Length>; 2] =
            [optional("longest", longest)?, optional("shortest", shortest)?];
        let band_m =
            (shortest.map_or(0.0, |length| length.m), longest.map_or(f64::INFINITY, |length| length.m));
        let needs = Needs { fit_band_m: Some(band_m), ..Needs::default() };
        self.table(py, needs, Sampling::default(), result_tables::fit)
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

impl PySurface {
    fn table<'py>(
        &self,
        py: Python<'py>,
        needs: Needs,
        sampling: Sampling,
        table: fn(&Results) -> Table,
    ) -> PyResult<Bound<'py, PyDict>> {
        let plan = Plan { psd: &self.surface.psd, sampling, needs };
        let table = light(py, || plan.compute().map(|results| table(&results))).map_err(input)?;
        columns(py, &table)
    }
}

/// Returns the scales that take part.
pub fn sampling(
    surface: &Surface,
    cutoff: Option<&Given<'_>>,
    scales_per_decade: Option<i64>,
) -> PyResult<Sampling> {
    let cutoff: Option<Length> = optional("cutoff", cutoff)?;
    let shortest_m = surface.psd.shortest_wavelength_m();
    if let Some(cutoff) = cutoff.filter(|cutoff| cutoff.m < shortest_m) {
        return Err(input(format!(
            "cutoff is {} m and leaves nothing out: the shortest wavelength of {} is {shortest_m} m; leave it out, or choose \
             a longer one",
            cutoff.m, surface.name
        )));
    }
    let scales_per_decade = scales_per_decade.map(per_decade).transpose()?;
    Ok(Sampling { scales_per_decade, cutoff_m: cutoff.map(|cutoff| cutoff.m) })
}

/// Checks a number of scales per decade.
pub fn per_decade(count: i64) -> PyResult<NonZeroU32> {
    let whole = u32::try_from(count).ok().and_then(NonZeroU32::new);
    whole.ok_or_else(|| input(format!("scales_per_decade is {count}; it must be from 1 to {}", u32::MAX)))
}

/// Parses a named choice.
pub fn named<T: std::str::FromStr<Err = UnknownName>>(argument: &str, name: &str) -> PyResult<T> {
    name.parse().map_err(|error| of_argument(argument, error))
}

/// Returns the notes and warnings on a surface; checks that were passed are left out.
pub fn notes(surface: &Surface) -> Vec<String> {
    let told = surface.notes.iter().filter_map(|note| match note.severity() {
        Severity::Passed => None,
        Severity::Note => Some(scan_words::note(note)),
        Severity::Warning => Some(format!("warning: {}", scan_words::note(note))),
    });
    told.collect()
}

fn to_vec(array: &PyReadonlyArray1<'_, f64>) -> Vec<f64> {
    array.as_array().to_vec()
}

/// Returns the options for reading a file of a spectrum.
pub fn reading(given: &Bound<'_, PyDict>) -> PyResult<ReadOptions> {
    let text = |key: &str| -> PyResult<Option<String>> {
        given.get_item(key)?.filter(|value| !value.is_none()).map(|value| value.extract()).transpose()
    };
    Ok(ReadOptions {
        column: text("column")?,
        convention: text("convention")?.map(|name| named("convention", &name)).transpose()?,
        x: text("x")?.map(|name| named("x", &name)).transpose()?,
        series: text("series")?,
        subject: text("subject")?,
        x_unit: text("x_unit")?,
        psd_unit: text("psd_unit")?,
    })
}

/// Converts an error of a spectrum, with the argument that mends it.
pub fn refused(error: &SurfaceError) -> PyErr {
    match error {
        SurfaceError::Scan { .. } => input(format!("{error}; use read_scan and composite")),
        SurfaceError::Spectrum { error: reading, .. } => {
            let mend = reading.mend().map(|mend| spectrum_words::mend(&mend, argument_of));
            input(format!("{error}{}", mend.unwrap_or_default()))
        }
        error => input(error),
    }
}

/// The argument that gives an option of reading.
fn argument_of(option: ReadOption) -> &'static str {
    match option {
        ReadOption::Column => "column",
        ReadOption::Convention => "convention",
        ReadOption::X => "x",
        ReadOption::Series => "series",
        ReadOption::Subject => "subject",
        ReadOption::XUnit => "x_unit",
        ReadOption::PsdUnit => "psd_unit",
    }
}
