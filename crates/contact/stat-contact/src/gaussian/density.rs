//! Gaussian density of the heights. Its value at the separation (or at its peak, if that is in contact) is taken out,
//! so that nothing under- or overflows however far the surfaces are apart.
//!
//! Everything here is in units of sigma_s: u = d/sigma_s is the separation, s = w/sigma_s the interference.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_SQRT_PI};

/// 1/sqrt(2 pi).
pub(crate) const DENSITY_SCALE: f64 = 0.5 * FRAC_2_SQRT_PI * FRAC_1_SQRT_2;

/// Logarithm of the density that is taken out at the separation u, without its constant 1/(sigma_s sqrt(2 pi)).
pub(crate) fn log_reference_density(u: f64) -> f64 {
    if u > 0.0 { -0.5 * u * u } else { 0.0 }
}

/// Density that is taken out at the separation u, without its constant; zero where it underflows.
pub(crate) fn reference_density(u: f64) -> f64 {
    if u <= 0.0 {
        return 1.0;
    }
    // Correct for the rounding of the square, up to 2e-13 at sixty sigma.
    let square = u * u;
    (-0.5 * square).exp() * (1.0 - 0.5 * u.mul_add(u, -square))
}

/// Integral of exp(-(u+s)^2/2)/sqrt(2 pi) over all s from `from` on, over the reference density.
pub(crate) fn tail(u: f64, from: f64) -> f64 {
    let z = (u + from) * FRAC_1_SQRT_2;
    if u > 0.0 {
        // z^2 and u^2/2 may both be large; their difference is taken before it is rounded.
        0.5 * scaled_erfc(z) * (-from * (u + 0.5 * from)).exp()
    } else {
        0.5 * libm::erfc(z)
    }
}

/// The density at the interference s, over the reference density.
pub(crate) fn density(u: f64, s: f64) -> f64 {
    let exponent = if u > 0.0 { -s * (u + 0.5 * s) } else { -0.5 * (u + s).powi(2) };
    DENSITY_SCALE * exponent.exp()
}

/// Computes exp(z^2) erfc(z) for z >= 0.
pub(crate) fn scaled_erfc(z: f64) -> f64 {
    const ASYMPTOTIC_FROM: f64 = 10.0;
    if z < ASYMPTOTIC_FROM {
        let square = z * z;
        // exp would turn the rounding of z^2, half a unit of up to 100, into 1e-14: correct for it.
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
    fn the_two_forms_of_the_scaled_function_meet() {
        let (below, above) = (scaled_erfc(10.0 - 1e-14), scaled_erfc(10.0));
        assert!((above / below - 1.0).abs() < 5e-15);
    }
}
