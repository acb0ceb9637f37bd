//! Exponentials and logarithms without calls or branches, for loops over many arguments.
//!
//! The compiler turns a loop over them into one over vectors. A lane of a vector rounds like a single number, so that
//! no digit depends on the width. The mathematical library is called once per argument, and is four to six times as
//! expensive there.

/// Constant 1.5 * 2^52: adding it leaves the nearest integer in the lowest bits.
const SHIFT: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts; the first ends in 32 zeros, so that its product with an exponent is exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
/// Coefficients of (e^r - 1 - r)/r^2, interpolated at ten Chebyshev points of |r| <= ln(2)/2: within 2e-17 of e^r.
const EXPONENTIAL: [f64; 10] = [
    0.500_000_000_000_000_1,
    0.166_666_666_666_666_69,
    0.041_666_666_666_624_164,
    0.008_333_333_333_330_065,
    0.001_388_888_891_719_673_6,
    0.000_198_412_698_630_405_59,
    2.480_152_132_234_228e-5,
    2.755_726_848_028_971_6e-6,
    2.762_007_589_254_816_4e-7,
    2.510_037_584_222_37e-8,
];
/// Coefficients of (ln((1+s)/(1-s)) - 2s)/s^3 in s^2, of the freely distributable mathematical library (Sun, 1993).
const LOGARITHM: [f64; 7] = [
    0.666_666_666_666_673_5,
    0.399_999_999_994_094_2,
    0.285_714_287_436_623_9,
    0.222_221_984_321_497_84,
    0.181_835_721_616_180_5,
    0.153_138_376_992_093_73,
    0.147_981_986_051_165_86,
];

/// Computes e^x to one unit in the last place. x is limited to \[-708, 709\], so that the result, 3e-308 to 8e307, is
/// never zero or infinite.
#[inline(always)]
#[must_use]
pub fn exp(x: f64) -> f64 {
    let (scale, rest) = scale_and_rest(x);
    scale + scale * rest
}

/// Computes e^x - 1 to one or two units in the last place, also around zero. x is limited to \[-708, 709\].
#[inline(always)]
#[must_use]
pub fn exp_m1(x: f64) -> f64 {
    let (scale, rest) = scale_and_rest(x);
    (scale - 1.0) + scale * rest
}

/// Returns a power of two and r, -0.3 < r < 0.42, such that e^x is the power times 1 + r.
#[inline(always)]
fn scale_and_rest(x: f64) -> (f64, f64) {
    let x = if x < -708.0 { -708.0 } else { x };
    scale_and_rest_in_range(if x > 709.0 { 709.0 } else { x })
}

#[inline(always)]
fn scale_and_rest_in_range(x: f64) -> (f64, f64) {
    let shifted = x * std::f64::consts::LOG2_E + SHIFT;
    let exponent = shifted - SHIFT;
    let r = (x - exponent * LN_2[0]) - exponent * LN_2[1];
    // Evaluated in pairs that do not wait for one another.
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = EXPONENTIAL;
    let square = r * r;
    let fourth = square * square;
    let low = (c0 + c1 * r) + (c2 + c3 * r) * square;
    let middle = (c4 + c5 * r) + (c6 + c7 * r) * square;
    let series = low + (middle + (c8 + c9 * r) * fourth) * fourth;
    let scale = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1f64.to_bits()));
    (scale, r + square * series)
}

/// Computes [`exp`] where x is known to lie in \[-708, 709\], which saves limiting it.
#[inline(always)]
pub(crate) fn exp_in_range(x: f64) -> f64 {
    let (scale, rest) = scale_and_rest_in_range(x);
    scale + scale * rest
}

/// Computes ln x to one unit in the last place, for every normal x > 0.
#[inline(always)]
#[must_use]
pub fn ln(x: f64) -> f64 {
    const ROOT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    const TWO_TO_52: f64 = 4_503_599_627_370_496.0;
    const BIAS: f64 = 1023.0;
    // x = 2^exponent m, m between the roots of 1/2 and of 2, so that neither is large where their logarithms cancel.
    let bits = x.to_bits().wrapping_add(1f64.to_bits() - ROOT_HALF);
    let exponent = f64::from_bits((bits >> 52) | TWO_TO_52.to_bits()) - (TWO_TO_52 + BIAS);
    let f = f64::from_bits((bits & MANTISSA).wrapping_add(ROOT_HALF)) - 1.0;
    let s = f / (2.0 + f);
    let square = s * s;
    let half = 0.5 * f * f;
    let [c0, c1, c2, c3, c4, c5, c6] = LOGARITHM;
    let fourth = square * square;
    let even = c0 + fourth * (c2 + fourth * (c4 + fourth * c6));
    let odd = c1 + fourth * (c3 + fourth * c5);
    let series = square * (even + square * odd);
    s * (half + series) + exponent * LN_2[1] - half + f + exponent * LN_2[0]
}

/// Computes ln(1 + x) to one or two units in the last place, also around zero, for x > -1.
#[inline(always)]
#[must_use]
pub fn ln_1p(x: f64) -> f64 {
    let sum = 1.0 + x;
    // First term of the series in the rounding error of the sum.
    ln(sum) + (x - (sum - 1.0)) / sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deviation in units of the last place from the library's value, which is taken as exact.
    fn units_off(value: f64, exact: f64) -> f64 {
        (value - exact).abs() / (exact.abs() * f64::EPSILON).max(f64::MIN_POSITIVE)
    }

    #[test]
    fn exponentials_agree_with_the_library() {
        for i in -200_000..200_000 {
            let x = f64::from(i) * 0.00354;
            assert!(units_off(exp(x), x.exp()) <= 1.0, "{x}: {:e}", exp(x));
            assert!(x.abs() > 708.0 || exp_in_range(x) == exp(x), "{x}: {:e}", exp_in_range(x));
            for x in [x, x * 1e-3, x * 1e-9, x * 1e-30] {
                assert!(units_off(exp_m1(x), x.exp_m1()) <= 1.5, "{x}: {:e}", exp_m1(x));
            }
        }
        assert_eq!([exp(0.0), exp_m1(0.0)], [1.0, 0.0]);
    }

    #[test]
    fn logarithms_agree_with_the_library() {
        for i in -200_000..200_000 {
            let x = (f64::from(i) * 0.00354).exp();
            assert!(units_off(ln(x), x.ln()) <= 1.0, "{x}: {:e}", ln(x));
            let near = 1.0 + f64::from(i) * 1e-9;
            assert!(units_off(ln(near), near.ln()) <= 1.0, "{near}: {:e}", ln(near));
            for x in [x, f64::from(i) * 4e-6, f64::from(i) * 1e-12, f64::from(i) * 1e-30] {
                assert!(units_off(ln_1p(x), x.ln_1p()) <= 2.0, "{x}: {:e}", ln_1p(x));
            }
        }
        assert_eq!([ln(1.0), ln_1p(0.0)], [0.0, 0.0]);
        assert_eq!(ln(f64::MIN_POSITIVE), f64::MIN_POSITIVE.ln());
        assert_eq!(ln(f64::MAX), f64::MAX.ln());
    }

    #[test]
    fn arguments_beyond_the_doubles_are_limited() {
        assert!(exp(-1e9) < 4e-308 && exp(-1e9) > 0.0);
        assert!(exp(1e9) > 8e307 && exp(f64::INFINITY).is_finite());
        assert!(exp(f64::NAN).is_nan());
    }
}
