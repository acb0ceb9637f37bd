//! The summits of a Gaussian surface under Hertz's ellipses.

use asperity::MaterialPair;

use super::answers::{Asperities, Response};
use super::pieces::Piece;
use crate::summits::integrals::SummitIntegrals;
use crate::summits::nayak::NayakSummits;

/// Elastic summits of Nayak's distribution (Bush, Gibson & Thomas 1975).
#[derive(Debug, Clone)]
pub(crate) struct ElasticSummits {
    integrals: SummitIntegrals,
    rms_height_m: f64,
}

impl ElasticSummits {
    pub fn new(pair: &MaterialPair, summits: &NayakSummits) -> Self {
        ElasticSummits {
            integrals: SummitIntegrals::new(pair, summits),
            rms_height_m: summits.m0_m2().sqrt(),
        }
    }
}

impl Asperities for ElasticSummits {
    /// Response to a flat that is this far below the mean plane.
    fn at_interference(&self, interference_m: f64) -> Response {
        let [pressure_pa, area_fraction] = self.integrals.far_below(-interference_m / self.rms_height_m);
        Response { pressure_pa, area_fraction }
    }

    fn summits(&self) -> Option<&SummitIntegrals> {
        Some(&self.integrals)
    }

    /// Returns none: the integrals are those of the summits.
    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece<'_>> {
        Vec::new()
    }
}
