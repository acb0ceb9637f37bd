//! Figures as data: the series of each, drawn by `plot` and written as tables.

use spectrum::Hole;
use stacked_contact::Scale;

use crate::plan::{CurveResult, Needs, Results};
use tables::Table;
use units::display::{length, load_in_full, pressure, typeset};

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
#[derive(Debug, Clone, PartialEq)]
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
#[derive(Debug, Clone, PartialEq)]
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
    /// Pairs of abscissas between which nothing was measured, so that no line is drawn from one to the other.
    pub gaps: Vec<(f64, f64)>,
}

/// An abscissa: its column in a table and its label in a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axis {
    /// The column.
    pub column: &'static str,
    /// The label.
    pub label: &'static str,
}

const WAVEVECTOR: Axis = Axis { column: "wavevector_rad_per_m", label: "wavevector q (rad/m)" };
const WAVELENGTH: Axis = Axis { column: "wavelength_m", label: "wavelength (m)" };
const CUTOFF: Axis = Axis { column: "wavelength_m", label: "shortest wavelength included (m)" };
const PRESSURE: Axis = Axis { column: "nominal_pressure_pa", label: "nominal pressure (Pa)" };
const PSD: &str = "power spectral density C1D (m³)";
const AREA: &str = "contact area / nominal area";

impl Figure {
    /// The figure drawn where none is asked for: the area of all these curves against cutoff.
    pub fn area_of_all(curves: Vec<usize>) -> Self {
        Figure {
            name: "area-fraction".to_owned(),
            shows: Shows::Area,
            title: None,
            curves,
            sweeps: Vec::new(),
        }
    }

    /// The figure's data, from the results of the plan that asked for it; loads are labelled in units of the hardness
    /// \[Pa\] as well, where there is one.
    pub fn data(&self, results: &Results, needs: &Needs, hardness_pa: Option<f64>) -> FigureData {
        let (x, y_label, series) = match self.shows {
            Shows::Psd => (WAVEVECTOR, PSD, psd_series(results)),
            Shows::Moments => (CUTOFF, "moment over its final value", moment_series(results)),
            Shows::Amplitude => (
                WAVELENGTH,
                "amplitude Δ (m)",
                scale_series(results, "amplitude_m", |scale| scale.amplitude_m),
            ),
            Shows::AspectRatio => (
                WAVELENGTH,
                "aspect ratio B = Δ/λ",
                scale_series(results, "aspect_ratio", Scale::aspect_ratio),
            ),
            Shows::Area => (CUTOFF, AREA, self.area_series(results, needs, hardness_pa)),
            Shows::AreaAgainstLoad => (PRESSURE, AREA, self.load_series(results, needs)),
        };
        let title = self.title.clone().unwrap_or_else(|| y_label.to_owned());
        let x_label = match hardness_pa.filter(|_| x == PRESSURE) {
            Some(hardness_pa) => format!("{}; H = {}", x.label, pressure(hardness_pa)),
            None => x.label.to_owned(),
        };
        FigureData {
            name: self.name.clone(),
            shows: self.shows,
            title,
            x,
            x_label,
            y_label,
            series,
            gaps: Vec::new(),
        }
    }

    fn area_series(&self, results: &Results, needs: &Needs, hardness_pa: Option<f64>) -> Vec<Series> {
        let mut series = Vec::new();
        for (place, &curve) in self.curves.iter().enumerate() {
            for (colour, load) in needs.loads.iter().enumerate() {
                let points = results.curves[curve].area_fractions(colour);
                let line = self.line(&needs.curves[curve].name, &load.label, place, colour, points);
                series.push(Series {
                    condition_in_full: load_in_full(&load.label, load.nominal_pressure_pa, hardness_pa),
                    ..line
                });
            }
            if let CurveResult::Statistical(_) = results.curves[curve] {
                for (at, separation_m) in needs.separations_m.iter().enumerate() {
                    // The blocks of separations follow those of the loads.
                    let block = needs.loads.len() + at;
                    let sign = if *separation_m < 0.0 { "-" } else { "" };
                    let label = format!("separation {sign}{}", length(separation_m.abs()));
                    let points = results.curves[curve].area_fractions(block);
                    series.push(self.line(&needs.curves[curve].name, &label, place, block, points));
                }
            }
        }
        series
    }

