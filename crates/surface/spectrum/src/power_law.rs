//! Pieces of a function of the wavevector that are power laws.

use crate::interval::{ln_ratio, mean_decay};

/// The power law f(q) = f_0 (q/q_0)^b from q_0 to q_1, a straight line in log-log axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// Start q_0 > 0 \[rad/m\].
    pub start_rad_per_m: f64,
    /// End q_1 > q_0 \[rad/m\].
    pub end_rad_per_m: f64,
    /// Value f_0 at the start, in the unit of the function.
    pub at_start: f64,
    /// Exponent b.
    pub exponent: f64,
}

impl PowerLaw {
    /// Makes the power law through two points (wavevector \[rad/m\], value), all positive and the wavevectors rising.
    #[must_use]
    pub fn through(start: (f64, f64), end: (f64, f64)) -> Self {
        let exponent = ln_ratio(end.1, start.1) / ln_ratio(end.0, start.0);
        Self { start_rad_per_m: start.0, end_rad_per_m: end.0, at_start: start.1, exponent }
    }

    /// Returns the value at a wavevector \[rad/m\], also outside the piece.
    #[must_use]
    #[inline]
    pub fn value_at(&self, q_rad_per_m: f64) -> f64 {
        self.at_start * (q_rad_per_m / self.start_rad_per_m).powf(self.exponent)
    }

    /// Integrates q^k f over the piece, exactly.
    ///
    /// With z = (b + k + 1) ln(q_1/q_0) the integral is q^(k+1) f ln(q_1/q_0) (1 - e^-|z|)/|z|, taken at the end where
    /// q^(k+1) f is larger: no cancellation at z = 0 and no overflow of the exponential.
    #[must_use]
    pub fn integral(&self, k: i32) -> f64 {
        let ln_q_ratio = ln_ratio(self.end_rad_per_m, self.start_rad_per_m);
        let z = (self.exponent + f64::from(k + 1)) * ln_q_ratio;
        let q_rad_per_m = if z > 0.0 { self.end_rad_per_m } else { self.start_rad_per_m };
        self.value_at(q_rad_per_m) * q_rad_per_m.powi(k + 1) * ln_q_ratio * mean_decay(z.abs())
    }

    /// Cuts the piece to the range between two wavevectors \[rad/m\]; `None` if nothing is left.
    #[must_use]
    pub fn between(&self, least_rad_per_m: f64, largest_rad_per_m: f64) -> Option<Self> {
        let start_rad_per_m = self.start_rad_per_m.max(least_rad_per_m);
        let end_rad_per_m = self.end_rad_per_m.min(largest_rad_per_m);
        (start_rad_per_m < end_rad_per_m).then(|| Self {
            start_rad_per_m,
            end_rad_per_m,
            at_start: self.value_at(start_rad_per_m),
            exponent: self.exponent,
        })
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn integrals_agree_with_the_closed_ones_and_pass_through_the_logarithm() {
        let piece = PowerLaw::through((2.0, 3.0), (8.0, 3.0 / 16.0));
        assert_relative_eq!(piece.exponent, -2.0, max_relative = 1e-15);
        assert_relative_eq!(piece.integral(1), 12.0 * 4f64.ln(), max_relative = 1e-14);
        assert_relative_eq!(piece.integral(3), 12.0 * (64.0 - 4.0) / 2.0, max_relative = 1e-14);
        assert_relative_eq!(piece.integral(0), 12.0 * (0.5 - 0.125), max_relative = 1e-14);
    }

    #[test]
    fn the_parts_of_a_piece_add_up_to_it() {
        let piece = PowerLaw { start_rad_per_m: 1.0, end_rad_per_m: 1e3, at_start: 5.0, exponent: -3.6 };
        let parts = [piece.between(0.1, 30.0), piece.between(30.0, 1e5)].map(Option::unwrap);
        for k in [1, 3, 5] {
            let sum: f64 = parts.iter().map(|part| part.integral(k)).sum();
            assert_relative_eq!(sum, piece.integral(k), max_relative = 1e-14);
        }
        assert_eq!(piece.between(1e3, 1e4), None);
        assert_eq!(piece.between(0.1, 1.0), None);
    }
}
