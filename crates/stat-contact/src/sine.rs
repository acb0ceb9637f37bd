//! Populations of sinusoids of one strength: the elastic one, and the elastic-plastic one without strain gradient.
//!
//! Their interference is explicit in the pressure, and the pressure in coordinates of the contact's own: the integrals run
//! over those, and nothing is solved for.

use asperity::{BemSinusoid, ElasticPlasticSinusoid, ElasticSinusoid, MaterialPair, PlasticFlow, elementary};

use crate::Population;
use crate::asperities::{Asperities, Chart, Piece, Points, Response};

/// t of the elastic mean gap, w/Delta = 1 - (1 - t)^(5/2) and p = p* t^2, at which the light chart gives over to the heavy one.
const CHARTS_MEET_AT: f64 = 0.5;

/// The elastic law in terms of t.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ElasticSine {
    amplitude_m: f64,
    complete_pressure_pa: f64,
}

impl ElasticSine {
    pub fn new(amplitude_m: f64, law: &ElasticSinusoid) -> Self {
        ElasticSine { amplitude_m, complete_pressure_pa: law.complete_contact_pressure_pa() }
    }

    /// Interference \[m\] at a mean pressure \[Pa\].
    pub fn interference_m(&self, pressure_pa: f64) -> f64 {
        self.at_t((pressure_pa / self.complete_pressure_pa).sqrt().min(1.0))
    }

    /// Interference \[m\] at which the charts meet.
    pub fn charts_meet_m(&self) -> f64 {
        self.at_t(CHARTS_MEET_AT)
    }

    /// 1 - (1-t)^(5/2) = (1 - (1-t)^5)/(1 + (1-t)^(5/2)), without cancellation at small t.
    #[inline(always)]
    fn at_t(&self, t: f64) -> f64 {
        let left = 1.0 - t;
        let numerator = t * (5.0 - t * (10.0 - t * (10.0 - t * (5.0 - t))));
        self.amplitude_m * numerator / (1.0 + left * left * left.sqrt())
    }

    /// The light chart's coordinate is t^(1/3), which turns the powers t^(4/3) and t^2.08 of the area into smooth ones; the
    /// heavy one's is -(1-t)^(1/2), in which w/Delta = 1 - (1-t)^(5/2) is a polynomial.
    pub fn coordinate(&self, chart: Chart, interference_m: f64) -> f64 {
        let ratio = (interference_m / self.amplitude_m).min(1.0);
        let root = elementary::exp(0.2 * elementary::ln(1.0 - ratio));
        if chart != Chart::SineLight {
            return -root;
        }
        // t = 1 - root^2 = (1 - root^10)/(1 + root^2 + ... + root^8), without cancellation.
        let y = root * root;
        let t = ratio * (2.0 - ratio) / (1.0 + y * (1.0 + y * (1.0 + y * (1.0 + y))));
        if t > 0.0 { elementary::exp(elementary::ln(t) / 3.0) } else { 0.0 }
    }

    /// Mean pressure \[Pa\] at t.
    pub fn pressure_pa(&self, t: f64) -> f64 {
        self.complete_pressure_pa * t * t
    }

    /// t, the interference \[m\] and its derivative by the coordinate.
    #[inline(always)]
    pub fn at_coordinate(&self, chart: Chart, v: f64) -> (f64, f64, f64) {
        match chart {
            Chart::SineLight => {
                let t = v * v * v;
                let left = 1.0 - t;
                (t, self.at_t(t), 7.5 * self.amplitude_m * left * left.sqrt() * v * v)
            }
            _ => {
                let square = v * v;
                let gap = self.amplitude_m * square * square;
                (1.0 - square, self.amplitude_m + gap * v, 5.0 * gap)
            }
        }
    }

    /// The interferences, their derivatives and the pressures at coordinates, with t in the place of the area fractions.
    pub fn at_coordinates(&self, chart: Chart, coordinates: &[f64], points: &mut Points<'_>) {
        for ((((&v, interference_m), slope_m), pressure_pa), t) in coordinates
            .iter()
            .zip(&mut *points.interferences_m)
            .zip(&mut *points.slopes_m)
            .zip(&mut *points.pressures_pa)
            .zip(&mut *points.area_fractions)
        {
            (*t, *interference_m, *slope_m) = self.at_coordinate(chart, v);
            *pressure_pa = self.pressure_pa(*t);
        }
    }

