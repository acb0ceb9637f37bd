//! The Gaussian density of the heights, with its value at the separation (or at its peak, when that is in contact)
//! taken out, so that nothing under- or overflows however far the surfaces are apart.
//!
//! Everything here is in units of sigma_s: u = d/sigma_s is the separation, s = w/sigma_s the interference.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_SQRT_PI};

/// 1/sqrt(2 pi).
pub(crate) const DENSITY_SCALE: f64 = 0.5 * FRAC_2_SQRT_PI * FRAC_1_SQRT_2;

/// Where the integrand is not negligible.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Window {
    /// The lowest interference.
    pub low: f64,
    /// The highest interference.
    pub high: f64,
    /// -ln of the density at its ends over the largest in contact.
    drop: f64,
}

impl Window {
    /// The interferences at which the density is above a share exp(-drop) of its largest value in contact, for every
    /// separation from `nearest` to `farthest`.
    pub fn new(nearest: f64, farthest: f64, drop: f64) -> Window {
        let reach = |u: f64| 2.0 * drop / (u + (u * u + 2.0 * drop).sqrt());
        let half_width = (2.0 * drop).sqrt();
        Window {
            low: (-farthest - half_width).max(0.0),
            high: if nearest >= 0.0 { reach(nearest) } else { half_width - nearest },
            drop,
        }
    }

    /// All interferences up to one.
    pub fn up_to(high: f64) -> Window {
        Window { low: 0.0, high, drop: f64::INFINITY }
    }

    /// Share of the integrals at the separation u that lies outside: that of a response like s^2, or of one that does not
    /// change above the window.
    pub fn left_out(&self, u: f64, saturates: bool) -> f64 {
        let s = self.high;
        let below = if self.low == 0.0 { 0.0 } else { (-self.drop).exp() };
        if saturates {
            return below;
        }
        // Int_s^inf t^2 exp(-t (u + t/2)) dt, and its whole from 0 on within a fifth.
        let y = s * (u + s);
        let beyond = density(u, s) / DENSITY_SCALE * s * s / (u + s) * (1.0 + 2.0 / y + 2.0 / (y * y));
        let whole = if u > 0.0 { 2.0 / (u + 1.17).powi(3) } else { 1.25 * (1.0 + u * u) };
        below + beyond / whole
    }
}

/// ln of the density that is taken out at the separation u, without its constant 1/(sigma_s sqrt(2 pi)).
pub(crate) fn log_reference_density(u: f64) -> f64 {
    if u > 0.0 { -0.5 * u * u } else { 0.0 }
}

/// The same density itself; zero where it underflows.
pub(crate) fn reference_density(u: f64) -> f64 {
    if u <= 0.0 {
        return 1.0;
    }
    // The rounding of the square, up to 2e-13 at sixty sigma, is carried along.
    let square = u * u;
    (-0.5 * square).exp() * (1.0 - 0.5 * u.mul_add(u, -square))
}

/// Integral of exp(-(u+s)^2/2)/sqrt(2 pi) over all s from `from` on, over the reference density.
pub(crate) fn tail(u: f64, from: f64) -> f64 {
    let z = (u + from) * FRAC_1_SQRT_2;
    if u > 0.0 {
        // Both z^2 and u^2/2 may be large; their difference is taken before it is rounded.
        0.5 * scaled_erfc(z) * (-from * (u + 0.5 * from)).exp()
    } else {
        0.5 * libm::erfc(z)
    }
}

/// phi(u) - u Q(u) over phi(u), times (1 + u)^2, for u >= 0: coefficients of the powers of (u - 5)/(u + 5), from 26
/// Chebyshev polynomials of it, within 1e-16; as many as make up fours.
const FIRST_MOMENT: [f64; 28] = [
    1.294_541_151_243_162_4,
    -0.368_722_964_545_018_24,
    -0.028_030_699_627_535_318,
    0.261_167_007_847_162_46,
    -0.273_548_203_762_268_9,
    0.154_021_662_311_231_07,
    -0.029_310_982_484_216_187,
    -0.031_861_872_708_039_22,
    0.034_746_227_044_115_68,
    -0.016_131_705_895_756_486,
    0.002_328_313_685_668_353_5,
    0.001_576_775_617_502_933_9,
    -0.000_852_726_679_260_871,
    -3.581_817_099_618_2e-5,
    0.000_146_927_563_032_433_38,
    -1.720_393_106_112_526_6e-5,
    -2.335_508_821_393_951_3e-5,
    4.971_636_920_474_042e-6,
    3.947_327_231_733_412_5e-6,
    -9.985_214_771_598_005e-7,
    -6.968_399_656_044_212e-7,
    1.660_151_115_420_457_6e-7,
    1.073_022_959_586_397e-7,
    -2.118_499_871_566_054_3e-8,
    -9.684_045_797_029_939e-9,
    1.529_418_606_351_620_5e-9,
    0.0,
    0.0,
];

