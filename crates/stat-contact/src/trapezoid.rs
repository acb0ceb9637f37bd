//! The trapezoidal rule over a window of Hertz's spheres.
//!
//! Their force is an even function of the coordinate, so that the rule converges exponentially; their area is an odd one,
//! and has a closed form instead.

use wide::f64x2;

use crate::asperities::Hertzian;
use crate::cell::{Cell, Precision};
use crate::coordinate::Coordinate;
use crate::density::Density;
use crate::frame::Sums;
use crate::gaussian::{DENSITY_SCALE, Window, first_moment};
use crate::nodes::{LANES, total};

/// The nodes (first + 0.5) step, (first + 1.5) step and so on, `count` of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trapezoid {
    pub step: f64,
    first: f64,
    pub count: usize,
}

impl Trapezoid {
    /// The rule that integrates a unit Gaussian between two coordinates to exp(-digits).
    pub fn between(from: f64, to: f64, digits: f64) -> Self {
        let step = Coordinate::trapezoidal_step(digits);
        Trapezoid { step, first: (from / step - 0.5).ceil(), count: ((to - from) / step).ceil() as usize }
    }

    /// A node.
    #[inline(always)]
    pub fn at(&self, k: usize) -> f64 {
        (self.first + f64::from(k as u32) + 0.5) * self.step
    }
}

/// The integrals at a separation u of a cell, and the nodes that they took, where all asperities in reach are Hertz's: what
/// the frame of the cell gives, without a frame.
pub(crate) fn sums_of_hertz(
    hertz: &Hertzian,
    sigma_s_m: f64,
    cell: Cell,
    precision: Precision,
    u: f64,
) -> Option<(Sums, usize)> {
    /// More than nearly all windows need.
    const AT_ONCE: usize = 32;
    let window = Window::new(cell.nearest(), cell.farthest(), precision.drop);
    if window.high * sigma_s_m > hertz.until_m {
        return None;
    }
    let centre = cell.centre();
    let coordinate = Coordinate::around(centre, cell.farthest(), precision.digits);
    let [from, to] = [window.low, window.high].map(|s| coordinate.of(s));
    let rule = Trapezoid::between(from, to, precision.digits);
    let density = Density::new(centre, u);
    let (mut load, mut moment) = (f64x2::ZERO, f64x2::ZERO);
    for first in (0..rule.count).step_by(AT_ONCE) {
        let count = AT_ONCE.min(rule.count - first);
        let mut rows = [[0.0; AT_ONCE]; 5];
        let [nodes, interferences, slopes, places, densities] = rows.each_mut().map(|row| &mut row[..count]);
        for (k, node) in nodes.iter_mut().enumerate() {
            *node = rule.at(first + k);
        }
        coordinate.interferences(nodes, interferences, slopes);
        for ((place, &s), &v) in places.iter_mut().zip(&*interferences).zip(&*nodes) {
            *place = density.place(coordinate, v, s);
        }
        density.at(places, densities);
        let [_, interferences, slopes, places, densities] = rows.each_ref().map(|row| row.as_chunks().0);
        for (((s, slope), place), density_at) in
            interferences.iter().zip(slopes).zip(places).zip(densities).take(count.div_ceil(LANES))
        {
            let [s, slope, place, density_at] = [s, slope, place, density_at].map(|lanes| f64x2::new(*lanes));
            let share = density_at * slope * s * s.sqrt();
            load += share;
            moment += (place + density.shift) * share;
        }
    }
    let (load, moment) = (total(load), total(moment));
    let scale_pa = hertz.pressure_per_three_halves * sigma_s_m * sigma_s_m.sqrt();
    let sums = Sums::of_hertz(
        DENSITY_SCALE * rule.step * load * scale_pa,
        hertz.area_per_m * sigma_s_m * first_moment(u),
        moment / load,
    );
    Some((sums, rule.count))
}
