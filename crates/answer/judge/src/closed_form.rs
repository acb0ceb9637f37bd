//! The closed form for the area of waves that elements do not press.

use persson::corrections::{Correction, algebraic_variance_pa2};
use persson::{constant_hardness, elastic};

use crate::waves::Waves;

/// Least factor g of the correction.
const LEAST_FACTOR: f64 = 0.01;
/// Share of g by which it changes per exponent of the stiffness, fitted to whole bands (docs/develop/trials.md).
const PER_EXPONENT: f64 = 0.85;

/// Persson's theory on some waves, with the variance of the pressure that would flatten them corrected for the elastic energy
/// that they keep (`algebraic-nayak`). The correction was fitted to elastic elements; with it, elements that flow at a hardness
/// agree better too.
///
/// On a layer whose modulus goes as q^n the factor g of the correction is (1 + 0.85 n) times that of half-spaces. On a bed of
/// springs, n = -1, points touch where the heights exceed a level, and a g near 0 gives that area within a tenth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClosedForm {
    variance_pa2: f64,
    /// Nayak's m0 m4/m2^2.
    alpha: f64,
    /// The exponent n of E*(q) ~ q^n: 0 on half-spaces.
    pub exponent_of_stiffness: f64,
}

impl ClosedForm {
    /// The closed form of these waves.
    pub fn new(waves: &Waves, composite_modulus_pa: f64) -> Self {
        let m2 = waves.flattened_alike().moments().m2;
        let variance_pa2 = 0.5 * m2 * composite_modulus_pa.powi(2);
        ClosedForm {
            variance_pa2,
            alpha: waves.alpha(),
            exponent_of_stiffness: waves.exponent_of_stiffness(),
        }
    }

    /// Twice the rms pressure \[Pa\] of full contact: E* h' on half-spaces.
    pub fn gradient_pa(self) -> f64 {
        2.0 * self.variance_pa2.sqrt()
    }

    /// The area fraction under a mean pressure \[Pa\]; elastic, or plastic at one hardness \[Pa\].
    pub fn area_fraction(self, pressure_pa: f64, hardness_pa: Option<f64>) -> f64 {
        let ClosedForm { variance_pa2, alpha, exponent_of_stiffness } = self;
        let factor = Correction::factor_of_nayak(alpha) * (1.0 + PER_EXPONENT * exponent_of_stiffness);
        let effective_pa2 =
            algebraic_variance_pa2(factor.clamp(LEAST_FACTOR, 1.0), pressure_pa, variance_pa2);
        let rms_pa = effective_pa2.sqrt();
        match hardness_pa {
            None => elastic::area_fraction(pressure_pa, rms_pa),
            Some(hardness_pa) => constant_hardness::areas(pressure_pa, rms_pa, hardness_pa).contact(),
        }
    }
}
