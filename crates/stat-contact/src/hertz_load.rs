//! Area and pressure of a Gaussian population of Hertz's spheres, in closed form.
//!
//! The load is the parabolic cylinder function I(u) = Int_0^inf s^(3/2) exp(-(u+s)^2/2) ds, of which few libraries know
//! the like and none to the last digits; the area is [`first_moment`]. Here I(u) is interpolated in five stretches, each by
//! one polynomial that errs by less than its rounding; `tests/reference/make_hertz_load.py` makes the coefficients.

use crate::asperities::Hertzian;
use crate::cell::error_estimate;
use crate::frame::Sums;
use crate::gaussian::{DENSITY_SCALE, Window, first_moment};

/// The integrals at every separation at which no asperity within reach leaves Hertz's law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HertzIntegrals {
    pressure_pa: f64,
    area_fraction: f64,
    /// The interference, in units of sigma_s, up to which the law is Hertz's.
    until: f64,
}

impl HertzIntegrals {
    /// `None` where asperities at the highest interference that counts, in units of sigma_s, are no longer Hertz's.
    pub fn of(hertz: &Hertzian, sigma_s_m: f64, highest: impl FnOnce() -> f64) -> Option<Self> {
        let until = hertz.until_m / sigma_s_m;
        (until == f64::INFINITY || highest() <= until).then(|| HertzIntegrals {
            pressure_pa: DENSITY_SCALE * hertz.pressure_per_three_halves * sigma_s_m * sigma_s_m.sqrt(),
            area_fraction: hertz.area_per_m * sigma_s_m,
            until,
        })
    }

    /// The integrals at the separation u, over the reference density.
    pub fn sums_at(&self, u: f64) -> Sums {
        let (load, mean) = load_and_mean_height(u);
        // Integration by parts leads the higher means back to the first.
        let square = 2.5 + u * mean;
        let cube = 3.5 * mean + 1.5 * u + u * u * mean;
        Sums::new(self.pressure_pa * load, self.area_fraction * first_moment(u), [mean, square, cube])
    }

    /// Estimate of their relative error.
    pub fn relative_error(&self, u: f64) -> f64 {
        let other_law =
            if self.until == f64::INFINITY { 0.0 } else { Window::up_to(self.until).left_out(u, false) };
        error_estimate(other_law, u)
    }
}

/// I(u), for positive u over exp(-u^2/2), and the mean of the height u + s that it weighs.
fn load_and_mean_height(u: f64) -> (f64, f64) {
    if u >= 0.0 {
        let (value, slope) = polynomial(&NEAR, (u - 3.0) / (u + 3.0));
        let distance = 1.0 + u;
        let log_slope = slope / value * 6.0 / ((u + 3.0) * (u + 3.0)) - 2.5 / distance;
        return (value / (distance * distance * distance.sqrt()), u - log_slope);
    }
    if u < -9.0 {
        let (value, slope) = polynomial(&FAR, 81.0 / (u * u));
        return (value * -u * (-u).sqrt(), 162.0 * slope / (value * u * u * u) - 1.5 / u);
    }
    const HALF_WIDTH: f64 = 1.5;
    let t = |middle: f64| -(u + middle) / HALF_WIDTH;
    let (value, slope) = if u >= -3.0 {
        polynomial(&FROM_0_TO_3, t(1.5))
    } else if u >= -6.0 {
        polynomial(&FROM_3_TO_6, t(4.5))
    } else {
        polynomial(&FROM_6_TO_9, t(7.5))
    };
    (value, slope / (value * HALF_WIDTH))
}

/// A polynomial and its derivative, in four sums over every fourth power, which do not wait for one another.
#[inline(always)]
fn polynomial(coefficients: &[f64], t: f64) -> (f64, f64) {
    let (square, fourth) = (t * t, t * t * (t * t));
    let (mut sums, mut slopes) = ([0.0; 4], [0.0; 4]);
    for four in coefficients.as_chunks::<4>().0.iter().rev() {
        for ((sum, slope), coefficient) in sums.iter_mut().zip(&mut slopes).zip(four) {
            *slope = *slope * fourth + *sum;
            *sum = *sum * fourth + coefficient;
        }
    }
    let value = (sums[0] + t * sums[1]) + square * (sums[2] + t * sums[3]);
    let by_fourth = (slopes[0] + t * slopes[1]) + square * (slopes[2] + t * slopes[3]);
    let of_the_powers = sums[1] + t * (2.0 * sums[2] + 3.0 * t * sums[3]);
    (value, of_the_powers + 4.0 * square * t * by_fourth)
}