/// Integral of s exp(-(u+s)^2/2)/sqrt(2 pi) over all s from 0 on, over the reference density: phi(u) - u Q(u), which is
/// that at -u, less u.
pub(crate) fn first_moment(u: f64) -> f64 {
    let distance = u.abs();
    let t = (distance - 5.0) / (distance + 5.0);
    let (square, fourth) = (t * t, t * t * (t * t));
    // Four sums that do not wait for one another.
    let mut sums = [0.0; 4];
    for coefficients in FIRST_MOMENT.as_chunks::<4>().0.iter().rev() {
        for (sum, coefficient) in sums.iter_mut().zip(coefficients) {
            *sum = *sum * fourth + coefficient;
        }
    }
    let series = (sums[0] + t * sums[1]) + square * (sums[2] + t * sums[3]);
    let moment = DENSITY_SCALE * series / (1.0 + distance) / (1.0 + distance);
    if u >= 0.0 { moment } else { moment * (-0.5 * u * u).exp() - u }
}

/// The density at the interference s, over the reference density.
pub(crate) fn density(u: f64, s: f64) -> f64 {
    let exponent = if u > 0.0 { -s * (u + 0.5 * s) } else { -0.5 * (u + s).powi(2) };
    DENSITY_SCALE * exponent.exp()
}

/// exp(z^2) erfc(z) for z >= 0.
fn scaled_erfc(z: f64) -> f64 {
    const ASYMPTOTIC_FROM: f64 = 10.0;
    if z < ASYMPTOTIC_FROM {
        let square = z * z;
        // exp would turn the rounding of z^2, half a unit of up to 100, into 1e-14: carry it along.
        let rounding = z.mul_add(z, -square);
        return square.exp() * (1.0 + rounding) * libm::erfc(z);
    }
    // 1 - 1/(2z^2) + 1*3/(2z^2)^2 - ..., below 1e-17 from the twelfth term on.
    let step = -0.5 / (z * z);
    let series = (1..=12).rev().fold(1.0, |sum, k| 1.0 + f64::from(2 * k - 1) * step * sum);
    0.5 * FRAC_2_SQRT_PI / z * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tail_agrees_with_twenty_digits() {
        // (u, from, integral over the reference density)
        for (u, from, exact) in [
            (0.0, 0.0, 0.5),
            (3.0, 0.25, 0.051_942_139_004_578_84),
            (-2.0, 1.0, 0.841_344_746_068_542_9),
            (-60.0, 61.0, 0.158_655_253_931_457_05),
            (13.5, 0.5, 0.000_029_296_737_172_281_53),
            (60.0, 0.125, 3.640_268_211_448_441_4e-6),
        ] {
            assert!((tail(u, from) / exact - 1.0).abs() < 1e-14, "{u}, {from}: {:e}", tail(u, from));
        }
    }

    #[test]
    fn the_first_moment_agrees_with_twenty_digits() {
        for (u, exact) in [
            (-60.0, 60.0),
            (-2.5, 2.5020041371791282),
            (0.0, 0.398_942_280_401_432_7),
            (1.5, 0.090_271_279_935_340_64),
            (2.9375, 0.035572604679241097),
            (3.0, 0.034400435334746177),
            (3.5, 0.026734242683463615),
            (6.0, 0.010266394454751582),
            (20.0, 0.000_989_967_434_892_046),
            (60.0, 0.00011072508037340583),
            (1000.0, 3.9894108358057557e-7),
        ] {
            assert!((first_moment(u) / exact - 1.0).abs() < 1e-14, "{u}: {:e}", first_moment(u));
        }
    }

    #[test]
    fn the_two_forms_of_the_scaled_function_meet() {
        let (below, above) = (scaled_erfc(10.0 - 1e-14), scaled_erfc(10.0));
        assert!((above / below - 1.0).abs() < 5e-15);
    }

    #[test]
    fn the_window_ends_where_the_density_has_dropped() {
        for u in [-9.0, 0.0, 2.0, 60.0] {
            let window = Window::new(u, u, 30.0);
            let drop = 0.5 * (u + window.high).powi(2) + log_reference_density(u);
            assert!((drop - 30.0).abs() < 1e-10, "u = {u}: {drop}");
        }
        assert_eq!(Window::new(-1.0, 1.0, 30.0).low, 0.0);
        assert!(Window::new(-20.0, -19.0, 30.0).low > 11.0);
    }
}
