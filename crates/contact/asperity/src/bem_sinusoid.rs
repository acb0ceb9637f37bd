//! The elastic sinusoid by boundary elements: the problem of Johnson, Greenwood & Higginson (1985) without fits.

use std::f64::consts::{PI, SQRT_2};
use std::sync::OnceLock;

use numerics::newton_in_bracket;

use crate::elastic_sinusoid::log_of_fraction;
use crate::monotone_cubic::MonotoneCubic;
use crate::{Break, ElasticSinusoid, MaterialPair};

/// Boundary-element solution at one pressure.
struct Solution {
    /// Pressure ratio p/p*.
    x: f64,
    /// Area fraction on a mesh of 1024^2.
    area_fraction: f64,
    /// Mean gap over amplitude.
    gap: f64,
}

impl Solution {
    const fn new(x: f64, area_fraction: f64, gap: f64) -> Self {
        Solution { x, area_fraction, gap }
    }

    /// Deformation over amplitude.
    fn deformation(&self) -> f64 {
        1.0 - self.gap
    }
}

/// Solutions computed for this project by boundary elements, in rising order of the pressure.
const SOLVED: [Solution; ROWS] = [
    Solution::new(0.0001, 0.001647, 0.990084),
    Solution::new(0.0003, 0.003399, 0.979739),
    Solution::new(0.001, 0.007665, 0.956117),
    Solution::new(0.003, 0.01604, 0.912458),
    Solution::new(0.01, 0.036392, 0.81829),
    Solution::new(0.02, 0.058791, 0.728823),
    Solution::new(0.05, 0.112945, 0.556371),
    Solution::new(0.1, 0.190555, 0.384749),
    Solution::new(0.15, 0.265347, 0.276613),
    Solution::new(0.2, 0.345096, 0.204634),
    Solution::new(0.25, 0.443538, 0.158195),
    Solution::new(0.3, 0.514107, 0.124881),
    Solution::new(0.4, 0.619906, 0.076908),
    Solution::new(0.5, 0.704183, 0.045078),
    Solution::new(0.6, 0.77616, 0.02417),
    Solution::new(0.7, 0.839925, 0.011131),
    Solution::new(0.8, 0.897616, 0.003847),
    Solution::new(0.85, 0.924645, 0.001833),
    Solution::new(0.9, 0.950658, 0.000651),
    Solution::new(0.95, 0.975764, 0.000113),
    Solution::new(0.98, 0.990377, 1.1e-05),
    Solution::new(0.99, 0.995199, 2e-06),
];
const ROWS: usize = 22;
/// Lightest and heaviest solution.
const FIRST: &Solution = &SOLVED[0];
const LAST: &Solution = &SOLVED[ROWS - 1];

/// A sinusoidal surface in elastic contact with a flat (`docs/theory/models.md`, section 3.3), interpolated between 22
/// boundary-element solutions: monotone cubics of the logarithms of the area fraction and of deformation over gap,
/// against that of the pressure.
///
/// Below the first solution, at p* 1e-4, both follow Hertz times a factor 1 + c (p/p*)^(1/3) that meets it: the
/// neighbours push the surface down in proportion to p, w is of the order of p^(2/3), and the second solution
/// confirms c to 0.1 % of w. Above the last, at 0.99 p*, they follow the analytic limits 1 - phi ~ 1 - x and g ~ (1 -
/// x)^(5/2) from that solution on. Everything is continuous.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BemSinusoid {
    complete_contact_pressure_pa: f64,
}

impl BemSinusoid {
    /// Creates a sinusoid of aspect ratio B = Delta/lambda > 0.
    #[must_use]
    pub fn new(pair: &MaterialPair, aspect_ratio: f64) -> Self {
        let elastic = ElasticSinusoid::new(pair, aspect_ratio);
        BemSinusoid { complete_contact_pressure_pa: elastic.complete_contact_pressure_pa() }
    }

