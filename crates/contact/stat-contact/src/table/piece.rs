//! Polynomials of the integrals between two separations.
//!
//! Their coordinate is x = arsinh(u/2): about u/2 near the mean plane and ln|u| far from it. Their values are taken over
//! exp(-u (u + sqrt(u^2 + 4))/4), which goes like the reference density on both sides of the mean plane and, unlike it,
//! is smooth there.

use std::f64::consts::PI;

use asperity::elementary;
use numerics::newton_in_bracket;

use crate::gaussian::density::log_reference_density;
use crate::quadrature::frames::Frames;
use crate::state::Integrals;

/// Intervals between the points of a fit. Each set of points contains the one before.
const INTERVALS: [usize; 4] = [6, 12, 24, 48];

/// ln p and ln A over the smooth density, the mean height that carries the load, and the share of the load outside the
/// range that the law was fitted in.
type Values = [f64; 4];

/// Polynomials between two coordinates.
#[derive(Debug)]
pub(crate) struct Piece {
    pub from_x: f64,
    pub to_x: f64,
    /// Chebyshev coefficients.
    coefficients: Vec<Values>,
    /// Points of the fit in the order of their coordinates.
    knots: Vec<Knot>,
    error_estimate: f64,
}

/// Point of a fit.
#[derive(Debug, Clone, Copy)]
struct Knot {
    x: f64,
    log_pressure: f64,
    /// Derivative of ln p by x.
    slope: f64,
}

impl Piece {
    /// Fits polynomials to the precision of the frames; `None` if even the highest degree does not suffice.
    pub fn fit(frames: &mut Frames<'_>, from_x: f64, to_x: f64) -> Option<Self> {
        let mut points: Vec<(f64, Integrals)> = Vec::new();
        for intervals in INTERVALS {
            let mut known = points.into_iter();
            let mut point = |k: usize| {
                let kept = if k.is_multiple_of(2) { known.next() } else { None };
                kept.unwrap_or_else(|| {
                    let share = 0.5 - 0.5 * libm::cos(PI * k as f64 / intervals as f64);
                    let x = (1.0 - share) * from_x + share * to_x;
                    (x, frames.integrals_at(separation(x)))
                })
            };
            points = (0..=intervals).map(&mut point).collect();
            let values: Vec<Values> = points.iter().map(|(_, integrals)| values(integrals)).collect();
            if values.iter().flatten().any(|value| !value.is_finite()) {
                return None;
            }
            let coefficients = coefficients(&values);
            let error = points.iter().map(|(_, integrals)| integrals.relative_error).fold(0.0, f64::max);
            let noise = scaled(error, &points);
            let allowed = scaled(error.max(frames.precision.tolerance), &points);
            if let Some(left_out) = left_out(&coefficients, &noise, &allowed) {
                // Errors of the points grow by at most this factor in between.
                let growth = 1.0 + 2.0 / PI * (intervals as f64 + 1.0).ln();
                let error_estimate = growth * error + 2.0 * left_out[0].max(left_out[1]);
                let knots = points.iter().map(|(x, integrals)| Knot::new(*x, integrals)).collect();
                return Some(Piece { from_x, to_x, coefficients, knots, error_estimate });
            }
        }
        None
    }

    /// Returns true if the pressure falls with the separation all over the piece.
    pub fn falls(&self) -> bool {
        // Between the points the polynomial shows what they may have missed.
        let falls_between = |x: f64| self.values(x)[2] > 0.0;
        self.knots.iter().all(|knot| knot.slope < 0.0)
            && self.knots.windows(2).all(|pair| {
                pair[1].log_pressure < pair[0].log_pressure && falls_between(0.5 * (pair[0].x + pair[1].x))
            })
    }

    /// Logarithm of the pressure at the end with the smaller separation.
    pub fn log_pressure_at_start(&self) -> f64 {
        self.knots[0].log_pressure
    }

    /// Logarithm of the pressure at the other end.
    pub fn log_pressure_at_end(&self) -> f64 {
        self.knots[self.knots.len() - 1].log_pressure
    }

    /// Returns the integrals at the separation u of a coordinate x of the piece.
    #[inline]
    pub fn integrals(&self, x: f64, u: f64) -> Integrals {
        let [log_pressure, log_area, mean_height, share] = self.values(x);
        let offset = offset(u);
        Integrals {
            u,
            pressure_pa: elementary::exp(log_pressure - offset),
            area_fraction: elementary::exp(log_area - offset),
            mean_height,
            relative_error: self.error_estimate,
            out_of_range_load_share: share.clamp(0.0, 1.0),
        }
    }

