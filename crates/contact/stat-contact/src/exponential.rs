//! Load and area of elastic spheres with exponential heights, in closed form (Greenwood & Williamson 1966, Proc. R. Soc. A 295:300).

use std::f64::consts::PI;

use numerics::zero_in_bracket;

use crate::gaussian::density::scaled_erfc;

/// Elastic spheres whose heights have an exponential distribution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExponentialSpheres {
    /// Standard deviation of the heights \[m\].
    pub sigma_s_m: f64,
    /// (4/3) eta E* sqrt(R) sigma_s^(3/2) \[Pa\].
    pub pressure_pa: f64,
    /// pi eta R sigma_s.
    pub area_fraction: f64,
}

/// Logarithms of pressure \[Pa\] and area fraction at a separation, and the separation over which the pressure falls by e \[m\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExponentialState {
    pub ln_pressure_pa: f64,
    pub ln_area_fraction: f64,
    pub decay_length_m: f64,
}

impl ExponentialSpheres {
    /// Computes the state at a separation \[m\].
    pub fn at_separation(&self, separation_m: f64) -> ExponentialState {
        let x = separation_m / self.sigma_s_m;
        let (above, below) = (x.max(0.0), (-x).max(0.0));
        let [load, slope] = load_and_slope(below);
        ExponentialState {
            ln_pressure_pa: (self.pressure_pa * load).ln() - above,
            ln_area_fraction: (self.area_fraction * (1.0 + below)).ln() - above,
            decay_length_m: self.sigma_s_m * load / slope,
        }
    }

    /// Finds the separation \[m\] under a pressure > 0 \[Pa\].
    pub fn separation_m(&self, pressure_pa: f64) -> f64 {
        let [at_zero, _] = load_and_slope(0.0);
        let ln_excess = (pressure_pa / self.pressure_pa / at_zero).ln();
        let x = if ln_excess <= 0.0 {
            -ln_excess
        } else {
            // The load is at least x^(3/2).
            let most = (pressure_pa / self.pressure_pa).powf(2.0 / 3.0);
            -zero_in_bracket(0.0, most, |below| (load_and_slope(below)[0] / at_zero).ln() - ln_excess)
        };
        x * self.sigma_s_m
    }
}

/// Int_0^inf (s + a)^(3/2) exp(-s) ds of a flat at the depth a >= 0 below z = 0, and its derivative by a.
fn load_and_slope(a: f64) -> [f64; 2] {
    let half = 0.5 * PI.sqrt() * scaled_erfc(a.sqrt());
    [1.5 * half + a.sqrt() * (a + 1.5), 1.5 * (half + a.sqrt())]
}
