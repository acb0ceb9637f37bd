//! Populations of elastic sinusoids by boundary elements.

use asperity::{BemSinusoid, MaterialPair};

use super::answers::{Asperities, Response};
use super::pieces::{Chart, LawChart, Piece, Points, pieces_between};
use crate::Population;

/// Elastic sinusoids by boundary elements. Their interference is tabulated against x = p/p*.
#[derive(Debug, Clone)]
pub(crate) struct BemSines {
    law: BemSinusoid,
    amplitude_m: f64,
    light: TableChart,
    between: TableChart,
    heavy: TableChart,
}

/// Coordinate of the table: the law is a polynomial in x^(1/3) below its first pressure and in (1-x)^(1/2) above its
/// last one, and smooth in ln x between neighbours.
#[derive(Debug, Clone, Copy)]
struct TableChart {
    law: BemSinusoid,
    amplitude_m: f64,
    stretch: Stretch,
}

#[derive(Debug, Clone, Copy)]
enum Stretch {
    Light,
    Between,
    Heavy,
}

impl BemSines {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let law = BemSinusoid::new(pair, amplitude_m / wavelength_m);
        let [light, between, heavy] = [Stretch::Light, Stretch::Between, Stretch::Heavy]
            .map(|stretch| TableChart { law, amplitude_m, stretch });
        BemSines { law, amplitude_m, light, between, heavy }
    }
}

impl Asperities for BemSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.amplitude_m;
        let pressure_pa = self.law.pressure_at_interference_pa(ratio);
        let area_fraction = if ratio >= 1.0 { 1.0 } else { self.law.area_fraction(pressure_pa) };
        Response { pressure_pa, area_fraction }
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>> {
        let tabulated_m =
            self.law.breaks().map(|b| self.amplitude_m * self.law.deformation_over_amplitude(b.at));
        let ends_m: Vec<f64> = std::iter::once(0.0).chain(tabulated_m).collect();
        let (first_m, complete_m) = (ends_m[1], ends_m[ends_m.len() - 1]);
        let mut pieces = pieces_between(&ends_m, |to_m| {
            Chart::Law(if to_m == first_m {
                &self.light
            } else if to_m == complete_m {
                &self.heavy
            } else {
                &self.between
            })
        });
        pieces.retain(|piece| piece.to_m > low_m && piece.from_m < high_m);
        pieces
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.law.complete_contact_pressure_pa();
        Some((self.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }
}

impl LawChart for TableChart {
    fn coordinate(&self, interference_m: f64) -> f64 {
        let pressure_pa = self.law.pressure_at_interference_pa(interference_m / self.amplitude_m);
        let x = pressure_pa / self.law.complete_contact_pressure_pa();
        match self.stretch {
            Stretch::Light => x.cbrt(),
            Stretch::Between => x.ln(),
            Stretch::Heavy => -(1.0 - x).sqrt(),
        }
    }

    fn goes_one_by_one(&self) -> bool {
        true
    }

    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>) {
        for (i, &v) in coordinates.iter().enumerate() {
            let (log_x, slope) = match self.stretch {
                Stretch::Light => (3.0 * v.ln(), 3.0 / v),
                Stretch::Between => (v, 1.0),
                Stretch::Heavy => ((-v * v).ln_1p(), -2.0 * v / (1.0 - v * v)),
            };
            let (ratio, by_log_x) = self.law.deformation_and_slope(log_x);
            let pressure_pa = self.law.complete_contact_pressure_pa() * log_x.exp();
            points.interferences_m[i] = self.amplitude_m * ratio;
            points.slopes_m[i] = self.amplitude_m * by_log_x * slope;
            points.pressures_pa[i] = pressure_pa;
            points.area_fractions[i] = self.law.area_fraction(pressure_pa);
        }
    }
}
