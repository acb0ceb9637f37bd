//! The integrals over the heights of the asperities, prepared for all separations near one.
//!
//! p(d) = eta Int_0^inf F(w) g(d + w) dw, and the same with the area A (Greenwood & Williamson 1966). The law is costly
//! and does not depend on d, the density is cheap and does: a frame holds the law's values at the nodes of a
//! quadrature built around one separation, and sums them against the density at any separation nearby. A search for
//! the separation that carries a load therefore evaluates the law once, not once per step.

use crate::asperities::{Asperities, Chart, Piece, Point, Response};
use crate::cell::{Cell, Precision};
use crate::coordinate::Coordinate;
use crate::gaussian::{self, DENSITY_SCALE, Window, log_reference_density};
use crate::legendre::{Rule, integrals_above, legendre_polynomials};

/// Law evaluations after which the error is accepted as it is, and reported.
const MOST_EVALUATIONS: usize = 3000;
/// Nodes of a rule above which a panel is halved rather than given more.
const MOST_NODES: usize = 28;
/// How often a panel is halved before its error is accepted.
const MOST_HALVINGS: usize = 24;

/// The law at the nodes of a quadrature.
pub(crate) struct Frame<'a> {
    asperities: &'a dyn Asperities,
    centre: f64,
    sigma_s_m: f64,
    coordinate: Coordinate,
    precision: Precision,
    panels: Vec<Panel>,
    /// The area fraction per unit of interference where it is proportional to it throughout.
    area_per_sigma: Option<f64>,
    /// The interference, in units of sigma_s, from which on the response is this one.
    saturation: Option<(f64, Response)>,
    /// The highest interference, in units of sigma_s, that counts.
    high: f64,
    /// Law evaluations spent.
    pub evaluations: usize,
}

/// The integrals at one separation, over the reference density there.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub pressure_pa: f64,
    pub area_fraction: f64,
    /// Mean and mean square height u + s, weighted by load.
    mean_height: f64,
    mean_square_height: f64,
}

impl Sums {
    /// First and second derivative of ln p by u.
    pub fn log_pressure_slopes(&self) -> (f64, f64) {
        (-self.mean_height, self.mean_square_height - self.mean_height * self.mean_height - 1.0)
    }
}

/// A stretch of one chart under one rule.
struct Panel {
    chart: Chart,
    coordinate: Coordinate,
    from: f64,
    to: f64,
    halvings: usize,
    /// None for the trapezoidal rule, whose error is known beforehand.
    rule: Option<&'static Rule>,
    nodes: Vec<Node>,
}

/// One node, its weight multiplied into the response. Lengths in units of sigma_s.
#[derive(Clone, Copy)]
struct Node {
    interference: f64,
    height: f64,
    pressure_pa: f64,
    area_fraction: f64,
}

impl<'a> Frame<'a> {
    /// The quadrature that serves a cell of separations at a precision.
    pub fn for_cell(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        cell: Cell,
        precision: Precision,
    ) -> Self {
        let window = Window::new(cell.nearest(), cell.farthest(), precision.drop);
        let coordinate = Coordinate::around(cell.centre(), cell.farthest(), precision.digits);
        let mut frame = Self::empty(asperities, sigma_s_m, cell.centre(), coordinate, precision);
        frame.high = window.high;
        if let Some((until_m, area_per_m)) = asperities.hertzian()
            && window.high * sigma_s_m <= until_m
        {
            frame.area_per_sigma = Some(area_per_m * sigma_s_m);
            frame.add_trapezoid(&window);
            return frame;
        }
        frame.saturation = asperities.saturation().map(|(from_m, at)| (from_m / sigma_s_m, at));
        let (low_m, high_m) = (window.low * sigma_s_m, window.high * sigma_s_m);
        for piece in asperities.pieces(low_m, high_m) {
            frame.add_piece(piece, &window);
        }
        frame.refine();
        frame
    }

    /// A few nodes around one separation, blind to the breaks of the law: within a few percent.
    pub fn rough(asperities: &'a dyn Asperities, sigma_s_m: f64, u: f64) -> Self {
        const NODES: usize = 7;
        const DROP: f64 = 9.0;
        let window = Window::new(u, u, DROP);
        let precision = Precision::new(Precision::COARSEST);
        let coordinate = Coordinate::around(u, u, precision.digits);
        let mut frame = Self::empty(asperities, sigma_s_m, u, coordinate, precision);
        let ends = [window.low, window.high].map(|s| coordinate.of(s));
        frame.add_panel(Chart::Interference, coordinate, ends, 0, Rule::of_at_least(NODES));
        frame
    }

