//! Populations of Hertz's spheres.

use asperity::{Hertz, MaterialPair};

use super::answers::{Asperities, Hertzian, Response};
use super::pieces::Piece;
use crate::Population;

/// Elastic spheres.
#[derive(Debug, Clone)]
pub(crate) struct ElasticSpheres {
    sphere: Hertz,
    density_per_m2: f64,
}

impl ElasticSpheres {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        ElasticSpheres {
            sphere: Hertz::new(pair, population.radius_m()),
            density_per_m2: population.density_per_m2(),
        }
    }
}

impl Asperities for ElasticSpheres {
    fn at_interference(&self, interference_m: f64) -> Response {
        Response {
            pressure_pa: self.density_per_m2 * self.sphere.force_n(interference_m),
            area_fraction: self.density_per_m2 * self.sphere.area_m2(interference_m),
        }
    }

    fn hertzian(&self) -> Option<Hertzian> {
        Some(hertzian(&self.sphere, self.density_per_m2, f64::INFINITY))
    }

    /// Returns none: the integrals have a closed form at every separation.
    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece<'_>> {
        Vec::new()
    }
}

/// Population of spheres that follow Hertz up to an interference.
pub(crate) fn hertzian(sphere: &Hertz, density_per_m2: f64, until_m: f64) -> Hertzian {
    Hertzian {
        until_m,
        area_per_m: density_per_m2 * sphere.area_m2(1.0),
        pressure_per_three_halves: density_per_m2 * sphere.force_per_three_halves(),
    }
}
