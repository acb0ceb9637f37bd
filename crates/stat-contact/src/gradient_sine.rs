//! Populations of elastic-plastic sinusoids whose strength depends on the depth of the deformation.

use asperity::{
    ElasticPlasticSinusoid, FLAGGED_ASPECT_RATIO_OVER_CRITICAL, MaterialPair, NixGao, elementary,
};
use numerics::{minimum_in_bracket, zero_in_bracket};

use crate::Population;
use crate::asperities::{Asperities, Chart, Course, Piece, Points, Response};
use crate::sine::ElasticSine;

/// Elastic-plastic sinusoids of the strength at the depth of their interference (Jackson & Jacobs, Eqs. 8-9), also
/// beyond complete contact. The interference is the variable, and the pressure is solved for at each of them.
#[derive(Debug, Clone)]
pub(crate) struct GradientSines {
    pair: MaterialPair,
    strength: NixGao,
    aspect_ratio: f64,
    amplitude_m: f64,
    shape: ElasticSine,
    /// r at the macroscopic strength.
    weakest_ratio: f64,
    /// The interference from which on B exceeds the critical aspect ratio, infinite where it never does.
    critical_m: f64,
}

impl GradientSines {
    pub fn new(pair: &MaterialPair, population: &Population, strength: NixGao) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let aspect_ratio = amplitude_m / wavelength_m;
        let weakest = ElasticPlasticSinusoid::new(pair, aspect_ratio, strength.macroscopic_strength_pa());
        // r = 1 at the strength that is r times the macroscopic one.
        let critical_strength_pa = weakest.aspect_ratio_over_critical() * strength.macroscopic_strength_pa();
        GradientSines {
            pair: *pair,
            strength,
            aspect_ratio,
            amplitude_m,
            shape: ElasticSine::new(amplitude_m, &weakest.elastic()),
            weakest_ratio: weakest.aspect_ratio_over_critical(),
            critical_m: strength.depth_of_strength_m(critical_strength_pa).unwrap_or(f64::INFINITY),
        }
    }

    #[inline(always)]
    fn at_depth(&self, depth_m: f64) -> ElasticPlasticSinusoid {
        ElasticPlasticSinusoid::new(&self.pair, self.aspect_ratio, self.strength.at_depth_pa(depth_m))
    }

    /// The zero of `sign` between two interferences, where it changes sign.
    fn crossing_m(
        &self,
        from_m: f64,
        to_m: f64,
        sign: impl Fn(&ElasticPlasticSinusoid, f64) -> f64,
    ) -> Option<f64> {
        let at = |log_m: f64| {
            let depth_m = log_m.exp();
            sign(&self.at_depth(depth_m), depth_m / self.amplitude_m)
        };
        let (low, high) = (from_m.ln(), to_m.ln());
        (low < high && at(low) * at(high) < 0.0).then(|| zero_in_bracket(low, high, at).exp())
    }

    /// Where plastic flow sets in or gives way to elasticity. The exponent A2 falls and rises again with r, so that it may
    /// do so several times, and a short stretch of flow may lie between two samples: an extremum that bends
    /// towards the other sign is looked up.
    fn flow_changes_m(&self, from_m: f64, to_m: f64) -> Vec<f64> {
        const SAMPLES: usize = 25;
        const GOLDEN_STEPS: usize = 40;
        if from_m >= to_m {
            return Vec::new();
        }
        let at = |log_m: f64| {
            let depth_m = elementary::exp(log_m);
            // The exponential of a logarithm may pass complete contact by its rounding.
            let ratio = (depth_m / self.amplitude_m).min(1.0 - f64::EPSILON);
            self.at_depth(depth_m).flow_margin_at_interference(ratio)
        };
        let step = (to_m / from_m).ln() / (SAMPLES - 1) as f64;
        let sample = |log_m: f64| (log_m, at(log_m));
        let low = from_m.ln();
        let mut margins = [0.0; SAMPLES];
        for (i, margin) in margins.iter_mut().enumerate() {
            *margin = at(low + step * i as f64);
        }
        let mut samples: Vec<(f64, f64)> = Vec::with_capacity(SAMPLES + SAMPLES / 2);
        samples.extend(margins.into_iter().enumerate().map(|(i, margin)| (low + step * i as f64, margin)));
        for i in 1..SAMPLES - 1 {
            let m = [i - 1, i, i + 1].map(|i| samples[i].1);
            let towards_zero =
                m[0] * m[1] > 0.0 && m[1] * m[2] > 0.0 && m[1].abs() < m[0].abs().min(m[2].abs());
            if towards_zero {
                let signed = |log_m: f64| at(log_m) * m[1].signum();
                samples.push(sample(minimum_in_bracket(
                    samples[i - 1].0,
                    samples[i + 1].0,
                    GOLDEN_STEPS,
                    signed,
                )));
            }
        }
        samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        let changes = samples.windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0);
        changes.map(|pair| zero_in_bracket(pair[0].0, pair[1].0, at).exp()).collect()
    }

    /// Kinks and jumps between two interferences below complete contact.
    fn breaks_m(&self, from_m: f64, to_m: f64) -> Vec<f64> {
        let mut breaks_m = vec![self.critical_m];
        breaks_m.extend(self.strength.cap_depth_m());
        // The elastic area's own break counts where nothing yields; elsewhere it only costs a panel.
        let elastic = self.at_depth(from_m).elastic();
        breaks_m.extend(elastic.breaks().map(|b| self.shape.interference_m(b.at)).filter(|&w| {
            let law = self.at_depth(w);
            !law.yields_at(law.pressure_at_interference_pa(w / self.amplitude_m))
        }));
        // Strictly inside the plastic branch, whose criteria make no sense at its very edge.
        let edge_m = from_m.max(self.critical_m * (1.0 + 1e-12));
        breaks_m.extend(self.flow_changes_m(edge_m, to_m));
        breaks_m.extend(self.crossing_m(edge_m, to_m, |law, ratio| {
            (law.pressure_at_interference_pa(ratio) / law.critical_pressure_pa()).ln()
        }));
        breaks_m.extend(self.crossing_m(edge_m, to_m, |law, ratio| {
            law.flattening_margin(law.pressure_at_interference_pa(ratio))
        }));
        breaks_m
    }
}