    fn empty(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        centre: f64,
        coordinate: Coordinate,
        precision: Precision,
    ) -> Self {
        Frame {
            asperities,
            centre,
            sigma_s_m,
            coordinate,
            precision,
            panels: Vec::with_capacity(4),
            high: 0.0,
            area_per_sigma: None,
            saturation: None,
            evaluations: 0,
        }
    }

    fn add_piece(&mut self, piece: Piece, window: &Window) {
        let low = window.low.max(piece.from_m / self.sigma_s_m);
        let high = window.high.min(piece.to_m / self.sigma_s_m);
        if low >= high {
            return;
        }
        let coordinate = match piece.chart {
            Chart::Interference => self.coordinate.between(low, high),
            _ => self.coordinate,
        };
        let [from, to] = [low, high].map(|s| match piece.chart {
            Chart::Interference => coordinate.of(s),
            chart => self.asperities.coordinate(chart, s * self.sigma_s_m),
        });
        // Over decades a law has more to be resolved than the density.
        let more = if coordinate.spans_decades() { 1.4 } else { 1.0 };
        let rule = Rule::of_at_least((more * self.nodes_between(low, high)).ceil() as usize);
        self.add_panel(piece.chart, coordinate, [from, to], 0, rule);
    }

    /// The trapezoidal rule over a window of Hertz's spheres. Their force is an even function of the coordinate, so that
    /// the rule converges exponentially; their area is an odd one, and has a closed form instead.
    fn add_trapezoid(&mut self, window: &Window) {
        let step = Coordinate::trapezoidal_step(self.precision.digits);
        let [from, to] = [window.low, window.high].map(|s| self.coordinate.of(s));
        let first = (from / step - 0.5).ceil();
        let count = ((to - from) / step).ceil() as usize;
        let nodes = (0..count)
            .map(|k| self.node(Chart::Interference, self.coordinate, (first + k as f64 + 0.5) * step, step))
            .collect();
        self.evaluations += count;
        let (chart, coordinate) = (Chart::Interference, self.coordinate);
        self.panels.push(Panel { chart, coordinate, from, to, halvings: 0, rule: None, nodes });
    }

    fn add_panel(
        &mut self,
        chart: Chart,
        coordinate: Coordinate,
        [from, to]: [f64; 2],
        halvings: usize,
        rule: &'static Rule,
    ) {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let nodes = rule
            .nodes
            .iter()
            .map(|n| self.node(chart, coordinate, middle + half * n.x, half * n.weight))
            .collect();
        self.evaluations += rule.nodes.len();
        self.panels.push(Panel { chart, coordinate, from, to, halvings, rule: Some(rule), nodes });
    }

    fn node(&self, chart: Chart, coordinate: Coordinate, at: f64, weight: f64) -> Node {
        let (interference, slope, height, response) = if chart == Chart::Interference {
            let (s, slope) = coordinate.interference(at);
            let response = self.asperities.at_interference(s * self.sigma_s_m);
            (s, slope, coordinate.height(at, self.centre, s), response)
        } else {
            let Point { interference_m, slope_m, response } = self.asperities.at_coordinate(chart, at);
            let s = interference_m / self.sigma_s_m;
            (s, slope_m / self.sigma_s_m, self.centre + s, response)
        };
        let weight = weight * slope;
        Node {
            interference,
            height,
            pressure_pa: weight * response.pressure_pa,
            area_fraction: weight * response.area_fraction,
        }
    }

    /// Nodes that a Gauss-Legendre rule needs between two interferences, from how far the exponent of the density runs
    /// (as its square root, as for a Gaussian), how much there is to be resolved beside it, and how little of
    /// the whole lies there. An undershoot is mended by halving.
    fn nodes_between(&self, low: f64, high: f64) -> f64 {
        let exponent = |s: f64| log_reference_density(self.centre) + 0.5 * (self.centre + s).powi(2);
        let (at_low, at_high) = (exponent(low), exponent(high));
        let holds_peak = self.centre + low < 0.0 && self.centre + high > 0.0;
        let (run, least) = if holds_peak {
            (1.75 * (at_low + at_high), 0.0)
        } else {
            (0.95 * (at_high - at_low).abs(), at_low.min(at_high))
        };
        let reach = if self.centre > 1.0 { 1.0 / self.centre } else { 1.0 - self.centre.min(0.0) };
        let log_share = (2.0 * (high / reach).ln()).min(0.0) - (least - 3.0).max(0.0);
        let digits = (self.precision.digits + log_share).max(1.0);
        let smooth = digits / 0.85;
        0.5 * (digits * run + smooth * smooth).sqrt()
    }

