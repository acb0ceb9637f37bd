//! Integrals over one straight segment of a profile.

use std::sync::LazyLock;

use numerics::GaussLegendre;

/// Computes sin(a)/a and its derivative for a >= 0, both to rounding.
///
/// The transform of a segment of length s, mean height m and rise r about its middle is
/// s [m sinc(a) + (i/2) r sinc'(a)] with a = qs/2.
pub(crate) fn sinc_and_derivative(a: f64) -> (f64, f64) {
    if a > 1.0 {
        let (sin, cos) = a.sin_cos();
        return (sin / a, (cos - sin / a) / a);
    }
    // The closed forms cancel here. sinc = Sum (-a^2)^k/(2k+1)!, sinc' = -a Sum (-a^2)^k 2(k+1)/(2k+3)!
    const TERMS: usize = 9;
    let square = a * a;
    let (mut sinc, mut derivative) = (1.0, 1.0);
    for k in (1..TERMS).rev() {
        let two_k = 2.0 * k as f64;
        sinc = 1.0 - square / (two_k * (two_k + 1.0)) * sinc;
        derivative = 1.0 - square / (two_k * (two_k + 3.0)) * derivative;
    }
    (sinc, -a / 3.0 * derivative)
}

static SIX_POINTS: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(6));

/// Computes the mean of a function over 0..1 in parts of equal width. Exact for polynomials up to the eleventh degree,
/// and to rounding for products of quadratics with cos(2 theta) if a part spans at most half a radian of theta.
pub(crate) fn mean_over_unit(parts: usize, function: impl Fn(f64) -> f64) -> f64 {
    let width = 1.0 / parts as f64;
    let part = |part: usize| -> f64 {
        let (from, to) = (part as f64 * width, (part as f64 + 1.0) * width);
        SIX_POINTS.over(from, to).map(|(node, weight)| weight * function(node)).sum()
    };
    (0..parts).map(part).sum()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn the_series_joins_the_closed_form_and_keeps_its_digits() {
        // Reference values with 40 digits from the power series.
        for (a, sinc, derivative) in [
            (1e-8, 1.0, -3.333_333_333_333_333e-9),
            (0.1, 0.998_334_166_468_281_5, -0.033_300_011_902_557_57),
            (1.0, 0.841_470_984_807_896_5, -0.301_168_678_939_756_8),
            (1.5, 0.664_996_657_736_036_3, -0.396_172_970_712_222_1),
        ] {
            let found = sinc_and_derivative(a);
            assert_relative_eq!(found.0, sinc, max_relative = 4e-16);
            assert_relative_eq!(found.1, derivative, max_relative = 8e-16);
        }
        assert_eq!(sinc_and_derivative(0.0), (1.0, 0.0));
    }

    #[test]
    fn the_rule_integrates_polynomials_and_cosines_to_rounding() {
        assert_relative_eq!(mean_over_unit(1, |x| x.powi(11)), 1.0 / 12.0, max_relative = 1e-15);
        let exact = 0.5f64.sin() / 0.5; // cos(2 theta) over half a radian of 2 theta
        assert_relative_eq!(mean_over_unit(1, |x| (0.5 * x).cos()), exact, max_relative = 1e-15);
        assert_relative_eq!(mean_over_unit(13, |x| (6.0 * x).cos()), 6f64.sin() / 6.0, max_relative = 1e-14);
    }
}
