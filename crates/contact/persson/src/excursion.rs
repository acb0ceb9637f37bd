//! The part of a Gaussian surface that stands above a level: heights z are in units of their standard deviation, with the density
//! phi(z) = exp(-z^2/2)/sqrt(2 pi).

use std::f64::consts::PI;
use std::sync::LazyLock;

use numerics::GaussLegendre;
use numerics::gaussian::{density, share_above};

/// Height above the level, in standard deviations, beyond which nothing counts beside what is lower.
const HIGHEST: f64 = 8.0;

/// Mean distance from the level down to the surface where that is lower, phi(t) + t \[1 - Q(t)\] at a level t.
pub(crate) fn mean_depth_below(level: f64) -> f64 {
    density(level) + level * share_above(-level)
}

/// Mean of (z - t)^(-1/2) over the surface above a level t, and its fall with the level, -d ln/dt. Rigid punches as high as the
/// summits carry in proportion to their radii, as this weight does.
pub(crate) fn punch_load(level: f64) -> [f64; 2] {
    static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(48));
    // With z = t + s^2 the root cancels.
    let end = (HIGHEST - level).max(3.0).sqrt();
    let [mut load, mut fall] = [0.0; 2];
    for (s, weight) in RULE.over(0.0, end) {
        let z = level + s * s;
        let of_z = 2.0 * weight * density(z);
        load += of_z;
        fall += z * of_z;
    }
    [load, fall / load]
}

/// Mean of the product of (z - t)^(-1/2) at two points, both above a level t, whose heights have the correlation rho < 1.
///
/// Over u = (z_1 + z_2)/2 - t, with the difference of the heights integrated:
/// Int_0^inf exp(-(t + u)^2/(1 + rho)) I_0(b) exp(-b)/sqrt(1 - rho^2) du, b = u^2/\[2 (1 - rho)\].
pub(crate) fn punch_pairs(level: f64, uncorrelated: f64) -> f64 {
    static RULE: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
        // Nodes in the cube root are dense at small u, where the integrand bends over sqrt(1 - rho).
        GaussLegendre::new(32).over(0.0, 1.0).map(|(s, weight)| [s.powi(3), 3.0 * s * s * weight]).collect()
    });
    let end = (HIGHEST - level).max(3.0);
    let alike = 2.0 - uncorrelated;
    let sum: f64 = RULE
        .iter()
        .map(|&[share, weight]| {
            let (u, b) = (end * share, (end * share).powi(2) / (2.0 * uncorrelated));
            weight * (-(level + u).powi(2) / alike).exp() * bessel_i0_scaled(b)
        })
        .sum();
    end * sum / (alike * uncorrelated).sqrt()
}

/// Modified Bessel function I_0(x) exp(-x) of x >= 0, to rounding.
fn bessel_i0_scaled(x: f64) -> f64 {
    /// From here on the asymptotic series has terms below rounding.
    const FAR: f64 = 25.0;
    let (mut term, mut sum) = (1.0, 1.0);
    if x < FAR {
        // Sum of (x/2)^(2 k)/(k!)^2.
        for k in 1..60 {
            term *= (0.5 * x / f64::from(k)).powi(2);
            sum += term;
            if term < 1e-17 * sum {
                break;
            }
        }
        return sum * (-x).exp();
    }
    // Sum of [1 3 5 ... (2 k - 1)]^2/(k! (8 x)^k).
    for k in 1..30 {
        let odd = f64::from(2 * k - 1);
        term *= odd * odd / (f64::from(k) * 8.0 * x);
        sum += term;
        if term < 1e-17 * sum {
            break;
        }
    }
    sum / (2.0 * PI * x).sqrt()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn the_depth_below_a_level_is_its_mean_over_the_lower_heights() {
        let rule = GaussLegendre::new(120);
        for level in [-2.0, -0.3, 1.0, 4.0] {
            let depth = |(z, weight): (f64, f64)| weight * (level - z) * density(z);
            let integral: f64 = rule.over(-12.0, level).map(depth).sum();
            assert!((mean_depth_below(level) / integral - 1.0).abs() < 1e-12, "{level}");
        }
    }

    #[test]
    fn bessel_functions_agree_with_their_integral() {
        let rule = GaussLegendre::new(200);
        for x in [0.0, 0.3, 7.0, 24.999, 25.001, 900.0] {
            let integral: f64 =
                rule.over(0.0, PI).map(|(angle, weight)| weight * (x * (angle.cos() - 1.0)).exp()).sum();
            assert!((bessel_i0_scaled(x) * PI / integral - 1.0).abs() < 1e-13, "{x}");
        }
    }

    #[test]
    fn pairs_far_apart_are_independent_and_near_ones_share_their_heights() {
        for level in [-1.0, 0.5, 3.0] {
            let [load, fall] = punch_load(level);
            let [above, below] = [1e-4, -1e-4].map(|step| punch_load(level + step)[0].ln());
            assert!(((below - above) / 2e-4 / fall - 1.0).abs() < 1e-6, "{level}: {fall}");
            let far = punch_pairs(level, 1.0) / load.powi(2);
            assert!((far - 1.0).abs() < 1e-5, "{level}: {far}");
        }
        // By brute force over both heights, with z = t + s^2 at each.
        let (level, correlation) = (0.7, 0.8f64);
        let rule = GaussLegendre::new(200);
        let of_both = |a: f64, b: f64| {
            let square = a * a + b * b - 2.0 * correlation * a * b;
            let uncorrelated = 1.0 - correlation * correlation;
            (-0.5 * square / uncorrelated).exp() / (TAU * uncorrelated.sqrt())
        };
        let mut sum = 0.0;
        for (first, weight) in rule.over(0.0, 2.7) {
            for (second, of_second) in rule.over(0.0, 2.7) {
                sum += 4.0 * weight * of_second * of_both(level + first * first, level + second * second);
            }
        }
        assert!((punch_pairs(level, 1.0 - correlation) / sum - 1.0).abs() < 1e-6);
    }
}
