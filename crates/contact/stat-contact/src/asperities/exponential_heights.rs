//! Elastic spheres with exponential heights.

use asperity::MaterialPair;

use super::answers::{Asperities, Hertzian, Response};
use super::one_by_one::elastic_spheres;
use super::pieces::Piece;
use crate::Population;
use crate::exponential::ExponentialSpheres;

/// Elastic spheres, and their closed form with exponential heights.
#[derive(Debug)]
pub(crate) struct ExponentialHeights {
    spheres: Box<dyn Asperities>,
    closed_form: ExponentialSpheres,
}

impl ExponentialHeights {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (spheres, sigma_s_m) = (elastic_spheres(pair, population), population.sigma_s_m());
        let Response { pressure_pa, area_fraction } = spheres.at_interference(sigma_s_m);
        ExponentialHeights {
            spheres,
            closed_form: ExponentialSpheres { sigma_s_m, pressure_pa, area_fraction },
        }
    }
}

impl Asperities for ExponentialHeights {
    fn at_interference(&self, interference_m: f64) -> Response {
        self.spheres.at_interference(interference_m)
    }

    fn hertzian(&self) -> Option<Hertzian> {
        self.spheres.hertzian()
    }

    fn exponential(&self) -> Option<&ExponentialSpheres> {
        Some(&self.closed_form)
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>> {
        self.spheres.pieces(low_m, high_m)
    }
}
