//! Elastic energy of the waves in contact as the integrals of mean gap and stiffness take it.
//!
//! D(x) = [g + (n + 1) (1 - g) erf(x)^n] exp(-x^2) and G(x) = Int_x^inf D(t) dt/t, with x the pressure over v. Both are
//! tabulated once for a law: as power series up to [`SERIES_END`], as a polynomial on each step up to [`STEPS_END`], and beyond,
//! where erf is 1 to rounding, as the exponential integral.

use std::f64::consts::PI;
use std::sync::{Arc, LazyLock};

use crate::energy::EnergyFactor;

/// End of the power series, and the number of their terms, which fall like (3 x^2)^j/j!.
const SERIES_END: f64 = 0.75;
const TERMS: usize = 24;

/// Steps of polynomials from there on, and the end of the last one.
const STEP: f64 = 0.25;
const STEPS: usize = 21;
const STEPS_END: f64 = SERIES_END + STEP * STEPS as f64;

/// Number of coefficients of D(t)/t on a step; they fall by a factor of fourteen each on the first one.
const SIZE: usize = 15;

/// D and G of one energy factor.
#[derive(Debug, Clone)]
pub(crate) struct ContactEnergy {
    factor: EnergyFactor,
    /// Limit of G(x) + g ln(x) as x vanishes.
    pub constant: f64,
    /// Coefficients of (n + 1) (1 - g) (erf(x)/x)^n exp(-x^2) by powers of x^2.
    series: [f64; TERMS],
    steps: Vec<Step>,
}

/// D(t)/t and its integral on a step, by powers of s from -1 to 1.
#[derive(Debug, Clone)]
struct Step {
    density: [f64; SIZE],
    /// Integral from the middle on.
    integral: [f64; SIZE],
    /// G at the middle.
    beyond_middle: f64,
}

/// Those of the two named factors, which most laws share.
static NAMED: LazyLock<[Arc<ContactEnergy>; 2]> =
    LazyLock::new(|| [EnergyFactor::ALMQVIST, EnergyFactor::FITTED].map(ContactEnergy::new).map(Arc::new));

impl ContactEnergy {
    /// D and G of a factor, tabulated once for a named one.
    pub(crate) fn of(factor: EnergyFactor) -> Arc<Self> {
        let named = NAMED.iter().find(|named| named.factor == factor);
        named.map_or_else(|| Arc::new(Self::new(factor)), Arc::clone)
    }

    fn new(factor: EnergyFactor) -> Self {
        let mut energy = ContactEnergy { factor, constant: 0.0, series: series(factor), steps: Vec::new() };
        let mut beyond = energy.beyond_steps(STEPS_END);
        for step in (0..STEPS).rev() {
            let middle = SERIES_END + STEP * (step as f64 + 0.5);
            let density = powers_of(|s| {
                let t = middle + 0.5 * STEP * s;
                energy.density_by_definition(t) / t
            });
            let mut integral = [0.0; SIZE];
            for (power, coefficient) in density.iter().enumerate() {
                integral[power] = 0.5 * STEP * coefficient / (power as f64 + 1.0);
            }
            let beyond_middle = beyond + polynomial(&integral, 1.0);
            beyond = beyond_middle + polynomial(&integral, -1.0);
            energy.steps.push(Step { density, integral, beyond_middle });
        }
        energy.steps.reverse();
        energy.constant = beyond + factor.light * SERIES_END.ln() + energy.risen(SERIES_END);
        energy
    }

    /// Factor g.
    pub(crate) fn light(&self) -> f64 {
        self.factor.light
    }

    /// Computes D(x).
    pub(crate) fn density(&self, x: f64) -> f64 {
        if x < SERIES_END {
            let square = x * x;
            return self.factor.light * (-square).exp() + self.power(x) * polynomial(&self.series, square);
        }
        match self.step(x) {
            Some((step, s)) => x * polynomial(&step.density, s),
            None => self.full() * (-x * x).exp(),
        }
    }

