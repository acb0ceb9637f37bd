//! Where a law is smooth, and the coordinate in which it is.
//!
//! A law that is explicit in something other than the interference, as sinusoids are in their pressure, brings coordinates
//! of its own: over those it is integrated without anything being solved for.

use std::fmt::Debug;

/// What a law answers at the points of a chart, a row for each quantity.
pub(crate) struct Points<'a> {
    pub interferences_m: &'a mut [f64],
    /// Derivative of the interference by the coordinate.
    pub slopes_m: &'a mut [f64],
    /// eta F \[Pa\] and eta A.
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
}

/// A coordinate of a law's own.
pub(crate) trait LawChart: Debug + Send + Sync {
    /// The coordinate of an interference \[m\]; rises with it.
    fn coordinate(&self, interference_m: f64) -> f64;

    /// What the law answers at coordinates that no break of it divides.
    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>);

    /// How much more or less the law has to be resolved than the density, on a piece that begins at first touch or
    /// further on: with nine of ten panels of the UNCD scenes so, at tolerances from 1e-6 to 1e-12, the right number of
    /// nodes at once saves a fifth of all evaluations.
    fn resolution(&self, _from_first_touch: bool) -> f64 {
        1.0
    }

    /// The power of the interference with which the response grows, or less: how little of the whole a small part of the
    /// interferences is.
    fn growth(&self) -> f64 {
        2.0
    }
}

/// The coordinate in which a piece of a law is smooth up to its ends.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Chart<'a> {
    /// The quadrature's own coordinate of the interference, good for powers of it.
    Interference,
    /// One that the law brings.
    Law(&'a dyn LawChart),
}

/// An interval of interferences \[m\] on which a law is smooth in the coordinate of `chart`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<'a> {
    pub from_m: f64,
    pub to_m: f64,
    pub chart: Chart<'a>,
}

/// The pieces between neighbouring ends in rising order, each on the chart that there is for its upper end.
pub(crate) fn pieces_between<'a>(ends_m: &[f64], chart_to: impl Fn(f64) -> Chart<'a>) -> Vec<Piece<'a>> {
    ends_m
        .windows(2)
        .filter(|ends| ends[0] < ends[1])
        .map(|ends| Piece { from_m: ends[0], to_m: ends[1], chart: chart_to(ends[1]) })
        .collect()
}
