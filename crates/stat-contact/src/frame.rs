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
use crate::legendre::Rule;

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
    nodes: Vec<Node>,
    /// The separation last summed at, and the density at every node there, over the reference density. Whatever is asked at
    /// one separation shares them: exponentials were a third of the cost of a state.
    u: f64,
    densities: Vec<f64>,
    /// The area fraction per unit of interference where it is proportional to it throughout.
    area_per_sigma: Option<f64>,
    /// The interference, in units of sigma_s, from which on the response is this one.
    saturation: Option<(f64, Response)>,
    /// The highest interference, in units of sigma_s, that counts, and whether the lowest is zero.
    high: f64,
    reaches_first_touch: bool,
    /// Law evaluations spent.
    pub evaluations: usize,
}

/// The integrals at one separation, over the reference density there.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub pressure_pa: f64,
    pub area_fraction: f64,
    /// Means of the height u + s, its square and its cube, weighted by load.
    mean_heights: [f64; 3],
}

impl Sums {
    /// First, second and third derivative of ln p by u.
    pub fn log_pressure_slopes(&self) -> [f64; 3] {
        let [mean, square, cube] = self.mean_heights;
        [-mean, square - mean * mean - 1.0, mean * (3.0 * square - 2.0 * mean * mean) - cube]
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
    /// The first of its nodes among those of the frame, and their number.
    first: usize,
    count: usize,
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
        const NODES: usize = 96;
        let precision = precision.in_cell(cell);
        let window = Window::new(cell.nearest(), cell.farthest(), precision.drop);
        let coordinate = Coordinate::around(cell.centre(), cell.farthest(), precision.digits);
        let mut frame = Self::empty(asperities, sigma_s_m, cell.centre(), coordinate, precision, NODES);
        frame.high = window.high;
        frame.reaches_first_touch = window.low == 0.0;
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

    /// A few nodes around one separation, blind to all breaks of the law but the strongest: within a percent or so, and so
    /// within the right cell for all but one search in fifty (blind to that one as well, for three in four).
    pub fn rough(asperities: &'a dyn Asperities, sigma_s_m: f64, u: f64) -> Self {
        const NODES_BELOW: usize = 8;
        const NODES_ABOVE: usize = 5;
        // Far below the mean plane ln p is flat: its curvature, of the order of 1/u^2, has to be seen.
        let digits = 10.0 + 2.0 * (-u).max(0.0).ln_1p();
        let precision = Precision { tolerance: (-digits).exp(), digits, drop: digits };
        let window = Window::new(u, u, precision.drop);
        let coordinate = Coordinate::around(u, u, precision.digits);
        let mut frame =
            Self::empty(asperities, sigma_s_m, u, coordinate, precision, NODES_BELOW + NODES_ABOVE);
        let kink = asperities.strongest_kink_m().map(|at_m| at_m / sigma_s_m);
        let Some(kink) = kink.filter(|&kink| window.low < kink && kink < window.high) else {
            frame.add_trapezoid(&window);
            return frame;
        };
        let [low, middle, high] = [window.low, kink, window.high].map(|s| coordinate.of(s));
        frame.add_panel(Chart::Interference, coordinate, [low, middle], 0, Rule::of_at_least(NODES_BELOW));
        frame.saturation = asperities.saturation().map(|(_, response)| (kink, response));
        if frame.saturation.is_none() {
            frame.add_panel(
                Chart::Interference,
                coordinate,
                [middle, high],
                0,
                Rule::of_at_least(NODES_ABOVE),
            );
        }
        frame
    }

    fn empty(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        centre: f64,
        coordinate: Coordinate,
        precision: Precision,
        nodes: usize,
    ) -> Self {
        Frame {
            asperities,
            centre,
            sigma_s_m,
            coordinate,
            precision,
            panels: Vec::new(),
            nodes: Vec::with_capacity(nodes),
            u: centre,
            densities: Vec::with_capacity(nodes),
            high: 0.0,
            reaches_first_touch: true,
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
        // How much more or less a law has to be resolved than the density, as nine of ten panels of the UNCD scenes want it
        // at tolerances from 1e-6 to 1e-12: the right number at once saves a fifth of all evaluations.
        let more = match piece.chart {
            Chart::Interference if coordinate.spans_decades() => 1.4,
            Chart::SineLight if low == 0.0 => 1.3,
            Chart::SineLight => 0.75,
            Chart::SineHeavy => 0.78,
            Chart::FlowHeavy => 1.15,
            _ => 1.0,
        };
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
        let (chart, coordinate, panel) = (Chart::Interference, self.coordinate, self.nodes.len());
        for k in 0..count {
            self.add_node(chart, coordinate, (first + k as f64 + 0.5) * step, step);
        }
        self.panels.push(Panel { chart, coordinate, from, to, halvings: 0, rule: None, first: panel, count });
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
        let (first, count) = (self.nodes.len(), rule.nodes.len());
        for node in &rule.nodes {
            self.add_node(chart, coordinate, middle + half * node.x, half * node.weight);
        }
        self.panels.push(Panel { chart, coordinate, from, to, halvings, rule: Some(rule), first, count });
    }

    /// Evaluates the law at a node, and the density at the centre.
    fn add_node(&mut self, chart: Chart, coordinate: Coordinate, at: f64, weight: f64) {
        let node = self.node(chart, coordinate, at, weight);
        self.evaluations += 1;
        self.nodes.push(node);
        self.densities.push(Density::new(self.centre, self.centre).at(&node));
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
        let totals = self.sums();
        let mut at = 0;
        while at < self.panels.len() && self.evaluations < MOST_EVALUATIONS {
            let [pressure, area] = self.errors(&self.panels[at]);
            let fine = pressure <= tolerance * totals.pressure_pa && area <= tolerance * totals.area_fraction;
            let Panel { chart, coordinate, from, to, halvings, rule: Some(rule), .. } = self.panels[at]
            else {
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
                let rule = Rule::of_at_least(nodes + nodes / 3 + 1);
                self.add_panel(chart, coordinate, [from, to], halvings, rule);
                continue;
            }
            let (middle, rule) = (0.5 * (from + to), Rule::of_at_least(nodes * 3 / 4));
            self.add_panel(chart, coordinate, [from, middle], halvings + 1, rule);
            self.add_panel(chart, coordinate, [middle, to], halvings + 1, rule);
        }
        self.drop_nodes_without_panel();
    }

    fn drop_nodes_without_panel(&mut self) {
        let live: usize = self.panels.iter().map(|panel| panel.count).sum();
        if live == self.nodes.len() {
            return;
        }
        let (nodes, densities) = (std::mem::take(&mut self.nodes), std::mem::take(&mut self.densities));
        self.nodes.reserve(live);
        self.densities.reserve(live);
        for panel in &mut self.panels {
            let range = panel.range();
            panel.first = self.nodes.len();
            self.nodes.extend_from_slice(&nodes[range.clone()]);
            self.densities.extend_from_slice(&densities[range]);
        }
    }

    /// Whether a separation is near enough to the centre.
    pub fn serves(&self, u: f64) -> bool {
        (u - self.centre).abs() < 0.2 * (1.0 + self.centre.max(0.0)) + 1e-15 * self.centre.abs()
    }

    /// The integrals at a separation near the centre.
    pub fn sums_at(&mut self, u: f64) -> Sums {
        if u != self.u {
            let density = Density::new(self.centre, u);
            for (value, node) in self.densities.iter_mut().zip(&self.nodes) {
                *value = density.at(node);
            }
            self.u = u;
        }
        self.sums()
    }

    /// The integrals at the separation last summed at.
    fn sums(&self) -> Sums {
        let (u, density) = (self.u, Density::new(self.centre, self.u));
        let mut total = [0.0; 5];
        for (node, share) in self.nodes.iter().zip(&self.densities) {
            let height = density.height(node);
            let pressure_pa = share * node.pressure_pa;
            let moment = height * pressure_pa;
            total[0] += pressure_pa;
            total[1] += moment;
            total[2] += height * moment;
            total[3] += height * height * moment;
            total[4] += share * node.area_fraction;
        }
        total.iter_mut().for_each(|sum| *sum *= DENSITY_SCALE);
        if let Some((from, response)) = self.saturation {
            let share = gaussian::tail(u, from);
            let at_edge = gaussian::density(u, from);
            total[0] += share * response.pressure_pa;
            total[1] += at_edge * response.pressure_pa;
            total[2] += (share + (u + from) * at_edge) * response.pressure_pa;
            total[3] += ((u + from).powi(2) + 2.0) * at_edge * response.pressure_pa;
            total[4] += share * response.area_fraction;
        }
        if let Some(area_per_sigma) = self.area_per_sigma {
            total[4] = area_per_sigma * gaussian::first_moment(u);
        }
        let [pressure_pa, first, second, third, area_fraction] = total;
        Sums { pressure_pa, area_fraction, mean_heights: [first, second, third].map(|sum| sum / pressure_pa) }
    }

    /// Estimate of the larger relative error of the two integrals at the separation last summed at.
    pub fn relative_error(&self, sums: &Sums) -> f64 {
        const ROUNDING: f64 = 1e-14;
        // With it the estimate bounds the error in 999 of 1000 reference states, and half lie within some forty of it.
        const CAUTION: f64 = 4.0;
        let mut errors = [0.0; 2];
        for panel in &self.panels {
            let [pressure, area] = self.errors(panel);
            errors[0] += pressure;
            errors[1] += area;
        }
        let rules = (errors[0] / sums.pressure_pa).max(errors[1] / sums.area_fraction);
        // The trapezoidal rule has no coefficients to judge by, but converges as it was laid out to.
        let trapezoidal = self.panels.iter().any(|panel| panel.rule.is_none());
        let trapezoid = if trapezoidal { (-self.precision.digits).exp() } else { 0.0 };
        // Far below the mean plane the interference has no more digits than u.
        let digits_of_u = 8.0 * f64::EPSILON * (-self.u).max(0.0);
        CAUTION * (rules + self.left_out() + trapezoid) + ROUNDING + digits_of_u
    }

    /// Share of the integrals, at the separation last summed at, that lies outside the window: that of a response like s^2,
    /// or nothing where the response saturates within.
    fn left_out(&self) -> f64 {
        let (u, s) = (self.u, self.high);
        let below = if self.reaches_first_touch { 0.0 } else { (-self.precision.drop).exp() };
        if self.saturation.is_some_and(|(from, _)| from <= s) {
            return below;
        }
        // Int_s^inf t^2 exp(-t (u + t/2)) dt, and its whole from 0 on within a fifth.
        let y = s * (u + s);
        let density = gaussian::density(u, s) / DENSITY_SCALE;
        let beyond = density * s * s / (u + s) * (1.0 + 2.0 / y + 2.0 / (y * y));
        let whole = if u > 0.0 { 2.0 / (u + 1.17).powi(3) } else { 1.25 * (1.0 + u * u) };
        below + beyond / whole
    }

    /// Share of the load, at the separation last summed at, that is carried at interferences for which the law was not
    /// fitted.
    pub fn out_of_range_load_share(&self, sums: &Sums) -> f64 {
        if self.area_per_sigma.is_some() {
            return 0.0;
        }
        let load_pa: f64 = self
            .asperities
            .out_of_fitted_range(self.high * self.sigma_s_m)
            .into_iter()
            .filter(|(from_m, to_m)| from_m < to_m)
            .map(|(from_m, to_m)| {
                let above = |at_m: f64| if at_m.is_finite() { self.load_above_pa(at_m) } else { 0.0 };
                above(from_m) - above(to_m)
            })
            .sum();
        (load_pa / sums.pressure_pa).clamp(0.0, 1.0)
    }

    /// The part of the pressure, over the reference density, that is carried beyond an interference \[m\].
    fn load_above_pa(&self, interference_m: f64) -> f64 {
        let s = interference_m / self.sigma_s_m;
        let panels: f64 = self
            .panels
            .iter()
            .map(|panel| {
                let at = match panel.chart {
                    Chart::Interference => panel.coordinate.of(s),
                    chart => self.asperities.coordinate(chart, interference_m),
                };
                let loads = panel.range().map(|i| self.densities[i] * self.nodes[i].pressure_pa);
                panel.load_above_pa(loads, at)
            })
            .sum();
        let saturated = self
            .saturation
            .map_or(0.0, |(from, response)| gaussian::tail(self.u, from.max(s)) * response.pressure_pa);
        panels * DENSITY_SCALE + saturated
    }

    /// Estimated errors of the pressure and the area that a panel adds at the separation last summed at.
    ///
    /// The rule errs by the Legendre coefficients beyond degree 2n. How those fall from degree n to 2n is judged by how
    /// they fall from 0 to n/2 and on to n: as fast again and twice as far where they fall geometrically or faster, no
    /// further than from n/2 to n behind an end-point power, where the fall levels off. It may level off later than n:
    /// three quarters of it are counted on, and less of the second stretch over decades, where singularities of the law
    /// that lie closer than those of the density, but are weak, take over late.
    fn errors(&self, panel: &Panel) -> [f64; 2] {
        const COUNTED_ON: f64 = 0.75;
        const COUNTED_ON_OVER_DECADES: f64 = 0.3;
        let Some(rule) = panel.rule else { return [0.0; 2] };
        let onward = if panel.coordinate.spans_decades() { COUNTED_ON_OVER_DECADES } else { 1.0 };
        let mut wholes = [0.0; 2];
        let mut coefficients = [[0.0; 4]; 2];
        let nodes = self.nodes[panel.range()].iter().zip(&self.densities[panel.range()]);
        for ((node, density), at) in nodes.zip(&rule.nodes) {
            let values = [density * node.pressure_pa, density * node.area_fraction];
            for ((whole, row), value) in wholes.iter_mut().zip(&mut coefficients).zip(values) {
                *whole += value;
                for (coefficient, probe) in row.iter_mut().zip(at.probes) {
                    *coefficient += value * probe;
                }
            }
        }
        [0, 1].map(|i| {
            let (whole, [a, b, c, d]) = (wholes[i], coefficients[i]);
            let (middle, high) = (a.abs().max(b.abs()), c.abs().max(d.abs()));
            if high == 0.0 {
                return 0.0;
            }
            let first_fall = (whole.abs() / middle).ln().max(0.1);
            let second_fall = (middle / high).ln().max(0.0);
            let falls = 1.0 + onward * (second_fall / first_fall).min(1.0);
            DENSITY_SCALE * high * (-COUNTED_ON * second_fall * falls).exp()
        })
    }
}

/// The density of the heights at the separation u, over the reference density, on a frame around another separation.
struct Density {
    around_peak: bool,
    /// u, or how far it is from the centre.
    shift: f64,
    /// What is left of the exponent beside the part that depends on the node.
    left: f64,
}

impl Density {
    fn new(centre: f64, u: f64) -> Self {
        let log_reference = log_reference_density(u);
        if centre > 0.0 {
            // What the reference density leaves of u^2/2: nothing, unless the cell's neighbour lies across zero.
            Density { around_peak: false, shift: u, left: 0.5 * u * u + log_reference }
        } else {
            Density { around_peak: true, shift: u - centre, left: log_reference }
        }
    }

    /// The height at which a node meets the flat.
    fn height(&self, node: &Node) -> f64 {
        self.shift + if self.around_peak { node.height } else { node.interference }
    }

    fn at(&self, node: &Node) -> f64 {
        let exponent = if self.around_peak {
            -0.5 * (node.height + self.shift).powi(2)
        } else {
            -node.interference * (self.shift + 0.5 * node.interference)
        };
        (exponent - self.left).exp()
    }
}

impl Panel {
    fn range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }

    /// The integral of the pressure beyond a coordinate, of the polynomial through the loads at the nodes.
    fn load_above_pa(&self, loads: impl Iterator<Item = f64>, at: f64) -> f64 {
        let x = (2.0 * at - self.from - self.to) / (self.to - self.from);
        match self.rule {
            _ if x <= -1.0 => loads.sum(),
            Some(rule) if x < 1.0 => rule.integral_above(x, loads),
            _ => 0.0,
        }
    }
}