    /// Computes G(x).
    pub(crate) fn beyond(&self, x: f64) -> f64 {
        if x < SERIES_END {
            return self.constant - self.factor.light * x.ln() - self.risen(x);
        }
        match self.step(x) {
            Some((step, s)) => step.beyond_middle - s * polynomial(&step.integral, s),
            None => self.beyond_steps(x),
        }
    }

    /// Step of a place and the place in it, from -1 to 1.
    fn step(&self, x: f64) -> Option<(&Step, f64)> {
        let steps = (x - SERIES_END) / STEP;
        let at = steps as usize;
        self.steps.get(at).map(|step| (step, 2.0 * (steps - at as f64) - 1.0))
    }

    fn density_by_definition(&self, x: f64) -> f64 {
        let EnergyFactor { light, power } = self.factor;
        (light + (power + 1.0) * (1.0 - light) * libm::erf(x).powf(power)) * (-x * x).exp()
    }

    /// Computes D(x) exp(x^2) where erf is 1.
    fn full(&self) -> f64 {
        let EnergyFactor { light, power } = self.factor;
        light + (power + 1.0) * (1.0 - light)
    }

    /// Computes x^n.
    fn power(&self, x: f64) -> f64 {
        if self.factor.power == 2.0 { x * x } else { x.powf(self.factor.power) }
    }

    /// Integral of D(t)/t - g/t from 0 to x, within the series.
    fn risen(&self, x: f64) -> f64 {
        let square = x * x;
        // Int_0^x (exp(-t^2) - 1) dt/t, whose coefficients are those of the exponential.
        let of_light = self.factor.light * square * polynomial(&EXPONENTIAL, square);
        let of_contact = self.series.iter().enumerate().rev().fold(0.0, |sum, (power, coefficient)| {
            sum * square + coefficient / (self.factor.power + 2.0 * power as f64)
        });
        of_light + self.power(x) * of_contact
    }

    /// Computes G beyond the steps: half of the exponential integral E1(x^2), by its continued fraction.
    fn beyond_steps(&self, x: f64) -> f64 {
        const LEVELS: i32 = 12;
        let square = x * x;
        let fraction = (1..=LEVELS).rev().fold(square, |below, level| {
            let level = f64::from(level);
            square + level / (1.0 + level / below)
        });
        0.5 * self.full() * (-square).exp() / fraction
    }
}

/// Coefficients of Int_0^x (exp(-t^2) - 1) dt/t over x^2, by powers of x^2: (-1)^j/(2 j j!) for j from 1 on.
static EXPONENTIAL: LazyLock<[f64; TERMS]> = LazyLock::new(|| {
    let mut inverse_factorial = 1.0;
    std::array::from_fn(|place| {
        let j = place as f64 + 1.0;
        inverse_factorial /= -j;
        inverse_factorial / (2.0 * j)
    })
});

/// Coefficients of (n + 1) (1 - g) (erf(x)/x)^n exp(-x^2) by powers of x^2.
fn series(EnergyFactor { light, power }: EnergyFactor) -> [f64; TERMS] {
    let mut inverse_factorial = 1.0;
    let exponential: [f64; TERMS] = std::array::from_fn(|place| {
        inverse_factorial /= if place == 0 { 1.0 } else { -(place as f64) };
        inverse_factorial
    });
    // erf(x)/x = (2/sqrt(pi)) Sum (-x^2)^j/(j! (2j + 1)); the powers of a series follow from its own (J. C. P. Miller).
    let root: [f64; TERMS] = std::array::from_fn(|place| exponential[place] / (2.0 * place as f64 + 1.0));
    let mut raised = [0.0; TERMS];
    raised[0] = (power + 1.0) * (1.0 - light) * (2.0 / PI.sqrt()).powf(power);
    for place in 1..TERMS {
        let terms = (1..=place).map(|before| {
            let (before_f64, place_f64) = (before as f64, place as f64);
            (before_f64 * (power + 1.0) - place_f64) * root[before] * raised[place - before]
        });
        raised[place] = terms.sum::<f64>() / place as f64;
    }
    std::array::from_fn(|place| (0..=place).map(|at| raised[at] * exponential[place - at]).sum())
}