    /// Finds the coordinate of a pressure between those at the ends of a piece on which it falls.
    pub fn coordinate_of(&self, log_pressure: f64) -> f64 {
        let above = self.knots.partition_point(|knot| knot.log_pressure > log_pressure);
        let above = above.clamp(1, self.knots.len() - 1);
        let (from, to) = (self.knots[above - 1], self.knots[above]);
        newton_in_bracket(from.x, to.x, start(from, to, log_pressure), |x| {
            let u = separation(x);
            let [smooth, _, mean_height, _] = self.values(x);
            let here = smooth - offset(u) + log_reference_density(u);
            (log_pressure - here, mean_height * (u * u + 4.0).sqrt())
        })
    }

    /// Sums the polynomials by Clenshaw's recurrence.
    #[inline]
    fn values(&self, x: f64) -> Values {
        let t = ((x - self.from_x) - (self.to_x - x)) / (self.to_x - self.from_x);
        let (mut last, mut before) = ([0.0; 4], [0.0; 4]);
        for coefficient in self.coefficients[1..].iter().rev() {
            for i in 0..4 {
                let next = 2.0 * t * last[i] - before[i] + coefficient[i];
                (before[i], last[i]) = (last[i], next);
            }
        }
        std::array::from_fn(|i| t * last[i] - before[i] + self.coefficients[0][i])
    }
}

impl Knot {
    fn new(x: f64, integrals: &Integrals) -> Self {
        let &Integrals { u, pressure_pa, mean_height, .. } = integrals;
        Knot {
            x,
            log_pressure: elementary::ln(pressure_pa) + log_reference_density(u),
            slope: -mean_height * (u * u + 4.0).sqrt(),
        }
    }
}

/// Coordinate of a separation in units of sigma_s.
pub(crate) fn coordinate(u: f64) -> f64 {
    let half = 0.5 * u.abs();
    elementary::ln_1p(half + half * (half / (1.0 + (1.0 + half * half).sqrt()))).copysign(u)
}

/// Separation at a coordinate, in units of sigma_s.
pub(crate) fn separation(x: f64) -> f64 {
    let rise = elementary::exp_m1(x.abs());
    (rise + rise / (1.0 + rise)).copysign(x)
}

/// Logarithm of the reference density over the smooth one.
fn offset(u: f64) -> f64 {
    u / (u.abs() + (u * u + 4.0).sqrt())
}

fn values(integrals: &Integrals) -> Values {
    let offset = offset(integrals.u);
    [
        elementary::ln(integrals.pressure_pa) + offset,
        elementary::ln(integrals.area_fraction) + offset,
        integrals.mean_height,
        integrals.out_of_range_load_share,
    ]
}

/// Errors of the values that correspond to a relative one of pressures and areas.
fn scaled(relative: f64, points: &[(f64, Integrals)]) -> Values {
    // A share says how far to trust a law; more digits of it tell nobody more.
    const SHARE: f64 = 1e-4;
    // Heights are sums of a separation and an interference.
    const ROUNDING: f64 = 1e-14;
    let heights = || points.iter().map(|(_, integrals)| integrals.mean_height);
    let (least, most) = heights().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
    // Where the pressure has a maximum, heights have no relative accuracy.
    let height = if least > 0.0 { least } else { most.abs().max(least.abs()) };
    let farthest = points.iter().map(|(_, integrals)| integrals.u.abs()).fold(1.0, f64::max);
    [relative, relative, relative * height + ROUNDING * farthest, relative.max(SHARE)]
}

/// Chebyshev coefficients of the polynomials through values at the points of a fit.
fn coefficients(values: &[Values]) -> Vec<Values> {
    let intervals = values.len() - 1;
    let cosines: Vec<f64> = (0..2 * intervals).map(|m| libm::cos(PI * m as f64 / intervals as f64)).collect();
    let at_end = |k: usize| k == 0 || k == intervals;
    let coefficient = |degree: usize| {
        let mut sums = [0.0; 4];
        for (k, value) in values.iter().enumerate() {
            // The first point is at the smaller end, where T_1 is -1.
            let polynomial = cosines[degree * (intervals - k) % (2 * intervals)];
            let weight = if at_end(k) { 0.5 * polynomial } else { polynomial };
            for (sum, value) in sums.iter_mut().zip(value) {
                *sum += weight * value;
            }
        }
        let scale = if at_end(degree) { 1.0 } else { 2.0 } / intervals as f64;
        sums.map(|sum| scale * sum)
    };
    (0..=intervals).map(coefficient).collect()
}

