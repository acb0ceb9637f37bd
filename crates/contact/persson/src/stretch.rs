//! The spectrum between two neighbouring samples: growth of the variance of the flattening pressure with the
//! wavevector.

/// Variance up to one wavevector of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeparationKnot {
    /// Wavevector q > 0 \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Variance V >= 0 of the flattening pressure up to q \[Pa^2\].
    pub variance_pa2: f64,
    /// Exponent e of dV/dq ~ q^(e-1) between here and the next knot: 3 plus the exponent of C1D.
    pub variance_exponent: f64,
}

/// Interval of the spectrum with q = q_i \[1 + k (V - V_i)\]^(1/e).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub(crate) start_rad_per_m: f64,
    pub(crate) end_rad_per_m: f64,
    pub(crate) start_pa2: f64,
    pub(crate) end_pa2: f64,
    growth_per_pa2: f64,
    exponent: f64,
}

impl Stretch {
    /// Stretch between two knots; `None` where nothing is added.
    pub(crate) fn between(start: &SeparationKnot, end: &SeparationKnot) -> Option<Self> {
        let rise_pa2 = end.variance_pa2 - start.variance_pa2;
        if rise_pa2 <= 0.0 {
            return None;
        }
        let exponent = not_flat(start.variance_exponent);
        let ln_q = (end.wavevector_rad_per_m / start.wavevector_rad_per_m).ln();
        Some(Stretch {
            start_rad_per_m: start.wavevector_rad_per_m,
            end_rad_per_m: end.wavevector_rad_per_m,
            start_pa2: start.variance_pa2,
            end_pa2: end.variance_pa2,
            growth_per_pa2: libm::expm1(exponent * ln_q) / rise_pa2,
            exponent,
        })
    }

    /// Part up to a wavevector, if there is any.
    pub(crate) fn up_to(self, wavevector_rad_per_m: f64) -> Option<Self> {
        if wavevector_rad_per_m >= self.end_rad_per_m {
            return Some(self);
        }
        let end_pa2 = self.variance_pa2(wavevector_rad_per_m);
        (wavevector_rad_per_m > self.start_rad_per_m).then_some(Stretch {
            end_rad_per_m: wavevector_rad_per_m,
            end_pa2,
            ..self
        })
    }

    /// Part beyond a wavevector, if there is any, with the variance counted from `left_out_pa2` on.
    pub(crate) fn beyond(self, wavevector_rad_per_m: f64, left_out_pa2: f64) -> Option<Self> {
        if wavevector_rad_per_m >= self.end_rad_per_m {
            return None;
        }
        let knot = |wavevector_rad_per_m: f64, variance_pa2: f64| SeparationKnot {
            wavevector_rad_per_m,
            variance_pa2: variance_pa2 - left_out_pa2,
            variance_exponent: self.exponent,
        };
        let start_rad_per_m = wavevector_rad_per_m.max(self.start_rad_per_m);
        let start = knot(start_rad_per_m, self.variance_pa2(start_rad_per_m));
        Stretch::between(&start, &knot(self.end_rad_per_m, self.end_pa2))
    }

    /// Wavevector up to which the variance is v^2/2.
    pub(crate) fn wavevector_rad_per_m(&self, v_pa: f64) -> f64 {
        let grown = self.growth_per_pa2 * (0.5 * v_pa * v_pa - self.start_pa2);
        let wavevector_rad_per_m = self.start_rad_per_m * (libm::log1p(grown) / self.exponent).exp();
        // If v hardly grows any more, rounding may lead beyond the end, and to NaN.
        wavevector_rad_per_m.min(self.end_rad_per_m)
    }

    /// Growth of the wavevector over which dV/dln(q) grows or falls by a factor; at least some units in the last place.
    pub(crate) fn growth_with_slope(&self, factor: f64) -> f64 {
        (factor.ln() / self.exponent.abs()).exp().max(1.0 + 4.0 * f64::EPSILON)
    }