/// Coefficients by powers of s of the polynomial through a function at the Chebyshev nodes of [-1, 1].
fn powers_of(function: impl Fn(f64) -> f64) -> [f64; SIZE] {
    let values: [f64; SIZE] = std::array::from_fn(|node| function(COSINES[1][node]));
    let mut powers = [0.0; SIZE];
    for (order, (cosines, polynomial)) in COSINES.iter().zip(&*POLYNOMIALS).enumerate() {
        let sum: f64 = values.iter().zip(cosines).map(|(value, cosine)| value * cosine).sum();
        let coefficient = sum * if order == 0 { 1.0 } else { 2.0 } / SIZE as f64;
        powers.iter_mut().zip(polynomial).for_each(|(power, of_order)| *power += coefficient * of_order);
    }
    powers
}

/// Chebyshev polynomials at the nodes, one row for each order.
static COSINES: LazyLock<[[f64; SIZE]; SIZE]> = LazyLock::new(|| {
    let angle = |node: usize| PI * (node as f64 + 0.5) / SIZE as f64;
    std::array::from_fn(|order| std::array::from_fn(|node| (order as f64 * angle(node)).cos()))
});

/// Their coefficients by powers of s: T_(k+1) = 2 s T_k - T_(k-1).
static POLYNOMIALS: LazyLock<[[f64; SIZE]; SIZE]> = LazyLock::new(|| {
    let mut rows = [[0.0; SIZE]; SIZE];
    (rows[0][0], rows[1][1]) = (1.0, 1.0);
    for order in 2..SIZE {
        for power in 0..SIZE {
            let lower = power.checked_sub(1).map_or(0.0, |lower| rows[order - 1][lower]);
            rows[order][power] = 2.0 * lower - rows[order - 2][power];
        }
    }
    rows
});

fn polynomial<const N: usize>(coefficients: &[f64; N], at: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient)
}

#[cfg(test)]
mod tests {
    use numerics::GaussLegendre;

    use super::*;

    #[test]
    fn tables_agree_with_the_definition_and_its_quadrature() {
        let rule = GaussLegendre::new(40);
        for factor in [EnergyFactor::ALMQVIST, EnergyFactor::FITTED, EnergyFactor::new(1.0).unwrap()] {
            let energy = ContactEnergy::new(factor);
            for at in 0..700 {
                let x = 1e-3 * 10f64.powf(f64::from(at) / 160.0);
                let density = energy.density_by_definition(x);
                if density < 1e-290 {
                    continue;
                }
                // Over the last steps D falls by a factor of twenty each.
                let bound = if x < 3.0 { 2e-14 } else { 1e-13 };
                assert!((energy.density(x) / density - 1.0).abs() < bound, "D({x}): {:e}", energy.density(x));
                let to = x + (0.5 / x).min(0.2 * x);
                let between: f64 =
                    rule.over(x, to).map(|(t, weight)| weight * energy.density_by_definition(t) / t).sum();
                let off = energy.beyond(x) - energy.beyond(to) - between;
                assert!(off.abs() < bound * energy.beyond(x), "G({x}): {off:e} of {:e}", energy.beyond(x));
            }
        }
    }

    #[test]
    fn the_whole_energy_without_contact_is_an_exponential_integral() {
        // g = 1: G(x) = E1(x^2)/2, 20 digits of Abramowitz & Stegun's function by mpmath.
        let energy = ContactEnergy::new(EnergyFactor::new(1.0).unwrap());
        for (x, exact) in [
            (0.1, 4.037_929_576_538_114),
            (0.75, 0.490_478_768_933_064_7),
            (2.0, 0.003_779_352_409_848_906_5),
            (7.0, 1.048_981_164_236_802_4e-23),
        ] {
            assert!((energy.beyond(x) / (0.5 * exact) - 1.0).abs() < 1e-14, "{x}: {:e}", energy.beyond(x));
        }
    }
}
