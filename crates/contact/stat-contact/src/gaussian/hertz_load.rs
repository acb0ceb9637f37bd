//! The load of Gaussian heights under Hertz's law, in closed form.
//!
//! It is the parabolic cylinder function I(u) = Int_0^inf s^(3/2) exp(-(u+s)^2/2) ds, which few libraries have and
//! none to the last digits. Here it is interpolated in five stretches, each by one polynomial that errs by less than
//! its rounding.

use super::coefficients::{FAR, FROM_0_TO_3, FROM_3_TO_6, FROM_6_TO_9, NEAR};
use super::polynomial::value_and_slope;

/// Returns I(u), for positive u over exp(-u^2/2), and the mean of the height u + s under its weight.
pub(crate) fn load_and_mean_height(u: f64) -> (f64, f64) {
    if u >= 0.0 {
        let (load, mean_interference) = load_and_mean_interference(u);
        return (load, u + mean_interference);
    }
    if u < -9.0 {
        let (value, slope) = value_and_slope(&FAR, 81.0 / (u * u));
        return (value * -u * (-u).sqrt(), 162.0 * slope / (value * u * u * u) - 1.5 / u);
    }
    const HALF_WIDTH: f64 = 1.5;
    let t = |middle: f64| -(u + middle) / HALF_WIDTH;
    let (value, slope) = if u >= -3.0 {
        value_and_slope(&FROM_0_TO_3, t(1.5))
    } else if u >= -6.0 {
        value_and_slope(&FROM_3_TO_6, t(4.5))
    } else {
        value_and_slope(&FROM_6_TO_9, t(7.5))
    };
    (value, slope / (value * HALF_WIDTH))
}

/// Returns I(u), for positive u over exp(-u^2/2), and the mean of the interference s under its weight: F_5/2 over F_3/2. For
/// positive u it is -d/du of the logarithm of what is returned.
pub(crate) fn load_and_mean_interference(u: f64) -> (f64, f64) {
    if u < 0.0 {
        let (load, mean_height) = load_and_mean_height(u);
        return (load, mean_height - u);
    }
    let (value, slope) = value_and_slope(&NEAR, (u - 3.0) / (u + 3.0));
    let distance = 1.0 + u;
    let log_slope = slope / value * 6.0 / ((u + 3.0) * (u + 3.0)) - 2.5 / distance;
    (value / (distance * distance * distance.sqrt()), -log_slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn load_and_mean_height_agree_with_the_parabolic_cylinder_function() {
        // (u, I over the reference density, mean height)
        for (u, load, mean) in [
            (0.0, 1.077_900_274_770_464, 1.433_966_392_458_37),
            (1e-3, 1.076_355_948_476_227_5, 1.434_522_732_742_32),
            (0.5, 0.554_452_793_002_463, 1.731_542_687_037_71),
            (2.9375, 0.062_037_611_826_236_4, 3.593_612_142_587_94),
            (6.0, 0.013_501_874_200_971_079, 6.383_121_552_535_48),
            (20.0, 7.351_191_884_133_292e-4, 20.123_927_538_127_1),
            (60.0, 4.761_358_371_291_475e-5, 60.041_626_247_151_6),
            (-1e-3, 1.079_446_756_092_885, 1.433_410_213_523_23),
            (-1.5, 5.444_921_501_730_261, 0.788_953_555_357_491),
            (-3.0, 13.581_857_683_922_33, 0.471_764_491_919_31),
            (-5.5, 32.735_534_315_149_12, 0.268_215_051_942_598),
            (-8.5, 62.441_389_550_525_28, 0.175_249_152_339_066),
            (-9.25, 70.828_168_155_810_18, 0.161_214_436_138_183),
            (-60.0, 1_165.096_905_475_913_7, 0.024_996_527_777_576_7),
        ] {
            let found = load_and_mean_height(u);
            assert!((found.0 / load - 1.0).abs() < 1.5e-15, "I({u}) = {:e}", found.0);
            assert!((found.1 / mean - 1.0).abs() < 1e-13, "{u}: mean height {:e}", found.1);
        }
        assert!((load_and_mean_height(1000.0).0 / 4.203_725_021_034_813_4e-8 - 1.0).abs() < 1.5e-15);
        assert!((load_and_mean_height(-123_456.0).0 / 108_732_215.358_637_69 - 1.0).abs() < 1.5e-15);
    }

    #[test]
    fn the_stretches_meet() {
        for u in [0.0f64, -3.0, -6.0, -9.0] {
            let (below, above) = (load_and_mean_height(u.next_down()), load_and_mean_height(u.next_up()));
            assert!((below.0 / above.0 - 1.0).abs() < 2e-15, "{u}: {:e} and {:e}", below.0, above.0);
            assert!((below.1 / above.1 - 1.0).abs() < 1e-13, "{u}: {:e} and {:e}", below.1, above.1);
        }
    }
}
