//! The elastic sinusoid: Johnson, Greenwood & Higginson (1985), its two limits joined by Jackson & Streator (2006),
//! Wear 261:1337; Jackson & Jacobs, Eqs. (6)-(7).
//!
//! The shape is Delta cos(2 pi x/lambda) cos(2 pi y/lambda): two peaks per lambda^2, density eta = 2/lambda^2, and
//! Delta = (lambda/2 pi)^2/R. Areas are fractions of the nominal area, which avoids factor-two errors.

use std::f64::consts::{PI, SQRT_2};

use multiversion::multiversion;

use crate::lanes::{LANES, any, check_lengths, each, in_blocks};
use crate::mean_gap::{complement, power_at, powers_at};
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

    /// Creates a sinusoid from the mean pressure > 0 \[Pa\] of its complete contact.
    pub(crate) fn complete_at(complete_contact_pressure_pa: f64) -> Self {
        ElasticSinusoid { complete_contact_pressure_pa }
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
        area_fraction_at(pressure_pa / self.complete_contact_pressure_pa)
    }

    /// Computes [`area_fraction`](Self::area_fraction) for N pressures \[Pa\].
    #[inline(always)]
    pub(crate) fn area_fractions<const N: usize>(&self, pressures_pa: [f64; N]) -> [f64; N] {
        let x: [f64; N] = each(|i| pressures_pa[i] / self.complete_contact_pressure_pa);
        let light = if any::<N>(|i| x[i] < JOINED_UP_TO) { light_joined(x) } else { [0.0; N] };
        each(|i| joined_area_fraction(x[i], || light[i]))
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
        self.pressure_at_power(interference_over_amplitude, || power_at(interference_over_amplitude))
    }

    /// Pressure \[Pa\] at an interference over amplitude and t of it, which counts below complete contact.
    #[inline(always)]
    fn pressure_at_power(&self, interference_over_amplitude: f64, t: impl FnOnce() -> f64) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa;
        }
        let t = t();
        self.complete_contact_pressure_pa * t * t
    }

    /// Computes [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) at each of some interferences over
    /// amplitude, to the same digits at a fraction of the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn pressures_at_interferences(&self, interferences_over_amplitude: &[f64], pressures_pa: &mut [f64]) {
        elastic_pressures(self, interferences_over_amplitude, pressures_pa);
    }

    /// Returns [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) and the
    /// [`area_fraction`](Self::area_fraction) at that pressure when the flat has descended by w > 0, given as w/Delta.
    #[must_use]
    pub fn pressure_and_area_at_interference(&self, interference_over_amplitude: f64) -> (f64, f64) {
        let pressure_pa = self.pressure_at_interference_pa(interference_over_amplitude);
        (pressure_pa, self.area_fraction(pressure_pa))
    }

    /// Computes [`pressure_and_area_at_interference`](Self::pressure_and_area_at_interference) at each of many
    /// interferences over amplitude, to the same digits at a fraction of the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn pressures_and_areas_at_interferences(
        &self,
        interferences_over_amplitude: &[f64],
        pressures_pa: &mut [f64],
        area_fractions: &mut [f64],
    ) {
        elastic_at_each(self, interferences_over_amplitude, pressures_pa, area_fractions);
    }

    /// Mean pressures \[Pa\] at which the area is not smooth, in rising order.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        self.area_breaks().into_iter()
    }

    pub(crate) fn area_breaks(&self) -> [Break; 2] {
        let complete = self.complete_contact_pressure_pa;
        let (below, above) = (light_joined_at(JOINED_UP_TO), heavy_limit(JOINED_UP_TO));
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

/// Pressures \[Pa\] and area fractions at interferences over amplitude.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn elastic_at_each(
    law: &ElasticSinusoid,
    interferences_over_amplitude: &[f64],
    pressures_pa: &mut [f64],
    area_fractions: &mut [f64],
) {
    in_blocks(interferences_over_amplitude, [pressures_pa, area_fractions], |ratios| {
        let t = if any::<LANES>(|i| ratios[i] < 1.0) { powers_at(ratios) } else { [1.0; LANES] };
        let pressures_pa = each(|i| law.pressure_at_power(ratios[i], || t[i]));
        [pressures_pa, law.area_fractions(pressures_pa)]
    });
}

