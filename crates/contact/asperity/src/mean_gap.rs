//! Mean gap left by a sinusoid under pressure, and its inverse: Rostami & Jackson (2013), Proc IMechE J 227:1376;
//! Jackson & Jacobs, Eqs. (9)-(12).
//!
//! Everything is written in ln x, x = p/p*, and in the complement h_p/Delta = 1 - g/Delta, which keeps its digits
//! where the gap is almost the amplitude. They matter because the strength goes like h_p^(-1/2).

use numerics::{newton_in_bracket, newton_in_brackets};

use crate::elementary;
use crate::lanes::each;

/// Exponent of g/Delta = (1 - x^(A1 x + A2))^(5/2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GapExponent {
    a1: f64,
    a2: f64,
}

impl GapExponent {
    /// Creates A1 = -0.1 ln r, A2 = (r-1)^0.44/15 + 0.99^(0.44 (r-1)) - 1/2 for the aspect ratio r >= 1 over the
    /// critical one; elastic at r = 1.
    #[inline(always)]
    pub fn elastic_plastic(aspect_ratio_over_critical: f64) -> Self {
        const LOG_OF_99_HUNDREDTHS: f64 = -0.010_050_335_853_501_44;
        let beyond = aspect_ratio_over_critical - 1.0;
        GapExponent {
            a1: -0.1 * elementary::ln(aspect_ratio_over_critical),
            a2: elementary::exp(0.44 * elementary::ln(beyond)) / 15.0
                + elementary::exp(0.44 * LOG_OF_99_HUNDREDTHS * beyond)
                - 0.5,
        }
    }

