//! Pictures of results for notebooks, as the core draws them.

use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use report::chart;
use report::chart::maps::FieldPicture;
use report::chart::palette::ModelStyle;
use study::figure::{Axis, BandKind, CurveLook, FigureBand, FigureData, Series, Shows, Variant};
use study::models::{MODELS, ModelEntry};

use crate::arguments::any_model;
use crate::errors::of_argument;

/// Columns that are drawn, and the labels of their axes.
const AXES: [(&str, &str); 17] = [
    ("wavelength_m", "shortest wavelength (m)"),
    ("scale_m", "wavelength (m)"),
    ("nominal_pressure_pa", "nominal pressure (Pa)"),
    ("pressure_pa", "pressure (Pa)"),
    ("pull_pa", "pull over the nominal area (Pa)"),
    ("overclosure_m", "overclosure (m)"),
    ("displacement_m", "displacement (m)"),
    ("tangential_stress_pa", "tangential stress (Pa)"),
    ("area_fraction", "contact area / nominal area"),
    ("mean_gap_m", "mean gap (m)"),
    ("amplitude_m", "amplitude (m)"),
    ("conductance_w_per_m2_k", "thermal conductance (W/(m² K))"),
    ("conductance_s_per_m2", "electrical conductance (S/m²)"),
    ("moments", "moments over their final values"),
    ("c1d_m3", "power spectral density C1D (m³)"),
    ("rms_gradient", "rms gradient"),
    ("share", "share of the variance of ln A"),
];

/// The label of an axis.
#[pyfunction]
pub fn axis_label(column: &str) -> PyResult<&'static str> {
    axis(column).map(|axis| axis.label)
}

fn axis(column: &str) -> PyResult<Axis> {
    let found = AXES.into_iter().find(|(name, _)| *name == column);
    let (name, label) = found.ok_or_else(|| of_argument("column", format!("'{column}' has no axis")))?;
    // Lengths have a column of their own among figures.
    let is_wavelength = matches!(name, "wavelength_m" | "scale_m");
    Ok(Axis { column: if is_wavelength { "wavelength_m" } else { name }, label })
}

/// A line: abscissas, ordinates, its label, the model that it belongs to, and the place of its condition.
type Line = (Vec<f64>, Vec<f64>, String, String, Option<usize>);

/// A band: abscissas, lower and upper ordinates, its label, and the model that it belongs to.
type Interval = (Vec<f64>, Vec<f64>, Vec<f64>, String, String);

/// A figure as SVG; logarithmic axes have no place for what is not above 0.
#[pyfunction]
pub fn figure_svg(
    title: String,
    x: &str,
    y: &str,
    lines: Vec<Line>,
    bands: Vec<Interval>,
    holes: Vec<(f64, f64)>,
    is_linear: bool,
) -> PyResult<String> {
    let (x, y) = (axis(x)?, axis(y)?);
    let mut models: Vec<String> = lines.iter().map(|line| line.3.clone()).collect();
    models.dedup();
    let place = |model: &str| models.iter().position(|other| other == model).unwrap_or_default();
    let series = lines.into_iter().enumerate().map(|(at, (xs, ys, label, model, condition_index))| {
        let entry = MODELS.iter().find(|entry| entry.name == model);
        let (look, curve) = (entry.map(look), entry.map_or("", |entry| entry.short_name).to_owned());
        let points = xs.into_iter().zip(ys).collect();
        let curve_index = place(&model);
        Series { curve, curve_index, look, condition_index, ..Series::under(&label, at, points) }
    });
    let bands = bands.into_iter().map(|(xs, lows, highs, label, model)| {
        let points = xs.into_iter().zip(lows.into_iter().zip(highs).map(|(low, high)| [low, high]));
        let curve_index = place(&model);
        FigureBand { label, kind: BandKind::Interval, load: None, curve_index, points: points.collect() }
    });
    let shows = if y.column == "area_fraction" { Shows::Area } else { Shows::Psd };
    let figure = FigureData {
        title,
        bands: bands.collect(),
        gaps: holes,
        ..FigureData::new("picture", shows, x, y.label, series.collect())
    };
    let figure = if is_linear { figure.with_linear_axes() } else { figure };
    Ok(chart::svg(&figure, "", &[]))
}

fn look(entry: &ModelEntry) -> CurveLook {
    CurveLook { model: entry.name, variant: Variant::Plain, repeat: 0 }
}

/// Short name, colour and SVG dash of a model in figures.
#[pyfunction]
pub fn model_style(name: &str) -> PyResult<(&'static str, &'static str, String)> {
    let entry = any_model(name)?;
    let style = ModelStyle::new(look(entry));
    Ok((entry.short_name, style.colour, style.dash))
}

/// A map of pressures \[Pa\] on a rectangle of a size in m, as SVG.
#[pyfunction]
pub fn pressures_picture(
    nominal_pressure_pa: f64,
    pressures_pa: PyReadonlyArray2<'_, f64>,
    size_m: [f64; 2],
) -> String {
    let columns = pressures_pa.shape()[1];
    let values: Vec<f64> = pressures_pa.as_array().iter().copied().collect();
    FieldPicture::of_pressures(nominal_pressure_pa, &values, columns, size_m).document()
}
