//! Figures as data: the series of each, to be drawn, and written as tables.

mod curve_look;
mod of_results;
mod of_scans;
mod shear_loops;
mod table;

use serde::{Deserialize, Serialize};
use spectrum::Hole;

use crate::plan::Needs;

pub use curve_look::{CurveLook, Variant};
pub use of_scans::{composite_figure, over_scans};
pub use shear_loops::{ShearLoop, shear_loops};

/// The subject of a figure.
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
    /// Contact area against nominal pressure, at some cutoffs.
    AreaAgainstLoad,
    /// A quantity of a contact against another. The answer to a question has such a figure, and no scene asks for it.
    #[serde(skip_deserializing)]
    Response,
}

impl Shows {
    /// Returns true if the figure draws areas of curves.
    #[must_use]
    pub fn draws_areas(self) -> bool {
        matches!(self, Shows::Area | Shows::AreaAgainstLoad)
    }

    /// Returns true if the figure needs the moments of the spectrum.
    #[must_use]
    pub fn needs_moments(self) -> bool {
        self == Shows::Moments
    }

    /// Returns true if the figure needs the amplitudes of the spectrum.
    #[must_use]
    pub fn needs_amplitudes(self) -> bool {
        matches!(self, Shows::Amplitude | Shows::AspectRatio)
    }
}

/// A requested figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The name of its files.
    pub name: String,
    /// The subject.
    pub shows: Shows,
    /// Its title; if absent, the title is the subject.
    pub title: Option<String>,
    /// Indices of the curves that it draws.
    pub curves: Vec<usize>,
    /// Indices of the sweeps over loads that it draws.
    pub sweeps: Vec<usize>,
    /// Indices of the loads that it draws; `None` for all.
    pub loads: Option<Vec<usize>>,
    /// True if nobody chose the curves: of a judged scene, it draws those nearest to boundary elements.
    pub draws_nearest: bool,
    /// The look of its file.
    pub style: FigureStyle,
    /// The formats of its files; SVG is always one.
    pub formats: Vec<PictureFormat>,
}

/// A format of the file of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PictureFormat {
    /// A drawing for the web, and the source of the others.
    Svg,
    /// A picture in pixels.
    Png,
    /// A drawing for print.
    Pdf,
    /// A Python script that draws it with matplotlib.
    #[serde(rename = "py")]
    Script,
}

impl PictureFormat {
    /// Returns the ending of the names of files.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
            PictureFormat::Script => "py",
        }
    }
}

/// The look of the file of a figure.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FigureStyle {
    /// The width in print \[mm\].
    pub width_mm: Option<f64>,
    /// The size of letters in print, in points.
    pub font_size_pt: Option<f64>,
    /// True to draw neither title nor subject.
    pub hides_title: bool,
}

/// One line of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Series {
    /// Its column in the table.
    pub column: String,
    /// The curve it belongs to.
    pub curve: String,
    /// The place of its curve among those of the figure, the one that others are held against first.
    pub curve_index: usize,
    /// The facts that decide its colour and dash; `None` for a line that belongs to no curve of a model.
    pub look: Option<CurveLook>,
    /// The load or cutoff it is drawn for, as typed; empty where it is alone.
    pub condition: String,
    /// The load or cutoff in the words of the legend: a load also in units of the hardness.
    pub condition_in_full: String,
    /// The load it is drawn for, by index; `None` for a line against the load, or without one.
    pub load: Option<usize>,
    /// The place of its condition among those of the figure, which is the index of the load where there is one; `None` where
    /// it has no condition.
    pub condition_index: Option<usize>,
    /// Abscissa and ordinate of each point; the abscissas run one way.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A line that belongs to no curve; its column is called like its condition.
    pub fn under(condition: &str, condition_index: usize, points: Vec<(f64, f64)>) -> Self {
        Series {
            column: condition.to_owned(),
            curve: String::new(),
            curve_index: 0,
            look: None,
            condition: condition.to_owned(),
            condition_in_full: condition.to_owned(),
            load: None,
            condition_index: Some(condition_index),
            points,
        }
    }

    /// The only line of a figure, which belongs to no curve.
    pub fn alone(column: &str, points: Vec<(f64, f64)>) -> Self {
        let nameless = Series { condition_index: None, ..Series::under("", 0, points) };
        Series { column: column.to_owned(), ..nameless }
    }
}

