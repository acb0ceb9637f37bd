//! Intervals on which a law is smooth, and the coordinates in which it is.
//!
//! A law that is explicit in another variable than the interference, as sinusoids are in their pressure, provides its
//! own coordinates: it is integrated over those without solving for anything.

use std::fmt::Debug;

/// Results of a law at the points of a chart, a row for each quantity.
pub(crate) struct Points<'a> {
    pub interferences_m: &'a mut [f64],
    /// Derivative of the interference by the coordinate.
    pub slopes_m: &'a mut [f64],
    /// Pressures eta F \[Pa\].
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
}

/// Coordinate provided by a law.
pub(crate) trait LawChart: Debug + Send + Sync {
    /// The coordinate of an interference \[m\]; rises with it.
    fn coordinate(&self, interference_m: f64) -> f64;

    /// Evaluates the law at coordinates between which it has no break.
    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>);

    /// True if the law is evaluated at one coordinate after the other, so that each one costs as much.
    fn goes_one_by_one(&self) -> bool {
        false
    }

    /// Resolution that the law needs relative to that of the density, on a piece that begins at first touch or
    /// further on. With the right value for nine of ten panels of the UNCD scenes, at tolerances from 1e-6 to 1e-12,
    /// a fifth of all evaluations is saved.
    fn resolution(&self, _from_first_touch: bool) -> f64 {
        1.0
    }

    /// Lower bound of the power of the interference with which the response grows: it tells how small a part of the
    /// whole a small part of the interferences is.
    fn growth(&self) -> f64 {
        2.0
    }
}

/// Coordinate in which a piece of a law is smooth up to its ends.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Chart<'a> {
    /// The quadrature's own coordinate of the interference, suited to powers of it.
    Interference,
    /// Coordinate provided by the law.
    Law(&'a dyn LawChart),
}

/// Interval of interferences \[m\] on which a law is smooth in the coordinate of `chart`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<'a> {
    pub from_m: f64,
    pub to_m: f64,
    pub chart: Chart<'a>,
}

/// Pieces between neighbouring ends in rising order, each on the chart that `chart_to` returns for its upper end.
pub(crate) fn pieces_between<'a>(ends_m: &[f64], chart_to: impl Fn(f64) -> Chart<'a>) -> Vec<Piece<'a>> {
    ends_m
        .windows(2)
        .filter(|ends| ends[0] < ends[1])
        .map(|ends| Piece { from_m: ends[0], to_m: ends[1], chart: chart_to(ends[1]) })
        .collect()
}
