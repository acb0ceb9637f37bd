//! The dimensionless problem, and its buffers.

use crate::half_space::transform::Convolution;

/// Problem in units in which the heights have a mean square of 1.
pub(crate) struct Problem<'a> {
    pub(crate) heights: &'a [f64],
    /// Quantity that is held.
    pub(crate) held: Held,
    /// Largest pressure of a point; infinite if it is elastic throughout.
    pub(crate) cap: f64,
    pub(crate) tolerance: f64,
}

/// Quantity that is held while the pressures adjust.
#[derive(Clone, Copy)]
pub(crate) enum Held {
    /// Mean pressure.
    Mean(f64),
    /// Offset from which the gaps are counted: gap = displacement - height - offset.
    Offset(f64),
}

impl Problem<'_> {
    /// Distance from a bound within which a pressure is at the bound, under a mean pressure.
    ///
    /// If all points are at a bound, a single one between them that holds the rounding of the whole load would
    /// otherwise set the offset.
    pub(crate) fn rounding_of_pressure(&self, mean: f64) -> f64 {
        let shares = if self.cap < f64::INFINITY { self.heights.len() as f64 } else { 1.0 };
        mean * 1e-14f64.max(1e-15 * shares)
    }
}

/// The two operators: the compliance, and roughly its inverse.
pub(crate) struct Operators {
    pub(crate) compliance: Convolution<f64>,
    /// In single precision, for changes of pressure far from equilibrium.
    pub(crate) rough_compliance: Convolution<f32>,
    /// In single precision, because it only preconditions directions.
    pub(crate) preconditioner: Convolution<f32>,
    /// True if a uniform pressure displaces the surface; false where displacements are counted from their mean.
    pub(crate) uniform_displaces: bool,
}

/// Maps in units of the problem, kept between solves.
pub(crate) struct State {
    pub(crate) pressures: Vec<f64>,
    /// Displacement less height, u - h, without the offset.
    pub(crate) gaps: Vec<f64>,
    /// Last change of the pressures, and its displacements.
    pub(crate) change: Vec<f64>,
    pub(crate) response: Vec<f64>,
    /// Gap on free points, and the preconditioned gap; then the change and its response in single precision.
    pub(crate) gradient: Vec<f32>,
    /// Points that may change.
    pub(crate) free: Vec<u32>,
    /// Trial pressures of the free points, then their changes.
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

    /// Four maps as work space, with arbitrary contents.
    pub(crate) fn maps(&mut self) -> [&mut [f64]; 4] {
        [&mut self.pressures, &mut self.gaps, &mut self.change, &mut self.response]
    }
}
