//! The area of a sinusoid that yields: Jackson, Krithivasan & Wilson (2008); `docs/models.md`, section 2.4.

use numerics::newton_in_bracket;

use crate::elastic_sinusoid::{
    FULL_CONTACT_SLOPE, HEAVY_EXPONENT, LIGHT_EXPONENT, heavy_limit, joining_powers, joining_powers_by,
};
use crate::elementary;

/// The area of a yielding sinusoid against x = p/p*_ep < 1: phi_p = exp(`log_factor`) x^`exponent`, joined to phi_2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlasticArea {
    pub log_factor: f64,
    pub exponent: f64,
}

impl PlasticArea {
    /// min(1, phi_p (1 - x^1.51) + phi_2 x^1.04), for loops over many pressures.
    #[inline(always)]
    pub fn fraction(self, x: f64, log_x: f64) -> f64 {
        self.fraction_by(elementary::exp, x, log_x)
    }

    /// The same for one pressure that others wait for, as down a stack: alone, the library's exponential is the faster one.
    pub fn fraction_alone(self, x: f64, log_x: f64) -> f64 {
        self.fraction_by(f64::exp, x, log_x)
    }

    #[inline(always)]
    fn fraction_by(self, exp: impl Fn(f64) -> f64, x: f64, log_x: f64) -> f64 {
        let [light, heavy] = joining_powers_by(&exp, x, log_x);
        let plastic = exp(self.log_factor + self.exponent * log_x);
        let fitted = plastic * (1.0 - light) + heavy_limit(x) * heavy;
        if fitted < 1.0 { fitted.max(f64::MIN_POSITIVE) } else { 1.0 }
    }

    /// The x in (0, 1/2] from which on the fraction is held at 1, where there is one.
    pub fn full_from(self) -> f64 {
        const LEAST_LOG: f64 = -700.0;
        let start = (-self.log_factor / self.exponent).clamp(LEAST_LOG, -std::f64::consts::LN_2);
        newton_in_bracket(LEAST_LOG, -std::f64::consts::LN_2, start, |log_x| {
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

    /// The fraction before it is held at 1, minus 1 and over 1 - x, at u = 1 - x in \[0, 1), and the derivative by u. The
    /// fraction minus one has a zero at x = 1; over 1 - x it has none there, and another one, at smaller x, just where it
    /// is positive at x = 1.
    pub fn overshoot(self, u: f64) -> (f64, f64) {
        let (x, log_x) = (1.0 - u, (-u).ln_1p());
        let plastic = elementary::exp(self.log_factor + self.exponent * log_x);
        let [light, heavy] = [LIGHT_EXPONENT, HEAVY_EXPONENT].map(|a| opening(a, u, log_x));
        let to_heavy = 1.0 - heavy.0 * u;
        let value = plastic * light.0 - heavy.0 - FULL_CONTACT_SLOPE * to_heavy;
        let slope = plastic * (light.1 - self.exponent / x * light.0) - heavy.1
            + FULL_CONTACT_SLOPE * HEAVY_EXPONENT * to_heavy / x;
        (value, slope)
    }
}

/// (1 - (1 - u)^a)/u, a at u = 0, and its derivative by u.
fn opening(a: f64, u: f64, log_x: f64) -> (f64, f64) {
    // The derivative cancels at small u, and has its limit there.
    const LINEAR_BELOW: f64 = 1e-5;
    if u == 0.0 {
        return (a, -0.5 * a * (a - 1.0));
    }
    let lost = -(a * log_x).exp_m1();
    let value = lost / u;
    let slope =
        if u < LINEAR_BELOW { -0.5 * a * (a - 1.0) } else { (a * (1.0 - lost) / (1.0 - u) - value) / u };
    (value, slope)
}
