//! The elastic sinusoid: Johnson, Greenwood & Higginson (1985), its two limits joined by Jackson & Streator (2006),
//! Wear 261:1337; Jackson & Jacobs, Eqs. (6)-(7).
//!
//! The shape is Delta cos(2 pi x/lambda) cos(2 pi y/lambda): two peaks per lambda^2, density eta = 2/lambda^2, and
//! Delta = (lambda/2 pi)^2/R. Areas are fractions of the nominal area, which avoids factor-two errors.

use std::f64::consts::{PI, SQRT_2};

use crate::mean_gap::{complement, power_at};
use crate::{Break, MaterialPair, elementary};

/// Ratio p/p* from which the law is its full-contact limit alone; the area steps down by 4.2e-4 there.
const JOINED_UP_TO: f64 = 0.8;
/// Slope of the full-contact limit 1 - (3/(2 pi)) (1 - x).
pub(crate) const FULL_CONTACT_SLOPE: f64 = 3.0 / (2.0 * PI);
/// Factor pi (3/(8 pi))^(2/3) of Hertz's limit phi_1 = pi (3x/(8 pi))^(2/3).
const HERTZ_LIMIT: f64 = 0.761_618_473_172_444_5;
/// Exponents of the weights that join the two limits: see [`joining_powers`].
pub(crate) const LIGHT_EXPONENT: f64 = 1.51;
pub(crate) const HEAVY_EXPONENT: f64 = 1.04;

/// Sinusoidal surface, of one aspect ratio, in elastic contact with a flat: Johnson, Greenwood & Higginson (1985), as
/// in `docs/theory/models.md`, section 2.3, with the mean gap of section 2.5. Its results depend on p/p* alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticSinusoid {
    complete_contact_pressure_pa: f64,
}

impl ElasticSinusoid {
    /// Creates a sinusoid of aspect ratio B = Delta/lambda > 0.
    #[must_use]
    pub fn new(pair: &MaterialPair, aspect_ratio: f64) -> Self {
        debug_assert!(aspect_ratio > 0.0);
        ElasticSinusoid {
            complete_contact_pressure_pa: SQRT_2 * PI * pair.composite_modulus_pa() * aspect_ratio,
        }
    }

    /// Mean pressure p* = sqrt(2) pi E* B \[Pa\] at which the surfaces touch everywhere.
    #[must_use]
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.complete_contact_pressure_pa
    }

    /// Fraction of the nominal area in contact, in (0, 1\], at the mean pressure p > 0 \[Pa\] (Jackson & Streator
    /// 2006): phi_1 (1 - x^1.51) + phi_2 x^1.04 below x = p/p* = 0.8, phi_2 from there on, and 1 from x = 1 on, with
    /// phi_1 = pi (3 x/(8 pi))^(2/3) and phi_2 = 1 - (3/(2 pi)) (1 - x).
    ///
    /// It lies within +12/-7.4 % of boundary-element solutions for all p, and steps down by 4.2e-4 at x = 0.8.
    #[must_use]
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        joined_area_fraction(pressure_pa / self.complete_contact_pressure_pa)
    }

    /// Area fraction, without a branch, where p/p* = t^2 is below 0.8 and t^(4/3) is known; t is at least the root of
    /// the smallest normal number.
    #[inline(always)]
    #[must_use]
    pub fn light_area_fraction(t: f64, t_to_four_thirds: f64) -> f64 {
        let x = t * t;
        let [light, heavy] = joining_powers(x, 2.0 * elementary::ln(t));
        HERTZ_LIMIT * t_to_four_thirds * (1.0 - light) + heavy_limit(x) * heavy
    }

    /// Area fraction where p/p* = x lies between 0.8 and 1.
    #[inline(always)]
    #[must_use]
    pub fn heavy_area_fraction(x: f64) -> f64 {
        heavy_limit(x)
    }

    /// Ratio p/p* from which the area fraction is that of the full-contact limit.
    pub const JOINED_UP_TO: f64 = JOINED_UP_TO;

    /// Mean gap over amplitude g/Delta = (1 - (p/p*)^(1/2))^(5/2) in \[0, 1) at the mean pressure p > 0 \[Pa\], 0 from
    /// p* on (Rostami & Jackson 2013).
    #[must_use]
    pub fn mean_gap_over_amplitude(&self, pressure_pa: f64) -> f64 {
        let (_, opening) = self.root_and_opening(pressure_pa);
        opening * opening * opening.sqrt()
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta in (0, 1\] at the mean pressure p > 0 \[Pa\] (Jackson &
    /// Jacobs, Eq. 9), to full precision where it is small. At light pressure it exceeds boundary elements, 2.5 times
    /// at 1e-4 p*.
    #[must_use]
    pub fn deformation_over_amplitude(&self, pressure_pa: f64) -> f64 {
        let (root, opening) = self.root_and_opening(pressure_pa);
        complement(root, opening)
    }

    /// Mean pressure \[Pa\] when the flat has descended by w > 0, given as w/Delta: p = p* t^2, t = 1 - (1 -
    /// w/Delta)^(2/5); p* from w = Delta on. At small w it grows like w^2, which is not Hertzian.
    #[must_use]
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa;
        }
        let t = power_at(interference_over_amplitude);
        self.complete_contact_pressure_pa * t * t
    }

    /// Mean pressures \[Pa\] at which the area is not smooth, in rising order.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        self.area_breaks().into_iter()
    }

    pub(crate) fn area_breaks(&self) -> [Break; 2] {
        let complete = self.complete_contact_pressure_pa;
        let (below, above) = (light_joined(JOINED_UP_TO), heavy_limit(JOINED_UP_TO));
        [
            Break::jump(JOINED_UP_TO * complete, "end of the joined law at 0.8 p*", below, above),
            Break::kink(complete, "complete contact at p*"),
        ]
    }

    /// Returns t = (p/p*)^(1/2) and 1 - t, which keeps its digits when p is close to p*; 1 and 0 from p* on.
    fn root_and_opening(&self, pressure_pa: f64) -> (f64, f64) {
        let complete_pa = self.complete_contact_pressure_pa;
        if pressure_pa >= complete_pa {
            return (1.0, 0.0);
        }
        let root = (pressure_pa / complete_pa).max(f64::MIN_POSITIVE).sqrt();
        (root, (complete_pa - pressure_pa) / complete_pa / (1.0 + root))
    }
}

