//! An elastic sphere on a flat: Hertz (1882); Greenwood & Williamson (1966) for the asperity of a population.

use std::f64::consts::PI;

use crate::MaterialPair;

/// A sphere pressed elastically by a flat (`docs/theory/models.md`, section 2.1). Exact for contact radii well below R;
/// it has no fitted range and no breaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    composite_modulus_pa: f64,
    radius_m: f64,
}

impl Hertz {
    /// Creates a sphere of radius R > 0 \[m\].
    #[must_use]
    pub fn new(pair: &MaterialPair, radius_m: f64) -> Self {
        debug_assert!(radius_m > 0.0);
        Hertz { composite_modulus_pa: pair.composite_modulus_pa(), radius_m }
    }

    /// Force F = (4/3) E* sqrt(R) w^(3/2) \[N\] at the interference w >= 0 \[m\].
    #[must_use]
    pub fn force_n(&self, interference_m: f64) -> f64 {
        4.0 / 3.0 * self.composite_modulus_pa * interference_m * (self.radius_m * interference_m).sqrt()
    }

    /// Force per w^(3/2), (4/3) E* sqrt(R) \[N/m^1.5\].
    #[must_use]
    pub fn force_per_three_halves(&self) -> f64 {
        4.0 / 3.0 * self.composite_modulus_pa * self.radius_m.sqrt()
    }

    /// Contact area A = pi R w \[m^2\] at the interference w >= 0 \[m\].
    #[must_use]
    pub fn area_m2(&self, interference_m: f64) -> f64 {
        PI * self.radius_m * interference_m
    }
}

#[cfg(test)]
mod tests {
    use crate::{ElasticBody, Hertz, MaterialPair};

    #[test]
    fn force_over_area_grows_with_the_root_of_the_interference() {
        let sphere = Hertz::new(&MaterialPair::against_rigid(ElasticBody::new(2e11, 0.3).unwrap()), 1e-6);
        let mean_pressure = |w| sphere.force_n(w) / sphere.area_m2(w);
        assert!((mean_pressure(4e-9) / mean_pressure(1e-9) - 2.0).abs() < 1e-14);
    }
}
