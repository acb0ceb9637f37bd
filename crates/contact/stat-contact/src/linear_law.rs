//! Linear laws of lightly loaded elastic surfaces: area in proportion to load.

use std::f64::consts::PI;

/// Area over nominal area, kappa p/(E* h'), with h' the rms gradient of the surface (sqrt(2 m2)). Yardsticks for
/// elastic areas below a few hundredths, where computed ones mostly lie between the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearLaw {
    /// Persson's theory at light loads (2001, J. Chem. Phys. 115:3840): kappa = sqrt(8/pi) = 1.596.
    Persson,
    /// Bush, Gibson & Thomas (1975, Wear 35:87) in the limit of vanishing load: kappa = sqrt(2 pi) = 2.507.
    BushGibsonThomas,
}

impl LinearLaw {
    /// Both laws, the one with the smaller areas first.
    pub const ALL: [LinearLaw; 2] = [LinearLaw::Persson, LinearLaw::BushGibsonThomas];

    /// Coefficient kappa.
    #[must_use]
    pub fn kappa(self) -> f64 {
        match self {
            LinearLaw::Persson => (8.0 / PI).sqrt(),
            LinearLaw::BushGibsonThomas => (2.0 * PI).sqrt(),
        }
    }

    /// Area fraction under a pressure \[Pa\] > 0, for a composite modulus E* \[Pa\] > 0 and an rms gradient h' > 0.
    /// Not limited to 1: the laws lose their validity far below.
    #[must_use]
    pub fn area_fraction(self, pressure_pa: f64, composite_modulus_pa: f64, rms_gradient: f64) -> f64 {
        self.kappa() * (pressure_pa / composite_modulus_pa) / rms_gradient
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_are_in_proportion_to_the_pressure() {
        let areas = LinearLaw::ALL.map(|law| law.area_fraction(1e9, 5e11, 0.2));
        assert!((areas[0] / 0.015_957_691_216_057_31 - 1.0).abs() < 1e-14, "{areas:?}");
        assert!((areas[1] / 0.025_066_282_746_310_005 - 1.0).abs() < 1e-14, "{areas:?}");
    }
}
