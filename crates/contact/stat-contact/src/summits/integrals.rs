//! Area and pressure of Nayak's summits under Hertz's ellipses: Bush, Gibson & Thomas (1975).
//!
//! In units of sqrt(m0), sqrt(m4) and with x = 3 T^2/2 (`docs/theory/models.md`, section 3.6):
//!
//! ```text
//! A/A0          = (3/2) sqrt(alpha)      Int_0^inf g(T) T^3     h_A(x) <w>       dT
//! p/(E* sqrt(m2)) = (2/pi) alpha^(3/4)   Int_0^inf g(T) T^(7/2) h_F(x) <w^(3/2)> dT
//! ```
//!
//! g is the density of T, normal with the variance 2/3. The heights of summits of one mean curvature are normal, so
//! that the means of their interference w are those of Hertz's spheres, in closed form.

use std::f64::consts::FRAC_2_PI;
use std::sync::LazyLock;

use asperity::MaterialPair;

use super::ellipticity::Ellipticity;
use super::nayak::NayakSummits;
use super::stretches::{Stretch, Stretches};
use crate::gaussian::density::DENSITY_SCALE;
use crate::gaussian::hertz_load::load_and_mean_height;
use crate::gaussian::moments::first_moment;
use crate::quadrature::Sums;
use crate::quadrature::rules::{Rule, error_of_rule};

/// Nodes of a stretch.
const NODES: usize = 34;
/// Smallest spread of heights at one curvature: the effect of a smaller one is below rounding, up to thirty sqrt(m0).
const LEAST_SPREAD: f64 = 1e-9;

/// The integrals of the summits of a surface, at any separation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SummitIntegrals {
    alpha: f64,
    /// Spread sqrt(1 - 3/(2 alpha)).
    spread: f64,
    /// Factor E* sqrt(m2) (2/pi) alpha^(3/4) of the pressure \[Pa\].
    pressure_pa: f64,
    /// Factor (3/2) sqrt(alpha) of the area fraction.
    area_fraction: f64,
}

/// Integrals at one separation with their error and cost.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SummitSums {
    pub sums: Sums,
    /// Estimate of the larger relative error of the two.
    pub relative_error: f64,
    /// Number of curvatures at which summits were evaluated.
    pub evaluations: usize,
}

impl SummitIntegrals {
    pub fn new(pair: &MaterialPair, summits: &NayakSummits) -> Self {
        let alpha = summits.alpha();
        SummitIntegrals {
            alpha,
            spread: (1.0 - 1.5 / alpha).sqrt().max(LEAST_SPREAD),
            pressure_pa: FRAC_2_PI * alpha.powf(0.75) * pair.composite_modulus_pa() * summits.m2().sqrt(),
            area_fraction: 1.5 * alpha.sqrt(),
        }
    }

    /// The integrals at a separation u, in sqrt(m0) from the mean plane, over the reference density.
    pub fn sums_at(&self, u: f64) -> SummitSums {
        let stretches = Stretches::around(u, self.alpha, self.spread);
        let rule = Rule::of_at_least(NODES);
        let (mut totals, mut errors, mut evaluations) = (WeightedSums::default(), [0.0; 2], 0);
        for stretch in stretches.iter() {
            let (summed, error) = self.sum_over(stretch, &stretches, u, rule);
            totals.add(&summed);
            errors = [errors[0] + error[0], errors[1] + error[1]];
            evaluations += rule.count();
        }
        let relative = [errors[0] / totals.load, errors[1] / totals.area];
        SummitSums {
            sums: self.sums(&totals),
            relative_error: error_estimate(relative[0].max(relative[1]), u),
            evaluations,
        }
    }

    /// Pressure \[Pa\] and area fraction if all summits are pressed to about the interference -u, far below the mean
    /// plane; the spread of the heights would change a relative 1/u^2.
    pub fn far_below(&self, u: f64) -> [f64; 2] {
        let DeepLimit { load, area, load_curvature, area_curvature } = *DeepLimit::shared();
        let below = |curvature: f64| 1.5 * curvature / self.alpha.sqrt() - u;
        let (for_load, for_area) = (below(load_curvature), below(area_curvature));
        [self.pressure_pa * load * for_load * for_load.sqrt(), self.area_fraction * area * for_area]
    }

    /// The sums over the nodes of a stretch, and their estimated errors of load and area.
    fn sum_over(
        &self,
        stretch: Stretch,
        stretches: &Stretches,
        u: f64,
        rule: &Rule,
    ) -> (WeightedSums, [f64; 2]) {
        let (mut totals, mut probed) = (WeightedSums::default(), [[0.0; 4]; 2]);
        for (at, (curvature, weight)) in nodes(stretch, stretches.origin, rule).enumerate() {
            let weighed = self.at(curvature, stretches, u).times(weight);
            totals.add(&weighed);
            for (probed, value) in probed.iter_mut().zip([weighed.load, weighed.area]) {
                for (sum, probe) in probed.iter_mut().zip(rule.probes_at(at)) {
                    *sum += value * probe;
                }
            }
        }
        let errors = [0, 1].map(|i| error_of_rule([totals.load, totals.area][i], probed[i], 1.0));
        (totals, errors)
    }