    /// Gives more nodes to the panels whose error at the centre is above their share of the tolerance, or halves them.
    fn refine(&mut self) {
        // Few panels err as much as they may: with this share their sum stays about the tolerance.
        const SHARE: f64 = 0.3;
        let tolerance = SHARE * self.precision.tolerance;
        let mut at = 0;
        let totals = self.sums(self.centre);
        while at < self.panels.len() && self.evaluations < MOST_EVALUATIONS {
            let panel = &self.panels[at];
            let [pressure, area] = panel.errors(self.centre, self.centre);
            let fine = pressure <= tolerance * totals.pressure_pa && area <= tolerance * totals.area_fraction;
            let Panel { chart, coordinate, from, to, halvings, rule: Some(rule), .. } = *panel else {
                at += 1;
                continue;
            };
            if fine || halvings >= MOST_HALVINGS {
                at += 1;
                continue;
            }
            self.panels.remove(at);
            let nodes = rule.nodes.len();
            if nodes < MOST_NODES {
                self.add_panel(
                    chart,
                    coordinate,
                    [from, to],
                    halvings,
                    Rule::of_at_least(nodes + nodes / 3 + 1),
                );
                continue;
            }
            let (middle, rule) = (0.5 * (from + to), Rule::of_at_least(nodes * 3 / 4));
            self.add_panel(chart, coordinate, [from, middle], halvings + 1, rule);
            self.add_panel(chart, coordinate, [middle, to], halvings + 1, rule);
        }
    }

    /// Whether a separation is near enough to the centre.
    pub fn serves(&self, u: f64) -> bool {
        (u - self.centre).abs() < 0.2 * (1.0 + self.centre.max(0.0)) + 1e-15 * self.centre.abs()
    }

    /// The integrals at a separation near the centre.
    pub fn sums(&self, u: f64) -> Sums {
        let mut total = [0.0; 4];
        let mut add = |height: f64, pressure_pa: f64, area_fraction: f64| {
            let moment = height * pressure_pa;
            total[0] += pressure_pa;
            total[1] += moment;
            total[2] += height * moment;
            total[3] += area_fraction;
        };
        for node in self.panels.iter().flat_map(|panel| &panel.nodes) {
            let (height, density) = relative_density(self.centre, node, u);
            add(height, density * node.pressure_pa, density * node.area_fraction);
        }
        total.iter_mut().for_each(|sum| *sum *= DENSITY_SCALE);
        if let Some((from, response)) = self.saturation {
            let share = gaussian::tail(u, from);
            let at_edge = gaussian::density(u, from);
            total[0] += share * response.pressure_pa;
            total[1] += at_edge * response.pressure_pa;
            total[2] += (share + (u + from) * at_edge) * response.pressure_pa;
            total[3] += share * response.area_fraction;
        }
        if let Some(area_per_sigma) = self.area_per_sigma {
            total[3] = area_per_sigma * gaussian::first_moment(u);
        }
        Sums {
            pressure_pa: total[0],
            area_fraction: total[3],
            mean_height: total[1] / total[0],
            mean_square_height: total[2] / total[0],
        }
    }

    /// Estimate of the larger relative error of the two integrals at a separation.
    pub fn relative_error(&self, u: f64, sums: &Sums) -> f64 {
        const ROUNDING: f64 = 1e-14;
        let mut errors = [0.0; 2];
        for panel in &self.panels {
            let [pressure, area] = panel.errors(self.centre, u);
            errors[0] += pressure;
            errors[1] += area;
        }
        let rules = (errors[0] / sums.pressure_pa).max(errors[1] / sums.area_fraction);
        let drop = self.precision.drop;
        rules + 0.5 * drop * drop * (-drop).exp() + 3.0 * (-self.precision.digits).exp() + ROUNDING
    }

    /// Share of the load, at a separation, that is carried at interferences for which the law was not fitted.
    pub fn out_of_range_load_share(&self, u: f64, sums: &Sums) -> f64 {
        if self.area_per_sigma.is_some() {
            return 0.0;
        }
        let load_pa: f64 = self
            .asperities
            .out_of_fitted_range(self.high * self.sigma_s_m)
            .into_iter()
            .filter(|(from_m, to_m)| from_m < to_m)
            .map(|(from_m, to_m)| {
                let above = |at_m: f64| if at_m.is_finite() { self.load_above_pa(u, at_m) } else { 0.0 };
                above(from_m) - above(to_m)
            })
            .sum();
        (load_pa / sums.pressure_pa).clamp(0.0, 1.0)
    }

