//! The laws by which a lightly loaded elastic surface has an area in proportion to its load.

use std::f64::consts::PI;

/// Area over nominal area, kappa p/(E* h'), h' the rms gradient of the surface (sqrt(2 m2)): yardsticks for elastic areas
/// below a few hundredths, at which computed ones mostly lie between the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearLaw {
    /// kappa = sqrt(8/pi) = 1.596: Persson's theory at light loads (2001, J. Chem. Phys. 115:3840).
    Persson,
    /// kappa = sqrt(2 pi) = 2.507: Bush, Gibson & Thomas (1975, Wear 35:87) as the load vanishes.
    BushGibsonThomas,
}

impl LinearLaw {
    /// The two, that of the smaller areas first.
    pub const ALL: [LinearLaw; 2] = [LinearLaw::Persson, LinearLaw::BushGibsonThomas];

    /// kappa.
    #[must_use]
    pub fn kappa(self) -> f64 {
        match self {
            LinearLaw::Persson => (8.0 / PI).sqrt(),
            LinearLaw::BushGibsonThomas => (2.0 * PI).sqrt(),
        }
    }

    /// The area fraction under a pressure \[Pa\] > 0, of a composite modulus E* \[Pa\] > 0 and an rms gradient h' > 0.
    /// It is not held at 1: the laws end long before.
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