    /// Turns t into the area fraction of the elastic law. No break of the law divides the coordinates.
    pub fn areas_at_coordinates(&self, chart: Chart, coordinates: &[f64], area_fractions: &mut [f64]) {
        if area_fractions.first().is_some_and(|t| t * t >= ElasticSinusoid::JOINED_UP_TO) {
            area_fractions.iter_mut().for_each(|t| *t = ElasticSinusoid::heavy_area_fraction(*t * *t));
        } else if chart == Chart::SineLight {
            for (t, &v) in area_fractions.iter_mut().zip(coordinates) {
                *t = ElasticSinusoid::light_area_fraction(*t, v * v * (v * v));
            }
        } else {
            for t in area_fractions {
                let power = elementary::exp(4.0 / 3.0 * elementary::ln(*t));
                *t = ElasticSinusoid::light_area_fraction(*t, power);
            }
        }
    }

    /// Cuts the interferences from `from_m` to `to_m` at the breaks between them, onto the two charts.
    pub fn pieces(&self, from_m: f64, to_m: f64, breaks_m: impl IntoIterator<Item = f64>) -> Vec<Piece> {
        let mut ends_m = vec![from_m, to_m];
        ends_m.extend(breaks_m.into_iter().chain([self.charts_meet_m()]).filter(|&w| from_m < w && w < to_m));
        ends_m.sort_by(f64::total_cmp);
        let chart = |to_m: f64| {
            if to_m <= self.charts_meet_m() { Chart::SineLight } else { Chart::SineHeavy }
        };
        ends_m
            .windows(2)
            .filter(|ends| ends[0] < ends[1])
            .map(|ends| Piece { from_m: ends[0], to_m: ends[1], chart: chart(ends[1]) })
            .collect()
    }
}

/// Elastic sinusoids, by the mean gap of Rostami & Jackson.
#[derive(Debug, Clone)]
pub(crate) struct ElasticSines {
    law: ElasticSinusoid,
    shape: ElasticSine,
}

impl ElasticSines {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let law = ElasticSinusoid::new(pair, amplitude_m / wavelength_m);
        ElasticSines { law, shape: ElasticSine::new(amplitude_m, &law) }
    }
}

impl Asperities for ElasticSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.shape.amplitude_m;
        let pressure_pa = self.law.pressure_at_interference_pa(ratio);
        let area_fraction = if ratio >= 1.0 { 1.0 } else { self.law.area_fraction(pressure_pa) };
        Response { pressure_pa, area_fraction }
    }

    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece> {
        let breaks_m = self.law.breaks().map(|b| self.shape.interference_m(b.at));
        self.shape.pieces(0.0, self.shape.amplitude_m, breaks_m)
    }

    fn highest_response_pa(&self) -> f64 {
        self.law.complete_contact_pressure_pa()
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.law.complete_contact_pressure_pa();
        Some((self.shape.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }

    fn coordinate(&self, chart: Chart, interference_m: f64) -> f64 {
        self.shape.coordinate(chart, interference_m)
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.law.pressure_at_interference_pa(w / self.shape.amplitude_m);
        }
    }

    fn at_coordinates(&self, chart: Chart, coordinates: &[f64], mut points: Points<'_>) {
        self.shape.at_coordinates(chart, coordinates, &mut points);
        self.shape.areas_at_coordinates(chart, coordinates, points.area_fractions);
    }
}

/// Elastic sinusoids by boundary elements.
#[derive(Debug, Clone)]
pub(crate) struct BemSines {
    law: BemSinusoid,
    amplitude_m: f64,
}

impl BemSines {
    pub fn new(pair: &MaterialPair, population: &Population) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        BemSines { law: BemSinusoid::new(pair, amplitude_m / wavelength_m), amplitude_m }
    }
}

