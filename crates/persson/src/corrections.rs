//! Corrected forms of the elastic theory: fits to simulations, each by an effective variance V_e in A = erf(p/sqrt(2 V_e)).
//!
//! They stand in for drift, re-entry and slower diffusion of the stress, which are sizeable and largely cancel (Dapp,
//! Prodanov & Mueser 2014, J. Phys.: Condens. Matter 26:355002).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use numerics::{GaussLegendre, newton_in_bracket};
use serde::{Deserialize, Serialize};
use units::named;

/// A corrected form by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Correction {
    /// dV_e = S(A) dV, S = 5/9 - (2/9) A^2 + (2/3) A^4: Wang & Mueser (2017), Tribol. Lett. 65:103.
    WangMuser,
    /// dV_e = S(A) dV, S = g + (1 - g) A^2, g = 0.45: Yang & Persson (2008), J. Phys.: Condens. Matter 20:215214.
    YangPersson,
    /// V_e = \[g + (1 - g) A\] V, g = 0.45: Xu et al. (2024).
    Algebraic,
    /// The same with g = 0.4244 + 0.0357 ln(alpha), alpha = m0 m4/m2^2, fitted to this project's boundary elements.
    AlgebraicNayak,
}

named!(Correction, "correction", {
    WangMuser => "wang-muser",
    YangPersson => "yang-persson",
    Algebraic => "algebraic",
    AlgebraicNayak => "algebraic-nayak",
});

/// g of `yang-persson` and `algebraic` as published.
const PUBLISHED: f64 = 0.45;

impl Correction {
    /// The range of alpha = m0 m4/m2^2 of the boundary elements that the forms were fitted to or compared with.
    pub const FITTED_ALPHA: [f64; 2] = [1.5, 140.0];

    /// The effective variance \[Pa^2\] at each of some variances that do not fall, under a nominal pressure p > 0 \[Pa\].
    /// `alpha` is Nayak's m0 m4/m2^2 at each of them.
    #[must_use]
    pub fn effective_variances_pa2(self, pressure_pa: f64, variances_pa2: &[f64], alpha: &[f64]) -> Vec<f64> {
        let algebraic = |g: f64, variance_pa2: f64| algebraic_variance_pa2(g, pressure_pa, variance_pa2);
        match self {
            Correction::WangMuser => marched(pressure_pa, variances_pa2, |area| {
                let square = area * area;
                5.0 / 9.0 - 2.0 / 9.0 * square + 2.0 / 3.0 * square * square
            }),
            Correction::YangPersson => {
                marched(pressure_pa, variances_pa2, |area| PUBLISHED + (1.0 - PUBLISHED) * area * area)
            }
            Correction::Algebraic => variances_pa2.iter().map(|&v| algebraic(PUBLISHED, v)).collect(),
            Correction::AlgebraicNayak => {
                variances_pa2.iter().zip(alpha).map(|(&v, &alpha)| algebraic(nayak(alpha), v)).collect()
            }
        }
    }
}

/// The effective variance \[Pa^2\] of the algebraic forms, V_e = \[g + (1 - g) A\] V with A that of V_e, for 0 < g <= 1, a
/// nominal pressure p > 0 \[Pa\] and a variance V >= 0 \[Pa^2\]: what their g is fitted with.
#[must_use]
pub fn algebraic_variance_pa2(g: f64, pressure_pa: f64, variance_pa2: f64) -> f64 {
    variance_pa2 * slowing(g, pressure_pa, variance_pa2)
}

/// g of `algebraic-nayak`, at most 1.
fn nayak(alpha: f64) -> f64 {
    (0.4244 + 0.0357 * alpha.ln()).min(1.0)
}

/// V_e/V = g + (1 - g) A, with A that of V_e.
fn slowing(g: f64, pressure_pa: f64, variance_pa2: f64) -> f64 {
    let b = FRAC_1_SQRT_2 * pressure_pa / variance_pa2.sqrt();
    if !b.is_finite() {
        return 1.0;
    }
    newton_in_bracket(g, 1.0, g + (1.0 - g) * libm::erf(b), |x: f64| {
        let argument = b / x.sqrt();
        let slope = 1.0 + (1.0 - g) / PI.sqrt() * (-argument * argument).exp() * argument / x;
        (x - g - (1.0 - g) * libm::erf(argument), slope)
    })
}

