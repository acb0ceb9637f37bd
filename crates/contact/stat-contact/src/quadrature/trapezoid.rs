//! Trapezoidal rule over a window, for rough integrals: it needs no knowledge of the law.

use super::coordinate::Coordinate;

/// Nodes (first + 0.5) step, (first + 1.5) step and so on, `count` of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trapezoid {
    pub step: f64,
    first: f64,
    pub count: usize,
}

impl Trapezoid {
    /// Returns the rule that integrates a unit Gaussian between two coordinates to exp(-digits).
    pub fn between(from: f64, to: f64, digits: f64) -> Self {
        let step = Coordinate::trapezoidal_step(digits);
        Trapezoid { step, first: (from / step - 0.5).ceil(), count: ((to - from) / step).ceil() as usize }
    }

    /// Coordinate of a node.
    #[inline(always)]
    pub fn at(&self, k: usize) -> f64 {
        (self.first + f64::from(k as u32) + 0.5) * self.step
    }
}
