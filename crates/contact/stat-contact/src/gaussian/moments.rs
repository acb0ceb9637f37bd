//! Moments of the heights above a separation, in closed form: areas and loads of spheres, on one face and on two.

use super::coefficients::FIRST_MOMENT;
use super::density::{DENSITY_SCALE, reference_density, tail};
use super::hertz_load::load_and_mean_interference;
use super::polynomial::{value, value_and_slope};

/// Order n of an upper partial moment of Gaussian heights, F_n(x) = Int_x^inf (s - x)^n phi(s) ds with the standard normal density
/// phi (Greenwood & Williamson 1966; Greenwood & Tripp 1970).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartialMoment {
    /// F_0: the share of the heights above the separation.
    Zeroth,
    /// F_1: the area of spheres.
    First,
    /// F_3/2: the load of elastic spheres.
    ThreeHalves,
    /// F_2: the area of the spheres of two faces that meet off their axes.
    Second,
    /// F_5/2: the load of these.
    FiveHalves,
}

impl PartialMoment {
    /// Computes F_n(x) of a finite separation x in standard deviations, with a relative error below 1e-13 where it does not
    /// underflow.
    #[must_use]
    pub fn above(self, x: f64) -> f64 {
        let over_reference = match self {
            PartialMoment::Zeroth => tail(x, 0.0),
            PartialMoment::First => first_moment(x),
            PartialMoment::ThreeHalves => DENSITY_SCALE * load_and_mean_interference(x).0,
            PartialMoment::Second => second_moment(x),
            PartialMoment::FiveHalves => {
                let (load, mean_interference) = load_and_mean_interference(x);
                DENSITY_SCALE * load * mean_interference
            }
        };
        over_reference * reference_density(x)
    }
}

/// F_2 over the reference density: F_0 - u F_1, which cancels for u > 0. There it is -d/du of F_1 over the reference density.
fn second_moment(u: f64) -> f64 {
    if u < 0.0 {
        return tail(u, 0.0) - u * first_moment(u);
    }
    let (series, slope) = value_and_slope(&FIRST_MOMENT, (u - 5.0) / (u + 5.0));
    let distance = 1.0 + u;
    let fall = 2.0 * series / distance - slope * 10.0 / ((u + 5.0) * (u + 5.0));
    DENSITY_SCALE * fall / (distance * distance)
}

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