impl Asperities for BemSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.amplitude_m;
        let pressure_pa = self.law.pressure_at_interference_pa(ratio);
        let area_fraction = if ratio >= 1.0 { 1.0 } else { self.law.area_fraction(pressure_pa) };
        Response { pressure_pa, area_fraction }
    }

    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece> {
        let mut ends_m = vec![0.0];
        ends_m
            .extend(self.law.breaks().map(|b| self.amplitude_m * self.law.deformation_over_amplitude(b.at)));
        let last = ends_m.len() - 2;
        let chart = |i| match i {
            0 => Chart::TableLight,
            i if i == last => Chart::TableHeavy,
            _ => Chart::Table,
        };
        let pieces = ends_m.windows(2).enumerate();
        pieces
            .filter(|(_, ends)| ends[1] > low_m && ends[0] < high_m)
            .map(|(i, ends)| Piece { from_m: ends[0], to_m: ends[1], chart: chart(i) })
            .collect()
    }

    fn highest_response_pa(&self) -> f64 {
        self.law.complete_contact_pressure_pa()
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.law.complete_contact_pressure_pa();
        Some((self.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }

    /// x^(1/3), ln x and -(1-x)^(1/2): the law is a polynomial in the first and the last.
    fn coordinate(&self, chart: Chart, interference_m: f64) -> f64 {
        let pressure_pa = self.law.pressure_at_interference_pa(interference_m / self.amplitude_m);
        let x = pressure_pa / self.law.complete_contact_pressure_pa();
        match chart {
            Chart::TableLight => x.cbrt(),
            Chart::TableHeavy => -(1.0 - x).sqrt(),
            _ => x.ln(),
        }
    }

    fn at_coordinates(&self, chart: Chart, coordinates: &[f64], points: Points<'_>) {
        for (i, &v) in coordinates.iter().enumerate() {
            let (log_x, slope) = match chart {
                Chart::TableLight => (3.0 * v.ln(), 3.0 / v),
                Chart::TableHeavy => ((-v * v).ln_1p(), -2.0 * v / (1.0 - v * v)),
                _ => (v, 1.0),
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

/// Elastic-plastic sinusoids of one strength.
#[derive(Debug, Clone)]
pub(crate) struct ElasticPlasticSines {
    law: ElasticPlasticSinusoid,
    flow: PlasticFlow,
    shape: ElasticSine,
    /// Pressure \[Pa\] and interference \[m\] from which on plastic flow sets the pressure; complete contact where none does.
    flow_onset: (f64, f64),
    /// Interferences \[m\] at which the area is not smooth.
    breaks_m: Vec<f64>,
}

/// x = p/p*_ep at which the light chart of plastic flow gives over to the heavy one.
const FLOW_CHARTS_MEET_AT: f64 = 0.3;

impl ElasticPlasticSines {
    pub fn new(pair: &MaterialPair, population: &Population, strength_pa: f64) -> Self {
        let (wavelength_m, amplitude_m) = population.sinusoid_m();
        let law = ElasticPlasticSinusoid::new(pair, amplitude_m / wavelength_m, strength_pa);
        let shape = ElasticSine::new(amplitude_m, &law.elastic());
        let flow_onset = match law.flow_onset_pressure_pa() {
            Some(pressure_pa) => (pressure_pa, shape.interference_m(pressure_pa)),
            None => (law.complete_contact_pressure_pa(), amplitude_m),
        };
        let mut sines =
            ElasticPlasticSines { law, flow: law.plastic_flow(), shape, flow_onset, breaks_m: Vec::new() };
        let elastic = law.elastic().breaks().filter(|b| !law.yields_at(b.at));
        sines.breaks_m = law.breaks().chain(elastic).map(|b| sines.interference_m(b.at)).collect();
        sines
    }

    fn interference_m(&self, pressure_pa: f64) -> f64 {
        let log_x = (pressure_pa / self.flow.complete_contact_pressure_pa()).ln();
        if pressure_pa <= self.flow_onset.0 {
            self.shape.interference_m(pressure_pa)
        } else if log_x >= 0.0 {
            self.shape.amplitude_m
        } else {
            self.shape.amplitude_m * self.flow.at_log_pressure(log_x).interference_over_amplitude
        }
    }

    /// Where the pressure is elastic; the area may be plastic.
    fn at_elastic_coordinates(&self, chart: Chart, coordinates: &[f64], mut points: Points<'_>) {
        self.shape.at_coordinates(chart, coordinates, &mut points);
        if points.pressures_pa.first().is_some_and(|&pressure_pa| self.law.yields_at(pressure_pa)) {
            let complete_pa = self.law.complete_contact_pressure_pa();
            for (pressure_pa, area_fraction) in points.pressures_pa.iter().zip(points.area_fractions) {
                *area_fraction = self.flow.yielding_area_fraction(pressure_pa / complete_pa);
            }
        } else {
            self.shape.areas_at_coordinates(chart, coordinates, points.area_fractions);
        }
    }

    /// Where plastic flow sets the pressure. The light chart's coordinate is x^(1/4), in which the powers of x at its low end
    /// are mild (ln x took twice the nodes over decades), the heavy one's -(1-x)^(1/2), in which the end-point power
    /// (1-x)^(5/2) of the gap is smooth.
    fn at_flow_coordinates(&self, chart: Chart, coordinates: &[f64], points: Points<'_>) {
        let complete_pa = self.law.complete_contact_pressure_pa();
        let light = chart == Chart::FlowLight;
        let yields = coordinates.first().is_some_and(|v| {
            let x = if light { v * v * (v * v) } else { 1.0 - v * v };
            self.law.yields_at(complete_pa * x)
        });
        let amplitude_m = self.shape.amplitude_m;
        let nodes = coordinates
            .iter()
            .zip(points.interferences_m)
            .zip(points.slopes_m)
            .zip(points.pressures_pa)
            .zip(points.area_fractions);
        for ((((&v, interference_m), slope_m), pressure_pa), area_fraction) in nodes {
            let (x, log_x, slope) = if light {
                (v * v * (v * v), 4.0 * elementary::ln(v), 4.0 / v)
            } else {
                let x = 1.0 - v * v;
                (x, elementary::ln_1p(-v * v), -2.0 * v / x)
            };
            let point =
                if yields { self.flow.yielding_at(x, log_x) } else { self.flow.at_log_pressure(log_x) };
            *interference_m = amplitude_m * point.interference_over_amplitude;
            *slope_m = amplitude_m * point.slope_by_log_pressure * slope;
            (*pressure_pa, *area_fraction) = (point.pressure_pa, point.area_fraction);
        }
    }
}

impl Asperities for ElasticPlasticSines {
    fn at_interference(&self, interference_m: f64) -> Response {
        let ratio = interference_m / self.shape.amplitude_m;
        let (pressure_pa, area_fraction) = self.law.pressure_and_area_at_interference(ratio);
        Response { pressure_pa, area_fraction }
    }

    fn pieces(&self, _low_m: f64, _high_m: f64) -> Vec<Piece> {
        let (_, onset_m) = self.flow_onset;
        let complete_m = self.shape.amplitude_m;
        let mut pieces = self.shape.pieces(0.0, onset_m, self.breaks_m.iter().copied());
        let meet_m =
            self.interference_m(FLOW_CHARTS_MEET_AT * self.flow.complete_contact_pressure_pa()).max(onset_m);
        let mut ends_m = vec![onset_m, meet_m, complete_m];
        ends_m.extend(self.breaks_m.iter().filter(|&&w| onset_m < w && w < complete_m));
        ends_m.sort_by(f64::total_cmp);
        pieces.extend(ends_m.windows(2).filter(|ends| ends[0] < ends[1]).map(|ends| Piece {
            from_m: ends[0],
            to_m: ends[1],
            chart: if ends[1] <= meet_m { Chart::FlowLight } else { Chart::FlowHeavy },
        }));
        pieces
    }

    fn highest_response_pa(&self) -> f64 {
        self.flow.complete_contact_pressure_pa()
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        let pressure_pa = self.flow.complete_contact_pressure_pa();
        Some((self.shape.amplitude_m, Response { pressure_pa, area_fraction: 1.0 }))
    }

    fn coordinate(&self, chart: Chart, interference_m: f64) -> f64 {
        if matches!(chart, Chart::SineLight | Chart::SineHeavy) {
            return self.shape.coordinate(chart, interference_m);
        }
        let ratio = interference_m / self.shape.amplitude_m;
        let log_x = if ratio < 1.0 { self.flow.log_pressure_at_interference(ratio) } else { 0.0 };
        if chart == Chart::FlowLight {
            elementary::exp(0.25 * log_x)
        } else {
            -(-elementary::exp_m1(log_x)).sqrt()
        }
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.flow.pressure_at_interference_pa(w / self.shape.amplitude_m);
        }
    }

    fn at_coordinates(&self, chart: Chart, coordinates: &[f64], points: Points<'_>) {
        if matches!(chart, Chart::SineLight | Chart::SineHeavy) {
            self.at_elastic_coordinates(chart, coordinates, points);
        } else {
            self.at_flow_coordinates(chart, coordinates, points);
        }
    }

    fn out_of_fitted_range(&self, _high_m: f64) -> Vec<(f64, f64)> {
        if self.law.in_fitted_range() {
            return Vec::new();
        }
        vec![(self.interference_m(self.law.critical_pressure_pa()), f64::INFINITY)]
    }
}
