//! Populations of elastic-plastic sinusoids of one strength.
//!
//! Their interference is explicit in the pressure, before and after the onset of plastic flow: the integrals run over
//! coordinates of the contact, and nothing is solved for.

use asperity::{ElasticPlasticSinusoid, FlowPoint, MaterialPair, PlasticFlow, elementary};
use multiversion::multiversion;

use super::answers::{Asperities, Response};
use super::pieces::{Chart, LawChart, Piece, Points, pieces_between};
use super::sine_charts::{Side, SineChart, SineShape};
use crate::Population;

/// Ratio x = p/p*_ep at which the heavy chart of plastic flow replaces the light one.
const FLOW_CHARTS_MEET_AT: f64 = 0.3;

/// Elastic-plastic sinusoids of one strength.
#[derive(Debug, Clone)]
pub(crate) struct ElasticPlasticSines {
    law: ElasticPlasticSinusoid,
    flow: PlasticFlow,
    shape: SineShape,
    onset: FlowOnset,
    /// Interferences \[m\] at which the area is not smooth.
    breaks_m: Vec<f64>,
    before_flow: [BeforeFlow; 2],
    in_flow: [InFlow; 2],
}

/// Onset of plastic flow: the point from which it sets the pressure; complete contact if it never does.
#[derive(Debug, Clone, Copy)]
struct FlowOnset {
    pressure_pa: f64,
    interference_m: f64,
}

/// Chart up to the onset of plastic flow, where the pressure is elastic and the area may be plastic.
#[derive(Debug, Clone, Copy)]
struct BeforeFlow {
    elastic: SineChart,
    law: ElasticPlasticSinusoid,
    flow: PlasticFlow,
}

/// Chart of plastic flow: on the light side x^(1/4), in which the powers of x at its low end are mild (ln x took
/// twice the nodes over decades); on the heavy side -(1-x)^(1/2), in which the end-point power (1-x)^(5/2) of the gap
/// is smooth.
#[derive(Debug, Clone, Copy)]
struct InFlow {
    side: Side,
    amplitude_m: f64,
    law: ElasticPlasticSinusoid,
    flow: PlasticFlow,
}

impl ElasticPlasticSines {
    pub fn new(pair: &MaterialPair, population: &Population, strength_pa: f64) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let law = ElasticPlasticSinusoid::new(pair, amplitude_m / wavelength_m, strength_pa);
        let shape = SineShape::new(amplitude_m, &law.elastic());
        let flow = law.plastic_flow();
        let onset = match law.flow_onset_pressure_pa() {
            Some(pressure_pa) => FlowOnset { pressure_pa, interference_m: shape.interference_m(pressure_pa) },
            None => {
                FlowOnset { pressure_pa: law.complete_contact_pressure_pa(), interference_m: amplitude_m }
            }
        };
        let interference_m = |pressure_pa| interference_m(&shape, &flow, &onset, pressure_pa);
        let elastic = law.elastic().breaks().filter(|b| !law.yields_at(b.at));
        let breaks_m = law.breaks().chain(elastic).map(|b| interference_m(b.at)).collect();
        ElasticPlasticSines {
            law,
            flow,
            shape,
            onset,
            breaks_m,
            before_flow: SineChart::both(shape).map(|elastic| BeforeFlow { elastic, law, flow }),
            in_flow: Side::BOTH.map(|side| InFlow { side, amplitude_m, law, flow }),
        }
    }

    fn interference_m(&self, pressure_pa: f64) -> f64 {
        interference_m(&self.shape, &self.flow, &self.onset, pressure_pa)
    }
}

/// Interference \[m\] at a mean pressure \[Pa\].
fn interference_m(shape: &SineShape, flow: &PlasticFlow, onset: &FlowOnset, pressure_pa: f64) -> f64 {
    let log_x = (pressure_pa / flow.complete_contact_pressure_pa()).ln();
    if pressure_pa <= onset.pressure_pa {
        shape.interference_m(pressure_pa)
    } else if log_x >= 0.0 {
        shape.amplitude_m
    } else {
        shape.amplitude_m * flow.at_log_pressure(log_x).interference_over_amplitude
    }
}