    /// Integrands at a mean curvature, counted from the origin of the stretches.
    fn at(&self, curvature: f64, stretches: &Stretches, u: f64) -> WeightedSums {
        let whole = stretches.origin + curvature;
        let height = stretches.height_at(curvature);
        let reached = ContactIntegrals::at(height);
        let [area, force] = Ellipticity::table().at(1.5 * whole * whole);
        let weight = self.density(curvature, height, u).exp() * whole * whole * whole;
        let load = weight * whole.sqrt() * force * reached.load;
        WeightedSums {
            load,
            area: weight * area * reached.area,
            slopes: reached.slopes.map(|slope| load * slope),
        }
    }

    /// Logarithm of the density of summits at a mean curvature, counted from the origin, whose mean height is
    /// `height` spreads below the flat, over the reference density of the separation and, for a positive `height`,
    /// that of their heights.
    fn density(&self, curvature: f64, height: f64, u: f64) -> f64 {
        if u <= 0.0 {
            return -0.75 * curvature * curvature;
        }
        if height >= 0.0 {
            let deviations = curvature / self.spread;
            return -0.75 * deviations * deviations;
        }
        let (above, scaled) = (-height * self.spread, u * self.spread);
        -self.alpha / 3.0 * (above * (2.0 * u + above) + scaled * scaled)
    }

    /// Integrals in their units, with the means of the heights that the derivatives of ln p by u need.
    fn sums(&self, totals: &WeightedSums) -> Sums {
        let s = self.spread;
        let [first, second, third] = totals.slopes.map(|slope| slope / totals.load);
        let mean = -first / s;
        let square = 1.0 + second / s / s;
        let cube = 3.0 * mean - third / s / s / s;
        let pressure_pa = self.pressure_pa * CURVATURE_SCALE * DENSITY_SCALE * s * s.sqrt() * totals.load;
        let area_fraction = self.area_fraction * CURVATURE_SCALE * s * totals.area;
        Sums::new(pressure_pa, area_fraction, [mean, square, cube])
    }
}

/// Density sqrt(3/(4 pi)) of the mean curvature at zero.
const CURVATURE_SCALE: f64 = 0.488_602_511_902_919_9;

/// Relative error to report for integrals at the separation u, from that of their rules.
fn error_estimate(rules: f64, u: f64) -> f64 {
    // Rounding of the averages over the difference of curvatures, and of sums of a hundred terms.
    const ROUNDING: f64 = 1e-13;
    // Caution because rules are judged by the fall of their coefficients.
    const CAUTION: f64 = 4.0;
    // Rounding of the exponents, which are as large as u^2.
    const UNITS: f64 = 4.0;
    let exponents = UNITS * f64::EPSILON * u.max(0.0).powi(2);
    CAUTION * rules + ROUNDING + exponents
}

/// Nodes of a rule over a stretch: curvatures counted from the origin, and weights. If the stretch begins at or near
/// curvature zero, the rule is over the root of the curvature.
fn nodes(stretch: Stretch, origin: f64, rule: &Rule) -> impl Iterator<Item = (f64, f64)> {
    let Stretch { from, to, rooted } = stretch;
    let [from, to] = [from, to].map(|end| if rooted { (origin + end).sqrt() } else { end });
    rule.gauss.over(from, to).map(
        move |(at, weight)| {
            if rooted { (at * at - origin, 2.0 * at * weight) } else { (at, weight) }
        },
    )
}

/// Load and area of summits, and the derivatives of the load by the height of the flat.
#[derive(Debug, Clone, Copy, Default)]
struct WeightedSums {
    load: f64,
    area: f64,
    slopes: [f64; 3],
}

impl WeightedSums {
    fn add(&mut self, other: &WeightedSums) {
        self.load += other.load;
        self.area += other.area;
        self.slopes.iter_mut().zip(other.slopes).for_each(|(slope, other)| *slope += other);
    }

    fn times(&self, weight: f64) -> WeightedSums {
        WeightedSums {
            load: weight * self.load,
            area: weight * self.area,
            slopes: self.slopes.map(|slope| weight * slope),
        }
    }
}

/// Integrals over normal heights of unit spread that a flat at a height above their mean reaches, for positive
/// heights over exp(-height^2/2).
struct ContactIntegrals {
    /// Load Int s^(3/2) exp(-(height + s)^2/2) ds.
    load: f64,
    /// Area Int s exp(-(height + s)^2/2) ds/sqrt(2 pi).
    area: f64,
    /// First, second and third derivative of the load by the height, over the load.
    slopes: [f64; 3],
}

