//! The axes of a picture on either scale: places of values, ticks and labels.

use kuva::TickFormat;
use kuva::render::layout::ComputedLayout;
use study::figure::{AxisKind, AxisScale, FigureData, Shows};

use super::WIDTH_PX;
use super::decades::{Decades, MAX_TICKS, lengths, powers_of_ten, shares};
use super::steps::Steps;

/// The most steps of linear axes, across and upwards.
const MAX_STEPS: [f64; 2] = [7.0, 8.0];
/// The least width of a narrow picture for each labelled tick.
const TICK_ROOM_PX: f64 = 65.0;

/// An axis: its scale, range and ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ruler {
    /// Powers of ten.
    Decades(Decades),
    /// Equal steps.
    Steps(Steps),
}

/// The abscissa and the ordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rulers {
    pub x: Ruler,
    pub y: Ruler,
}

impl Rulers {
    /// Returns axes with the scales of a figure around points, in a picture of a width \[px\] if that is narrow.
    pub fn around(figure: &FigureData, points: &[(f64, f64)], narrow_px: Option<f64>) -> Self {
        let most = narrow_px.filter(|px| *px < WIDTH_PX).map_or(f64::INFINITY, |px| px / TICK_ROOM_PX);
        let x = points.iter().map(|(x, _)| *x);
        let y = points.iter().map(|(_, y)| *y);
        let [across, upwards] = MAX_STEPS;
        Rulers {
            x: match figure.x_scale {
                AxisScale::Logarithmic => Ruler::Decades(Decades::with_ticks(x, most.min(MAX_TICKS))),
                AxisScale::Linear => Ruler::Steps(Steps::around(x, &figure.x_label, most.min(across))),
            },
            y: match figure.y_scale {
                AxisScale::Logarithmic => Ruler::Decades(Decades::around(y)),
                AxisScale::Linear => Ruler::Steps(Steps::around(y, figure.y_label, upwards)),
            },
        }
    }

    /// Returns the points that have a place, in the units of the layout.
    pub fn places(&self, points: &[(f64, f64)]) -> Vec<(f64, f64)> {
        points.iter().filter_map(|(x, y)| Some((self.x.place(*x)?, self.y.place(*y)?))).collect()
    }

    /// Returns the abscissa of a value in pixels, if it has a place.
    pub fn x_px(&self, computed: &ComputedLayout, value: f64) -> Option<f64> {
        self.x.place(value).map(|place| computed.map_x(place))
    }

    /// Returns the ordinate of a value in pixels, if it has a place.
    pub fn y_px(&self, computed: &ComputedLayout, value: f64) -> Option<f64> {
        self.y.place(value).map(|place| computed.map_y(place))
    }

    /// Returns the labels of the ticks of the abscissa: lengths if it is one, else powers of ten; on a linear axis numbers.
    pub fn x_ticks(&self, figure: &FigureData) -> TickFormat {
        match self.x {
            Ruler::Steps(steps) => steps.numbers(),
            Ruler::Decades(_) if figure.x.kind() == AxisKind::Length => lengths(),
            Ruler::Decades(_) => powers_of_ten(),
        }
    }

    /// Returns the labels of the ticks of the ordinate: areas in percent, amplitudes as lengths, else powers of ten; on a
    /// linear axis numbers.
    pub fn y_ticks(&self, figure: &FigureData) -> TickFormat {
        match self.y {
            Ruler::Steps(steps) if is_share(figure) => steps.percents(),
            Ruler::Steps(steps) => steps.numbers(),
            Ruler::Decades(_) if is_share(figure) => shares(),
            Ruler::Decades(_) if is_length(figure) => lengths(),
            Ruler::Decades(_) => powers_of_ten(),
        }
    }

    /// Returns the label of the abscissa.
    pub fn x_label(&self, figure: &FigureData) -> String {
        self.x.label(&figure.x_label, figure.x.kind() == AxisKind::Length)
    }

    /// Returns the label of the ordinate.
    pub fn y_label(&self, figure: &FigureData) -> String {
        self.y.label(figure.y_label, is_length(figure))
    }
}

impl Ruler {
    /// Returns the place of a value in the units of the layout: its power of ten, if it is positive, or the value in the unit
    /// with its prefix.
    pub fn place(&self, value: f64) -> Option<f64> {
        match self {
            Ruler::Decades(_) => (value > 0.0).then(|| value.log10()),
            Ruler::Steps(steps) => value.is_finite().then(|| steps.place(value)),
        }
    }

    /// Returns the place at which the axis begins.
    pub fn first(&self) -> f64 {
        match self {
            Ruler::Decades(decades) => decades.first,
            Ruler::Steps(steps) => steps.first,
        }
    }

    /// Returns the place at which the axis ends.
    pub fn last(&self) -> f64 {
        match self {
            Ruler::Decades(decades) => decades.last,
            Ruler::Steps(steps) => steps.last,
        }
    }

    /// Returns the distance of labelled ticks.
    pub fn step(&self) -> f64 {
        match self {
            Ruler::Decades(decades) => decades.step,
            Ruler::Steps(steps) => steps.step,
        }
    }

    /// Returns the places of unlabelled ticks.
    pub fn minor_ticks(&self) -> Vec<f64> {
        match self {
            Ruler::Decades(decades) => decades.minor_ticks(),
            Ruler::Steps(steps) => steps.minor_ticks(),
        }
    }

    /// Returns true for a linear axis with zero between its ends.
    pub fn crosses_zero(&self) -> bool {
        matches!(self, Ruler::Steps(steps) if steps.first < 0.0 && steps.last > 0.0)
    }

    /// Returns the value at a place.
    pub fn value(&self, place: f64) -> f64 {
        match self {
            Ruler::Decades(_) => 10f64.powf(place),
            Ruler::Steps(steps) => place * steps.scale(),
        }
    }

    /// Returns the label of the axis: without its unit if ticks that are lengths have one, or with the prefix of the unit.
    fn label(&self, label: &str, is_length: bool) -> String {
        match self {
            Ruler::Decades(_) => label.strip_suffix(" (m)").filter(|_| is_length).unwrap_or(label).to_owned(),
            Ruler::Steps(steps) => steps.label(label),
        }
    }
}

/// Returns true if the ordinate is a share of an area.
pub(super) fn is_share(figure: &FigureData) -> bool {
    matches!(figure.shows, Shows::Area | Shows::AreaAgainstLoad)
}

/// Returns true if the ordinate is a length.
pub(super) fn is_length(figure: &FigureData) -> bool {
    figure.y_label.ends_with(" (m)")
}
