//! The two charts of a sinusoid whose pressure follows from its interference by the elastic mean gap of Rostami &
//! Jackson (2013): w/Delta = 1 - (1 - t)^(5/2) and p = p* t^2.
//!
//! Towards first touch the coordinate is t^(1/3), which turns the powers t^(4/3) and t^2.08 of the area into smooth
//! ones; towards complete contact it is -(1-t)^(1/2), in which the interference is a polynomial.

use asperity::{ElasticSinusoid, elementary};
use multiversion::multiversion;

use super::pieces::{Chart, LawChart, Piece, Points, pieces_between};

/// Value of t at which the heavy chart replaces the light one.
const CHARTS_MEET_AT: f64 = 0.5;

/// Side of the charts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// From first touch on.
    Light,
    /// Towards complete contact.
    Heavy,
}

impl Side {
    pub const BOTH: [Side; 2] = [Side::Light, Side::Heavy];
}

/// The elastic law in terms of t.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SineShape {
    pub amplitude_m: f64,
    complete_pressure_pa: f64,
}

impl SineShape {
    pub fn new(amplitude_m: f64, law: &ElasticSinusoid) -> Self {
        SineShape { amplitude_m, complete_pressure_pa: law.complete_contact_pressure_pa() }
    }

    /// Interference \[m\] at a mean pressure \[Pa\].
    pub fn interference_m(&self, pressure_pa: f64) -> f64 {
        self.at_t((pressure_pa / self.complete_pressure_pa).sqrt().min(1.0))
    }

    /// Mean pressure \[Pa\] at t.
    pub fn pressure_pa(&self, t: f64) -> f64 {
        self.complete_pressure_pa * t * t
    }

    /// Interference \[m\] at which the charts meet.
    fn charts_meet_m(&self) -> f64 {
        self.at_t(CHARTS_MEET_AT)
    }

    /// 1 - (1-t)^(5/2) = (1 - (1-t)^5)/(1 + (1-t)^(5/2)), without cancellation at small t.
    #[inline(always)]
    fn at_t(&self, t: f64) -> f64 {
        let left = 1.0 - t;
        let numerator = t * (5.0 - t * (10.0 - t * (10.0 - t * (5.0 - t))));
        self.amplitude_m * numerator / (1.0 + left * left * left.sqrt())
    }

    /// Cuts the interferences from `from_m` to `to_m` at the breaks between them, onto the charts of the two sides.
    pub fn pieces<'a>(
        &self,
        from_m: f64,
        to_m: f64,
        breaks_m: impl IntoIterator<Item = f64>,
        [light, heavy]: [&'a dyn LawChart; 2],
    ) -> Vec<Piece<'a>> {
        let charts_meet_m = self.charts_meet_m();
        let mut ends_m = vec![from_m, to_m];
        ends_m.extend(breaks_m.into_iter().chain([charts_meet_m]).filter(|&w| from_m < w && w < to_m));
        ends_m.sort_by(f64::total_cmp);
        pieces_between(&ends_m, |to_m| Chart::Law(if to_m <= charts_meet_m { light } else { heavy }))
    }
}

/// Chart of one side of the elastic law. Other laws take their interferences from it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SineChart {
    shape: SineShape,
    side: Side,
}

impl SineChart {
    /// The charts of the two sides.
    pub fn both(shape: SineShape) -> [SineChart; 2] {
        Side::BOTH.map(|side| SineChart { shape, side })
    }

    /// Value of t at a coordinate.
    #[inline(always)]
    pub fn t(&self, v: f64) -> f64 {
        match self.side {
            Side::Light => v * v * v,
            Side::Heavy => 1.0 - v * v,
        }
    }

    /// The elastic pressure \[Pa\] at a coordinate.
    #[inline(always)]
    pub fn pressure_pa(&self, v: f64) -> f64 {
        self.shape.pressure_pa(self.t(v))
    }

    /// The interferences \[m\] at coordinates, and their derivatives.
    #[inline(always)]
    pub fn interferences(&self, coordinates: &[f64], interferences_m: &mut [f64], slopes_m: &mut [f64]) {
        let amplitude_m = self.shape.amplitude_m;
        for ((&v, interference_m), slope_m) in coordinates.iter().zip(interferences_m).zip(slopes_m) {
            (*interference_m, *slope_m) = match self.side {
                Side::Light => {
                    let t = self.t(v);
                    let left = 1.0 - t;
                    (self.shape.at_t(t), 7.5 * amplitude_m * left * left.sqrt() * v * v)
                }
                Side::Heavy => {
                    let square = v * v;
                    let gap_m = amplitude_m * square * square;
                    (amplitude_m + gap_m * v, 5.0 * gap_m)
                }
            };
        }
    }

    /// Points at coordinates with the elastic pressure, and with the area fraction that `area` returns for coordinate
    /// and t.
    #[inline(always)]
    pub fn with_areas(&self, coordinates: &[f64], points: Points<'_>, area: impl Fn(f64, f64) -> f64) {
        let Points { interferences_m, slopes_m, pressures_pa, area_fractions } = points;
        self.interferences(coordinates, interferences_m, slopes_m);
        for ((&v, pressure_pa), area_fraction) in coordinates.iter().zip(pressures_pa).zip(area_fractions) {
            let t = self.t(v);
            (*pressure_pa, *area_fraction) = (self.shape.pressure_pa(t), area(v, t));
        }
    }
}

impl LawChart for SineChart {
    fn coordinate(&self, interference_m: f64) -> f64 {
        let ratio = (interference_m / self.shape.amplitude_m).min(1.0);
        let root = elementary::exp(0.2 * elementary::ln(1.0 - ratio));
        match self.side {
            Side::Heavy => -root,
            Side::Light => {
                // t = 1 - root^2 = (1 - root^10)/(1 + root^2 + ... + root^8), without cancellation.
                let y = root * root;
                let t = ratio * (2.0 - ratio) / (1.0 + y * (1.0 + y * (1.0 + y * (1.0 + y))));
                if t > 0.0 { elementary::exp(elementary::ln(t) / 3.0) } else { 0.0 }
            }
        }
    }

    fn at_coordinates(&self, coordinates: &[f64], points: Points<'_>) {
        elastic_points(self, coordinates, points);
    }

    fn resolution(&self, from_first_touch: bool) -> f64 {
        match self.side {
            Side::Light if from_first_touch => 1.3,
            Side::Light => 0.75,
            Side::Heavy => 0.78,
        }
    }
}

/// Points of the elastic law. No break of it divides the coordinates: all are on the branch of the first.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn elastic_points<'a>(chart: &SineChart, coordinates: &[f64], points: Points<'a>) {
    let is_joined = coordinates.first().is_some_and(|&v| {
        let t = chart.t(v);
        t * t < ElasticSinusoid::JOINED_UP_TO
    });
    match chart.side {
        _ if !is_joined => {
            chart.with_areas(coordinates, points, |_, t| ElasticSinusoid::heavy_area_fraction(t * t));
        }
        Side::Light => chart
            .with_areas(coordinates, points, |v, t| ElasticSinusoid::light_area_fraction(t, v * v * (v * v))),
        Side::Heavy => chart.with_areas(coordinates, points, |_, t| {
            let power = elementary::exp(4.0 / 3.0 * elementary::ln(t));
            ElasticSinusoid::light_area_fraction(t, power)
        }),
    }
}
