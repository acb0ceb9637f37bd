//! Density of the heights at the nodes of a quadrature.

use asperity::elementary;
use multiversion::multiversion;

use super::coordinate::Coordinate;
use crate::gaussian::density::log_reference_density;

/// Density of the heights at the separation u, over the reference density, on a frame around another separation.
pub(crate) struct Density {
    centre: f64,
    /// True if places are heights.
    pub around_peak: bool,
    /// Offset from the place of a node to the height at which it meets the flat: u, or u less the centre.
    pub shift: f64,
    /// Part of the exponent that does not depend on the node.
    left: f64,
}

impl Density {
    /// Creates the density at the separation u, on a frame around another one.
    pub fn new(centre: f64, u: f64) -> Self {
        let log_reference = log_reference_density(u);
        if centre > 0.0 {
            // The reference density cancels u^2/2 unless the cell's neighbour lies across zero.
            Density { centre, around_peak: false, shift: u, left: 0.5 * u * u + log_reference }
        } else {
            Density { centre, around_peak: true, shift: u - centre, left: log_reference }
        }
    }

    /// Place of a node at the coordinate v of the interference s: its height at the centre, or else its interference.
    #[inline(always)]
    pub fn place(&self, coordinate: Coordinate, v: f64, s: f64) -> f64 {
        match coordinate {
            _ if !self.around_peak => s,
            // The coordinate is the height, to the last digit.
            Coordinate::Height { .. } => v,
            _ => s + self.centre,
        }
    }

    /// Densities of nodes at their places.
    pub fn at(&self, places: &[f64], densities: &mut [f64]) {
        densities_at(self, places, densities);
    }
}

#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn densities_at(of: &Density, places: &[f64], densities: &mut [f64]) {
    let Density { shift, left, around_peak, .. } = *of;
    if around_peak {
        for (place, density) in places.iter().zip(densities) {
            let height = place + shift;
            *density = elementary::exp(-0.5 * height * height - left);
        }
    } else {
        for (place, density) in places.iter().zip(densities) {
            *density = elementary::exp(-place * (shift + 0.5 * place) - left);
        }
    }
}