/// Pressures \[Pa\] at interferences over amplitude.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn elastic_pressures(law: &ElasticSinusoid, interferences_over_amplitude: &[f64], pressures_pa: &mut [f64]) {
    check_lengths(interferences_over_amplitude, [pressures_pa]);
    for (&ratio, pressure_pa) in interferences_over_amplitude.iter().zip(pressures_pa) {
        let t = power_at(ratio);
        *pressure_pa = law.pressure_at_power(ratio, || t);
    }
}

/// Area fraction at x = p/p*.
fn area_fraction_at(x: f64) -> f64 {
    joined_area_fraction(x, || light_joined_at(x))
}

/// Area fraction at x = p/p*, given the joined law there, which counts below x = 0.8.
#[inline(always)]
fn joined_area_fraction(x: f64, light: impl FnOnce() -> f64) -> f64 {
    if x >= 1.0 {
        1.0
    } else if x >= JOINED_UP_TO {
        heavy_limit(x)
    } else {
        light()
    }
}

/// Joined law at one x. Not inlined: in the loop of a stack the compiler then no longer pairs its two exponentials.
#[inline(never)]
fn light_joined_at(x: f64) -> f64 {
    let [area_fraction] = light_joined([x]);
    area_fraction
}

/// Joined law phi_1 (1 - x^1.51) + phi_2 x^1.04 with Hertz's limit phi_1 = pi (3x/(8 pi))^(2/3).
#[inline(always)]
fn light_joined<const N: usize>(x: [f64; N]) -> [f64; N] {
    let x: [f64; N] = each(|i| if x[i] > f64::MIN_POSITIVE { x[i] } else { f64::MIN_POSITIVE });
    let log_x: [f64; N] = each(|i| elementary::ln(x[i]));
    // x^(2/3) is x times x^(-1/3), from the logarithm that the powers need anyway, with one Newton step to rounding,
    // which needs no division: a third of the cost of `cbrt`.
    let rough: [f64; N] = each(|i| elementary::exp_in_range(log_x[i] * (-1.0 / 3.0)));
    each(|i| {
        let (x, rough) = (x[i], rough[i]);
        let missing = 1.0 - x * rough * rough * rough;
        let two_thirds = x * (rough + rough * missing * (1.0 / 3.0));
        let [light, heavy] = joining_powers(x, log_x[i]);
        HERTZ_LIMIT * two_thirds * (1.0 - light) + heavy_limit(x) * heavy
    })
}

/// Computes x^1.51 and x^1.04 for 0 < x <= 1 from one exponential: x^1.5 (x^0.01) and x (x^0.01)^4.
#[inline(always)]
pub(crate) fn joining_powers(x: f64, log_x: f64) -> [f64; 2] {
    joining_powers_by(&elementary::exp_in_range, x, log_x)
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
    use crate::samples::assert_batch_has_the_digits_of_each;

    fn sinusoid() -> ElasticSinusoid {
        ElasticSinusoid::new(&MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap()), 0.01)
    }

    #[test]
    fn the_area_steps_down_at_four_fifths_of_complete_contact_as_published() {
        let step = sinusoid().breaks().next().unwrap();
        let (below, above) = (light_joined_at(0.8), heavy_limit(0.8));
        assert!((above - below + 4.176e-4).abs() < 0.005e-4, "{}", above - below);
        assert!((step.step - (above / below - 1.0)).abs() < 1e-15);
    }

    #[test]
    fn many_interferences_have_the_digits_of_each() {
        let law = sinusoid();
        let breaks = law.breaks().map(|b| law.deformation_over_amplitude(b.at));
        assert_batch_has_the_digits_of_each(
            &breaks.collect::<Vec<_>>(),
            &[-0.0, -1e-300, -1e-9, -0.5, -7.0, f64::INFINITY, f64::NAN],
            |ratio| {
                let pressure_pa = law.pressure_at_interference_pa(ratio);
                (pressure_pa, law.area_fraction(pressure_pa))
            },
            |ratios, pressures, areas| law.pressures_and_areas_at_interferences(ratios, pressures, areas),
        );
        assert_batch_has_the_digits_of_each(
            &[1.0],
            &[-0.0, -0.5, f64::INFINITY, f64::NAN],
            |ratio| (law.pressure_at_interference_pa(ratio), 0.0),
            |ratios, pressures, others| {
                law.pressures_at_interferences(ratios, pressures);
                others.fill(0.0);
            },
        );
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
            let deviation = area_fraction_at(x) / solved - 1.0;
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