    /// Mean gap over amplitude g/Delta at ln x <= 0.
    pub fn gap_over_amplitude(self, log_x: f64) -> f64 {
        let opening = -self.log_power(log_x, log_x.exp()).exp_m1();
        opening * opening * opening.sqrt()
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta at ln x <= 0 and x.
    pub fn deformation_over_amplitude(self, log_x: f64, x: f64) -> f64 {
        let t = self.log_power(log_x, x).exp();
        complement(t, 1.0 - t)
    }

    /// Deformation over amplitude h_p/Delta and its derivative by ln x, at ln x < 0 and x.
    #[inline(always)]
    pub fn deformation_and_slope(self, log_x: f64, x: f64) -> (f64, f64) {
        let exponent = self.a1 * x + self.a2;
        let log_t = exponent * log_x;
        let (t, opening) = (elementary::exp(log_t), -elementary::exp_m1(log_t));
        let slope = 2.5 * opening * opening.sqrt() * t * (exponent + self.a1 * x * log_x);
        (complement(t, opening), slope)
    }

    /// Solves x^(A1 x + A2) = x^(1/2) e^`log_factor` for ln x < 0, with a factor below 1 and A2 > 1/2.
    pub fn log_x_where_half_power_is(self, log_factor: f64) -> f64 {
        // (A1 x + A2 - 1/2) ln x = ln(factor)/2 < 0. The left side rises from minus infinity at x = 0 and never falls
        // below zero once above it; without A1 x <= 0 it is smaller, and its zero an upper bound.
        let excess = self.a2 - 0.5;
        let target = 0.5 * log_factor;
        newton_in_bracket(-2.0 * (target / excess).abs() - 700.0, 0.0, target / excess, |log_x| {
            let x = elementary::exp(log_x);
            let exponent = self.a1 * x + excess;
            (exponent * log_x - target, self.a1 * x * log_x + exponent)
        })
    }

    /// ln x at which h_p/Delta has the given value in (0, 1).
    pub fn log_x_at(self, deformation_over_amplitude: f64) -> f64 {
        self.log_x_at_power(elementary::ln(power_at(deformation_over_amplitude)))
    }

    /// ln x at which (A1 x + A2) ln x = ln t, t in (0, 1).
    pub fn log_x_at_power(self, log_t: f64) -> f64 {
        if self.a1 == 0.0 {
            return log_t / self.a2;
        }
        let [lower, upper, start] = self.bracket(log_t);
        newton_in_bracket(lower, upper, start, |log_x| self.excess_and_slope(log_x, log_t))
    }

    /// Computes [`log_x_at_power`](Self::log_x_at_power) for N values of ln t at which `is_wanted`; elsewhere the result
    /// is 0. A1 is below 0, as it is for r > 1.
    #[inline(always)]
    pub fn log_xs_at_powers<const N: usize>(
        self,
        log_ts: [f64; N],
        is_wanted: impl Fn(usize) -> bool,
    ) -> [f64; N] {
        let (mut lowers, mut uppers, mut starts) = ([0.0; N], [0.0; N], [0.0; N]);
        for i in 0..N {
            let [lower, upper, start] = self.bracket(log_ts[i]);
            // A bracket of a single number ends at once.
            let wanted = |value: f64| if is_wanted(i) { value } else { 0.0 };
            (lowers[i], uppers[i], starts[i]) = (wanted(lower), wanted(upper), wanted(start));
        }
        newton_in_brackets(lowers, uppers, starts, |i, log_x| self.excess_and_slope(log_x, log_ts[i]))
    }

    /// Bracket of ln x at which (A1 x + A2) ln x = ln t, and a number near it.
    #[inline(always)]
    fn bracket(self, log_t: f64) -> [f64; 3] {
        // A1 <= 0 makes the exponent largest at x = 0 and the left side rise with ln x. So `upper` is an upper bound,
        // and the exponent there yields a lower one. Halley's step from there needs no further exponential, and leaves
        // Newton's method one to three.
        let upper = log_t / self.a2;
        let grown = self.a1 * elementary::exp(upper);
        let lower = log_t / (grown + self.a2);
        let excess = grown * upper;
        let (slope, curvature) = (excess + grown + self.a2, excess + 2.0 * grown);
        [lower, upper, upper - 2.0 * excess * slope / (2.0 * slope * slope - excess * curvature)]
    }

    /// Computes (A1 x + A2) ln x - ln t and its derivative by ln x.
    #[inline(always)]
    fn excess_and_slope(self, log_x: f64, log_t: f64) -> (f64, f64) {
        let x = elementary::exp(log_x);
        let exponent = self.a1 * x + self.a2;
        (exponent * log_x - log_t, self.a1 * x * log_x + exponent)
    }

    /// Logarithm of x^(A1 x + A2).
    #[inline(always)]
    pub fn log_power(self, log_x: f64, x: f64) -> f64 {
        (self.a1 * x + self.a2) * log_x
    }
}

/// Power t = 1 - (1 - h_p/Delta)^(2/5) of g/Delta = (1 - t)^(5/2), at h_p/Delta in [0, 1).
///
/// With y = (1 - h_p/Delta)^(2/5), 1 - y is (1 - y^5)/(1 + y + y^2 + y^3 + y^4), where nothing cancels.
#[inline(always)]
pub(crate) fn power_at(deformation_over_amplitude: f64) -> f64 {
    let [t] = powers_at([deformation_over_amplitude]);
    t
}

/// Computes [`power_at`] for N numbers.
#[inline(always)]
pub(crate) fn powers_at<const N: usize>(deformations_over_amplitude: [f64; N]) -> [f64; N] {
    let h = deformations_over_amplitude;
    let log_y: [f64; N] = each(|i| 0.4 * elementary::ln(1.0 - h[i]));
    let y: [f64; N] = each(|i| elementary::exp_in_range(log_y[i]));
    each(|i| h[i] * (2.0 - h[i]) / (1.0 + y[i] * (1.0 + y[i] * (1.0 + y[i] * (1.0 + y[i])))))
}

/// Computes 1 - (1-t)^(5/2) from t in [0, 1] and 1 - t: as (1 - (1-t)^5)/(1 + (1-t)^(5/2)) for small t, without
/// cancellation, and with a root instead of a logarithm and an exponential.
#[inline(always)]
pub(crate) fn complement(t: f64, opening: f64) -> f64 {
    let gap = opening * opening * opening.sqrt();
    let shallow = t * (5.0 - t * (10.0 - t * (10.0 - t * (5.0 - t)))) / (1.0 + gap);
    if t > 0.25 { 1.0 - gap } else { shallow }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elastic_plastic_exponent_starts_at_the_elastic_one() {
        assert_eq!(GapExponent::elastic_plastic(1.0), GapExponent { a1: 0.0, a2: 0.5 });
    }

    #[test]
    fn gap_and_deformation_make_up_the_amplitude() {
        for r in [1.0, 1.5, 37.0, 393.0, 1e4] {
            let law = GapExponent::elastic_plastic(r);
            for x in [1e-12f64, 1e-3, 0.5, 0.999] {
                let sum = law.gap_over_amplitude(x.ln()) + law.deformation_over_amplitude(x.ln(), x);
                assert!((sum - 1.0).abs() < 1e-15, "r = {r}, x = {x}: {sum}");
            }
        }
    }

    #[test]
    fn a_shallow_deformation_keeps_its_digits() {
        // 1 - (1 - s)^2.5 = 2.5 s - 1.875 s^2 + ... with s = sqrt(x) = 1e-10
        let shallow = GapExponent::elastic_plastic(1.0).deformation_over_amplitude(1e-20f64.ln(), 1e-20);
        assert!((shallow / (2.5e-10 - 1.875e-20) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_pressure_at_a_deformation_inverts_the_deformation_at_a_pressure() {
        for r in [1.0 + 1e-12, 1.01, 2.0, 37.0, 200.0, 1e4] {
            let law = GapExponent::elastic_plastic(r);
            for x in [1e-14, 1e-6, 0.01, 0.3, 0.9f64] {
                let back = law.log_x_at(law.deformation_over_amplitude(x.ln(), x));
                assert!((back - x.ln()).abs() < 1e-11 * x.ln().abs().max(1.0), "r = {r}, x = {x}: {back}");
            }
        }
    }
}
