//! Panels: stretches of a law under one rule, the law at their nodes, and its sums against the density of the heights.

use asperity::elementary;
use multiversion::multiversion;

use super::Sums;
use super::rules::{Coordinate, LANES, Lanes, Rule, error_of_rule};
use crate::asperities::answers::{Asperities, Response};
use crate::asperities::pieces::LawChart;
use crate::gaussian::density::{DENSITY_SCALE, density, log_reference_density, tail};

/// Panels with the law at their nodes, and the density there at one separation.
pub(crate) struct Panels<'a> {
    pub asperities: &'a dyn Asperities,
    pub sigma_s_m: f64,
    /// Separation around which they are laid.
    pub centre: f64,
    pub list: Vec<Panel<'a>>,
    /// Nodes, with the density at the separation `u`, over the reference density.
    pub nodes: Nodes,
    u: f64,
    /// Interference, in units of sigma_s, from which on the response is constant, and that response.
    pub saturation: Option<(f64, Response)>,
    /// Law evaluations spent.
    pub evaluations: usize,
    /// Estimate of the larger relative error of the rules in the two integrals at the centre.
    pub relative_error: f64,
}

impl<'a> Panels<'a> {
    /// Creates an empty set of panels around a separation, with capacity for some nodes.
    pub fn around(centre: f64, asperities: &'a dyn Asperities, sigma_s_m: f64, nodes: usize) -> Self {
        Panels {
            asperities,
            sigma_s_m,
            centre,
            list: Vec::new(),
            nodes: Nodes::with_room_for(nodes),
            u: centre,
            saturation: None,
            evaluations: 0,
            relative_error: 0.0,
        }
    }

    /// Moves to a separation near the centre: the sums are taken there from now on.
    pub fn go_to(&mut self, u: f64) {
        let density = Density::new(self.centre, u);
        for panel in &self.list {
            let Rows { places, densities, .. } = self.nodes.rows(panel.nodes);
            density.at(places, densities);
        }
        self.u = u;
    }

    /// Integrals at the current separation.
    pub fn sums(&self) -> Sums {
        let (u, shift) = (self.u, Density::new(self.centre, self.u).shift);
        let mut sums = [[0.0; LANES]; 5];
        for panel in &self.list {
            add(&mut sums, shift, &self.nodes.summed(panel.nodes));
        }
        let mut total = sums.map(|lanes: Lanes| DENSITY_SCALE * total(lanes));
        if let Some((from, response)) = self.saturation {
            let share = tail(u, from);
            let at_edge = density(u, from);
            total[0] += share * response.pressure_pa;
            total[1] += at_edge * response.pressure_pa;
            total[2] += (share + (u + from) * at_edge) * response.pressure_pa;
            total[3] += ((u + from).powi(2) + 2.0) * at_edge * response.pressure_pa;
            total[4] += share * response.area_fraction;
        }
        let [pressure_pa, first, second, third, area_fraction] = total;
        Sums::new(pressure_pa, area_fraction, [first, second, third].map(|sum| sum / pressure_pa))
    }

    /// Estimated errors of a panel's contributions to pressure \[Pa\] and area fraction.
    pub fn errors(&self, panel: &Panel<'_>) -> [f64; 2] {
        panel.errors(&self.nodes.summed(panel.nodes))
    }

    /// Part of the pressure \[Pa\], over the reference density, that is carried beyond an interference \[m\].
    pub fn load_above_pa(&self, interference_m: f64) -> f64 {
        let s = interference_m / self.sigma_s_m;
        let panels: f64 = self
            .list
            .iter()
            .map(|panel| {
                let Summands { pressures_pa, densities, .. } = self.nodes.summed(panel.nodes);
                let loads = pressures_pa.as_flattened().iter().zip(densities.as_flattened());
                let loads = loads.map(|(pressure_pa, density)| density * pressure_pa);
                panel.sum_above(loads, panel.variable.at(s, interference_m))
            })
            .sum();
        let saturated =
            self.saturation.map_or(0.0, |(from, response)| tail(self.u, from.max(s)) * response.pressure_pa);
        panels * DENSITY_SCALE + saturated
    }
}

