//! Stretch of a law under one rule.

use multiversion::multiversion;

use super::coordinate::Coordinate;
use super::nodes::{Block, LANES, Lanes, Summands, total};
use super::rules::{Rule, error_of_rule};
use crate::asperities::pieces::LawChart;
use crate::gaussian::density::DENSITY_SCALE;

/// Coordinate that a panel is integrated over.
#[derive(Clone, Copy)]
pub(crate) enum Variable<'a> {
    /// The quadrature's own coordinate of the interference.
    Own(Coordinate),
    /// Coordinate provided by the law.
    Law(&'a dyn LawChart),
}

impl Variable<'_> {
    /// Value at an interference, given in units of sigma_s and in metres.
    pub fn at(self, s: f64, interference_m: f64) -> f64 {
        match self {
            Variable::Own(coordinate) => coordinate.at(s),
            Variable::Law(chart) => chart.coordinate(interference_m),
        }
    }

    /// True for the variable of a stretch over decades of the interference.
    fn spans_decades(self) -> bool {
        matches!(self, Variable::Own(coordinate) if coordinate.spans_decades())
    }
}

/// Stretch of one variable under one rule.
#[derive(Clone, Copy)]
pub(crate) struct Panel<'a> {
    pub variable: Variable<'a>,
    pub from: f64,
    pub to: f64,
    pub halvings: usize,
    /// `None` for the trapezoidal rule of rough quadratures, whose error is not needed.
    pub rule: Option<&'static Rule>,
    pub nodes: Block,
}

impl Panel<'_> {
    /// Estimated errors of the contributions to pressure \[Pa\] and area fraction, from the values at the nodes. Over
    /// decades, singularities of the law that lie closer than those of the density, but are weak, take over late.
    pub fn errors(&self, values: &Summands<'_>) -> [f64; 2] {
        const COUNTED_ON_OVER_DECADES: f64 = 0.3;
        let Some(rule) = self.rule else { return [0.0; 2] };
        let onward = if self.variable.spans_decades() { COUNTED_ON_OVER_DECADES } else { 1.0 };
        let Coefficients { wholes, coefficients } = coefficients(values, &rule.probes);
        [0, 1].map(|i| DENSITY_SCALE * error_of_rule(total(wholes[i]), coefficients[i].map(total), onward))
    }

    /// Sums weighted values beyond a value of the variable: the integral there of the polynomial through them.
    pub fn sum_above(&self, weighted_values: impl Iterator<Item = f64>, at: f64) -> f64 {
        let x = (2.0 * at - self.from - self.to) / (self.to - self.from);
        match self.rule {
            _ if x <= -1.0 => weighted_values.sum(),
            Some(rule) if x < 1.0 => rule.integral_above(x, weighted_values),
            _ => 0.0,
        }
    }
}

/// Sums of the pressures and of the areas over the nodes of a panel, with the Legendre coefficients of both that the
/// probes of its rule give.
#[derive(Default)]
struct Coefficients {
    wholes: [Lanes; 2],
    coefficients: [[Lanes; 4]; 2],
}

#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn coefficients<'a>(values: &Summands<'a>, probes: &[[Lanes; 4]]) -> Coefficients {
    let mut sums = Coefficients::default();
    for (((pressure_pa, area_fraction), density), probes) in
        values.pressures_pa.iter().zip(values.area_fractions).zip(values.densities).zip(probes)
    {
        for (quantity, value) in [pressure_pa, area_fraction].into_iter().enumerate() {
            for lane in 0..LANES {
                let value = density[lane] * value[lane];
                sums.wholes[quantity][lane] += value;
                for (sum, probe) in sums.coefficients[quantity].iter_mut().zip(probes) {
                    sum[lane] += value * probe[lane];
                }
            }
        }
    }
    sums
}
