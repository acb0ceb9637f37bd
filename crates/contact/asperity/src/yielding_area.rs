//! Area of a sinusoid that yields: Jackson, Krithivasan & Wilson (2008); `docs/theory/models.md`, section 2.4.
//!
//! With x = p/p*_ep the area fraction is min(1, phi_p (1 - x^1.51) + phi_2 x^1.04): a power of x at light pressures,
//! joined to the limit phi_2 of the elastic law near complete contact.

use std::f64::consts::LN_2;

use numerics::newton_in_bracket;

use crate::elastic_sinusoid::{
    FULL_CONTACT_SLOPE, HEAVY_EXPONENT, LIGHT_EXPONENT, heavy_limit, joining_powers, joining_powers_by,
};
use crate::elementary;

/// Area of a sinusoid that yields, with the pressure-independent constants precomputed
/// ([`ElasticPlasticSinusoid::yielding_area`](crate::ElasticPlasticSinusoid::yielding_area)).
///
/// It does not check for first yield: below that pressure the elastic area holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldingArea {
    /// Mean pressure of complete contact p*_ep \[Pa\].
    complete_contact_pressure_pa: f64,
    /// Factor of phi_p = exp(`log_factor`) x^`exponent`.
    log_factor: f64,
    exponent: f64,
}

/// Parameters of the area of a sinusoid that yields.
pub(crate) struct YieldParameters {
    /// Mean pressure of complete contact p*_ep \[Pa\].
    pub complete_contact_pressure_pa: f64,
    /// ln(p*_ep/p*).
    pub log_softening: f64,
    /// Slope ratio s = E* B/Sy: the slope over the slope that the strength admits.
    pub slope_over_yield_slope: f64,
    /// ln C.
    pub log_yield_coefficient: f64,
}

impl YieldingArea {
    /// Creates phi_p = 2 (phi_c/2)^(1/(1+d)) \[3 p/(4 C Sy)\]^(d/(1+d)), with phi_c/2 = (C Sy/(8 E* B))^2/pi and d =
    /// 3.8 (E* B/Sy)^0.11, as a power of x: 3 p*_ep/(4 C Sy) is (3 sqrt(2) pi/4) s/C times the softening.
    #[inline(always)]
    pub(crate) fn new(yielding: YieldParameters) -> Self {
        const LN_8: f64 = 2.079_441_541_679_835_9;
        const LN_PI: f64 = 1.144_729_885_849_400_2;
        const LN_3_SQRT_2_PI_OVER_4: f64 = 1.203_621_403_677_591_9;
        let YieldParameters { complete_contact_pressure_pa, log_softening, log_yield_coefficient, .. } =
            yielding;
        let log_slope = elementary::ln(yielding.slope_over_yield_slope);
        let d = 3.8 * elementary::exp(0.11 * log_slope);
        let log_half_critical_area = 2.0 * (log_yield_coefficient - LN_8 - log_slope) - LN_PI;
        let log_complete = LN_3_SQRT_2_PI_OVER_4 - log_yield_coefficient + log_slope + log_softening;
        YieldingArea {
            complete_contact_pressure_pa,
            log_factor: LN_2 + (log_half_critical_area + d * log_complete) / (1.0 + d),
            exponent: d / (1.0 + d),
        }
    }

