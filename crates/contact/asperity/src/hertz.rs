//! An elastic sphere on a flat: Hertz (1882); Greenwood & Williamson (1966) for the asperity of a population.

use std::f64::consts::PI;

use multiversion::multiversion;

use crate::MaterialPair;
use crate::lanes::check_lengths;

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

    /// Computes [`force_n`](Self::force_n) and [`area_m2`](Self::area_m2) at each of many interferences w >= 0 \[m\], to
    /// the same digits at a fraction of the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn forces_and_areas(&self, interferences_m: &[f64], forces_n: &mut [f64], areas_m2: &mut [f64]) {
        check_lengths(interferences_m, [forces_n, areas_m2]);
        hertz_at_each(self, interferences_m, forces_n, areas_m2);
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

/// Forces and areas at interferences.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn hertz_at_each(law: &Hertz, interferences_m: &[f64], forces_n: &mut [f64], areas_m2: &mut [f64]) {
    for ((&w, force_n), area_m2) in interferences_m.iter().zip(forces_n).zip(areas_m2) {
        (*force_n, *area_m2) = (law.force_n(w), law.area_m2(w));
    }
}

#[cfg(test)]
mod tests {
    use crate::samples::assert_batch_has_the_digits_of_each;
    use crate::{ElasticBody, Hertz, MaterialPair};

    #[test]
    fn many_interferences_have_the_digits_of_each() {
        let law = Hertz::new(&MaterialPair::against_rigid(ElasticBody::new(2e11, 0.3).unwrap()), 1e-6);
        assert_batch_has_the_digits_of_each(
            &[1e-9],
            &[-1e-9, f64::NAN],
            |w| (law.force_n(w), law.area_m2(w)),
            |w, forces, areas| law.forces_and_areas(w, forces, areas),
        );
    }

    #[test]
    fn force_over_area_grows_with_the_root_of_the_interference() {
        let sphere = Hertz::new(&MaterialPair::against_rigid(ElasticBody::new(2e11, 0.3).unwrap()), 1e-6);
        let mean_pressure = |w| sphere.force_n(w) / sphere.area_m2(w);
        assert!((mean_pressure(4e-9) / mean_pressure(1e-9) - 2.0).abs() < 1e-14);
    }
}
