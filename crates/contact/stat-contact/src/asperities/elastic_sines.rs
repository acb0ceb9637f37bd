//! Populations of elastic sinusoids, by the mean gap of Rostami & Jackson (2013).

use asperity::{ElasticSinusoid, MaterialPair};

use super::answers::{Asperities, Response};
use super::pieces::{LawChart, Piece};
use super::sine_charts::{SineChart, SineShape};
use crate::Population;

/// Elastic sinusoids. Their interference is explicit in the pressure, so nothing is solved for.
#[derive(Debug, Clone)]
pub(crate) struct ElasticSines {
    law: ElasticSinusoid,
    shape: SineShape,
    charts: [SineChart; 2],
}

impl ElasticSines {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let law = ElasticSinusoid::new(pair, amplitude_m / wavelength_m);
        let shape = SineShape::new(amplitude_m, &law);
        ElasticSines { law, shape, charts: SineChart::both(shape) }
    }
}

impl Asperities for ElasticSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.shape.amplitude_m;
        let (pressure_pa, area_fraction) = self.law.pressure_and_area_at_interference(ratio);
        Response { pressure_pa, area_fraction }
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        let ratios: Vec<f64> = interferences_m.iter().map(|w| w / self.shape.amplitude_m).collect();
        self.law.pressures_at_interferences(&ratios, pressures_pa);
    }

    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece<'_>> {
        let breaks_m = self.law.breaks().map(|b| self.shape.interference_m(b.at));
        let charts = self.charts.each_ref().map(|chart| chart as &dyn LawChart);
        self.shape.pieces(0.0, self.shape.amplitude_m, breaks_m, charts)
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.law.complete_contact_pressure_pa();
        Some((self.shape.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }
}
