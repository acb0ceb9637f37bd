//! Integrals over panels of the variance that are near: the kernels at the nodes of their rules.

use std::f64::consts::PI;

use multiversion::multiversion;

use crate::hardness_path::Piece;
use crate::panel_rules::Polynomial;
use crate::sources::sum;

/// Nodes of rules over an arc, an angle each, and the kernels there: number by number, so that several are computed at once.
#[derive(Debug, Default)]
pub(crate) struct NearPanel {
    /// Cosines and sines of the middles of the pieces to which the nodes belong.
    middles: [Vec<f64>; 2],
    /// Angles from there.
    deviations: Vec<f64>,
    /// Weights of the angles, later of the kernels of A_pl and of A.
    weights: [Vec<f64>; 2],
    /// Variables of the panel, in \[-1, 1\].
    variables: Vec<f64>,
}

/// Panel as it is seen from a place (V, H) above it.
pub(crate) struct Sight {
    pub(crate) radius_pa: f64,
    pub(crate) piece: Piece,
    /// Distances of the panel's ends from the start of its piece of the path \[Pa\].
    pub(crate) kink_distances_pa: [f64; 2],
    /// Hardness H \[Pa\].
    pub(crate) hardness_pa: f64,
    /// Pressure p \[Pa\] if the panel holds a polynomial times exp(-E).
    pub(crate) steep_about_pa: Option<f64>,
    /// Exponent of a factor of the integral.
    pub(crate) relief: f64,
}

impl NearPanel {
    pub(crate) fn clear(&mut self) {
        for numbers in self.middles.iter_mut().chain([&mut self.deviations]).chain(&mut self.weights) {
            numbers.clear();
        }
    }

    /// Appends the nodes of a rule between two angles.
    pub(crate) fn append(&mut self, rule: &numerics::GaussLegendre, start: f64, end: f64) {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let (sine, cosine) = middle.sin_cos();
        let count = self.deviations.len() + rule.nodes().len();
        for (numbers, value) in self.middles.iter_mut().zip([cosine, sine]) {
            numbers.resize(count, value);
        }
        self.deviations.extend(rule.nodes().iter().map(|node| half * node));
        self.weights[0].extend(rule.weights().iter().map(|weight| half * weight));
    }

    /// Turns the weights of the angles into those of A_pl in its two integrals.
    pub(crate) fn weigh(&mut self, sight: &Sight) {
        let count = self.deviations.len();
        self.variables.resize(count, 0.0);
        self.weights[1].resize(count, 0.0);
        weigh_each(sight, self);
    }

    /// Integrals of a polynomial of the panel's variable. Uses up the weights.
    pub(crate) fn integrals(&mut self, polynomial: &Polynomial) -> [f64; 2] {
        integrals_of_polynomial(
            polynomial,
            &mut self.variables,
            self.weights.each_mut().map(Vec::as_mut_slice),
        )
    }

    /// Integrals of the first powers of the panel's variable. Uses up the weights.
    pub(crate) fn integrals_of_powers(&mut self, size: usize) -> [Polynomial; 2] {
        let variables = &self.variables;
        self.weights.each_mut().map(|weights| integrals_of_powers(size, variables, weights))
    }
}

