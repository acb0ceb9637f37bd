//! Hardness against scale, and the scales at which pressures exceed it.

use asperity::NixGao;
use stacked_contact::Scale;

use study::hardness_and_strength::HARDNESS_OVER_STRENGTH;

/// Hardness against scale, from long to short wavelengths; it never falls towards the short ones.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HardnessOfScales {
    wavelengths_m: Vec<f64>,
    hardnesses_pa: Vec<f64>,
}

impl HardnessOfScales {
    /// Computes H = 3 Sy of every scale. Sy is the strength at the depth of the scale's amplitude, or of the least amplitude
    /// of the longer scales: Nix & Gao (1998); Jackson & Jacobs, Eq. (8).
    pub fn new(strength: &NixGao, scales: &[Scale]) -> Self {
        let mut depth_m = f64::INFINITY;
        let hardness_pa = |scale: &Scale| {
            depth_m = depth_m.min(scale.amplitude_m);
            HARDNESS_OVER_STRENGTH * strength.at_depth_pa(depth_m)
        };
        HardnessOfScales {
            wavelengths_m: scales.iter().map(|scale| scale.wavelength_m).collect(),
            hardnesses_pa: scales.iter().map(hardness_pa).collect(),
        }
    }

    /// The hardness \[Pa\] at a wavelength \[m\], taken from the next longer scale.
    pub fn at_pa(&self, wavelength_m: f64) -> f64 {
        let longer = self.wavelengths_m.partition_point(|scale_m| *scale_m >= wavelength_m * (1.0 - 1e-12));
        self.hardnesses_pa[longer.saturating_sub(1)]
    }

    /// The first of these pairs of wavelength \[m\] and pressure \[Pa\] whose pressure exceeds the hardness.
    pub fn first_above(&self, pressures: impl Iterator<Item = (f64, f64)>) -> Option<AboveHardness> {
        pressures
            .map(|(wavelength_m, pressure_pa)| AboveHardness {
                wavelength_m,
                pressure_pa,
                hardness_pa: self.at_pa(wavelength_m),
            })
            .find(|at| at.pressure_pa > at.hardness_pa)
    }
}

/// A scale at which the pressure exceeds the hardness.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct AboveHardness {
    /// The scale's wavelength \[m\].
    pub wavelength_m: f64,
    /// The real pressure at the scale \[Pa\].
    pub pressure_pa: f64,
    /// The hardness at the scale \[Pa\].
    pub hardness_pa: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scales() -> [Scale; 3] {
        [(1e-5, 1e-7), (1e-6, 1e-8), (1e-7, 2e-8)]
            .map(|(wavelength_m, amplitude_m)| Scale { wavelength_m, amplitude_m })
    }

    #[test]
    fn hardness_grows_where_the_depth_shrinks_and_never_falls() {
        let strength = NixGao::constant(1e9).unwrap().with_strain_gradient(3e-8).unwrap();
        let hardness = HardnessOfScales::new(&strength, &scales());
        assert!((hardness.at_pa(1e-6) / 6e9 - 1.0).abs() < 1e-14);
        assert_eq!(hardness.at_pa(1e-7), hardness.at_pa(1e-6));
        assert_eq!(hardness.at_pa(2e-6), hardness.at_pa(1e-5));
        let above = hardness.first_above([(1e-5, 3.2e9), (1e-6, 6.1e9)].into_iter()).unwrap();
        assert_eq!((above.wavelength_m, above.pressure_pa), (1e-6, 6.1e9));
    }

    #[test]
    fn a_pressure_equal_to_the_hardness_does_not_exceed_it() {
        let hardness = HardnessOfScales::new(&NixGao::constant(1e9).unwrap(), &scales());
        let pressures = |last_pa| [(1e-5, 3e9), (1e-6, last_pa)].into_iter();
        assert_eq!(hardness.first_above(pressures(3e9)), None);
        assert_eq!(hardness.first_above(pressures(3.1e9)).unwrap().wavelength_m, 1e-6);
        // Waves longer than all scales have the hardness of the longest.
        assert_eq!(hardness.at_pa(1.0), hardness.at_pa(1e-5));
    }
}
