//! Figures as data: the series of each, drawn by `plot` and written as tables.

use stacked_contact::Scale;

use crate::plan::{Needs, Results};
use crate::table::Table;

/// What a figure shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shows {
    /// The power spectrum.
    Psd,
    /// Spectral moments against cutoff, each over its final value.
    Moments,
    /// Amplitude against wavelength.
    Amplitude,
    /// Aspect ratio against wavelength.
    AspectRatio,
    /// Contact area against cutoff.
    Area,
}

/// A figure as asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The name of its files.
    pub name: String,
    /// What it shows.
    pub shows: Shows,
    /// Its title; what it shows, where absent.
    pub title: Option<String>,
    /// Which curves it draws, by index.
    pub curves: Vec<usize>,
}

/// One line of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its column in the table.
    pub column: String,
    /// Its entry in the legend; none where it is alone.
    pub legend: Option<String>,
    /// Which lines share a colour.
    pub colour: usize,
    /// Which lines share a dash pattern.
    pub dash: usize,
    /// One value per abscissa.
    pub values: Vec<f64>,
}

/// A figure with its data; all axes are logarithmic.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureData {
    /// The name of its files.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The abscissa's column in the table.
    pub x_column: &'static str,
    /// The abscissa's label.
    pub x_label: &'static str,
    /// The ordinate's label.
    pub y_label: &'static str,
    /// The abscissas.
    pub x: Vec<f64>,
    /// The lines.
    pub series: Vec<Series>,
}

const WAVELENGTH: (&str, &str) = ("wavelength_m", "wavelength (m)");
const CUTOFF: (&str, &str) = ("wavelength_m", "shortest wavelength included (m)");

impl Figure {
    /// The figure drawn where none is asked for: the area of every curve.
    pub fn area_of_all(curves: usize) -> Self {
        Figure {
            name: "area-fraction".to_owned(),
            shows: Shows::Area,
            title: None,
            curves: (0..curves).collect(),
        }
    }

    /// The figure's data, from the results of the plan that asked for it.
    pub fn data(&self, results: &Results, needs: &Needs) -> FigureData {
        let of_scales = |column: &str, y_label, of: fn(&Scale) -> f64| {
            let x = results.scales.iter().map(|scale| scale.wavelength_m).collect();
            (WAVELENGTH, y_label, x, vec![single(column, results.scales.iter().map(of).collect())])
        };
        let ((x_column, x_label), y_label, x, series) = match self.shows {
            Shows::Psd => {
                let x = results
                    .psd
                    .wavelengths_m()
                    .iter()
                    .map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
                let axis = ("wavevector_rad_per_m", "wavevector q (rad/m)");
                (
                    axis,
                    "power spectral density C1D (m³)",
                    x.collect(),
                    vec![single("c1d_m3", results.psd.c1d_m3().to_vec())],
                )
            }
            Shows::Moments => {
                let x = results.moments.iter().map(|(moments, _)| moments.wavelength_m).collect();
                (CUTOFF, "moment over its final value", x, moment_series(results))
            }
            Shows::Amplitude => of_scales("amplitude_m", "amplitude Δ (m)", |scale| scale.amplitude_m),
            Shows::AspectRatio => of_scales("aspect_ratio", "aspect ratio B = Δ/λ", Scale::aspect_ratio),
            Shows::Area => {
                let x = results.scales.iter().map(|scale| scale.wavelength_m).collect();
                (CUTOFF, "contact area / nominal area", x, self.area_series(results, needs))
            }
        };
        let title = self.title.clone().unwrap_or_else(|| y_label.to_owned());
        FigureData { name: self.name.clone(), title, x_column, x_label, y_label, x, series }
    }

    fn area_series(&self, results: &Results, needs: &Needs) -> Vec<Series> {
        let mut series = Vec::new();
        for (place, &curve) in self.curves.iter().enumerate() {
            // The first of several curves is the reference that the others are held against: dashed.
            let dash = if self.curves.len() > 1 { [1, 0].get(place).copied().unwrap_or(place) } else { 0 };
            let name = &needs.curves[curve].name;
            for (colour, (load, levels)) in needs.loads.iter().zip(&results.curves[curve]).enumerate() {
                series.push(Series {
                    column: format!("{name} at {}", load.label),
                    legend: Some(format!("{}, {}", name.replace('-', " "), load.label)),
                    colour,
                    dash,
                    values: levels.iter().map(|level| level.area_fraction).collect(),
                });
            }
        }
        series
    }
}

fn single(column: &str, values: Vec<f64>) -> Series {
    Series { column: column.to_owned(), legend: None, colour: 0, dash: 0, values }
}

fn moment_series(results: &Results) -> Vec<Series> {
    let moment = |colour, name: &str, of: fn(&spectrum::Moments) -> f64| {
        let last = results.moments.last().map_or(1.0, |(moments, _)| of(moments));
        Series {
            column: format!("{name}_over_final"),
            legend: Some(name.to_owned()),
            colour,
            dash: 0,
            values: results.moments.iter().map(|(moments, _)| of(moments) / last).collect(),
        }
    };
    vec![moment(0, "m0", |m| m.m0_m2), moment(1, "m2", |m| m.m2), moment(2, "m4", |m| m.m4_per_m2)]
}

impl FigureData {
    /// What is drawn, as a table: the abscissa and a column per line.
    pub fn table(&self) -> Table {
        let table = Table::default().with_numbers(self.x_column, self.x.iter().copied());
        self.series
            .iter()
            .fold(table, |table, series| table.with_numbers(&series.column, series.values.iter().copied()))
    }
}