    /// Mean pressure of complete contact p*_ep \[Pa\].
    #[must_use]
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.complete_contact_pressure_pa
    }

    /// Equals [`ElasticPlasticSinusoid::area_fraction`](crate::ElasticPlasticSinusoid::area_fraction) where the
    /// sinusoid yields at the mean pressure p > 0 \[Pa\].
    #[must_use]
    pub fn fraction_at(&self, pressure_pa: f64) -> f64 {
        let x = pressure_pa / self.complete_contact_pressure_pa;
        if x < 1.0 { self.fraction_alone(x, x.ln()) } else { 1.0 }
    }

    /// Area fraction in (0, 1\] at x < 1 and ln x, for loops over many pressures.
    #[inline(always)]
    pub(crate) fn fraction(&self, x: f64, log_x: f64) -> f64 {
        self.fraction_by(elementary::exp, x, log_x)
    }

    /// Area fraction at one pressure on which others depend, as down a stack: for a single number the library's
    /// exponential is faster.
    pub(crate) fn fraction_alone(&self, x: f64, log_x: f64) -> f64 {
        self.fraction_by(f64::exp, x, log_x)
    }

    #[inline(always)]
    fn fraction_by(&self, exp: impl Fn(f64) -> f64, x: f64, log_x: f64) -> f64 {
        let [light, heavy] = joining_powers_by(&exp, x, log_x);
        let plastic = exp(self.log_factor + self.exponent * log_x);
        let fitted = plastic * (1.0 - light) + heavy_limit(x) * heavy;
        if fitted < 1.0 { fitted.max(f64::MIN_POSITIVE) } else { 1.0 }
    }

    /// Mean pressure \[Pa\] from which on the fraction is limited to 1: p*_ep, or the smaller pressure at which the
    /// fit first reaches 1.
    pub(crate) fn flattening_pressure_pa(&self) -> f64 {
        self.flattening_share() * self.complete_contact_pressure_pa
    }

    /// Returns a smooth number that is positive above [`flattening_pressure_pa`](Self::flattening_pressure_pa) and
    /// negative below it, for mean pressures \[Pa\] up to p*_ep.
    pub(crate) fn flattening_margin(&self, pressure_pa: f64) -> f64 {
        let complete_pa = self.complete_contact_pressure_pa;
        self.overshoot_over_rest(((complete_pa - pressure_pa) / complete_pa).max(0.0)).0
    }

    /// Smallest x in (0, 1\] from which on the fraction is limited to 1.
    fn flattening_share(&self) -> f64 {
        if self.overshoot_over_rest(0.0).0 <= 0.0 {
            return 1.0;
        }
        let rest = newton_in_bracket(0.0, 1.0, 0.5, |rest| {
            let (overshoot, slope) = self.overshoot_over_rest(rest);
            (-overshoot, -slope)
        });
        // Far below complete contact 1 - rest has no digits.
        if rest < 0.5 { 1.0 - rest } else { self.flattening_share_below_half() }
    }

    /// [`flattening_share`](Self::flattening_share) if it is at most 1/2, from ln x.
    fn flattening_share_below_half(&self) -> f64 {
        const LEAST_LOG: f64 = -700.0;
        let start = (-self.log_factor / self.exponent).clamp(LEAST_LOG, -LN_2);
        newton_in_bracket(LEAST_LOG, -LN_2, start, |log_x| {
            let x = elementary::exp(log_x);
            let [light, heavy] = joining_powers(x, log_x);
            let plastic = elementary::exp(self.log_factor + self.exponent * log_x);
            let value = plastic * (1.0 - light) + heavy_limit(x) * heavy - 1.0;
            let slope = plastic * (self.exponent * (1.0 - light) - LIGHT_EXPONENT * light)
                + heavy * (HEAVY_EXPONENT * heavy_limit(x) + FULL_CONTACT_SLOPE * x);
            (value, slope)
        })
        .exp()
    }

    /// Computes (fraction - 1)/u, before the limit to 1, and its derivative by u, at the rest u = 1 - x in \[0, 1).
    ///
    /// The fraction minus one has a zero at x = 1. Divided by u it has none there. It has another one, at smaller x,
    /// just if it is positive at x = 1.
    fn overshoot_over_rest(&self, rest: f64) -> (f64, f64) {
        let (x, log_x) = (1.0 - rest, (-rest).ln_1p());
        let plastic = elementary::exp(self.log_factor + self.exponent * log_x);
        let light = lost_over_rest(LIGHT_EXPONENT, rest, log_x);
        let heavy = lost_over_rest(HEAVY_EXPONENT, rest, log_x);
        let to_heavy = 1.0 - heavy.0 * rest;
        let value = plastic * light.0 - heavy.0 - FULL_CONTACT_SLOPE * to_heavy;
        let slope = plastic * (light.1 - self.exponent / x * light.0) - heavy.1
            + FULL_CONTACT_SLOPE * HEAVY_EXPONENT * to_heavy / x;
        (value, slope)
    }
}