/// Of t = (u - 3)/(u + 3) for u >= 0, of the integral over exp(-u^2/2), times (1 + u)^(5/2).
const NEAR: [f64; 32] = [
    1.905_968_108_897_743_8,
    -0.255_313_055_786_266_73,
    -0.830_286_863_923_712_2,
    0.575_420_568_164_723_2,
    0.118_235_931_275_961_71,
    -0.248_683_433_984_237_45,
    0.014_359_979_845_773_198,
    0.068_787_489_637_949_69,
    -0.003_929_531_856_128_239,
    -0.018_301_762_281_928_678,
    -0.001_869_657_730_210_083_4,
    0.004_548_652_623_432_593,
    0.001_721_753_070_256_772_8,
    -0.000_738_384_930_359_565_6,
    -0.000_753_005_142_513_780_7,
    -7.678_968_603_950_224e-05,
    0.000_191_264_947_857_906_9,
    0.000_109_792_915_901_032_98,
    -5.716_877_759_857_465e-06,
    -3.718_831_537_303_770_6e-05,
    -1.871_895_868_680_326e-05,
    1.483_375_102_253_443e-06,
    7.996_944_991_719_758e-06,
    4.427_362_104_958_26e-06,
    -9.427_819_983_207_302e-07,
    -2.209_933_062_481_777_6e-06,
    -4.430_621_736_892_874e-07,
    5.218_157_201_266_211e-07,
    2.047_270_846_803_530_3e-07,
    -5.473_140_905_725_345e-08,
    -2.790_168_638_746_881e-08,
    4.580_791_407_808_221_3e-10,
];
/// Of t = -(u + 1.5)/1.5, and so on.
const FROM_0_TO_3: [f64; 24] = [
    5.444_921_501_730_261,
    6.443_685_266_148_804,
    1.939_159_109_752_407_7,
    -0.246_178_344_911_407_22,
    -0.043_320_847_526_485_635,
    0.061_036_977_090_781_32,
    -0.014_766_207_500_352_06,
    -0.006_698_152_223_112_383,
    0.004_553_638_389_501_698,
    1.283_532_239_659_494e-05,
    -0.000_742_854_323_107_817_8,
    0.000_149_978_389_788_086_48,
    7.950_900_668_084_506e-05,
    -3.431_100_443_337_598_6e-05,
    -4.807_778_856_060_452e-06,
    4.948_578_304_990_254e-06,
    -1.306_403_569_225_255_3e-07,
    -5.350_560_571_025_882e-07,
    7.888_956_236_329_937e-08,
    4.495_918_147_433_447_4e-08,
    -1.149_435_358_922_757_1e-08,
    -2.825_354_804_358_264_4e-09,
    8.414_960_249_878_088e-10,
    1.070_417_722_275_441_7e-10,
];
const FROM_3_TO_6: [f64; 24] = [
    24.375_702_084_152_29,
    11.886_191_137_447_453,
    1.018_102_178_121_835_6,
    -0.062_069_062_502_732_97,
    0.009_294_463_774_441_69,
    -0.002_073_371_798_157_916,
    0.000_589_831_315_184_307_6,
    -0.000_180_008_698_943_042_74,
    4.523_873_174_940_438_6e-05,
    -2.990_053_492_972_697_3e-06,
    -5.333_009_743_448_595e-06,
    3.731_229_286_317_538_3e-06,
    -1.326_129_092_636_306_2e-06,
    1.773_191_212_035_476_2e-07,
    8.663_203_597_845_507e-08,
    -6.083_688_984_209_275e-08,
    1.553_958_024_221_504e-08,
    6.290_134_673_429_956e-10,
    -1.920_051_177_868_440_4e-09,
    6.135_537_779_090_502e-10,
    -1.353_102_125_652_514_2e-12,
    -5.475_639_141_207_807e-11,
    1.001_906_867_980_849_7e-11,
    1.110_593_640_358_549_7e-12,
];
const FROM_6_TO_9: [f64; 20] = [
    51.829_541_630_121_93,
    15.410_614_975_190_775,
    0.777_642_265_382_651_1,
    -0.026_668_187_336_671_603,
    0.002_100_314_504_765_744,
    -0.000_225_451_022_658_852_14,
    2.891_169_783_658_147_7e-05,
    -4.193_161_923_610_691e-06,
    6.692_957_640_559_931e-07,
    -1.159_199_707_881_827e-07,
    2.164_927_840_336_057_7e-08,
    -4.358_209_285_996_725e-09,
    9.494_258_276_374_993e-10,
    -2.243_239_259_907_995_1e-10,
    5.660_854_906_196_789_4e-11,
    -1.496_269_850_815_034e-11,
    4.235_417_823_357_415e-12,
    -1.037_070_041_528_722_8e-12,
    3.215_834_669_742_513e-14,
    5.300_942_830_027_051_5e-14,
];
/// Of w = (9/u)^2, of the integral over (-u)^(3/2).
const FAR: [f64; 12] = [
    2.506_628_274_631_000_7,
    0.011_604_760_530_699_077,
    2.686_287_159_882_245e-05,
    4.836_422_359_084_283e-07,
    1.847_244_334_066_254_3e-08,
    1.111_785_175_452_243_7e-09,
    9.229_995_670_238_918e-11,
    9.974_369_981_191_142e-12,
    1.072_630_426_723_795_2e-12,
    3.959_235_521_989_181e-13,
    -7.821_919_759_169_409e-14,
    3.920_338_669_180_998e-14,
];

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

    #[test]
    fn the_means_are_the_derivatives_of_the_logarithm() {
        let hertz = Hertzian { until_m: f64::INFINITY, pressure_per_three_halves: 1.0, area_per_m: 1.0 };
        let integrals = HertzIntegrals::of(&hertz, 1.0, || f64::INFINITY).unwrap();
        for u in [-20.0f64, -4.0, -0.5, 0.7, 5.0, 30.0] {
            let slopes = |u: f64| integrals.sums_at(u).log_pressure_slopes();
            let step = 1e-4 * (1.0 + u.abs());
            for order in [0, 1] {
                let difference = (slopes(u + step)[order] - slopes(u - step)[order]) / (2.0 * step);
                let error = (difference / slopes(u)[order + 1] - 1.0).abs();
                assert!(error < 1e-5, "u = {u}, order {order}: {difference} and {:?}", slopes(u));
            }
        }
    }
}