#[multiversion(targets("x86_64+avx2"))]
fn weigh_each(sight: &Sight, panel: &mut NearPanel) {
    let steep = sight.steep_about_pa.is_some();
    let count = panel.deviations.len();
    let [cosines, sines] = panel.middles.each_ref().map(|numbers| &numbers[..count]);
    let deviations = &panel.deviations[..count];
    let variables = &mut panel.variables[..count];
    let [plastic, contact] = panel.weights.each_mut().map(|numbers| &mut numbers[..count]);
    let [first_pa, last_pa] = sight.kink_distances_pa;
    let per_pa = 2.0 / (last_pa - first_pa);
    let kink_pa2 = sight.piece.from_variance_pa2;
    let (here_pa, pressure_pa) = (sight.hardness_pa, sight.steep_about_pa.unwrap_or_default());
    let scale = (2.0 / PI).sqrt() * if steep { 1.0 } else { sight.relief.exp() };
    for at in 0..count {
        let [by_cosine, by_sine] = cosine_and_sine(deviations[at]);
        let (cosine, sine) =
            (cosines[at] * by_cosine - sines[at] * by_sine, sines[at] * by_cosine + cosines[at] * by_sine);
        // The larger one follows from the smaller: a rounded node still lies on the circle, V - V' is the square of x.
        let (cosine, sine) = match cosine < sine {
            true => (cosine, (1.0 - cosine * cosine).sqrt()),
            false => ((1.0 - sine * sine).sqrt(), sine),
        };
        let (root_pa, from_kink_pa) = (sight.radius_pa * cosine, sight.radius_pa * sine);
        variables[at] = (from_kink_pa - first_pa) * per_pa - 1.0;
        let from_kink_pa2 = from_kink_pa * from_kink_pa;
        let there_pa = sight.piece.hardness_beyond_pa(from_kink_pa2);
        let weight = scale * plastic[at] * from_kink_pa / (root_pa * root_pa);
        // (H' - p)^2/(2V') is the distance E of the hardness from the stress.
        let exponent = match steep {
            true => {
                let distance_pa = there_pa - pressure_pa;
                sight.relief - 0.5 * distance_pa * distance_pa / (kink_pa2 + from_kink_pa2)
            }
            false => 0.0,
        };
        let passage = |distance_pa: f64| {
            let ratio = distance_pa / root_pa;
            distance_pa * asperity::elementary::exp(exponent - 0.5 * ratio * ratio)
        };
        plastic[at] = weight * (passage(here_pa + there_pa) - passage(here_pa - there_pa));
        contact[at] = weight * passage(there_pa);
    }
}

#[multiversion(targets("x86_64+avx2"))]
fn integrals_of_polynomial(
    polynomial: &Polynomial,
    variables: &mut [f64],
    weights: [&mut [f64]; 2],
) -> [f64; 2] {
    for t in &mut *variables {
        *t = polynomial.iter().rev().fold(0.0, |sum, coefficient| sum * *t + coefficient);
    }
    weights.map(|weights| {
        for (weight, value) in weights.iter_mut().zip(&*variables) {
            *weight *= value;
        }
        sum(weights)
    })
}

#[multiversion(targets("x86_64+avx2"))]
fn integrals_of_powers(size: usize, variables: &[f64], weights: &mut [f64]) -> Polynomial {
    let mut integrals = Polynomial::default();
    for integral in &mut integrals[..size] {
        *integral = sum(weights);
        for (weight, t) in weights.iter_mut().zip(variables) {
            *weight *= t;
        }
    }
    integrals
}

/// Cosine and sine of an angle up to pi/4 on either side, to rounding: without branches, so that several are computed at
/// once.
#[inline(always)]
fn cosine_and_sine(angle: f64) -> [f64; 2] {
    let square = angle * angle;
    let series = |coefficients: &[f64]| coefficients.iter().fold(0.0, |sum, c| sum * square + c);
    [1.0 + square * series(&COSINE), angle + angle * (square * series(&SINE))]
}

/// 1/k! with alternating signs, from k = 16 down to 2.
const COSINE: [f64; 8] = [
    1.0 / 20_922_789_888_000.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 479_001_600.0,
    -1.0 / 3_628_800.0,
    1.0 / 40_320.0,
    -1.0 / 720.0,
    1.0 / 24.0,
    -0.5,
];

/// 1/k! with alternating signs, from k = 17 down to 3.
const SINE: [f64; 8] = [
    1.0 / 355_687_428_096_000.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 39_916_800.0,
    1.0 / 362_880.0,
    -1.0 / 5040.0,
    1.0 / 120.0,
    -1.0 / 6.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosines_and_sines_are_those_of_the_library() {
        for k in -7854..=7854 {
            let angle = 1e-4 * f64::from(k);
            let [cosine, sine] = cosine_and_sine(angle);
            assert!((cosine - angle.cos()).abs() < 2.3e-16, "{angle}");
            assert!((sine - angle.sin()).abs() <= 2.3e-16 * angle.abs(), "{angle}");
        }
    }
}