/// Computes (1 - x^a)/u at u = 1 - x in \[0, 1) and ln x, a at u = 0, and its derivative by u.
fn lost_over_rest(a: f64, rest: f64, log_x: f64) -> (f64, f64) {
    // At small u the derivative cancels; its limit is used.
    const LINEAR_BELOW: f64 = 1e-5;
    let limit = -0.5 * a * (a - 1.0);
    if rest == 0.0 {
        return (a, limit);
    }
    let lost = -(a * log_x).exp_m1();
    let value = lost / rest;
    let slope = if rest < LINEAR_BELOW { limit } else { (a * (1.0 - lost) / (1.0 - rest) - value) / rest };
    (value, slope)
}

#[cfg(test)]
mod tests {
    use crate::samples::at_ratio;
    use crate::{ElasticBody, ElasticPlasticSinusoid, MaterialPair};

    #[test]
    fn the_area_is_complete_just_above_the_flattening_pressure_however_low_that_is() {
        for strength_pa in [1e-20, 1e-12, 1e-3, 1e3, 1e8] {
            let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.2).unwrap());
            let law = ElasticPlasticSinusoid::new(&pair, 0.1, strength_pa);
            let flattening_pa = law.flattening_pressure_pa();
            assert_eq!(law.area_fraction(flattening_pa * (1.0 + 1e-12)), 1.0, "Sy = {strength_pa}");
            let below = law.area_fraction(flattening_pa * (1.0 - 1e-6));
            assert!(below < 1.0 && below > 1.0 - 1e-5, "Sy = {strength_pa}: {below}");
        }
    }

    /// Lets a stack distinguish a flattened scale from a steeper one that was flattened before.
    #[test]
    fn a_steeper_sinusoid_takes_more_pressure_to_flatten_up_to_four_thousand_critical_aspect_ratios() {
        for poisson_ratio in [-0.99, 0.0, 0.2, 0.5] {
            let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, poisson_ratio).unwrap());
            let critical = ElasticPlasticSinusoid::new(&pair, 1.0, 1e9).critical_aspect_ratio();
            let flattening_pa: Vec<f64> = (-100..=1200)
                .map(|i| critical * 4000f64.powf(f64::from(i) / 1200.0))
                .map(|b| ElasticPlasticSinusoid::new(&pair, b, 1e9).flattening_pressure_pa())
                .collect();
            assert!(flattening_pa.is_sorted_by(|flatter, steeper| flatter < steeper), "nu = {poisson_ratio}");
        }
    }

    #[test]
    fn the_fit_flattens_before_complete_contact_as_published() {
        let at = |r: f64| at_ratio(r).flattening_pressure_pa() / at_ratio(r).complete_contact_pressure_pa();
        assert!((at(37.0) - 0.50).abs() < 0.005, "{}", at(37.0));
        assert_eq!(at(1.2), 1.0);
        assert!(at(2.0) < 1.0);
    }

    #[test]
    fn the_area_is_complete_from_the_flattening_pressure_on_and_not_before() {
        for r in [1.05, 1.49, 1.6, 3.0, 37.0, 1e3, 1e5] {
            let law = at_ratio(r);
            let flat = law.flattening_pressure_pa();
            for i in 1..2000 {
                let pressure = law.complete_contact_pressure_pa() * f64::from(i) / 1500.0;
                let complete = law.area_fraction(pressure) == 1.0;
                let clear = (pressure / flat - 1.0).abs() > 1e-9;
                assert!(!clear || complete == (pressure > flat), "r = {r}, p/p_flat = {}", pressure / flat);
            }
        }
    }
}
