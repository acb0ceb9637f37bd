//! Corrected forms of the elastic theory: fits to simulations, each an effective variance V_e in A = erf(p/sqrt(2
//! V_e)).
//!
//! They account for drift, re-entry and slower diffusion of the stress, which are sizeable and largely cancel (Dapp,
//! Prodanov & Mueser 2014, J. Phys.: Condens. Matter 26:355002).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use numerics::{GaussLegendre, newton_in_bracket};
use serde::{Deserialize, Serialize};
use units::named;

/// Corrected form of the elastic theory, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Correction {
    /// Wang & Mueser (2017), Tribol. Lett. 65:103: dV_e = S(A) dV, S = 5/9 - (2/9) A^2 + (2/3) A^4.
    WangMuser,
    /// Yang & Persson (2008), J. Phys.: Condens. Matter 20:215214: dV_e = S(A) dV, S = g + (1 - g) A^2, g = 0.45.
    YangPersson,
    /// Xu et al. (2024): V_e = \[g + (1 - g) A\] V, g = 0.45.
    Algebraic,
    /// V_e = \[g + (1 - g) A\] V with g = 0.4244 + 0.0357 ln(alpha), alpha = m0 m4/m2^2, fitted to this project's
    /// boundary elements.
    AlgebraicNayak,
}

named!(Correction, "correction", {
    WangMuser => "wang-muser",
    YangPersson => "yang-persson",
    Algebraic => "algebraic",
    AlgebraicNayak => "algebraic-nayak",
});

/// Published g of `yang-persson` and `algebraic`.
const PUBLISHED: f64 = 0.45;

impl Correction {
    /// Range of alpha = m0 m4/m2^2 of the boundary elements that the forms were fitted to or compared with.
    pub const FITTED_ALPHA: [f64; 2] = [1.5, 140.0];

    /// Returns the effective variance \[Pa^2\] at each of some non-decreasing variances, under a nominal pressure p >
    /// 0 \[Pa\]. `alpha` is Nayak's m0 m4/m2^2 at each of them.
    #[must_use]
    pub fn effective_variances_pa2(self, pressure_pa: f64, variances_pa2: &[f64], alpha: &[f64]) -> Vec<f64> {
        let algebraic = |g: f64, variance_pa2: f64| algebraic_variance_pa2(g, pressure_pa, variance_pa2);
        match self.form() {
            Form::Differential(slowness) => marched(pressure_pa, variances_pa2, slowness),
            Form::Algebraic(factor) => {
                let of_place = |(&variance_pa2, &alpha)| algebraic(factor(alpha)[0], variance_pa2);
                variances_pa2.iter().zip(alpha).map(of_place).collect()
            }
        }
    }

    /// Returns the factor g of [`AlgebraicNayak`](Self::AlgebraicNayak) for Nayak's alpha = m0 m4/m2^2, at most 1.
    #[must_use]
    pub fn factor_of_nayak(alpha: f64) -> f64 {
        nayak(alpha)[0]
    }

    fn form(self) -> Form {
        match self {
            Correction::WangMuser => Form::Differential(|area| {
                let square = area * area;
                5.0 / 9.0 - 2.0 / 9.0 * square + 2.0 / 3.0 * square * square
            }),
            Correction::YangPersson => Form::Differential(|area| PUBLISHED + (1.0 - PUBLISHED) * area * area),
            Correction::Algebraic => Form::Algebraic(|_| [PUBLISHED, 0.0]),
            Correction::AlgebraicNayak => Form::Algebraic(nayak),
        }
    }
}

/// Equation that determines the effective variance of a corrected form.
enum Form {
    /// dV_e = S(A) dV, as the function S(A).
    Differential(fn(f64) -> f64),
    /// V_e = \[g + (1 - g) A\] V, as g and dg/dln(alpha) of alpha.
    Algebraic(fn(f64) -> [f64; 2]),
}

/// Flattened variance at which the contact has come down to a share A.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlattenedVariance {
    /// V/p^2.
    pub(crate) variance_over_square_pressure: f64,
    /// Derivative of V/p^2 by A, below 0.
    pub(crate) per_area: f64,
    /// Derivative of V/p^2 by ln(alpha).
    pub(crate) per_ln_alpha: f64,
}

/// Flattened variance at which A = erf(`argument`), argument > 0, by the theory or by a corrected form.
pub(crate) fn flattened(correction: Option<Correction>, argument: f64, alpha: f64) -> FlattenedVariance {
    let area = libm::erf(argument);
    // V_e/p^2 = 1/(2 x^2), and dA = (2/sqrt(pi)) exp(-x^2) dx.
    let effective = 0.5 / (argument * argument);
    let effective_per_area = -0.5 * PI.sqrt() * (argument * argument).exp() / argument.powi(3);
    match correction.map(Correction::form) {
        None => FlattenedVariance {
            variance_over_square_pressure: effective,
            per_area: effective_per_area,
            per_ln_alpha: 0.0,
        },
        Some(Form::Differential(slowness)) => FlattenedVariance {
            variance_over_square_pressure: variance_of(&rule(), 0.0, effective, slowness),
            per_area: effective_per_area / slowness(area),
            per_ln_alpha: 0.0,
        },
        Some(Form::Algebraic(factor)) => {
            let [g, g_per_ln_alpha] = factor(alpha);
            let slowing = g + (1.0 - g) * area;
            let variance = effective / slowing;
            FlattenedVariance {
                variance_over_square_pressure: variance,
                per_area: (effective_per_area - variance * (1.0 - g)) / slowing,
                per_ln_alpha: -variance * libm::erfc(argument) / slowing * g_per_ln_alpha,
            }
        }
    }
}