/// V_e along the variances where dV_e = S(A) dV: by V(V_e) = Int dV_e/S, which is a quadrature, inverted step by step.
fn marched(pressure_pa: f64, variances_pa2: &[f64], slowness: impl Fn(f64) -> f64) -> Vec<f64> {
    let rule = GaussLegendre::new(10);
    let unit_pa2 = pressure_pa * pressure_pa;
    let inverse = |t: f64| slowness(libm::erf(FRAC_1_SQRT_2 / t.sqrt())).recip();
    let integral =
        |from: f64, to: f64| stretches(from, to).map(|[a, b]| sum(&rule, a, b, inverse)).sum::<f64>();
    let (mut reached, mut at) = (0.0, 0.0);
    let step = |&variance_pa2: &f64| {
        let target = variance_pa2 / unit_pa2 - reached;
        let start = at;
        if target > 0.0 {
            // S lies between 0 and 1.
            at = newton_in_bracket(start, start + target, start + target / inverse(start + target), |t| {
                (integral(start, t) - target, inverse(t))
            });
            reached += target;
        }
        at * unit_pa2
    };
    variances_pa2.iter().map(step).collect()
}

fn sum(rule: &GaussLegendre, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    rule.over(from, to).map(|(t, weight)| weight * f(t)).sum()
}

/// What S is smooth on: below 1/80 it is 1 to rounding, above it changes with the logarithm of V_e/p^2.
fn stretches(from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
    const CONTACT: f64 = 1.0 / 80.0;
    const RATIO: f64 = 1.5;
    let mut start = from;
    std::iter::from_fn(move || {
        if start >= to {
            return None;
        }
        let begin = start;
        start = to.min(if begin < CONTACT { CONTACT } else { begin * RATIO });
        Some([begin, start])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPREADS_PA: [f64; 8] = [1e-3, 0.03, 0.1, 0.2, 0.5, 1.0, 3.0, 1e3];

    fn variances_pa2() -> Vec<f64> {
        SPREADS_PA.iter().map(|s| s * s).collect()
    }

    #[test]
    fn near_full_contact_nothing_is_corrected_and_at_light_loads_the_factor_is_constant() {
        let alpha = [139.8; SPREADS_PA.len()];
        let light = [
            (Correction::WangMuser, 5.0 / 9.0),
            (Correction::YangPersson, 0.45),
            (Correction::Algebraic, 0.45),
            (Correction::AlgebraicNayak, 0.4244 + 0.0357 * 139.8f64.ln()),
        ];
        for (correction, factor) in light {
            let effective = correction.effective_variances_pa2(1.0, &variances_pa2(), &alpha);
            assert!((effective[1] / variances_pa2()[1] - 1.0).abs() < 1e-12, "{correction}");
            assert!((effective[7] / variances_pa2()[7] / factor - 1.0).abs() < 2e-3, "{correction}");
            assert!(effective.is_sorted());
        }
    }

    #[test]
    fn marching_meets_its_equation_and_does_not_depend_on_its_steps() {
        let effective =
            |to: &[f64]| *Correction::WangMuser.effective_variances_pa2(0.7, to, &[]).last().unwrap();
        let (v, dv) = (0.8, 1e-4);
        let slope = (effective(&[v + dv]) - effective(&[v - dv])) / (2.0 * dv);
        let area = libm::erf(FRAC_1_SQRT_2 * 0.7 / effective(&[v]).sqrt());
        let slowness = 5.0 / 9.0 - 2.0 / 9.0 * area.powi(2) + 2.0 / 3.0 * area.powi(4);
        assert!((slope / slowness - 1.0).abs() < 1e-7, "{slope} {slowness}");
        let stepped: Vec<f64> = (1..=40).map(|i| 0.02 * f64::from(i)).collect();
        assert!((effective(&stepped) / effective(&[v]) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn the_algebraic_form_is_implicit_in_its_own_area() {
        let effective = Correction::Algebraic.effective_variances_pa2(0.7, &variances_pa2(), &[]);
        for (effective, variance) in effective.iter().zip(variances_pa2()) {
            let area = libm::erf(FRAC_1_SQRT_2 * 0.7 / effective.sqrt());
            assert!((effective / ((0.45 + 0.55 * area) * variance) - 1.0).abs() < 1e-14);
        }
    }
}