    fn load_series(&self, results: &Results, needs: &Needs) -> Vec<Series> {
        let mut cutoff_multiples: Vec<f64> = Vec::new();
        let line = |&sweep: &usize| {
            let (asked, states) = (&needs.sweeps[sweep], &results.sweeps[sweep]);
            let multiple = asked.cutoff_multiple;
            let known = cutoff_multiples.iter().position(|&other| other == multiple);
            let colour = known.unwrap_or_else(|| {
                cutoff_multiples.push(multiple);
                cutoff_multiples.len() - 1
            });
            let place = self.curves.iter().position(|&curve| curve == asked.curve).unwrap_or(0);
            let points =
                asked.pressures_pa.iter().zip(states).map(|(&p, state)| (p, state.area_fraction)).collect();
            let cutoff = length(multiple * results.psd.shortest_wavelength_m());
            let line = self.line(&needs.curves[asked.curve].name, &cutoff, place, colour, points);
            Series { condition_in_full: format!("cutoff {cutoff}"), ..line }
        };
        self.sweeps.iter().map(line).collect()
    }

    /// The line of one curve under one condition. The first of several curves is the reference that the others are held
    /// against: dashed.
    fn line(
        &self,
        curve: &str,
        condition: &str,
        place: usize,
        colour: usize,
        points: Vec<(f64, f64)>,
    ) -> Series {
        let dash = if self.curves.len() > 1 { [1, 0].get(place).copied().unwrap_or(place) } else { 0 };
        Series {
            column: format!("{curve} at {condition}"),
            curve: curve.to_owned(),
            condition: condition.to_owned(),
            condition_in_full: typeset(condition),
            colour,
            dash,
            points,
        }
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
        gaps: Vec::new(),
    }
}

fn psd_series(results: &Results) -> Vec<Series> {
    let wavevectors =
        results.psd.wavelengths_m().iter().map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
    vec![alone("c1d_m3", wavevectors.zip(results.psd.c1d_m3().iter().copied()).collect())]
}

fn scale_series(results: &Results, column: &str, of: fn(&Scale) -> f64) -> Vec<Series> {
    vec![alone(column, results.scales.iter().map(|scale| (scale.wavelength_m, of(scale))).collect())]
}

fn moment_series(results: &Results) -> Vec<Series> {
    let moment = |colour, name: &str, of: fn(&spectrum::Moments) -> f64| {
        let last = results.moments.last().map_or(1.0, |(moments, _)| of(moments));
        Series {
            column: format!("{name}_over_final"),
            curve: String::new(),
            condition: name.to_owned(),
            condition_in_full: name.to_owned(),
            colour,
            dash: 0,
            points: results
                .moments
                .iter()
                .map(|(moments, _)| (moments.wavelength_m, of(moments) / last))
                .collect(),
        }
    };
    vec![moment(0, "m0", |m| m.m0_m2), moment(1, "m2", |m| m.m2), moment(2, "m4", |m| m.m4_per_m2)]
}

fn alone(column: &str, points: Vec<(f64, f64)>) -> Series {
    Series {
        column: column.to_owned(),
        curve: String::new(),
        condition: String::new(),
        condition_in_full: String::new(),
        colour: 0,
        dash: 0,
        points,
    }
}

impl FigureData {
    /// A figure of spectra against wavevectors that leaves these holes open.
    #[must_use]
    pub fn with_holes(self, holes: &[Hole]) -> Self {
        let wavevector = |wavelength_m: f64| std::f64::consts::TAU / wavelength_m;
        let gaps =
            holes.iter().map(|hole| (wavevector(hole.longest_m), wavevector(hole.shortest_m))).collect();
        FigureData { gaps, ..self }
    }