/// Adds the nodes of a panel to the sums of the load, of its first three moments over the height, and of the area.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn add<'a>(sums: &mut [Lanes; 5], shift: f64, summands: &Summands<'a>) {
    let Summands { places, pressures_pa, area_fractions, densities } = *summands;
    let [loads, firsts, seconds, thirds, areas] = sums;
    for (((place, pressure_pa), area_fraction), density) in
        places.iter().zip(pressures_pa).zip(area_fractions).zip(densities)
    {
        for lane in 0..LANES {
            let height = place[lane] + shift;
            let load = density[lane] * pressure_pa[lane];
            let moment = height * load;
            let second = height * moment;
            loads[lane] += load;
            firsts[lane] += moment;
            seconds[lane] += second;
            thirds[lane] += height * second;
            areas[lane] += density[lane] * area_fraction[lane];
        }
    }
}

/// Coordinate that a panel is integrated over.
#[derive(Clone, Copy)]
pub(crate) enum Variable<'a> {
    /// The quadrature's own coordinate of the interference.
    Own(Coordinate),
    /// Coordinate provided by the law.
    Law(&'a dyn LawChart),
}

impl Variable<'_> {
    /// Value at an interference, given in units of sigma_s and in metres.
    pub fn at(self, s: f64, interference_m: f64) -> f64 {
        match self {
            Variable::Own(coordinate) => coordinate.at(s),
            Variable::Law(chart) => chart.coordinate(interference_m),
        }
    }

    /// True for the variable of a stretch over decades of the interference.
    fn spans_decades(self) -> bool {
        matches!(self, Variable::Own(coordinate) if coordinate.spans_decades())
    }
}

/// Stretch of one variable under one rule.
#[derive(Clone, Copy)]
pub(crate) struct Panel<'a> {
    pub variable: Variable<'a>,
    pub from: f64,
    pub to: f64,
    pub halvings: usize,
    /// `None` for the trapezoidal rule of rough quadratures, whose error is not needed.
    pub rule: Option<&'static Rule>,
    pub nodes: Block,
}

impl Panel<'_> {
    /// Estimated errors of the contributions to pressure \[Pa\] and area fraction, from the values at the nodes. Over
    /// decades, singularities of the law that lie closer than those of the density, but are weak, take over late.
    pub fn errors(&self, values: &Summands<'_>) -> [f64; 2] {
        const COUNTED_ON_OVER_DECADES: f64 = 0.3;
        let Some(rule) = self.rule else { return [0.0; 2] };
        let onward = if self.variable.spans_decades() { COUNTED_ON_OVER_DECADES } else { 1.0 };
        let Coefficients { wholes, coefficients } = coefficients(values, &rule.probes);
        [0, 1].map(|i| DENSITY_SCALE * error_of_rule(total(wholes[i]), coefficients[i].map(total), onward))
    }

    /// Sums weighted values beyond a value of the variable: the integral there of the polynomial through them.
    pub fn sum_above(&self, weighted_values: impl Iterator<Item = f64>, at: f64) -> f64 {
        let x = (2.0 * at - self.from - self.to) / (self.to - self.from);
        match self.rule {
            _ if x <= -1.0 => weighted_values.sum(),
            Some(rule) if x < 1.0 => rule.integral_above(x, weighted_values),
            _ => 0.0,
        }
    }
}

/// Sums of the pressures and of the areas over the nodes of a panel, with the Legendre coefficients of both that the
/// probes of its rule give.
#[derive(Default)]
struct Coefficients {
    wholes: [Lanes; 2],
    coefficients: [[Lanes; 4]; 2],
}

#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn coefficients<'a>(values: &Summands<'a>, probes: &[[Lanes; 4]]) -> Coefficients {
    let mut sums = Coefficients::default();
    for (((pressure_pa, area_fraction), density), probes) in
        values.pressures_pa.iter().zip(values.area_fractions).zip(values.densities).zip(probes)
    {
        for (quantity, value) in [pressure_pa, area_fraction].into_iter().enumerate() {
            for lane in 0..LANES {
                let value = density[lane] * value[lane];
                sums.wholes[quantity][lane] += value;
                for (sum, probe) in sums.coefficients[quantity].iter_mut().zip(probes) {
                    sum[lane] += value * probe[lane];
                }
            }
        }
    }
    sums
}

