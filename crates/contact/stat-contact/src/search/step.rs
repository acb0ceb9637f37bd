//! One step of a search: extrapolates ln p to the target by its derivatives at a separation.

use super::bracket::{Bracket, Side};
use super::problem::Search;
use crate::quadrature::Sums;

/// Lower limit of the discriminant of the parabola, as a share of the tangent's slope squared, if it does not reach
/// the target: the step is then at most a third longer than twice the tangent's.
const LEAST_DISCRIMINANT: f64 = 0.25;
/// Largest share of a step by which the third derivative may change it.
const MOST_BEND: f64 = 0.25;
/// Length, relative to 1 + |u|, below which a step to the maximum of the pressure ends there.
const AT_THE_PEAK: f64 = 1e-4;

impl Search<'_, '_> {
    /// Returns the next separation from u, within the bracket, and narrows the bracket; `None` if the target is above
    /// the highest pressure.
    pub fn next(&mut self, u: f64, sums: &Sums, bracket: &mut Bracket) -> Option<f64> {
        let missing = self.missing(u, sums);
        let [slope, curvature, third] = sums.log_pressure_slopes();
        if let Some(edge) = self.far_edge() {
            if missing > 0.0 && u < edge {
                // The slope may be lost in rounding here: look up the peak.
                if self.pressure_pa > self.highest_pressure_pa() {
                    return None;
                }
                bracket.narrow(u, Side::Farther);
                return Some(bracket.halve(u, Side::Farther));
            }
            if slope >= 0.0 || (curvature < 0.0 && slope * slope < -2.0 * missing * curvature) {
                return next_to_peak(u, missing, [slope, curvature], bracket);
            }
        }
        let side = Side::of_missing(missing);
        bracket.narrow(u, side);
        Some(bracket.step(u, u + step_to_target(missing, [slope, curvature, third]), side))
    }
}

/// Step to the point where the parabola through ln p meets the target, or its tangent if it does not, with a
/// correction by the third derivative.
fn step_to_target(missing: f64, [slope, curvature, third]: [f64; 3]) -> f64 {
    let discriminant = (slope * slope + 2.0 * missing * curvature).max(LEAST_DISCRIMINANT * slope * slope);
    let step = 2.0 * missing / (slope - discriminant.sqrt());
    // One step of Newton's from there on the cubic: with it most searches sum the density twice, without it three
    // times.
    let bend = third * step * step / 6.0 * step / (slope + step * (curvature + 0.5 * third * step));
    if bend.abs() < MOST_BEND * step.abs() { step - bend } else { step }
}

/// Next separation if u lies on the near side of the peak, or if the parabola through ln p does not reach the target:
/// the far side of the parabola if it meets the target, else its peak. `None` if u is at the peak and the peak is too
/// low.
fn next_to_peak(u: f64, missing: f64, [slope, curvature]: [f64; 2], bracket: &mut Bracket) -> Option<f64> {
    // From the near side the solution lies beyond the peak, as if there were too much pressure.
    let side = if slope >= 0.0 { Side::Farther } else { Side::of_missing(missing) };
    bracket.narrow(u, side);
    if curvature >= 0.0 {
        return Some(bracket.halve(u, side));
    }
    let discriminant = slope * slope + 2.0 * missing * curvature;
    let step = -(slope + discriminant.max(0.0).sqrt()) / curvature;
    if discriminant < 0.0 && step.abs() < AT_THE_PEAK * (1.0 + u.abs()) {
        return None;
    }
    Some(bracket.step(u, u + step, side))
}
