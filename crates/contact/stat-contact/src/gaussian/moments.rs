//! The first moment of the heights in contact, in closed form: the area of Hertz's spheres.

use super::coefficients::FIRST_MOMENT;
use super::density::DENSITY_SCALE;
use super::polynomial::value;

/// Integral of s exp(-(u+s)^2/2)/sqrt(2 pi) over all s from 0 on, over the reference density: phi(u) - u Q(u), which
/// equals its value at -u, less u. Relative error within 1e-16 for u >= 0.
pub(crate) fn first_moment(u: f64) -> f64 {
    let distance = u.abs();
    let series = value(&FIRST_MOMENT, (distance - 5.0) / (distance + 5.0));
    let moment = DENSITY_SCALE * series / (1.0 + distance) / (1.0 + distance);
    if u >= 0.0 { moment } else { moment * (-0.5 * u * u).exp() - u }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