/// Number of nodes that rows are filled up to a multiple of, so that no node is left over for a loop over single ones.
const FILLED_TO: usize = 8;

/// Rows of all panels, one panel after the other.
pub(crate) struct Nodes {
    values: Vec<f64>,
}

/// Position of the nodes of a panel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    at: usize,
    row: usize,
}

/// Nodes of a panel, an entry in each row for each of them, filled up with nodes of no weight. Lengths are in units of
/// sigma_s.
pub(crate) struct Rows<'a> {
    /// Height u + s at the separation u of the frame if that is not positive, else the interference s.
    pub places: &'a mut [f64],
    /// Weight times the pressure of the law.
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
    /// Density at the separation of the last sums.
    pub densities: &'a mut [f64],
}

/// Summands over the nodes of a panel, in lanes.
pub(crate) struct Summands<'a> {
    pub places: &'a [Lanes],
    pub pressures_pa: &'a [Lanes],
    pub area_fractions: &'a [Lanes],
    pub densities: &'a [Lanes],
}

impl Nodes {
    const ROWS: usize = 4;

    /// Creates an empty set of nodes with a capacity.
    pub fn with_room_for(count: usize) -> Self {
        Nodes { values: Vec::with_capacity(Self::ROWS * count) }
    }

    /// Length of the rows of a panel.
    pub fn row(count: usize) -> usize {
        count.next_multiple_of(FILLED_TO)
    }

    /// Adds the nodes of one more panel, all zero.
    pub fn add(&mut self, count: usize) -> Block {
        let (at, row) = (self.values.len(), Self::row(count));
        self.values.resize(at + Self::ROWS * row, 0.0);
        Block { at, row }
    }

    /// Rows of a panel.
    pub fn rows(&mut self, block: Block) -> Rows<'_> {
        let Block { at, row } = block;
        let [places, pressures_pa, area_fractions, densities] =
            split(&mut self.values[at..at + Self::ROWS * row], row);
        Rows { places, pressures_pa, area_fractions, densities }
    }

    /// Rows of a panel as summands.
    pub fn summed(&self, block: Block) -> Summands<'_> {
        let (places, rest) = self.values[block.at..].split_at(block.row);
        let (pressures_pa, rest) = rest.split_at(block.row);
        let (area_fractions, rest) = rest.split_at(block.row);
        Summands {
            places: places.as_chunks().0,
            pressures_pa: pressures_pa.as_chunks().0,
            area_fractions: area_fractions.as_chunks().0,
            densities: rest[..block.row].as_chunks().0,
        }
    }
}

/// Splits a slice into `ROWS` rows of a length.
pub(crate) fn split<const ROWS: usize>(rows: &mut [f64], length: usize) -> [&mut [f64]; ROWS] {
    let mut rest = rows;
    std::array::from_fn(|_| {
        let (row, others) = std::mem::take(&mut rest).split_at_mut(length);
        rest = others;
        row
    })
}

/// The sum of the lanes.
pub(crate) fn total([a, b, c, d]: Lanes) -> f64 {
    (a + b) + (c + d)
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_keep_their_nodes() {
        let mut nodes = Nodes::with_room_for(2);
        let blocks = [7, 8].map(|count| nodes.add(count));
        for (block, value) in blocks.into_iter().zip([1.0, 2.0]) {
            let rows = nodes.rows(block);
            assert_eq!(rows.area_fractions.len(), 8);
            rows.places.fill(value);
            rows.densities.fill(-value);
        }
        let first = nodes.summed(blocks[0]);
        assert_eq!(first.places, [[1.0; 4]; 2]);
        assert_eq!(first.densities, [[-1.0; 4]; 2]);
        assert_eq!(first.pressures_pa, [[0.0; 4]; 2]);
        assert_eq!(nodes.summed(blocks[1]).places, [[2.0; 4]; 2]);
        assert_eq!(total([1.0, 2.0, 3.0, 4.0]), 10.0);
    }
}
