//! An elastic summit of two curvatures on a flat: the contact ellipse of Hertz (1882), as used by Bush, Gibson &
//! Thomas (1975).

use std::f64::consts::FRAC_PI_2;

use numerics::zero_in_bracket;

/// Ellipse in which a flat touches an elastic summit of principal curvatures k1 >= k2 > 0 (Johnson, Contact
/// Mechanics, 1985, section 4.2; `docs/theory/models.md`, section 2.8).
///
/// Both factors compare it with the sphere of the mean curvature (k1 + k2)/2, and are 1 for k1 = k2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzEllipse {
    /// Minor over major axis, sqrt(1 - e^2).
    axis_ratio: f64,
    /// Complete elliptic integral K(e).
    first_integral: f64,
    /// (K - E)/K - e^2/2, of the order of e^4.
    remainder: f64,
}

impl HertzEllipse {
    /// Creates the ellipse of a summit whose principal curvatures have the ratio k1/k2, given as ln(k1/k2) from 0 to
    /// 60.
    #[must_use]
    pub fn from_curvatures(log_curvature_ratio: f64) -> Self {
        // ln(k1/k2) is 3/2 of -ln(b/a) for nearly round ellipses, and nearly twice it for slender ones.
        let [least, most] = [0.5, 1.0].map(|share| share * log_curvature_ratio);
        let missing = |slenderness: f64| {
            Self::from_axes((-slenderness).exp()).log_curvature_ratio() - log_curvature_ratio
        };
        Self::from_axes((-zero_in_bracket(least, most, missing)).exp())
    }

    /// Creates the ellipse of a ratio of minor to major axis in (0, 1].
    #[must_use]
    pub fn from_axes(axis_ratio: f64) -> Self {
        debug_assert!(0.0 < axis_ratio && axis_ratio <= 1.0);
        // Means of 1 and a number above 1e-9 agree to rounding after at most seven steps.
        const STEPS: usize = 8;
        let (mut arithmetic, mut geometric) = (1.0, axis_ratio);
        let (mut remainder, mut power) = (0.0, 1.0);
        for _ in 0..STEPS {
            let half_difference = 0.5 * (arithmetic - geometric);
            remainder += power * half_difference * half_difference;
            power *= 2.0;
            (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
        }
        HertzEllipse { axis_ratio, first_integral: FRAC_PI_2 / arithmetic, remainder }
    }

    /// Inverts [`from_curvatures`](Self::from_curvatures): returns ln(k1/k2), with k1/k2 = \[E/(1 - e^2) - K\]/(K -
    /// E).
    #[must_use]
    pub fn log_curvature_ratio(&self) -> f64 {
        let (square, half) = (self.axis_ratio * self.axis_ratio, 0.5 * self.eccentricity_squared());
        if half == 0.0 {
            return 0.0;
        }
        // Both brackets vanish with e^2 and differ by e^4: their difference is written out.
        let difference = 2.0 * half * half - self.remainder * (1.0 + square);
        let quotient = difference / (half + self.remainder);
        // The ratio of slender ellipses is so large that its logarithm needs no care.
        if square > 0.1 {
            (quotient / square).ln_1p()
        } else {
            (quotient + square).ln() - 2.0 * self.axis_ratio.ln()
        }
    }

    /// Area over pi w/t, the area of the sphere of the mean curvature t at the interference w: E/(K sqrt(1 - e^2)).
    #[must_use]
    pub fn area_factor(&self) -> f64 {
        self.second_over_first() / self.axis_ratio
    }

    /// Force over (4/3) E* w^(3/2)/sqrt(t): (pi/2) sqrt(E/K^3)/sqrt(1 - e^2).
    #[must_use]
    pub fn force_factor(&self) -> f64 {
        FRAC_PI_2 * self.second_over_first().sqrt() / (self.first_integral * self.axis_ratio)
    }

    fn eccentricity_squared(&self) -> f64 {
        (1.0 - self.axis_ratio) * (1.0 + self.axis_ratio)
    }

    /// Ratio E/K of the complete elliptic integrals.
    fn second_over_first(&self) -> f64 {
        1.0 - 0.5 * self.eccentricity_squared() - self.remainder
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ellipses_agree_with_twenty_digits() {
        // (b/a, ln(k1/k2), area factor, force factor)
        for (axis_ratio, log_ratio, area, force) in [
            (0.9999, 1.500_075_005_155_648_3e-4, 1.000_000_002_500_25, 1.000_000_001_875_187_5),
            (0.8, 0.334_888_397_869_427_3, 1.012_480_589_851_504_2, 1.009_353_186_079_091_2),
            (0.3, 1.830_982_726_605_184_9, 1.390_882_924_850_680_4, 1.287_112_880_844_183_8),
            (0.01, 7.602_316_389_154_986, 16.694_645_203_204_49, 10.711_898_144_378_36),
            (1e-6, 24.977_652_052_413_4, 65_781.662_462_444_13, 26_501.908_149_888_75),
        ] {
            let ellipse = HertzEllipse::from_axes(axis_ratio);
            assert!((ellipse.log_curvature_ratio() / log_ratio - 1.0).abs() < 1e-11, "{ellipse:?}");
            assert!((ellipse.area_factor() / area - 1.0).abs() < 1e-14, "{ellipse:?}");
            assert!((ellipse.force_factor() / force - 1.0).abs() < 1e-14, "{ellipse:?}");
            let same = HertzEllipse::from_curvatures(log_ratio);
            assert!((same.axis_ratio / axis_ratio - 1.0).abs() < 1e-13, "{same:?}");
        }
    }

    #[test]
    fn equal_curvatures_make_a_circle() {
        for ellipse in [HertzEllipse::from_axes(1.0), HertzEllipse::from_curvatures(0.0)] {
            assert_eq!((ellipse.log_curvature_ratio(), ellipse.area_factor()), (0.0, 1.0));
            assert!((ellipse.force_factor() - 1.0).abs() < 1e-15);
        }
    }
}