    /// Variance V up to a wavevector; before the beginning, that of the beginning.
    pub(crate) fn variance_pa2(&self, wavevector_rad_per_m: f64) -> f64 {
        let ln_q = (wavevector_rad_per_m / self.start_rad_per_m).max(1.0).ln();
        self.start_pa2 + libm::expm1(self.exponent * ln_q) / self.growth_per_pa2
    }

    /// Derivative dV/dln(q) at a wavevector.
    pub(crate) fn variance_per_ln_wavevector_pa2(&self, wavevector_rad_per_m: f64) -> f64 {
        let ln_q = |to_rad_per_m: f64| (to_rad_per_m / self.start_rad_per_m).ln();
        let [_, slope] =
            share_of_power_law(self.exponent, ln_q(wavevector_rad_per_m), ln_q(self.end_rad_per_m));
        slope * (self.end_pa2 - self.start_pa2)
    }

    /// Computes v = sqrt(2 V) up to a wavevector.
    pub(crate) fn v_pa(&self, wavevector_rad_per_m: f64) -> f64 {
        (2.0 * self.variance_pa2(wavevector_rad_per_m)).sqrt()
    }
}

/// Share of a power law's integral over an interval that lies in its first part, in \[0, 1\], and the slope of that
/// share over ln(q). Both lengths are given as ln(q_end/q_start).
pub(crate) fn share_of_power_law(exponent: f64, part_ln: f64, whole_ln: f64) -> [f64; 2] {
    let exponent = not_flat(exponent);
    // The larger end of the power is taken out, so that neither overflows.
    let (before, whole) = if exponent > 0.0 {
        ((exponent * (part_ln - whole_ln)).exp(), -libm::expm1(-exponent * whole_ln))
    } else {
        ((exponent * part_ln).exp(), libm::expm1(exponent * whole_ln))
    };
    let share = if exponent > 0.0 {
        -before * libm::expm1(-exponent * part_ln) / whole
    } else {
        libm::expm1(exponent * part_ln) / whole
    };
    [share, exponent * before / whole]
}

/// Replaces an exponent of 0 by one so small that the difference is below rounding.
fn not_flat(exponent: f64) -> f64 {
    if exponent.abs() < 1e-9 { 1e-9 } else { exponent }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_of_a_power_law_agrees_with_its_integral() {
        for exponent in [-900.0, -1.6, 0.0, 0.4, 2.4, 9e4] {
            let share = |part_ln: f64| share_of_power_law(exponent, part_ln, 0.7);
            assert_eq!((share(0.0)[0], share(0.7)[0]), (0.0, 1.0), "{exponent}");
            let [_, slope] = share(0.3);
            let by_differences = (share(0.3 + 1e-5)[0] - share(0.3 - 1e-5)[0]) / 2e-5;
            assert!(
                (slope - by_differences).abs() <= 1e-4 * slope + 1e-12,
                "{exponent}: {slope} {by_differences}"
            );
        }
        assert!((share_of_power_law(0.0, 0.3, 0.6)[0] - 0.5).abs() < 1e-9);
    }

    #[test]
    fn the_stretch_beyond_a_place_follows_the_same_law() {
        let knot = |wavevector_rad_per_m, variance_pa2| SeparationKnot {
            wavevector_rad_per_m,
            variance_pa2,
            variance_exponent: 0.4,
        };
        let whole = Stretch::between(&knot(1e4, 3.0), &knot(1e6, 8.0)).unwrap();
        let left_out_pa2 = whole.variance_pa2(5e4);
        let rest = whole.beyond(5e4, left_out_pa2).unwrap();
        assert!(rest.start_pa2 == 0.0 && rest.start_rad_per_m == 5e4);
        let off = rest.variance_pa2(2e5) + left_out_pa2 - whole.variance_pa2(2e5);
        assert!(off.abs() < 1e-14, "{off}");
        assert!(whole.beyond(1e6, 8.0).is_none());
        assert!(whole.beyond(1e3, 3.0).is_some_and(|all| all.start_rad_per_m == 1e4));
    }
}
