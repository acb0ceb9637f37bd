//! An elastic-plastic sinusoid whose strength depends on the depth of its deformation: Jackson & Jacobs, Eqs. (8)-(9).

use asperity::{ElasticPlasticSinusoid, MaterialPair, NixGao};

use super::sine_charts::SineShape;
use crate::Population;

/// Sinusoid with the strength at the depth of the interference. The variable is the interference; the pressure is
/// solved for at each.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GradientLaw {
    pair: MaterialPair,
    aspect_ratio: f64,
    pub strength: NixGao,
    pub amplitude_m: f64,
    pub shape: SineShape,
    /// Ratio r at the macroscopic strength.
    pub weakest_ratio: f64,
    /// Interference from which on B exceeds the critical aspect ratio; infinite if it never does.
    pub critical_m: f64,
}

impl GradientLaw {
    pub fn new(pair: &MaterialPair, population: &Population, strength: NixGao) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let aspect_ratio = amplitude_m / wavelength_m;
        let weakest = ElasticPlasticSinusoid::new(pair, aspect_ratio, strength.macroscopic_strength_pa());
        let weakest_ratio = weakest.aspect_ratio_over_critical();
        // r = 1 at a strength that is r times the macroscopic one.
        let critical_strength_pa = weakest_ratio * strength.macroscopic_strength_pa();
        GradientLaw {
            pair: *pair,
            aspect_ratio,
            strength,
            amplitude_m,
            shape: SineShape::new(amplitude_m, &weakest.elastic()),
            weakest_ratio,
            critical_m: strength.depth_of_strength_m(critical_strength_pa).unwrap_or(f64::INFINITY),
        }
    }

    /// The sinusoid of the strength at a depth \[m\].
    #[inline(always)]
    pub fn at_depth(&self, depth_m: f64) -> ElasticPlasticSinusoid {
        ElasticPlasticSinusoid::new(&self.pair, self.aspect_ratio, self.strength.at_depth_pa(depth_m))
    }

    /// Mean pressure \[Pa\] at an interference \[m\].
    pub fn pressure_pa(&self, interference_m: f64) -> f64 {
        self.at_depth(interference_m).pressure_at_interference_pa(interference_m / self.amplitude_m)
    }

    /// Computes ln(p/p_c) at an interference \[m\]: above zero where the sinusoid yields, as long as r > 1.
    pub fn log_pressure_over_critical(&self, interference_m: f64) -> f64 {
        (self.pressure_pa(interference_m) / self.at_depth(interference_m).critical_pressure_pa()).ln()
    }
}