/// Effective variance \[Pa^2\] of the algebraic forms: solves V_e = \[g + (1 - g) A(V_e)\] V for 0 < g <= 1, a
/// nominal pressure p > 0 \[Pa\] and a variance V >= 0 \[Pa^2\]. Fits of g use it.
#[must_use]
pub fn algebraic_variance_pa2(g: f64, pressure_pa: f64, variance_pa2: f64) -> f64 {
    variance_pa2 * slowing(g, pressure_pa, variance_pa2)
}

/// g of `algebraic-nayak`, at most 1, and its derivative by ln(alpha).
fn nayak(alpha: f64) -> [f64; 2] {
    const PER_LN_ALPHA: f64 = 0.0357;
    let g = 0.4244 + PER_LN_ALPHA * alpha.ln();
    if g < 1.0 { [g, PER_LN_ALPHA] } else { [1.0, 0.0] }
}

/// Solves V_e/V = g + (1 - g) A(V_e).
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

/// V_e along the variances where dV_e = S(A) dV: inverts the quadrature V(V_e) = Int dV_e/S step by step.
fn marched(pressure_pa: f64, variances_pa2: &[f64], slowness: fn(f64) -> f64) -> Vec<f64> {
    let rule = rule();
    let unit_pa2 = pressure_pa * pressure_pa;
    let (mut reached, mut at) = (0.0, 0.0);
    let step = |&variance_pa2: &f64| {
        let target = variance_pa2 / unit_pa2 - reached;
        let start = at;
        if target > 0.0 {
            // 0 < S <= 1.
            at = newton_in_bracket(
                start,
                start + target,
                start + target / variance_rate(slowness, start + target),
                |t| (variance_of(&rule, start, t, slowness) - target, variance_rate(slowness, t)),
            );
            reached += target;
        }
        at * unit_pa2
    };
    variances_pa2.iter().map(step).collect()
}

/// Ten nodes for each of [`stretches`].
fn rule() -> GaussLegendre {
    GaussLegendre::new(10)
}

/// Growth of V/p^2 as V_e/p^2 grows.
fn variance_of(rule: &GaussLegendre, from: f64, to: f64, slowness: fn(f64) -> f64) -> f64 {
    let over = |[a, b]: [f64; 2]| -> f64 {
        rule.over(a, b).map(|(t, weight)| weight * variance_rate(slowness, t)).sum()
    };
    stretches(from, to).map(over).sum()
}

/// dV/dV_e = 1/S at V_e/p^2.
fn variance_rate(slowness: fn(f64) -> f64, effective: f64) -> f64 {
    slowness(libm::erf(FRAC_1_SQRT_2 / effective.sqrt())).recip()
}

/// Intervals on which S is smooth: below 1/80 it is 1 to rounding, above it varies with the logarithm of V_e/p^2.
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
        let effective =
            Correction::Algebraic.effective_variances_pa2(0.7, &variances_pa2(), &[2.0; SPREADS_PA.len()]);
        for (effective, variance) in effective.iter().zip(variances_pa2()) {
            let area = libm::erf(FRAC_1_SQRT_2 * 0.7 / effective.sqrt());
            assert!((effective / ((0.45 + 0.55 * area) * variance) - 1.0).abs() < 1e-14);
        }
    }
    #[test]
    fn the_flattened_variance_leaves_its_share_in_contact() {
        let forms = std::iter::once(None).chain(Correction::ALL.iter().copied().map(Some));
        for correction in forms {
            let alpha = 30.0;
            for argument in [1e-6, 0.1, 0.39, 1.5, 4.0] {
                let found = flattened(correction, argument, alpha);
                let variance_pa2 = 0.49 * found.variance_over_square_pressure;
                let effective_pa2 = match correction {
                    Some(correction) => correction.effective_variances_pa2(0.7, &[variance_pa2], &[alpha])[0],
                    None => variance_pa2,
                };
                assert!(
                    (0.7 / (2.0 * effective_pa2).sqrt() / argument - 1.0).abs() < 1e-12,
                    "{correction:?}"
                );
                let step = 1e-4 * argument;
                let [more, less] = [argument + step, argument - step]
                    .map(|x| (flattened(correction, x, alpha).variance_over_square_pressure, libm::erf(x)));
                let per_area = (more.0 - less.0) / (more.1 - less.1);
                assert!((found.per_area / per_area - 1.0).abs() < 1e-5, "{correction:?} {argument}");
                let [more, less] = [1e-5f64, -1e-5].map(|ln| {
                    flattened(correction, argument, alpha * ln.exp()).variance_over_square_pressure
                });
                let per_ln_alpha = (more - less) / 2e-5;
                assert!(
                    (found.per_ln_alpha - per_ln_alpha).abs() < 1e-7 * found.variance_over_square_pressure,
                    "{correction:?} {argument}"
                );
            }
        }
    }
}