    /// The points of a line in pieces, none of which crosses a gap. Points inside a gap are interpolated and left out.
    #[must_use]
    pub fn pieces(&self, series: &Series) -> Vec<Vec<(f64, f64)>> {
        // An abscissa at the end of a gap was measured, whatever the rounding.
        let is_inside = |x: f64| self.gaps.iter().any(|(a, b)| x > a * (1.0 + 1e-9) && x < b * (1.0 - 1e-9));
        let crosses = |x: f64, y: f64| {
            let (from, to) = (x.min(y) * (1.0 - 1e-9), x.max(y) * (1.0 + 1e-9));
            self.gaps.iter().any(|(a, b)| from <= *a && to >= *b)
        };
        let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
        for point in series.points.iter().filter(|(x, _)| !is_inside(*x)) {
            match pieces.last_mut() {
                Some(piece) if !piece.last().is_some_and(|last| crosses(last.0, point.0)) => {
                    piece.push(*point)
                }
                _ => pieces.push(vec![*point]),
            }
        }
        pieces
    }

    /// Whether its lines belong to several curves.
    pub fn compares_curves(&self) -> bool {
        self.series.iter().any(|series| series.dash > 0)
    }

    /// What is drawn, as a table: every abscissa of any line, and a column per line.
    pub fn table(&self) -> Table {
        let abscissas = self.abscissas();
        let table = Table::default().with_numbers(self.x.column, abscissas.iter().copied());
        self.series.iter().fold(table, |table, series| {
            let mut points = series.points.iter().peekable();
            let cell = |x: &f64| points.next_if(|(at, _)| at == x).map(|(_, value)| *value);
            table.with_numbers(&series.column, abscissas.iter().map(cell).collect::<Vec<_>>())
        })
    }

    /// The abscissas of all lines, each once, in the direction in which the lines run.
    fn abscissas(&self) -> Vec<f64> {
        let mut all: Vec<f64> =
            self.series.iter().flat_map(|series| series.points.iter().map(|(x, _)| *x)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let falling =
            self.series.iter().any(|series| matches!(series.points[..], [(a, _), .., (b, _)] if a > b));
        if falling {
            all.reverse();
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tables::Cells;

    #[test]
    fn f_a_2_no_line_crosses_a_hole() {
        let points = vec![(1.0, 0.1), (2.0, 0.2), (4.0, 0.3), (8.0, 0.4), (9.0, 0.5)];
        let tau = std::f64::consts::TAU;
        let hole = Hole { longest_m: tau / 2.0, shortest_m: tau / 8.0 };
        let figure = psd_figure("f", vec![alone("c1d_m3", points.clone())]).with_holes(&[hole]);
        let pieces = figure.pieces(&figure.series[0]);
        assert_eq!(pieces, [vec![(1.0, 0.1), (2.0, 0.2)], vec![(8.0, 0.4), (9.0, 0.5)]]);
        let whole = psd_figure("f", vec![alone("c1d_m3", points.clone())]);
        assert_eq!(whole.pieces(&whole.series[0]), [points]);
    }

    #[test]
    fn lines_of_different_abscissas_share_a_table() {
        let figure = FigureData {
            name: "f".to_owned(),
            shows: Shows::Area,
            title: String::new(),
            x: WAVELENGTH,
            x_label: String::new(),
            y_label: AREA,
            series: vec![
                alone("a", vec![(3.0, 0.3), (2.0, 0.2), (1.0, 0.1)]),
                alone("b", vec![(2.0, 0.5), (0.5, 0.4)]),
            ],
            gaps: Vec::new(),
        };
        let table = figure.table();
        let column = |name: &str| match table.column(name) {
            Some(Cells::Numbers(cells)) => cells.clone(),
            other => panic!("{other:?}"),
        };
        assert_eq!(column("wavelength_m"), [Some(3.0), Some(2.0), Some(1.0), Some(0.5)]);
        assert_eq!(column("a"), [Some(0.3), Some(0.2), Some(0.1), None]);
        assert_eq!(column("b"), [None, Some(0.5), None, Some(0.4)]);
    }
}