    /// The part of the pressure, over the reference density, that is carried beyond an interference \[m\].
    fn load_above_pa(&self, u: f64, interference_m: f64) -> f64 {
        let s = interference_m / self.sigma_s_m;
        let panels: f64 = self
            .panels
            .iter()
            .map(|panel| {
                let at = match panel.chart {
                    Chart::Interference => panel.coordinate.of(s),
                    chart => self.asperities.coordinate(chart, interference_m),
                };
                panel.load_above_pa(self.centre, u, at)
            })
            .sum();
        let saturated = self
            .saturation
            .map_or(0.0, |(from, response)| gaussian::tail(u, from.max(s)) * response.pressure_pa);
        panels * DENSITY_SCALE + saturated
    }
}

/// Height of a node at the separation u, and the density there over the reference density.
fn relative_density(centre: f64, node: &Node, u: f64) -> (f64, f64) {
    if centre > 0.0 {
        let s = node.interference;
        // What the reference density leaves of u^2/2: nothing, unless the cell's neighbour lies across zero.
        let left = 0.5 * u * u + log_reference_density(u);
        (u + s, (-s * (u + 0.5 * s) - left).exp())
    } else {
        let height = node.height + (u - centre);
        (height, (-0.5 * height * height - log_reference_density(u)).exp())
    }
}

impl Panel {
    /// Estimated errors of the pressure and the area that this panel adds.
    ///
    /// The rule errs by the Legendre coefficients beyond degree 2n. How those fall from degree n to 2n is judged by how
    /// they fall from 0 to n/2 and on to n: as fast again and twice as far where they fall geometrically or faster, no
    /// further than from n/2 to n behind an end-point power, where the fall levels off. It may level off later than n:
    /// three quarters of it are counted on, and less of the second stretch over decades, where singularities of the law
    /// that lie closer than those of the density, but are weak, take over late.
    fn errors(&self, centre: f64, u: f64) -> [f64; 2] {
        const COUNTED_ON: f64 = 0.75;
        const COUNTED_ON_OVER_DECADES: f64 = 0.3;
        let Some(rule) = self.rule else { return [0.0; 2] };
        let onward = if self.coordinate.spans_decades() { COUNTED_ON_OVER_DECADES } else { 1.0 };
        let mut coefficients = [[0.0; 5]; 2];
        for (node, at) in self.nodes.iter().zip(&rule.nodes) {
            let (_, density) = relative_density(centre, node, u);
            for (row, value) in coefficients.iter_mut().zip([node.pressure_pa, node.area_fraction]) {
                let value = value * density * DENSITY_SCALE;
                row[0] += value;
                row[1] += value * at.middle[0];
                row[2] += value * at.middle[1];
                row[3] += value * at.high[0];
                row[4] += value * at.high[1];
            }
        }
        coefficients.map(|[whole, a, b, c, d]| {
            let (middle, high) = (a.abs().max(b.abs()), c.abs().max(d.abs()));
            if high == 0.0 {
                return 0.0;
            }
            let first_fall = (whole.abs() / middle).ln().max(0.1);
            let second_fall = (middle / high).ln().max(0.0);
            let falls = 1.0 + onward * (second_fall / first_fall).min(1.0);
            high * (-COUNTED_ON * second_fall * falls).exp()
        })
    }

    /// The integral of the pressure beyond a coordinate, of the polynomial through the nodes.
    fn load_above_pa(&self, centre: f64, u: f64, at: f64) -> f64 {
        let x = (2.0 * at - self.from - self.to) / (self.to - self.from);
        let loads = self.nodes.iter().map(|node| node.pressure_pa * relative_density(centre, node, u).1);
        match self.rule {
            _ if x <= -1.0 => loads.sum(),
            Some(rule) if x < 1.0 => {
                let count = rule.nodes.len();
                let above = integrals_above(x, count);
                let share = |at: f64| {
                    let legendre = legendre_polynomials(at, count);
                    (0..count).map(|k| (k as f64 + 0.5) * legendre[k] * above[k]).sum::<f64>()
                };
                loads.zip(&rule.nodes).map(|(load, node)| load * share(node.x)).sum()
            }
            _ => 0.0,
        }
    }
}