impl ContactIntegrals {
    fn at(height: f64) -> Self {
        // Below this height the recurrence between the means loses the digits that the series has: both have nine of
        // the third derivative there. Narrow spectra need them, because their third derivatives nearly cancel.
        const SERIES_BELOW: f64 = -30.0;
        let (load, mean) = load_and_mean_height(height);
        let slopes = if height < SERIES_BELOW { deep_slopes(height) } else { slopes(height, mean) };
        ContactIntegrals { load, area: first_moment(height), slopes }
    }
}

/// Derivatives of the load by the height, over the load, from the mean height: integration by parts reduces the
/// higher means to it.
fn slopes(height: f64, mean: f64) -> [f64; 3] {
    let square = 2.5 + height * mean;
    let cube = 3.5 * mean + 1.5 * height + height * height * mean;
    [-mean, square - 1.0, 3.0 * mean - cube]
}

/// Derivatives if all heights are reached: of v^(3/2) (1 + (3/8)/v^2 + (9/128)/v^4 + ...), v the depth.
fn deep_slopes(height: f64) -> [f64; 3] {
    // (3/2)(1/2)...(5/2 - 2k)/(2^k k!). The next term is below 1e-14 of the first at the smallest depth.
    const SERIES: [f64; 5] = [1.0, 3.0 / 8.0, 9.0 / 128.0, 105.0 / 1024.0, 10395.0 / 32768.0];
    let depth = -height;
    let square = 1.0 / (depth * depth);
    let mut derivatives = [0.0; 4];
    let (mut power, mut exponent) = (1.0, 1.5);
    for coefficient in SERIES {
        let mut term = coefficient * power;
        for (order, derivative) in derivatives.iter_mut().enumerate() {
            *derivative += term;
            // The derivative is by the height, which runs against the depth.
            term *= -(exponent - order as f64) / depth;
        }
        power *= square;
        exponent -= 2.0;
    }
    let [value, first, second, third] = derivatives;
    [first / value, second / value, third / value]
}

/// Loads and areas if every summit is reached, and the mean curvatures under their weights.
struct DeepLimit {
    load: f64,
    area: f64,
    load_curvature: f64,
    area_curvature: f64,
}

impl DeepLimit {
    /// Values of Nayak's distribution of curvatures, computed at their first use.
    fn shared() -> &'static DeepLimit {
        static FAR: LazyLock<DeepLimit> = LazyLock::new(|| {
            let rule = Rule::of_at_least(NODES);
            let stretches = Stretches::around(0.0, 1.5, LEAST_SPREAD);
            let [mut load, mut area, mut load_curvature, mut area_curvature] = [0.0; 4];
            for stretch in stretches.iter() {
                for (curvature, weight) in nodes(stretch, 0.0, rule) {
                    let [of_area, of_force] = Ellipticity::table().at(1.5 * curvature * curvature);
                    let density = CURVATURE_SCALE * weight * (-0.75 * curvature * curvature).exp();
                    let cubed = density * curvature.powi(3);
                    let (of_load, of_area) = (cubed * curvature.sqrt() * of_force, cubed * of_area);
                    load += of_load;
                    area += of_area;
                    load_curvature += of_load * curvature;
                    area_curvature += of_area * curvature;
                }
            }
            DeepLimit {
                load,
                area,
                load_curvature: load_curvature / load,
                area_curvature: area_curvature / area,
            }
        });
        &FAR
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_of_curvatures_is_the_root_of_three_over_four_pi() {
        assert!((CURVATURE_SCALE - (0.75 / std::f64::consts::PI).sqrt()).abs() < 1e-16);
    }

    #[test]
    fn the_two_forms_of_the_derivatives_meet() {
        let (_, mean) = load_and_mean_height(-30.0);
        for (recurred, series) in slopes(-30.0, mean).into_iter().zip(deep_slopes(-30.0)) {
            assert!((recurred / series - 1.0).abs() < 2e-9, "{recurred} {series}");
        }
    }

    #[test]
    fn the_means_are_the_derivatives_of_the_logarithm() {
        for alpha in [1.5001, 2.0, 30.0, 1e4] {
            let integrals = SummitIntegrals {
                alpha,
                spread: (1.0 - 1.5 / alpha).sqrt(),
                pressure_pa: 1.0,
                area_fraction: 1.0,
            };
            for u in [-20.0f64, -4.0, -0.5, 0.7, 5.0, 30.0] {
                let slopes = |u: f64| integrals.sums_at(u).sums.log_pressure_slopes();
                let step = 1e-4 * (1.0 + u.abs());
                for order in [0, 1] {
                    let difference = (slopes(u + step)[order] - slopes(u - step)[order]) / (2.0 * step);
                    let error = (difference / slopes(u)[order + 1] - 1.0).abs();
                    assert!(error < 1e-5, "alpha = {alpha}, u = {u}, order {order}: {difference}");
                }
            }
        }
    }
}