/// Estimates the errors of polynomials from the rate at which their coefficients fall, which are geometric for smooth
/// functions, down to the noise of the values; `None` if one may be larger than allowed. Blocks of three are compared:
/// single coefficients may vanish by symmetry.
fn left_out(coefficients: &[Values], noise: &Values, allowed: &Values) -> Option<Values> {
    const BLOCK: usize = 3;
    // Blocks of few coefficients may fall faster than those after them.
    const LEAST: f64 = 4.0;
    let largest = |block: &[Values], i: usize| block.iter().map(|values| values[i].abs()).fold(0.0, f64::max);
    let (before, last) = coefficients.split_at(coefficients.len() - BLOCK);
    let (_, before) = before.split_at(before.len() - BLOCK);
    let mut errors = [0.0; 4];
    for (i, error) in errors.iter_mut().enumerate() {
        let (before, last) = (largest(before, i), largest(last, i));
        let is_noise = last <= noise[i];
        let rate = (last / before).min(if is_noise { 0.5 } else { 1.0 });
        // All blocks to come, which the polynomial through the values has once more in its coefficients.
        *error = if last == 0.0 { 0.0 } else { last * (2.0 * BLOCK as f64 * rate / (1.0 - rate)).max(LEAST) };
        if !(is_noise || *error <= allowed[i]) {
            return None;
        }
    }
    Some(errors)
}

/// Coordinate of a pressure between two knots by the cubic in ln p with their slopes.
fn start(from: Knot, to: Knot, log_pressure: f64) -> f64 {
    let rise = to.log_pressure - from.log_pressure;
    let t = (log_pressure - from.log_pressure) / rise;
    let step = to.x - from.x;
    let (bend_from, bend_to) = (rise / from.slope - step, step - rise / to.slope);
    from.x + t * step + t * (1.0 - t) * ((1.0 - t) * bend_from + t * bend_to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_return() {
        for u in [-1e6, -30.0, -1e-3, 0.0, 1e-12, 0.7, 20.0, 1e12, 1e30f64] {
            let back = separation(coordinate(u));
            assert!((back - u).abs() <= 4e-15 * u.abs() * coordinate(u).abs().max(1.0), "{u}: {back}");
            assert!((coordinate(u) - (0.5 * u).asinh()).abs() <= 1e-15 * (1.0 + coordinate(u).abs()), "{u}");
        }
    }

    #[test]
    fn a_polynomial_has_its_own_coefficients() {
        // T_0 - 2 T_1 + 3 T_5 at the points of six intervals.
        let at = |k: usize| -> Values {
            let angle = PI * (6 - k) as f64 / 6.0;
            [1.0 - 2.0 * angle.cos() + 3.0 * (5.0 * angle).cos(); 4]
        };
        let found = coefficients(&(0..=6).map(at).collect::<Vec<_>>());
        for (found, exact) in found.iter().zip([1.0, -2.0, 0.0, 0.0, 0.0, 3.0, 0.0]) {
            assert!((found[0] - exact).abs() < 1e-14, "{found:?}");
        }
    }

    #[test]
    fn what_is_left_out_follows_from_the_rate_of_the_coefficients() {
        // They fall by a factor of 2/3 from one block to the next, or are noise.
        let coefficients = [4.0, 4.5, -2.0, -3.0, 1.0, 0.0].map(|coefficient| [coefficient; 4]);
        let found =
            |noise, allowed| left_out(&coefficients, &[noise; 4], &[allowed; 4]).map(|errors| errors[1]);
        assert!((found(0.0, 37.0).unwrap() - 36.0).abs() < 1e-12);
        assert_eq!(found(0.0, 35.0), None);
        assert_eq!(found(3.1, 0.0), Some(18.0));
    }

    #[test]
    fn a_search_starts_near_its_end() {
        let knot = |x: f64| Knot { x, log_pressure: -x.exp(), slope: -x.exp() };
        let found = start(knot(1.0), knot(1.3), -(1.2f64.exp()));
        assert!((found - 1.2).abs() < 2e-4, "{found}");
    }
}