    /// Mean pressure p* = sqrt(2) pi E* B \[Pa\] at which the surfaces touch everywhere.
    #[must_use]
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.complete_contact_pressure_pa
    }

    /// Fraction of the nominal area in contact, in (0, 1], at the mean pressure p > 0 \[Pa\].
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        self.below_complete_contact(pressure_pa).map_or(1.0, area_fraction)
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta in (0, 1] at the mean pressure p > 0 \[Pa\].
    #[must_use]
    pub fn deformation_over_amplitude(&self, pressure_pa: f64) -> f64 {
        self.below_complete_contact(pressure_pa).map_or(1.0, |log_x| deformation_and_slope(log_x).0)
    }

    /// Returns the deformation over amplitude, and its derivative by ln x, at the mean pressure p* x, ln x < 0.
    #[must_use]
    pub fn deformation_and_slope(&self, log_x: f64) -> (f64, f64) {
        deformation_and_slope(log_x)
    }

    /// Mean pressure \[Pa\] when the flat has descended by w > 0, given as w/Delta; p* from w = Delta on.
    #[must_use]
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa;
        }
        self.complete_contact_pressure_pa * log_x_at(interference_over_amplitude).exp()
    }

    /// Mean pressures \[Pa\] at which the interpolation passes from one piece to the next, in rising order.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let complete = self.complete_contact_pressure_pa;
        SOLVED
            .iter()
            .map(move |solution| Break::kink(solution.x * complete, "solution of the table"))
            .chain([Break::kink(complete, "complete contact at p*")])
    }

    /// ln(p/p*) if it is below zero, else `None`.
    fn below_complete_contact(&self, pressure_pa: f64) -> Option<f64> {
        log_of_fraction(pressure_pa, self.complete_contact_pressure_pa)
    }
}

/// Fraction of the area at ln x < 0.
fn area_fraction(log_x: f64) -> f64 {
    let x = log_x.exp();
    if x < FIRST.x {
        light_area_fraction(x)
    } else if x > LAST.x {
        1.0 + (1.0 - LAST.area_fraction) / (1.0 - LAST.x) * log_x.exp_m1()
    } else {
        tables().log_area.at(log_x).0.exp()
    }
}

/// Hertz's area times its correction.
fn light_area_fraction(x: f64) -> f64 {
    let hertz = |x: f64| PI * (3.0 * x / (8.0 * PI)).cbrt().powi(2);
    let beyond_hertz = FIRST.area_fraction / hertz(FIRST.x) - 1.0;
    hertz(x) * (1.0 + beyond_hertz * (x / FIRST.x).cbrt())
}

/// Deformation over amplitude, and its derivative by ln x, at ln x < 0.
fn deformation_and_slope(log_x: f64) -> (f64, f64) {
    let x = log_x.exp();
    if x < FIRST.x {
        light_deformation_and_slope(x)
    } else if x > LAST.x {
        let left = -log_x.exp_m1();
        let gap = LAST.gap * (left / (1.0 - LAST.x)).powi(2) * (left / (1.0 - LAST.x)).sqrt();
        (1.0 - gap, 2.5 * gap * x / left)
    } else {
        let (log_ratio, slope) = tables().log_deformation_over_gap.at(log_x);
        let deformation = 1.0 / (1.0 + (-log_ratio).exp());
        (deformation, deformation * slope / (1.0 + log_ratio.exp()))
    }
}

/// Hertz's w/Delta = (6 sqrt(2) pi^2 x/8)^(2/3) times its correction, and the derivative by ln x.
fn light_deformation_and_slope(x: f64) -> (f64, f64) {
    let hertz = |x: f64| (0.75 * SQRT_2 * PI * PI * x).cbrt().powi(2);
    let beyond_hertz = FIRST.deformation() / hertz(FIRST.x) - 1.0;
    let share = beyond_hertz * (x / FIRST.x).cbrt();
    (hertz(x) * (1.0 + share), hertz(x) * (2.0 / 3.0 + share))
}

/// ln x at which the deformation over amplitude has a value in (0, 1): the inverse of [`deformation_and_slope`].
fn log_x_at(deformation: f64) -> f64 {
    if 1.0 - deformation < LAST.gap {
        return (-(1.0 - LAST.x) * ((1.0 - deformation) / LAST.gap).powf(0.4)).ln_1p();
    }
    let above = SOLVED.partition_point(|solution| solution.deformation() <= deformation);
    let (low, high) = if above == 0 {
        // The correction is below 4 %: Hertz bounds x from below, and 1.1 times that from above.
        let hertz = 1.5 * deformation.ln() - (0.75 * SQRT_2 * PI * PI).ln();
        (hertz - 1e-9, hertz + 0.1)
    } else {
        (SOLVED[above - 1].x.ln(), SOLVED[above.min(ROWS - 1)].x.ln())
    };
    newton_in_bracket(low, high, 0.5 * (low + high), |log_x| {
        let (value, slope) = deformation_and_slope(log_x);
        (value - deformation, slope)
    })
}