impl Asperities for ElasticPlasticSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.shape.amplitude_m;
        let (pressure_pa, area_fraction) = self.law.pressure_and_area_at_interference(ratio);
        Response { pressure_pa, area_fraction }
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        let ratios: Vec<f64> = interferences_m.iter().map(|w| w / self.shape.amplitude_m).collect();
        self.flow.pressures_at_interferences(&ratios, pressures_pa);
    }

    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece<'_>> {
        let (onset_m, complete_m) = (self.onset.interference_m, self.shape.amplitude_m);
        let before_flow = self.before_flow.each_ref().map(|chart| chart as &dyn LawChart);
        let mut pieces = self.shape.pieces(0.0, onset_m, self.breaks_m.iter().copied(), before_flow);
        let charts_meet_pa = FLOW_CHARTS_MEET_AT * self.flow.complete_contact_pressure_pa();
        let charts_meet_m = self.interference_m(charts_meet_pa).max(onset_m);
        let mut ends_m = vec![onset_m, charts_meet_m, complete_m];
        ends_m.extend(self.breaks_m.iter().filter(|&&w| onset_m < w && w < complete_m));
        ends_m.sort_by(f64::total_cmp);
        let [light, heavy] = &self.in_flow;
        pieces.extend(pieces_between(&ends_m, |to_m| {
            Chart::Law(if to_m <= charts_meet_m { light } else { heavy })
        }));
        pieces
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.flow.complete_contact_pressure_pa();
        Some((self.shape.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }

    fn out_of_fitted_range(&self, _high_m: f64) -> Vec<(f64, f64)> {
        if self.law.in_fitted_range() {
            return Vec::new();
        }
        vec![(self.interference_m(self.law.critical_pressure_pa()), f64::INFINITY)]
    }
}

impl LawChart for BeforeFlow {
    fn coordinate(&self, interference_m: f64) -> f64 {
        self.elastic.coordinate(interference_m)
    }

    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>) {
        // No break of the law divides the coordinates: if the first one yields, all do.
        let yields = coordinates.first().is_some_and(|&v| self.law.yields_at(self.elastic.pressure_pa(v)));
        if !yields {
            return self.elastic.at_coordinates(coordinates, points);
        }
        points_before_flow(self, coordinates, points);
    }

    fn resolution(&self, from_first_touch: bool) -> f64 {
        self.elastic.resolution(from_first_touch)
    }
}

impl LawChart for InFlow {
    fn coordinate(&self, interference_m: f64) -> f64 {
        let ratio = interference_m / self.amplitude_m;
        let log_x = if ratio < 1.0 { self.flow.log_pressure_at_interference(ratio) } else { 0.0 };
        match self.side {
            Side::Light => elementary::exp(0.25 * log_x),
            Side::Heavy => -(-elementary::exp_m1(log_x)).sqrt(),
        }
    }

    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>) {
        points_in_flow(self, coordinates, points);
    }

    fn resolution(&self, _from_first_touch: bool) -> f64 {
        match self.side {
            Side::Light => 1.0,
            Side::Heavy => 1.15,
        }
    }
}

impl InFlow {
    /// Ratio x = p/p*_ep at a coordinate.
    #[inline(always)]
    fn pressure_ratio(&self, v: f64) -> f64 {
        match self.side {
            Side::Light => v * v * (v * v),
            Side::Heavy => 1.0 - v * v,
        }
    }

    /// Points at coordinates from those at x and ln x.
    #[inline(always)]
    fn fill(&self, coordinates: &[f64], points: Points<'_>, at: impl Fn(f64, f64) -> FlowPoint) {
        let nodes = coordinates
            .iter()
            .zip(points.interferences_m)
            .zip(points.slopes_m)
            .zip(points.pressures_pa)
            .zip(points.area_fractions);
        for ((((&v, interference_m), slope_m), pressure_pa), area_fraction) in nodes {
            let x = self.pressure_ratio(v);
            let (log_x, slope) = match self.side {
                Side::Light => (4.0 * elementary::ln(v), 4.0 / v),
                Side::Heavy => (elementary::ln_1p(-v * v), -2.0 * v / x),
            };
            let point = at(x, log_x);
            *interference_m = self.amplitude_m * point.interference_over_amplitude;
            *slope_m = self.amplitude_m * point.slope_by_log_pressure * slope;
            (*pressure_pa, *area_fraction) = (point.pressure_pa, point.area_fraction);
        }
    }
}

/// Points where the area yields under an elastic pressure.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn points_before_flow<'a>(chart: &BeforeFlow, coordinates: &[f64], points: Points<'a>) {
    let complete_pa = chart.flow.complete_contact_pressure_pa();
    chart.elastic.with_areas(coordinates, points, |v, _| {
        chart.flow.yielding_area_fraction(chart.elastic.pressure_pa(v) / complete_pa)
    });
}

/// Points in plastic flow. No break of the law divides the coordinates: if the first one yields, all do.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn points_in_flow<'a>(chart: &InFlow, coordinates: &[f64], points: Points<'a>) {
    let flow = &chart.flow;
    let complete_pa = flow.complete_contact_pressure_pa();
    let yields =
        coordinates.first().is_some_and(|&v| chart.law.yields_at(complete_pa * chart.pressure_ratio(v)));
    // A loop for each side and branch: the compiler makes no vectors of one that decides at every node.
    match (yields, chart.side) {
        (false, _) => chart.fill(coordinates, points, |_, log_x| flow.at_log_pressure(log_x)),
        (true, side @ Side::Light) => {
            InFlow { side, ..*chart }.fill(coordinates, points, |x, log_x| flow.yielding_at(x, log_x));
        }
        (true, side @ Side::Heavy) => {
            InFlow { side, ..*chart }.fill(coordinates, points, |x, log_x| flow.yielding_at(x, log_x));
        }
    }
}
