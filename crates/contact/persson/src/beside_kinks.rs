//! Areas beside kinks of the hardness, which are too sharp for the modes of the stress.
//!
//! Where the growth d(H^2)/dV changes, A_pl responds with the root of V - V_i, in a layer of that width at the hardness. The modes
//! resolve the layer once it is wider than a few hundredths of the hardness. Up to there an integral equation gives the areas, from
//! the modes at the last variance before the layer. The modes themselves pass the layer, and are accurate again behind it.

use crate::areas::ContactAreas;
use crate::hardness_path::{HardnessPath, Piece};
use crate::plastic_march::PlasticMarch;
use crate::stress_modes::{StressEquations, StressModes};
use crate::stress_profile::StressProfile;

/// Change of the growth from which on a kink counts, and width in sqrt(V - V_i)/H over which its effect on the modes decays: a
/// change by c leaves areas off by 2e-5 c exp(-(width/RESOLUTION)^2) of the contact, plastic areas by some 20 times as much.
const CHANGE_MIN: f64 = 5e-4;
const RESOLUTION: f64 = 0.024;
/// Root of the variance that is left before it comes to an end, in the hardness: below it the growth changes too fast for the modes.
const REST_MIN: f64 = 0.05;
/// Root at which a stop is made before that, where they still resolve the stress.
const REST_STOP: f64 = 0.08;

/// Areas that the modes do not resolve.
pub(crate) struct BesideKinks<'a> {
    path: &'a HardnessPath,
    pressure_pa: f64,
    equations: &'static StressEquations,
    /// Last variance \[Pa^2\] at which the modes resolved the stress, and the modes there.
    resolved: (f64, StressModes),
    /// Integral equation from there on, once it is needed.
    march: Option<PlasticMarch<'a>>,
    /// Variance \[Pa^2\] up to which the last kinks count.
    until_pa2: f64,
}

impl<'a> BesideKinks<'a> {
    /// Starts at a variance \[Pa^2\] at which the modes resolve the stress.
    pub(crate) fn new(
        path: &'a HardnessPath,
        pressure_pa: f64,
        equations: &'static StressEquations,
        resolved: (f64, StressModes),
    ) -> Self {
        let until_pa2 = resolved.0;
        BesideKinks { path, pressure_pa, equations, resolved, march: None, until_pa2 }
    }

    /// Registers the kink with which the piece at a place begins.
    pub(crate) fn enter(&mut self, at: usize) {
        self.until_pa2 = self.until_pa2.max(end_of_kink_pa2(self.path, at));
    }

    /// Returns the areas at a variance of a piece, from the modes there if they resolve the stress.
    pub(crate) fn areas(&mut self, piece: &Piece, variance_pa2: f64, modes: &StressModes) -> ContactAreas {
        let hardness_pa = piece.hardness_pa(variance_pa2);
        if variance_pa2 >= self.until_pa2 && !is_near_end(piece, variance_pa2) {
            (self.resolved, self.march) = ((variance_pa2, modes.clone()), None);
            return self.equations.areas(modes, self.pressure_pa / hardness_pa);
        }
        let march = self.march.get_or_insert_with(|| {
            let (from_pa2, modes) = self.resolved.clone();
            let hardness_pa = self.path.hardness_pa(from_pa2);
            let profile = StressProfile::new(self.equations, modes, self.pressure_pa, hardness_pa, from_pa2);
            PlasticMarch::from_profile(self.path, self.pressure_pa, profile)
        });
        march.extend_to(variance_pa2);
        march.areas_at(variance_pa2)
    }
}

/// Returns the variance \[Pa^2\] up to which the modes do not resolve the kink with which the piece at a place begins; the beginning
/// of the piece if the kink does not count.
fn end_of_kink_pa2(path: &HardnessPath, at: usize) -> f64 {
    let (before, piece) = (path.piece(at.saturating_sub(1)), path.piece(at));
    let kink_pa2 = piece.from_variance_pa2;
    let change = (piece.growth_of_square(kink_pa2) - before.growth_of_square(kink_pa2)).abs();
    let width = RESOLUTION * (change / CHANGE_MIN).max(1.0).ln().sqrt();
    kink_pa2 + (width * piece.hardness_pa(kink_pa2)).powi(2)
}

