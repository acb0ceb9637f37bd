//! Populations of elastic-plastic sinusoids whose strength depends on the depth of the deformation.

use asperity::{FLAGGED_ASPECT_RATIO_OVER_CRITICAL, MaterialPair, NixGao};
use numerics::zero_in_bracket;

use super::answers::{Asperities, Course, Response};
use super::gradient_breaks::{breaks_m, ends_of_growth_m};
use super::gradient_law::GradientLaw;
use super::pieces::{Chart, LawChart, Piece, Points, pieces_between};
use super::sine_charts::SineChart;
use crate::Population;

/// Share of the highest interference below which nothing contributes: the pressure grows like w^2.
const NEGLIGIBLE: f64 = 1e-9;

/// Ratio r at the macroscopic strength from which on the pressure may fall before complete contact.
const RISES_BELOW: f64 = 3e4;

/// Elastic-plastic sinusoids with the strength at the depth of their interference, also beyond complete contact.
#[derive(Debug, Clone)]
pub(crate) struct GradientSines {
    law: GradientLaw,
    charts: [GradientChart; 2],
}

/// Chart of the elastic law, in which this law is smooth too.
#[derive(Debug, Clone, Copy)]
struct GradientChart {
    law: GradientLaw,
    elastic: SineChart,
}

impl GradientSines {
    pub fn new(pair: &MaterialPair, population: &Population, strength: NixGao) -> Self {
        let law = GradientLaw::new(pair, population, strength);
        let charts = SineChart::both(law.shape).map(|elastic| GradientChart { law, elastic });
        GradientSines { law, charts }
    }
}

impl Asperities for GradientSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.law.amplitude_m;
        let (pressure_pa, area_fraction) =
            self.law.at_depth(interference_m).pressure_and_area_at_interference(ratio);
        Response { pressure_pa, area_fraction }
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (&w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.law.pressure_pa(w);
        }
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>> {
        let complete_m = self.law.amplitude_m;
        let mut pieces = Vec::new();
        if low_m < complete_m {
            let from_m = low_m.max(NEGLIGIBLE * high_m);
            // Below complete contact by a few units in the last place.
            let to_m = high_m.min(complete_m * (1.0 - 1e-15));
            let charts = self.charts.each_ref().map(|chart| chart as &dyn LawChart);
            pieces = self.law.shape.pieces(0.0, complete_m, breaks_m(&self.law, from_m, to_m), charts);
        }
        let beyond = [Some(self.law.critical_m), self.law.strength.cap_depth_m()].into_iter().flatten();
        let mut ends_m = vec![complete_m, f64::INFINITY];
        ends_m.extend(beyond.chain(ends_of_growth_m(&self.law, high_m)).filter(|&w| w > complete_m));
        ends_m.sort_by(f64::total_cmp);
        pieces.extend(pieces_between(&ends_m, |_| Chart::Interference));
        pieces
    }

    fn strongest_kink_m(&self) -> Option<f64> {
        Some(self.law.amplitude_m)
    }

    fn out_of_fitted_range(&self, high_m: f64) -> Vec<(f64, f64)> {
        // Asperities that yield with r above the flagged value. The strength falls with depth, so r rises and p_c
        // falls.
        let flagged_strength_pa = self.law.strength.macroscopic_strength_pa()
            * (self.law.weakest_ratio / FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        let Some(flagged_m) = self.law.strength.depth_of_strength_m(flagged_strength_pa) else {
            return Vec::new();
        };
        let yields = |log_m: f64| self.law.log_pressure_over_critical(log_m.exp());
        let (from, to) = (flagged_m.max(NEGLIGIBLE * high_m).ln(), high_m.ln());
        let first_m = if from >= to || yields(to) < 0.0 {
            return Vec::new();
        } else if yields(from) >= 0.0 {
            flagged_m
        } else {
            zero_in_bracket(from, to, yields).exp()
        };
        vec![(first_m, f64::INFINITY)]
    }

    fn highest_response_pa(&self) -> f64 {
        // Pressure of complete contact of an asperity that has not yielded.
        self.law.at_depth(self.law.amplitude_m).elastic().complete_contact_pressure_pa()
    }

    fn course(&self, _sigma_s_m: f64) -> Course {
        // Beyond complete contact p*_ep falls with the strength for good. Below it the pressure usually rises.
        if self.law.critical_m.is_finite() {
            Course::Peaks { certain: self.law.weakest_ratio < RISES_BELOW }
        } else {
            Course::Rises
        }
    }

    fn falls_from_m(&self) -> Option<f64> {
        self.law.critical_m.is_finite().then(|| self.law.amplitude_m.max(self.law.critical_m))
    }
}

impl LawChart for GradientChart {
    fn coordinate(&self, interference_m: f64) -> f64 {
        self.elastic.coordinate(interference_m)
    }

    fn goes_one_by_one(&self) -> bool {
        true
    }

    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>) {
        let Points { interferences_m, slopes_m, pressures_pa, area_fractions } = points;
        self.elastic.interferences(coordinates, interferences_m, slopes_m);
        // Each node by itself: if strengths fall over decades of depth, a short stretch of another branch may lie
        // between two nodes without a known break.
        let nodes = coordinates.iter().zip(&*interferences_m).zip(pressures_pa).zip(area_fractions);
        for (((&v, &depth_m), pressure_pa), area_fraction) in nodes {
            let t = self.elastic.t(v);
            (*pressure_pa, *area_fraction) = self.law.at_depth(depth_m).pressure_and_area_at_power(t);
        }
    }

    fn resolution(&self, from_first_touch: bool) -> f64 {
        self.elastic.resolution(from_first_touch)
    }

    fn growth(&self) -> f64 {
        // Then the pressure of plastic flow hardly depends on the interference, and a millionth of these
        // interferences carries as much.
        if self.law.weakest_ratio < RISES_BELOW { 2.0 } else { 0.0 }
    }
}
