//! Elastic spheres with exponential heights, in closed form (Greenwood & Williamson 1966, Proc. R. Soc. A 295:300).

use std::f64::consts::PI;

use asperity::MaterialPair;
use numerics::zero_in_bracket;
use units::named;

use crate::asperities::answers::{Asperities, Hertzian, Response};
use crate::asperities::one_by_one::elastic_spheres;
use crate::asperities::pieces::Piece;
use crate::gaussian::density::scaled_erfc;
use crate::{ContactState, Population};

/// Distribution of the heights of asperities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SummitHeights {
    /// Gaussian.
    #[default]
    Gaussian,
    /// Exponential, exp(-z/sigma_s)/sigma_s above z = 0: the simplification of Greenwood & Williamson for elastic spheres, whose real
    /// pressure E* sqrt(sigma_s/(pi R)) is that of every load. Separations are measured from z = 0.
    Exponential,
}

named!(SummitHeights, "distribution of heights", { Gaussian => "gaussian", Exponential => "exponential" });

/// Elastic spheres whose heights have an exponential distribution.
#[derive(Debug)]
pub(crate) struct ExponentialSpheres {
    spheres: Box<dyn Asperities>,
    sigma_s_m: f64,
    /// (4/3) eta E* sqrt(R) sigma_s^(3/2) \[Pa\].
    pressure_pa: f64,
    /// pi eta R sigma_s.
    area_fraction: f64,
}

impl ExponentialSpheres {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (spheres, sigma_s_m) = (elastic_spheres(pair, population), population.sigma_s_m());
        let Response { pressure_pa, area_fraction } = spheres.at_interference(sigma_s_m);
        ExponentialSpheres { spheres, sigma_s_m, pressure_pa, area_fraction }
    }

    /// State at a separation \[m\].
    pub fn at_separation(&self, separation_m: f64) -> ContactState {
        let x = separation_m / self.sigma_s_m;
        let (above, below) = (x.max(0.0), (-x).max(0.0));
        let [load, slope] = load_and_slope(below);
        let ln_pressure_pa = (self.pressure_pa * load).ln() - above;
        let ln_area_fraction = (self.area_fraction * (1.0 + below)).ln() - above;
        ContactState {
            separation_m: Some(separation_m),
            pressure_pa: ln_pressure_pa.exp(),
            area_fraction: ln_area_fraction.exp().min(1.0),
            ln_pressure_pa,
            ln_area_fraction: ln_area_fraction.min(0.0),
            error_estimate: 4.0 * f64::EPSILON * (1.0 + ln_pressure_pa.abs()),
            evaluations: 0,
            out_of_range_load_share: 0.0,
            flattened_share: None,
            clamped: ln_area_fraction > 0.0,
            decay_length_m: Some(self.sigma_s_m * load / slope),
        }
    }

    /// State under a pressure > 0 \[Pa\].
    pub fn at_pressure(&self, pressure_pa: f64) -> ContactState {
        let [at_zero, _] = load_and_slope(0.0);
        let ln_excess = (pressure_pa / self.pressure_pa / at_zero).ln();
        let x = if ln_excess <= 0.0 {
            -ln_excess
        } else {
            // The load is at least x^(3/2).
            let most = (pressure_pa / self.pressure_pa).powf(2.0 / 3.0);
            -zero_in_bracket(0.0, most, |below| (load_and_slope(below)[0] / at_zero).ln() - ln_excess)
        };
        let state = self.at_separation(x * self.sigma_s_m);
        ContactState { pressure_pa, ln_pressure_pa: pressure_pa.ln(), ..state }
    }
}

/// Int_0^inf (s + a)^(3/2) exp(-s) ds of a flat at the depth a >= 0 below z = 0, and its derivative by a.
fn load_and_slope(a: f64) -> [f64; 2] {
    let half = 0.5 * PI.sqrt() * scaled_erfc(a.sqrt());
    [1.5 * half + a.sqrt() * (a + 1.5), 1.5 * (half + a.sqrt())]
}

impl Asperities for ExponentialSpheres {
    fn at_interference(&self, interference_m: f64) -> Response {
        self.spheres.at_interference(interference_m)
    }

    fn hertzian(&self) -> Option<Hertzian> {
        self.spheres.hertzian()
    }

    fn exponential(&self) -> Option<&ExponentialSpheres> {
        Some(self)
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>> {
        self.spheres.pieces(low_m, high_m)
    }
}
