//! Intervals between neighbouring samples, on which the spectrum is a power law of the wavevector.

use std::f64::consts::TAU;

/// C1D = C_0 (q/q_0)^alpha between two neighbouring samples: a straight line in log-log axes.
///
/// Both log ratios are stored: dense samples make them tiny, and recomputing them from rounded quotients would lose
/// digits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    start: Sample,
    end: Sample,
    ln_q_ratio: f64,
    ln_c_ratio: f64,
}

/// A wavelength in m and the spectrum C1D there in m^3.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) wavelength_m: f64,
    pub(crate) c1d_m3: f64,
}

impl Interval {
    /// Makes the interval from a sample to the next one at a shorter wavelength.
    pub(crate) fn new(start: Sample, end: Sample) -> Self {
        let ln_q_ratio = ln_ratio(start.wavelength_m, end.wavelength_m);
        let ln_c_ratio = ln_ratio(end.c1d_m3, start.c1d_m3);
        Self { start, end, ln_q_ratio, ln_c_ratio }
    }

    pub(crate) fn end_wavelength_m(&self) -> f64 {
        self.end.wavelength_m
    }

    /// Integrates q^k C over the interval, in m^(2-k).
    ///
    /// With z = (k+1) ln(q_1/q_0) + ln(C_1/C_0) the integral is C q^(k+1) ln(q_1/q_0) (1 - e^-|z|)/|z|, taken
    /// at the end where C q^(k+1) is larger: no cancellation and no overflow of the exponential.
    pub(crate) fn integral(&self, k: i32) -> f64 {
        let z = f64::from(k + 1) * self.ln_q_ratio + self.ln_c_ratio;
        let larger = if z > 0.0 { self.end } else { self.start };
        let q_rad_per_m = TAU / larger.wavelength_m;
        larger.c1d_m3 * q_rad_per_m.powi(k + 1) * self.ln_q_ratio * mean_decay(z.abs())
    }

    /// Returns C1D \[m^3\] at a wavelength of the interval.
    pub(crate) fn value_at(&self, wavelength_m: f64) -> f64 {
        if wavelength_m == self.end.wavelength_m {
            return self.end.c1d_m3;
        }
        let fraction = ln_ratio(self.start.wavelength_m, wavelength_m) / self.ln_q_ratio;
        self.start.c1d_m3 * (fraction * self.ln_c_ratio).exp()
    }

    /// Cuts the interval to wavelengths from the cutoff up; `None` if nothing is left.
    pub(crate) fn down_to(self, cutoff_wavelength_m: f64) -> Option<Self> {
        if self.end.wavelength_m >= cutoff_wavelength_m {
            Some(self)
        } else if self.start.wavelength_m > cutoff_wavelength_m {
            let c1d_m3 = self.value_at(cutoff_wavelength_m);
            Some(Self::new(self.start, Sample { wavelength_m: cutoff_wavelength_m, c1d_m3 }))
        } else {
            None
        }
    }

    /// Splits the interval at its geometric midpoint.
    pub(crate) fn halves(&self) -> (Self, Self) {
        let middle = Sample {
            wavelength_m: self.start.wavelength_m.sqrt() * self.end.wavelength_m.sqrt(),
            c1d_m3: self.start.c1d_m3.sqrt() * self.end.c1d_m3.sqrt(),
        };
        let (ln_q_ratio, ln_c_ratio) = (0.5 * self.ln_q_ratio, 0.5 * self.ln_c_ratio);
        (
            Self { start: self.start, end: middle, ln_q_ratio, ln_c_ratio },
            Self { start: middle, end: self.end, ln_q_ratio, ln_c_ratio },
        )
    }
}

/// Computes ln(a/b) of two positive numbers, to full relative precision even if they nearly agree.
pub(crate) fn ln_ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if (0.5..=2.0).contains(&ratio) {
        ((a - b) / b).ln_1p() // the difference is exact here (Sterbenz)
    } else if ratio.is_normal() {
        ratio.ln()
    } else {
        a.ln() - b.ln()
    }
}

/// Computes (1 - e^-z)/z, the mean of e^-t over 0 <= t <= z, for z >= 0.
pub(crate) fn mean_decay(z: f64) -> f64 {
    if z == 0.0 { 1.0 } else { -(-z).exp_m1() / z }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn interval(wavelengths_m: [f64; 2], c1d_m3: [f64; 2]) -> Interval {
        let sample = |i: usize| Sample { wavelength_m: wavelengths_m[i], c1d_m3: c1d_m3[i] };
        Interval::new(sample(0), sample(1))
    }

    #[test]
    fn a_constant_spectrum_integrates_to_a_polynomial() {
        let flat = interval([TAU, TAU / 3.0], [2.0, 2.0]);
        assert_relative_eq!(flat.integral(0), 2.0 * (3.0 - 1.0), max_relative = 1e-15);
        assert_relative_eq!(flat.integral(2), 2.0 * (27.0 - 1.0) / 3.0, max_relative = 1e-15);
        assert_relative_eq!(flat.integral(4), 2.0 * (243.0 - 1.0) / 5.0, max_relative = 1e-15);
    }

    #[test]
    fn the_inverse_spectrum_integrates_to_a_logarithm() {
        let inverse = interval([TAU, TAU / 2.0], [1.0, 0.5]);
        assert_relative_eq!(inverse.integral(0), 2f64.ln(), max_relative = 1e-15);
    }

    #[test]
    fn integrals_are_continuous_at_the_logarithmic_exponent() {
        let at = |c: f64| interval([TAU, TAU / 2.0], [1.0, c]).integral(0) / 2f64.ln() - 1.0;
        assert_relative_eq!(at(0.5 * (1.0 + 1e-9)), 0.5e-9, max_relative = 1e-6);
        assert_relative_eq!(at(0.5 * (1.0 - 1e-9)), -0.5e-9, max_relative = 1e-6);
    }

    #[test]
    fn steep_intervals_neither_overflow_nor_vanish() {
        let fall = interval([1.0, 1e-3], [1e300, 1e-300]).integral(4);
        let rise = interval([1.0, 1e-3], [1e-300, 1e280]).integral(4);
        assert!(fall.is_finite() && fall > 0.0 && rise.is_finite() && rise > 0.0);
    }

    #[test]
    fn the_halves_add_up_to_the_whole() {
        let whole = interval([3e-6, 1e-8], [5e-22, 7e-31]);
        let (long, short) = whole.halves();
        for k in [0, 2, 4] {
            assert_relative_eq!(
                long.integral(k) + short.integral(k),
                whole.integral(k),
                max_relative = 1e-14
            );
        }
    }

    #[test]
    fn logarithms_of_close_ratios_keep_their_digits() {
        let a = 1.0 + 3.0 * f64::EPSILON;
        assert_relative_eq!(ln_ratio(a, 1.0), 3.0 * f64::EPSILON, max_relative = 1e-15, epsilon = 0.0);
        assert_relative_eq!(ln_ratio(1e300, 1e-300), 600.0 * 10f64.ln(), max_relative = 1e-15);
    }
}