impl Asperities for GradientSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.amplitude_m;
        let (pressure_pa, area_fraction) =
            self.at_depth(interference_m).pressure_and_area_at_interference(ratio);
        Response { pressure_pa, area_fraction }
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece> {
        let complete_m = self.amplitude_m;
        let mut pieces = Vec::new();
        if low_m < complete_m {
            // Below this share of the window nothing contributes: the pressure grows like w^2.
            let from_m = low_m.max(1e-9 * high_m);
            let to_m = high_m.min(complete_m * (1.0 - 1e-15));
            let breaks_m = self.breaks_m(from_m, to_m);
            pieces = self.shape.pieces(0.0, complete_m, breaks_m);
        }
        let mut ends_m = vec![complete_m, f64::INFINITY];
        ends_m.extend(
            [Some(self.critical_m), self.strength.cap_depth_m()]
                .into_iter()
                .flatten()
                .filter(|&w| w > complete_m),
        );
        ends_m.sort_by(f64::total_cmp);
        pieces.extend(crate::asperities::pieces_between(&ends_m, Chart::Interference));
        pieces
    }

    fn strongest_kink_m(&self) -> Option<f64> {
        Some(self.amplitude_m)
    }

    fn coordinate(&self, chart: Chart, interference_m: f64) -> f64 {
        self.shape.coordinate(chart, interference_m)
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (&w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.at_depth(w).pressure_at_interference_pa(w / self.amplitude_m);
        }
    }

    fn at_coordinates(&self, chart: Chart, coordinates: &[f64], mut points: Points<'_>) {
        self.shape.at_coordinates(chart, coordinates, &mut points);
        let Points { interferences_m, pressures_pa, area_fractions, .. } = points;
        // Each node by itself: with strengths that fall over decades of depth a short stretch of another branch may lie
        // between two of them, unseen by the breaks.
        for ((&depth_m, pressure_pa), area_fraction) in
            interferences_m.iter().zip(pressures_pa).zip(area_fractions)
        {
            let t = *area_fraction;
            (*pressure_pa, *area_fraction) = self.at_depth(depth_m).pressure_and_area_at_power(t);
        }
    }

    fn out_of_fitted_range(&self, high_m: f64) -> Vec<(f64, f64)> {
        // Those that yield with r above the flagged value. The strength falls with depth, so r rises and p_c falls.
        let flagged_strength_pa = self.strength.macroscopic_strength_pa()
            * (self.weakest_ratio / FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        let Some(flagged_m) = self.strength.depth_of_strength_m(flagged_strength_pa) else {
            return Vec::new();
        };
        let yields = |log_m: f64| {
            let law = self.at_depth(log_m.exp());
            let ratio = log_m.exp() / self.amplitude_m;
            (law.pressure_at_interference_pa(ratio) / law.critical_pressure_pa()).ln()
        };
        let (from, to) = (flagged_m.max(1e-9 * high_m).ln(), high_m.ln());
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
        // Complete contact of an asperity that has not yielded.
        self.at_depth(self.amplitude_m).elastic().complete_contact_pressure_pa()
    }

    fn course(&self, _sigma_s_m: f64) -> Course {
        // Beyond complete contact p*_ep falls with the strength for good. Below it the pressure rises, but for r beyond
        // some 3e4, where it may fall before.
        const RISES_BELOW: f64 = 3e4;
        if self.critical_m.is_finite() {
            Course::Peaks { certain: self.weakest_ratio < RISES_BELOW }
        } else {
            Course::Rises
        }
    }

    fn falls_from_m(&self) -> Option<f64> {
        self.critical_m.is_finite().then(|| self.amplitude_m.max(self.critical_m))
    }
}