/// Interpolants over ln x.
struct Tables {
    log_area: MonotoneCubic,
    log_deformation_over_gap: MonotoneCubic,
}

fn tables() -> &'static Tables {
    static TABLES: OnceLock<Tables> = OnceLock::new();
    TABLES.get_or_init(|| {
        let log_x = column(|solution| solution.x.ln());
        Tables {
            log_area: MonotoneCubic::through(log_x.clone(), column(|solution| solution.area_fraction.ln())),
            log_deformation_over_gap: MonotoneCubic::through(
                log_x,
                column(|solution| (solution.deformation() / solution.gap).ln()),
            ),
        }
    })
}

fn column(of: fn(&Solution) -> f64) -> Vec<f64> {
    SOLVED.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ElasticBody, Hertz};

    fn pair() -> MaterialPair {
        MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap())
    }

    fn sinusoid() -> BemSinusoid {
        BemSinusoid::new(&pair(), 0.01)
    }

    #[test]
    fn the_solutions_are_met() {
        let law = sinusoid();
        for Solution { x, area_fraction: area, gap } in SOLVED {
            let pressure = x * law.complete_contact_pressure_pa();
            assert!((law.area_fraction(pressure) / area - 1.0).abs() < 1e-13, "{x}");
            assert!((law.deformation_over_amplitude(pressure) - (1.0 - gap)).abs() < 1e-13, "{x}");
        }
    }

    #[test]
    fn area_and_deformation_rise_without_jumps_to_complete_contact() {
        let law = sinusoid();
        let mut last = (0.0, 0.0);
        for i in -7000..=0 {
            let pressure = (f64::from(i) / 500.0).exp() * law.complete_contact_pressure_pa();
            let now = (law.area_fraction(pressure), law.deformation_over_amplitude(pressure));
            assert!(now.0 >= last.0 && now.1 >= last.1, "{i}: {last:?} {now:?}");
            assert!(i == -7000 || (now.0 / last.0 < 1.01 && now.1 / last.1 < 1.01), "{i}");
            last = now;
        }
        assert_eq!(last, (1.0, 1.0));
    }

    #[test]
    fn light_contacts_are_hertzian_in_the_limit() {
        // lambda = 1, B = Delta = 0.01, eta = 2, R = (lambda/2 pi)^2/Delta
        let sphere = Hertz::new(&pair(), 1.0 / (0.01 * 4.0 * PI * PI));
        let law = sinusoid();
        for (ratio, within) in [(1e-12, 1e-4), (1e-6, 0.01), (5e-3, 0.07)] {
            let pressure = law.pressure_at_interference_pa(ratio);
            let hertz = 2.0 * sphere.force_n(0.01 * ratio);
            assert!((pressure / hertz - 1.0).abs() < within, "{ratio}: {}", pressure / hertz);
            let area = 2.0 * sphere.area_m2(0.01 * ratio);
            assert!((law.area_fraction(pressure) / area - 1.0).abs() < within, "{ratio}");
        }
    }

    #[test]
    fn the_second_solution_confirms_the_correction_to_hertz() {
        let (beyond_first, _) = light_deformation_and_slope(SOLVED[1].x);
        assert!((beyond_first / SOLVED[1].deformation() - 1.0).abs() < 1e-3, "{beyond_first}");
    }

    #[test]
    fn the_pressure_at_an_interference_inverts_the_deformation() {
        let law = sinusoid();
        for x in [1e-14, 9.9e-5, 1e-4, 2e-4, 0.0417, 0.35, 0.9, 0.989, 0.99, 0.995] {
            let pressure = x * law.complete_contact_pressure_pa();
            let back = law.pressure_at_interference_pa(law.deformation_over_amplitude(pressure));
            assert!((back / pressure - 1.0).abs() < 1e-9, "{x}: {back}");
            if x == LAST.x {
                continue; // where the slope changes
            }
            let step = 1e-6;
            let (low, high) =
                (deformation_and_slope(x.ln() - step).0, deformation_and_slope(x.ln() + step).0);
            let slope = deformation_and_slope(x.ln()).1;
            assert!(((high - low) / (2.0 * step) - slope).abs() < 1e-3 * slope + 1e-9, "{x}");
        }
        assert_eq!(law.pressure_at_interference_pa(1.0), law.complete_contact_pressure_pa());
    }
}
