//! Figures as data: the series of each, to be drawn, and written as tables.

mod of_results;
mod table;

use serde::{Deserialize, Serialize};

/// What a figure shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
    /// Contact area of statistical curves against nominal pressure, at some cutoffs.
    AreaAgainstLoad,
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
    /// Which sweeps over loads it draws, by index.
    pub sweeps: Vec<usize>,
}

/// One line of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Series {
    /// Its column in the table.
    pub column: String,
    /// The curve it belongs to, which its dash pattern stands for.
    pub curve: String,
    /// The load or cutoff it is drawn for, as typed, which its colour stands for; empty where it is alone.
    pub condition: String,
    /// The same for the legend: a load also in units of the hardness.
    pub condition_in_full: String,
    /// Which lines share a colour.
    pub colour: usize,
    /// Which lines share a dash pattern; 0 is solid.
    pub dash: usize,
    /// Abscissa and ordinate of each point; the abscissas run one way.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A solid line that belongs to no curve: its condition, by which its column goes too, is its colour.
    pub fn under(condition: &str, colour: usize, points: Vec<(f64, f64)>) -> Self {
        Series {
            column: condition.to_owned(),
            curve: String::new(),
            condition: condition.to_owned(),
            condition_in_full: condition.to_owned(),
            colour,
            dash: 0,
            points,
        }
    }
}

/// A figure with its data; all axes are logarithmic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureData {
    /// The name of its files.
    pub name: String,
    /// What it shows.
    pub shows: Shows,
    /// Its title.
    pub title: String,
    /// The abscissa.
    pub x: Axis,
    /// The abscissa's label, with the hardness where pressures are drawn and it is known.
    pub x_label: String,
    /// The ordinate's label.
    pub y_label: &'static str,
    /// The lines.
    pub series: Vec<Series>,
}

/// An abscissa: its column in a table and its label in a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Axis {
    /// The column.
    pub column: &'static str,
    /// The label.
    pub label: &'static str,
}

const WAVEVECTOR: Axis = Axis { column: "wavevector_rad_per_m", label: "wavevector q (rad/m)" };
const PSD: &str = "power spectral density C1D (m³)";

/// The name of the figure that is drawn where none is asked for.
pub const AREA_OF_ALL: &str = "area-fraction";

impl Figure {
    /// The figure drawn where none is asked for: the area of all these curves against cutoff.
    pub fn area_of_all(curves: Vec<usize>) -> Self {
        Figure { name: AREA_OF_ALL.to_owned(), shows: Shows::Area, title: None, curves, sweeps: Vec::new() }
    }
}

/// A figure of spectra.
pub fn psd_figure(name: &str, series: Vec<Series>) -> FigureData {
    FigureData {
        name: name.to_owned(),
        shows: Shows::Psd,
        title: PSD.to_owned(),
        x: WAVEVECTOR,
        x_label: WAVEVECTOR.label.to_owned(),
        y_label: PSD,
        series,
    }
}

impl FigureData {
    /// Whether its lines belong to several curves.
    pub fn compares_curves(&self) -> bool {
        self.series.iter().any(|series| series.dash > 0)
    }
}