/// An area between two lines, to hold lines against.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureBand {
    /// The label in the legend.
    pub label: String,
    /// The role of the band beside the lines under its load.
    pub kind: BandKind,
    /// The load of these lines, by index, if they are drawn for one.
    pub load: Option<usize>,
    /// The place of the curve whose interval it is; 0 of a yardstick.
    pub curve_index: usize,
    /// Abscissa, and the lower and the upper ordinate, of each point.
    pub points: Vec<(f64, [f64; 2])>,
}

/// The role of a band beside lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BandKind {
    /// Other values for comparison.
    Yardstick,
    /// The interval in which the lines lie, as far as is known.
    Interval,
}

/// A figure with its data.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureData {
    /// The name of its files.
    pub name: String,
    /// The subject.
    pub shows: Shows,
    /// Its title.
    pub title: String,
    /// The abscissa.
    pub x: Axis,
    /// The abscissa's label, with the hardness where pressures are drawn and it is known.
    pub x_label: String,
    /// The ordinate's label.
    pub y_label: &'static str,
    /// The scale of the abscissa.
    pub x_scale: AxisScale,
    /// The scale of the ordinate.
    pub y_scale: AxisScale,
    /// The lines.
    pub series: Vec<Series>,
    /// The bands that the lines are compared with.
    pub bands: Vec<FigureBand>,
    /// Pairs of abscissas between which nothing was measured, so that no line connects them.
    pub gaps: Vec<(f64, f64)>,
    /// Values with their errors that belong to no line.
    pub marks: Vec<Mark>,
}

/// A value with its error, drawn beside the lines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mark {
    /// The label in the legend.
    pub label: String,
    /// Its column in the table; those of its limits have `low` and `high` after it.
    pub column: String,
    /// True if it is drawn as a ring rather than a disc.
    pub is_ring: bool,
    /// The place of the condition of the lines that it belongs with, if they have one.
    pub condition_index: Option<usize>,
    /// The abscissa.
    pub x: f64,
    /// The ordinate.
    pub y: f64,
    /// The lower limit of the ordinate, > 0 on a logarithmic axis.
    pub low: f64,
    /// The upper limit of the ordinate.
    pub high: f64,
}

/// The scale of an axis.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AxisScale {
    /// Equal factors take equal lengths; only positive values have a place.
    #[default]
    Logarithmic,
    /// Equal differences take equal lengths.
    Linear,
}

/// An abscissa: its column in a table and its label in a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Axis {
    /// The column.
    pub column: &'static str,
    /// The label.
    pub label: &'static str,
}

/// The quantity along an abscissa.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// A wavevector \[rad/m\].
    Wavevector,
    /// A wavelength \[m\].
    Length,
    /// Anything else, such as a pressure.
    Other,
}

impl Axis {
    /// Returns the quantity along the axis, by the column of its table.
    #[must_use]
    pub fn kind(&self) -> AxisKind {
        match self.column {
            "wavevector_rad_per_m" => AxisKind::Wavevector,
            "wavelength_m" => AxisKind::Length,
            _ => AxisKind::Other,
        }
    }
}

const WAVEVECTOR: Axis = Axis { column: "wavevector_rad_per_m", label: "wavevector q (rad/m)" };
const PSD: &str = "power spectral density C1D (m³)";

/// The name of the default figure.
pub const AREA_OF_ALL: &str = "area-fraction";

impl Figure {
    /// Returns the default figure: the area of all these curves against cutoff.
    pub fn area_of_all(curves: Vec<usize>) -> Self {
        Figure {
            name: AREA_OF_ALL.to_owned(),
            shows: Shows::Area,
            title: None,
            curves,
            sweeps: Vec::new(),
            loads: None,
            draws_nearest: false,
            style: FigureStyle::default(),
            formats: vec![PictureFormat::Svg],
        }
    }

    /// Returns the names of the files of its formats.
    pub fn file_names(&self) -> impl Iterator<Item = String> {
        self.formats.iter().map(|format| format!("{}.{}", self.name, format.extension()))
    }

    /// Keeps some of the curves, by index, and their sweeps over loads.
    pub fn keep_curves(&mut self, kept: &[usize], needs: &Needs) {
        self.curves.retain(|curve| kept.contains(curve));
        self.sweeps.retain(|sweep| kept.contains(&needs.sweeps[*sweep].curve));
    }

