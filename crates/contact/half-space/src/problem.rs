//! The problem that is solved, in numbers, and what is worked on.

use crate::transform::Convolution;

/// What is asked, in units in which the heights have a mean square of 1.
pub(crate) struct Problem<'a> {
    pub(crate) heights: &'a [f64],
    /// Mean pressure.
    pub(crate) mean: f64,
    /// The largest pressure a point carries; infinite where it is elastic throughout.
    pub(crate) cap: f64,
    pub(crate) tolerance: f64,
}

impl Problem<'_> {
    /// Pressures so near to a bound are at it.
    ///
    /// Where all points are at a bound, one between them that holds the rounding of the whole load would set the offset.
    pub(crate) fn rounding_of_pressure(&self) -> f64 {
        let shares = if self.cap < f64::INFINITY { self.heights.len() as f64 } else { 1.0 };
        self.mean * 1e-14f64.max(1e-15 * shares)
    }
}

/// The two operators: displacements of pressures, and roughly the inverse.
pub(crate) struct Operators {
    pub(crate) compliance: Convolution<f64>,
    /// In single precision, since it only shapes directions.
    pub(crate) preconditioner: Convolution<f32>,
}

/// Maps in units of the problem, kept between solves.
pub(crate) struct State {
    pub(crate) pressures: Vec<f64>,
    /// u - h, from which the offset is not yet taken.
    pub(crate) gaps: Vec<f64>,
    /// The last change of the pressures, and the displacements it makes.
    pub(crate) change: Vec<f64>,
    pub(crate) response: Vec<f64>,
    /// The gap on free points, and what the preconditioner makes of it.
    pub(crate) gradient: Vec<f32>,
    /// Points that may change.
    pub(crate) free: Vec<u32>,
    /// Where each of them is tried, then by how much it would change.
    pub(crate) trial: Vec<f64>,
}

impl State {
    pub(crate) fn new(points: usize) -> Self {
        Self {
            pressures: vec![0.0; points],
            gaps: vec![0.0; points],
            change: vec![0.0; points],
            response: vec![0.0; points],
            gradient: vec![0.0; points],
            free: Vec::with_capacity(points),
            trial: Vec::with_capacity(points),
        }
    }

    /// Four maps to work on, with whatever they hold.
    pub(crate) fn maps(&mut self) -> [&mut [f64]; 4] {
        [&mut self.pressures, &mut self.gaps, &mut self.change, &mut self.response]
    }
}
