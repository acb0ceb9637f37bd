//! The closed form for the area of waves that elements do not press.

use gaussian_surfaces::AreaSpectrum;
use persson::corrections::Correction;
use persson::{constant_hardness, elastic};
use spectrum::Moments;

/// Persson's theory on some waves, with the variance of the pressure that would flatten them corrected for the elastic energy
/// that they keep (`algebraic-nayak`). The correction was fitted to elastic elements; with it, elements that flow at a hardness
/// agree better too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClosedForm {
    variance_pa2: f64,
    /// Nayak's m0 m4/m2^2.
    alpha: f64,
}

impl ClosedForm {
    /// The closed form of these waves.
    pub fn new(waves: &AreaSpectrum, composite_modulus_pa: f64) -> Self {
        let Moments { m0_m2, m2, m4_per_m2, .. } = waves.moments();
        let variance_pa2 = 0.5 * m2 * composite_modulus_pa.powi(2);
        ClosedForm { variance_pa2, alpha: m0_m2 * m4_per_m2 / (m2 * m2) }
    }

    /// The area fraction under a mean pressure \[Pa\]; elastic, or plastic at one hardness \[Pa\].
    pub fn area_fraction(self, pressure_pa: f64, hardness_pa: Option<f64>) -> f64 {
        let ClosedForm { variance_pa2, alpha } = self;
        let effective_pa2 =
            Correction::AlgebraicNayak.effective_variances_pa2(pressure_pa, &[variance_pa2], &[alpha]);
        let rms_pa = effective_pa2[0].sqrt();
        match hardness_pa {
            None => elastic::area_fraction(pressure_pa, rms_pa),
            Some(hardness_pa) => constant_hardness::areas(pressure_pa, rms_pa, hardness_pa).contact(),
        }
    }
}