    /// Returns true if the figure draws the load at an index.
    #[must_use]
    pub fn draws_load(&self, load: usize) -> bool {
        self.loads.as_ref().is_none_or(|loads| loads.contains(&load))
    }
}

/// A figure of spectra.
pub fn psd_figure(name: &str, series: Vec<Series>) -> FigureData {
    FigureData::new(name, Shows::Psd, WAVEVECTOR, PSD, series)
}

impl FigureData {
    /// Makes a figure of lines on logarithmic axes, with the ordinate's label as its title and nothing beside the lines.
    #[must_use]
    pub fn new(name: &str, shows: Shows, x: Axis, y_label: &'static str, series: Vec<Series>) -> Self {
        FigureData {
            name: name.to_owned(),
            shows,
            title: y_label.to_owned(),
            x,
            x_label: x.label.to_owned(),
            y_label,
            x_scale: AxisScale::Logarithmic,
            y_scale: AxisScale::Logarithmic,
            series,
            bands: Vec::new(),
            gaps: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// Returns the figure with both axes linear.
    #[must_use]
    pub fn with_linear_axes(self) -> Self {
        FigureData { x_scale: AxisScale::Linear, y_scale: AxisScale::Linear, ..self }
    }

    /// A figure against wavevectors or wavelengths that leaves these holes open; any other figure as it is.
    #[must_use]
    pub fn with_holes(self, holes: &[Hole]) -> Self {
        let ends = |hole: &Hole| match self.x.kind() {
            AxisKind::Wavevector => {
                Some((std::f64::consts::TAU / hole.longest_m, std::f64::consts::TAU / hole.shortest_m))
            }
            AxisKind::Length => Some((hole.shortest_m, hole.longest_m)),
            AxisKind::Other => None,
        };
        let gaps = holes.iter().filter_map(ends).collect();
        FigureData { gaps, ..self }
    }

    /// Splits the points of a line into pieces that cross no gap. Points inside a gap are interpolated and left out.
    #[must_use]
    pub fn pieces(&self, series: &Series) -> Vec<Vec<(f64, f64)>> {
        pieces(&series.points, &self.gaps)
    }

    /// Returns true if the lines belong to several curves.
    pub fn compares_curves(&self) -> bool {
        self.series.iter().any(|series| series.curve_index != self.series[0].curve_index)
    }
}

/// Splits points with monotonic abscissas into pieces that cross no gap. Points inside a gap are left out.
#[must_use]
pub fn pieces<T: Copy>(points: &[(f64, T)], gaps: &[(f64, f64)]) -> Vec<Vec<(f64, T)>> {
    // An abscissa at the end of a gap was measured, whatever the rounding.
    let is_inside = |x: f64| gaps.iter().any(|(a, b)| x > a * (1.0 + 1e-9) && x < b * (1.0 - 1e-9));
    let crosses = |x: f64, y: f64| {
        let (from, to) = (x.min(y) * (1.0 - 1e-9), x.max(y) * (1.0 + 1e-9));
        gaps.iter().any(|(a, b)| from <= *a && to >= *b)
    };
    let mut pieces: Vec<Vec<(f64, T)>> = Vec::new();
    for point in points.iter().filter(|(x, _)| !is_inside(*x)) {
        match pieces.last_mut() {
            Some(piece) if !piece.last().is_some_and(|last| crosses(last.0, point.0)) => piece.push(*point),
            _ => pieces.push(vec![*point]),
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_crosses_a_hole() {
        let points = vec![(1.0, 0.1), (2.0, 0.2), (4.0, 0.3), (8.0, 0.4), (9.0, 0.5)];
        let tau = std::f64::consts::TAU;
        let hole = Hole { longest_m: tau / 2.0, shortest_m: tau / 8.0 };
        let figure = psd_figure("f", vec![Series::under("c1d_m3", 0, points.clone())]).with_holes(&[hole]);
        let pieces = figure.pieces(&figure.series[0]);
        assert_eq!(pieces, [vec![(1.0, 0.1), (2.0, 0.2)], vec![(8.0, 0.4), (9.0, 0.5)]]);
        let whole = psd_figure("f", vec![Series::under("c1d_m3", 0, points.clone())]);
        assert_eq!(whole.pieces(&whole.series[0]), [points]);
    }
}