/// Computes ln(p/full) for p < full, keeping its digits when p is close to full.
pub(crate) fn log_of_fraction(pressure_pa: f64, full_pa: f64) -> Option<f64> {
    let x = pressure_pa / full_pa;
    (x < 1.0).then(|| if x > 0.5 { ((pressure_pa - full_pa) / full_pa).ln_1p() } else { x.ln() })
}

fn joined_area_fraction(x: f64) -> f64 {
    if x >= 1.0 {
        1.0
    } else if x >= JOINED_UP_TO {
        heavy_limit(x)
    } else {
        light_joined(x)
    }
}

/// Joined law phi_1 (1 - x^1.51) + phi_2 x^1.04 with Hertz's limit phi_1 = pi (3x/(8 pi))^(2/3).
fn light_joined(x: f64) -> f64 {
    let x = x.max(f64::MIN_POSITIVE);
    let log_x = elementary::ln(x);
    // Cube root from the logarithm that the powers need anyway, with one Newton step to rounding: a third of the cost
    // of `cbrt`.
    let rough = elementary::exp(log_x / 3.0);
    let root = rough - (rough * rough * rough - x) / (3.0 * rough * rough);
    let [light, heavy] = joining_powers(x, log_x);
    HERTZ_LIMIT * (root * root) * (1.0 - light) + heavy_limit(x) * heavy
}

/// Computes x^1.51 and x^1.04 for 0 < x <= 1 from one exponential: x^1.5 (x^0.01) and x (x^0.01)^4.
#[inline(always)]
pub(crate) fn joining_powers(x: f64, log_x: f64) -> [f64; 2] {
    joining_powers_by(&elementary::exp, x, log_x)
}

#[inline(always)]
pub(crate) fn joining_powers_by(exp: &impl Fn(f64) -> f64, x: f64, log_x: f64) -> [f64; 2] {
    let hundredth = exp(0.01 * log_x);
    let square = hundredth * hundredth;
    [x * x.sqrt() * hundredth, x * (square * square)]
}

/// Limit near complete contact, phi_2 = 1 - (3/(2 pi)) (1 - x).
#[inline(always)]
pub(crate) fn heavy_limit(x: f64) -> f64 {
    1.0 - FULL_CONTACT_SLOPE * (1.0 - x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticBody;

    fn sinusoid() -> ElasticSinusoid {
        ElasticSinusoid::new(&MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap()), 0.01)
    }

    #[test]
    fn the_area_steps_down_at_four_fifths_of_complete_contact_as_published() {
        let step = sinusoid().breaks().next().unwrap();
        let (below, above) = (light_joined(0.8), heavy_limit(0.8));
        assert!((above - below + 4.176e-4).abs() < 0.005e-4, "{}", above - below);
        assert!((step.step - (above / below - 1.0)).abs() < 1e-15);
    }

    #[test]
    fn light_pressures_follow_hertz() {
        let law = sinusoid();
        let complete = law.complete_contact_pressure_pa();
        let slope = (law.area_fraction(1e-11 * complete) / law.area_fraction(1e-12 * complete)).log10();
        assert!((slope - 2.0 / 3.0).abs() < 1e-4, "{slope}");
    }

    #[test]
    fn the_area_lies_within_its_published_error_of_boundary_elements() {
        // p/p*, area fraction on a 1024^2 mesh
        for (x, solved) in
            [(1e-4, 0.001647), (0.01, 0.036392), (0.1, 0.190555), (0.3, 0.514107), (0.9, 0.950658)]
        {
            let deviation = joined_area_fraction(x) / solved - 1.0;
            assert!((-0.074..0.12).contains(&deviation), "p/p* = {x}: {deviation}");
        }
    }

    #[test]
    fn the_interference_inverts_the_mean_gap() {
        let law = sinusoid();
        for x in [1e-15, 1e-9, 1e-3, 0.4, 0.99] {
            let pressure = x * law.complete_contact_pressure_pa();
            let back = law.pressure_at_interference_pa(law.deformation_over_amplitude(pressure));
            assert!((back / pressure - 1.0).abs() < 1e-12, "p/p* = {x}");
        }
        assert_eq!(law.pressure_at_interference_pa(1.0), law.complete_contact_pressure_pa());
        assert_eq!(law.mean_gap_over_amplitude(law.complete_contact_pressure_pa()), 0.0);
        assert_eq!(law.deformation_over_amplitude(2.0 * law.complete_contact_pressure_pa()), 1.0);
    }
}