/// Returns true if the hardness grows too fast for the modes, because the variance of a piece comes to an end.
fn is_near_end(piece: &Piece, variance_pa2: f64) -> bool {
    let rest_pa = REST_MIN * piece.hardness_pa(variance_pa2);
    piece.left_pa2(variance_pa2) < rest_pa * rest_pa && stop_before_end(piece, variance_pa2).is_some()
}

/// Returns true if the modes resolve the stress at a variance \[Pa^2\], as far as the piece decides that leads to it.
pub(crate) fn is_resolved(path: &HardnessPath, variance_pa2: f64) -> bool {
    let at = path.piece_at(variance_pa2.next_down());
    variance_pa2 >= end_of_kink_pa2(path, at) && !is_near_end(&path.piece(at), variance_pa2)
}

/// Returns the variance \[Pa^2\] at which to stop on a piece up to `to_pa2`, before the hardness grows too fast for the modes
/// towards the end of the variance; the beginning of the piece if that is later. `None` if the hardness does not grow so fast.
pub(crate) fn stop_before_end(piece: &Piece, to_pa2: f64) -> Option<f64> {
    let rest_pa = REST_STOP * piece.hardness_pa(to_pa2);
    let stop_pa2 = (to_pa2 + piece.left_pa2(to_pa2) - rest_pa * rest_pa).max(piece.from_variance_pa2);
    let grows = || piece.growth_of_square(to_pa2) - piece.growth_of_square(stop_pa2) > CHANGE_MIN;
    (stop_pa2 < to_pa2 && grows()).then_some(stop_pa2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::HardnessKnot;
    use crate::growing_hardness::areas_along;

    /// Asserts that areas agree with the integral equation from the beginning of the path on, which splits at every kink.
    fn assert_same(path: &HardnessPath, pressure: f64, variances: &[f64]) {
        let mut march = PlasticMarch::new(path, pressure);
        march.extend_to(variances[variances.len() - 1]);
        for (found, variance) in areas_along(path, pressure, variances).iter().zip(variances) {
            let known = march.areas_at(*variance);
            let [contact, plastic] =
                [found.contact() / known.contact() - 1.0, found.plastic / known.plastic - 1.0];
            assert!(contact.abs() < 1e-8 && plastic.abs() < 3e-7, "{variance}: {contact:e} {plastic:e}");
        }
    }

    #[test]
    fn areas_beside_a_kink_are_those_of_the_integral_equation() {
        for growth in [0.1, 1.0, 4.0, 12.0f64] {
            let hardness = (1.0 + 0.5 * growth).sqrt();
            let path = HardnessPath::with_squared_growth(1.0, growth).capped(hardness);
            let kink = path.piece(1).from_variance_pa2;
            let widths = [1e-3, 3e-3, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.2, 0.3];
            for pressure in [0.001, 0.3] {
                for width in widths {
                    assert_same(&path, pressure, &[0.3, kink + (width * hardness).powi(2)]);
                }
                assert_same(&path, pressure, &widths.map(|width| kink + (width * hardness).powi(2)));
            }
        }
    }

    #[test]
    fn areas_at_the_end_of_a_variance_are_those_of_the_integral_equation() {
        // From V = 1 on the variance comes to an end after another `width` squared, all of it but exp(-`log`).
        for (width, log, growth) in
            [(0.5f64, 5.0f64, 12.0), (0.5, 9.0, 12.0), (0.5, 9.0, 25.0), (0.2, 6.0, 12.0)]
        {
            let exponent = 1.5 * growth * width * width * (-log).exp();
            let knot = |ln_q: f64| HardnessKnot {
                wavevector_rad_per_m: ln_q.exp(),
                variance_pa2: 1.0 + width * width * libm::expm1(-3.0 * ln_q) / libm::expm1(-log),
                hardness_pa: (exponent * ln_q).exp(),
                variance_exponent: -3.0,
            };
            let (start, end) = (knot(0.0), knot(log / 3.0));
            let first = HardnessKnot {
                wavevector_rad_per_m: 0.5,
                variance_pa2: 0.0,
                variance_exponent: 3.0,
                ..start
            };
            let last = HardnessKnot { wavevector_rad_per_m: 1e5, variance_pa2: 2.0, ..end };
            let path =
                HardnessPath::through(&[first, start, HardnessKnot { variance_exponent: 3.0, ..end }, last]);
            let at = |beyond: f64| end.variance_pa2 + beyond * beyond;
            assert_same(&path, 0.1, &[0.5, 1.0, end.variance_pa2, at(1e-3), at(0.03), at(0.1), at(0.5)]);
        }
    }
}
