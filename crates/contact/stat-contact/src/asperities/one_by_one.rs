//! Populations under a law that is smooth in the interference between its breaks.

use asperity::{Hertz, MaterialPair};

use super::answers::{Asperities, Hertzian, Response};
use super::pieces::{Chart, Piece, pieces_between};
use crate::Population;

/// Asperities by the force \[N\] and the area \[m^2\] of one at an interference > 0 \[m\].
pub(crate) struct OneByOne<F> {
    density_per_m2: f64,
    force_and_area: F,
    /// Interferences \[m\] at which the law is not smooth, in rising order.
    breaks_m: Vec<f64>,
    hertzian: Option<Hertzian>,
}

impl<F: Fn(f64) -> [f64; 2] + Send + Sync> OneByOne<F> {
    /// Creates a population from its law and the interferences \[m\] at which that is not smooth, in any order.
    pub fn new(population: &Population, force_and_area: F, breaks_m: impl IntoIterator<Item = f64>) -> Self {
        let mut breaks_m: Vec<f64> = breaks_m.into_iter().collect();
        breaks_m.sort_by(f64::total_cmp);
        OneByOne { density_per_m2: population.density_per_m2(), force_and_area, breaks_m, hertzian: None }
    }
}

/// Returns elastic spheres.
pub(crate) fn elastic_spheres(pair: &MaterialPair, population: &Population) -> Box<dyn Asperities> {
    let sphere = Hertz::new(pair, population.radius_m());
    let hertzian = Some(hertzian(&sphere, population.density_per_m2(), f64::INFINITY));
    let force_and_area = move |w_m| [sphere.force_n(w_m), sphere.area_m2(w_m)];
    Box::new(OneByOne { hertzian, ..OneByOne::new(population, force_and_area, []) })
}

/// Population of spheres that follow Hertz up to an interference.
pub(crate) fn hertzian(sphere: &Hertz, density_per_m2: f64, until_m: f64) -> Hertzian {
    Hertzian {
        until_m,
        area_per_m: density_per_m2 * sphere.area_m2(1.0),
        pressure_per_three_halves: density_per_m2 * sphere.force_per_three_halves(),
    }
}

impl<F: Fn(f64) -> [f64; 2] + Send + Sync> Asperities for OneByOne<F> {
    fn at_interference(&self, interference_m: f64) -> Response {
        let [force_n, area_m2] = (self.force_and_area)(interference_m);
        Response { pressure_pa: self.density_per_m2 * force_n, area_fraction: self.density_per_m2 * area_m2 }
    }

    fn hertzian(&self) -> Option<Hertzian> {
        self.hertzian
    }

    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece<'_>> {
        if self.hertzian.is_some_and(|hertzian| hertzian.until_m == f64::INFINITY) {
            // The integrals have a closed form at every separation.
            return Vec::new();
        }
        let ends_m = [&[0.0], &self.breaks_m[..], &[f64::INFINITY]].concat();
        pieces_between(&ends_m, |_| Chart::Interference)
    }
}

impl<F> std::fmt::Debug for OneByOne<F> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("OneByOne").field("breaks_m", &self.breaks_m).finish_non_exhaustive()
    }
}
