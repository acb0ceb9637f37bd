//! Asperity parameters from spectral moments.
//!
//! J. I. McCool (1987), J. Tribol. 109:264, after Nayak's random-process model (1971, J. Lubr. Technol.
//! 93:398), with the radius and density of Jackson & Jacobs, Eqs. (3) and (4).

use std::f64::consts::PI;

use serde::Serialize;

use crate::approximate::approximate;
use crate::moments::Moments;

/// Difference of the variances of surface and summit heights, in units of 1/(eta R)^2: 0.8968 m0/alpha.
const SUMMIT_VARIANCE_LOSS: f64 = 3.717e-4;
/// Height of the mean asperity summit above the mean plane, in units of 1/(eta R).
const SUMMIT_MEAN_HEIGHT: f64 = 0.045944;
/// Smallest Nayak parameter of a Gaussian isotropic surface.
const NAYAK_LOWEST: f64 = 1.5;

/// The asperities of a surface whose spectrum ends at a cutoff.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AsperityParameters {
    /// Radius of the summits in m: R = 0.375 sqrt(pi/m4), Jackson & Jacobs, Eq. (3).
    pub radius_m: f64,
    /// Number of summits per area in 1/m^2: eta = m4/(6 pi sqrt(3) m2), Jackson & Jacobs, Eq. (4).
    pub density_per_m2: f64,
    /// Standard deviation of the summit heights in m: sigma_s^2 = m0 - 3.717e-4/(eta R)^2.
    pub sigma_s_m: f64,
    /// Height of the mean summit above the mean plane of the surface in m: 0.045944/(eta R).
    pub offset_m: f64,
    /// Nayak's bandwidth parameter m0 m4/m2^2, at least 1.
    pub nayak_alpha: f64,
}

approximate!(AsperityParameters { radius_m, density_per_m2, sigma_s_m, offset_m, nayak_alpha });

impl AsperityParameters {
    /// Computes the parameters of the surface with these moments.
    ///
    /// `None` if a parameter is not finite and above 0. Only moments that are zero, underflow or overflow cause this:
    /// sigma_s^2 = m0 (1 - 0.8968/alpha), and alpha is at least 1 for every spectrum.
    pub fn from_moments(moments: &Moments) -> Option<Self> {
        let &Moments { m0_m2, m2, m4_per_m2, .. } = moments;
        let radius_m = 0.375 * (PI / m4_per_m2).sqrt();
        let density_per_m2 = m4_per_m2 / (6.0 * PI * 3f64.sqrt() * m2);
        let density_radius_per_m = density_per_m2 * radius_m;
        let variance_m2 = m0_m2 - SUMMIT_VARIANCE_LOSS / (density_radius_per_m * density_radius_per_m);
        let parameters = Self {
            radius_m,
            density_per_m2,
            sigma_s_m: variance_m2.sqrt(),
            offset_m: SUMMIT_MEAN_HEIGHT / density_radius_per_m,
            nayak_alpha: (m0_m2 / m2) * (m4_per_m2 / m2),
        };
        parameters.all_positive().then_some(parameters)
    }

    /// Returns true if a Gaussian isotropic surface can have this bandwidth: alpha >= 1.5. Below, the parameters
    /// describe no such surface and deserve a warning.
    pub fn is_gaussian_isotropic(&self) -> bool {
        self.nayak_alpha >= NAYAK_LOWEST
    }

    fn all_positive(&self) -> bool {
        [self.radius_m, self.density_per_m2, self.sigma_s_m, self.offset_m, self.nayak_alpha]
            .iter()
            .all(|value| value.is_finite() && *value > 0.0)
    }
}
