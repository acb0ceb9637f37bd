//! The integrals over the heights of the asperities, prepared for all separations near one.
//!
//! p(d) = eta Int_0^inf F(w) g(d + w) dw, and the same with the area A (Greenwood & Williamson 1966). The law is costly
//! and does not depend on d, the density is cheap and does: a frame holds the law's values at the nodes of a
//! quadrature built around one separation, and sums them against the density at any separation nearby. A search for
//! the separation that carries a load therefore evaluates the law once, not once per step.

use asperity::elementary;
use wide::f64x2;

use crate::asperities::{Asperities, Chart, Piece, Points, Response};
use crate::cell::{Cell, Precision, error_estimate};
use crate::coordinate::Coordinate;
use crate::density::Density;
use crate::gaussian::{self, DENSITY_SCALE, Window, log_reference_density};
use crate::hertz_load::HertzIntegrals;
use crate::legendre::Rule;
use crate::nodes::{Block, Nodes, Rows, Summed, total};
use crate::trapezoid::Trapezoid;

/// Law evaluations after which the error is accepted as it is, and reported.
const MOST_EVALUATIONS: usize = 3000;
/// Nodes of a rule above which a panel is halved rather than given more.
const MOST_NODES: usize = 28;
/// How often a panel is halved before its error is accepted.
const MOST_HALVINGS: usize = 24;

/// The law at the nodes of a quadrature.
pub(crate) struct Frame<'a> {
    asperities: &'a dyn Asperities,
    /// The separation it is built around.
    pub centre: f64,
    sigma_s_m: f64,
    coordinate: Coordinate,
    precision: Precision,
    panels: Vec<Panel>,
    /// With the density at every node at the separation last summed at, over the reference density.
    nodes: Nodes,
    /// The separation last summed at.
    u: f64,
    /// The integrals there, once they have been asked for.
    sums: Option<Sums>,
    /// The integrals at the centre, at which every search on the frame begins.
    sums_at_centre: Option<Sums>,
    /// Stands for all nodes where no asperity within the window leaves Hertz's law.
    hertz: Option<HertzIntegrals>,
    /// The interference, in units of sigma_s, from which on the response is this one.
    saturation: Option<(f64, Response)>,
    /// The interferences that count.
    window: Window,
    /// Whether the areas matter.
    with_areas: bool,
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
    /// Pressure, area fraction, and means of the height u + s, its square and its cube, weighted by load.
    pub fn new(pressure_pa: f64, area_fraction: f64, mean_heights: [f64; 3]) -> Self {
        Sums { pressure_pa, area_fraction, mean_heights }
    }

    /// Derivative of ln p by u.
    pub fn log_pressure_slope(&self) -> f64 {
        -self.mean_heights[0]
    }

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
    /// None for the trapezoidal rule of rough frames, whose error is of no interest.
    rule: Option<&'static Rule>,
    nodes: Block,
}

/// The weights of a rule in a coordinate.
enum Weights {
    Equal(f64),
    /// Those of a Gauss rule, times the half length of its panel.
    Gauss(&'static Rule, f64),
}

impl<'a> Frame<'a> {
    /// The one frame that all separations share where every asperity is Hertz's at any interference.
    pub fn for_every_cell(asperities: &'a dyn Asperities, sigma_s_m: f64) -> Option<Self> {
        let hertz = HertzIntegrals::of(&asperities.hertzian()?, sigma_s_m, || f64::INFINITY)?;
        Some(Self::closed(asperities, sigma_s_m, hertz, Window::up_to(f64::INFINITY), 0.0))
    }

    /// The quadrature that serves a cell of separations at a precision.
    pub fn for_cell(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        cell: Cell,
        precision: Precision,
    ) -> Self {
        // Room for nearly all.
        const NODES: usize = 96;
        let precision = precision.in_cell(cell);
        let window = Window::new(cell.nearest(), cell.farthest(), precision.drop);
        if let Some(hertz) = Self::hertz(asperities, sigma_s_m, &window) {
            return Self::closed(asperities, sigma_s_m, hertz, window, cell.centre());
        }
        let coordinate = Coordinate::around(cell.centre(), cell.farthest(), precision.digits);
        let mut frame =
            Self::empty(asperities, sigma_s_m, cell.centre(), coordinate, window, precision, NODES);
        frame.saturation = asperities.saturation().map(|(from_m, at)| (from_m / sigma_s_m, at));
        let (low_m, high_m) = (window.low * sigma_s_m, window.high * sigma_s_m);
        for piece in asperities.pieces(low_m, high_m) {
            frame.add_piece(piece, &window);
        }
        frame.refine();
        frame
    }

    /// The force at a few nodes around one separation, blind to all breaks of the law but the strongest: within a percent or so, and so
    /// within the right cell for all but one search in fifty (blind to that one as well, for three in four).
    pub fn rough(asperities: &'a dyn Asperities, sigma_s_m: f64, u: f64) -> Self {
        const NODES_BELOW: usize = 8;
        const NODES_ABOVE: usize = 5;
        // Far below the mean plane ln p is flat: its curvature, of the order of 1/u^2, has to be seen.
        let digits = 10.0 + 2.0 * (-u).max(0.0).ln_1p();
        let precision = Precision { tolerance: (-digits).exp(), digits, drop: digits };
        let window = Window::new(u, u, precision.drop);
        if let Some(hertz) = Self::hertz(asperities, sigma_s_m, &window) {
            return Self::closed(asperities, sigma_s_m, hertz, window, u);
        }
        let coordinate = Coordinate::around(u, u, precision.digits);
        let mut frame =
            Self::empty(asperities, sigma_s_m, u, coordinate, window, precision, NODES_BELOW + NODES_ABOVE);
        frame.with_areas = false;
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

    fn hertz(asperities: &dyn Asperities, sigma_s_m: f64, window: &Window) -> Option<HertzIntegrals> {
        HertzIntegrals::of(&asperities.hertzian()?, sigma_s_m, || window.high)
    }

    /// A frame without nodes, for which no law is evaluated.
    fn closed(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        hertz: HertzIntegrals,
        window: Window,
        centre: f64,
    ) -> Self {
        let (coordinate, precision) = (Coordinate::Height { u: centre }, Precision::EXACT);
        let frame = Self::empty(asperities, sigma_s_m, centre, coordinate, window, precision, 0);
        Frame { hertz: Some(hertz), ..frame }
    }

    fn empty(
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        centre: f64,
        coordinate: Coordinate,
        window: Window,
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
            nodes: Nodes::with_room_for(nodes),
            u: centre,
            sums: None,
            sums_at_centre: None,
            window,
            hertz: None,
            saturation: None,
            with_areas: true,
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

    fn add_trapezoid(&mut self, window: &Window) {
        let [from, to] = [window.low, window.high].map(|s| self.coordinate.of(s));
        let trapezoid = Trapezoid::between(from, to, self.precision.digits);
        let (chart, coordinate) = (Chart::Interference, self.coordinate);
        let nodes = self.nodes.add(trapezoid.count);
        for (k, v) in self.nodes.rows(nodes).densities.iter_mut().enumerate() {
            *v = trapezoid.at(k);
        }
        self.evaluate(chart, coordinate, nodes, Weights::Equal(trapezoid.step));
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
        let nodes = self.nodes.add(rule.count());
        for (v, x) in self.nodes.rows(nodes).densities.iter_mut().zip(rule.gauss.nodes()) {
            *v = middle + half * x;
        }
        self.evaluate(chart, coordinate, nodes, Weights::Gauss(rule, half));
        self.panels.push(Panel { chart, coordinate, from, to, halvings, rule: Some(rule), nodes });
    }

    /// Evaluates the law at the nodes of a panel, whose coordinates stand in the place of the densities, and then the
    /// densities at the centre.
    fn evaluate(&mut self, chart: Chart, coordinate: Coordinate, nodes: Block, weights: Weights) {
        let (centre, sigma_s_m) = (self.centre, self.sigma_s_m);
        self.evaluations += nodes.count();
        let Rows { places, pressures_pa, area_fractions, densities, slopes } = self.nodes.rows(nodes);
        let density = Density::new(centre, centre);
        let per_slope = if chart == Chart::Interference {
            coordinate.interferences(densities, places, slopes);
            for (place, value) in places.iter_mut().zip(&mut *densities) {
                let (s, v) = (*place, *value);
                (*place, *value) = (density.place(coordinate, v, s), s * sigma_s_m);
            }
            if self.with_areas {
                self.asperities.at_interferences(densities, pressures_pa, area_fractions);
            } else {
                self.asperities.pressures_at_interferences(densities, pressures_pa);
            }
            1.0
        } else {
            let points = Points {
                interferences_m: &mut *places,
                slopes_m: &mut *slopes,
                pressures_pa: &mut *pressures_pa,
                area_fractions: &mut *area_fractions,
            };
            self.asperities.at_coordinates(chart, densities, points);
            let origin = if density.around_peak { centre } else { 0.0 };
            places.iter_mut().for_each(|place| *place = *place / sigma_s_m + origin);
            1.0 / sigma_s_m
        };
        match weights {
            Weights::Equal(step) => slopes.iter_mut().for_each(|slope| *slope *= step * per_slope),
            Weights::Gauss(rule, half) => {
                let half = half * per_slope;
                slopes
                    .iter_mut()
                    .zip(rule.gauss.weights())
                    .for_each(|(slope, weight)| *slope *= half * weight);
            }
        }
        for ((pressure_pa, area_fraction), weight) in
            pressures_pa.iter_mut().zip(area_fractions).zip(&*slopes)
        {
            (*pressure_pa, *area_fraction) = (weight * *pressure_pa, weight * *area_fraction);
        }
        density.at(places, densities);
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
            let nodes = rule.count();
            if nodes < MOST_NODES {
                let rule = Rule::of_at_least(nodes + nodes / 3 + 1);
                self.add_panel(chart, coordinate, [from, to], halvings, rule);
                continue;
            }
            let (middle, rule) = (0.5 * (from + to), Rule::of_at_least(nodes * 3 / 4));
            self.add_panel(chart, coordinate, [from, middle], halvings + 1, rule);
            self.add_panel(chart, coordinate, [middle, to], halvings + 1, rule);
        }
    }

    /// Whether a separation is near enough to the centre.
    pub fn serves(&self, u: f64) -> bool {
        self.hertz.is_some()
            || (u - self.centre).abs() < 0.2 * (1.0 + self.centre.max(0.0)) + 1e-15 * self.centre.abs()
    }

    /// The integrals at a separation near the centre.
    pub fn sums_at(&mut self, u: f64) -> Sums {
        if u != self.u {
            let density = Density::new(self.centre, u);
            for panel in &self.panels {
                let Rows { places, densities, .. } = self.nodes.rows(panel.nodes);
                density.at(places, densities);
            }
            self.u = u;
            self.sums = None;
        }
        if u == self.centre {
            self.sums_at_centre = Some(self.sums_here());
        }
        self.sums_here()
    }

    /// The integrals at the separation last summed at, added up once.
    fn sums_here(&mut self) -> Sums {
        let sums = self.sums.unwrap_or_else(|| self.sums());
        self.sums = Some(sums);
        sums
    }

    /// The integrals at the centre, for which the frame need not go back there.
    pub fn sums_at_centre(&mut self) -> Sums {
        self.sums_at_centre.unwrap_or_else(|| self.sums_at(self.centre))
    }

    /// The integrals at the separation last summed at.
    fn sums(&self) -> Sums {
        if let Some(hertz) = &self.hertz {
            return hertz.sums_at(self.u);
        }
        let (u, shift) = (self.u, Density::new(self.centre, self.u).shift);
        let mut sums = [f64x2::ZERO; 5];
        for panel in &self.panels {
            let Summed { places, pressures_pa, area_fractions, densities } = self.nodes.summed(panel.nodes);
            for (((place, pressure_pa), area_fraction), density) in
                places.iter().zip(pressures_pa).zip(area_fractions).zip(densities)
            {
                let [place, pressure_pa, area_fraction, density] =
                    [place, pressure_pa, area_fraction, density].map(|lanes| f64x2::new(*lanes));
                let height = place + shift;
                let load = density * pressure_pa;
                let moment = height * load;
                let second = height * moment;
                sums[0] += load;
                sums[1] += moment;
                sums[2] += second;
                sums[3] += height * second;
                sums[4] += density * area_fraction;
            }
        }
        let mut total = sums.map(|lanes| DENSITY_SCALE * total(lanes));
        if let Some((from, response)) = self.saturation {
            let share = gaussian::tail(u, from);
            let at_edge = gaussian::density(u, from);
            total[0] += share * response.pressure_pa;
            total[1] += at_edge * response.pressure_pa;
            total[2] += (share + (u + from) * at_edge) * response.pressure_pa;
            total[3] += ((u + from).powi(2) + 2.0) * at_edge * response.pressure_pa;
            total[4] += share * response.area_fraction;
        }
        let [pressure_pa, first, second, third, area_fraction] = total;
        Sums::new(pressure_pa, area_fraction, [first, second, third].map(|sum| sum / pressure_pa))
    }

    /// Estimate of the larger relative error of the two integrals at the separation last summed at.
    pub fn relative_error(&self, sums: &Sums) -> f64 {
        if let Some(hertz) = &self.hertz {
            return hertz.relative_error(self.u);
        }
        let mut errors = [0.0; 2];
        for panel in &self.panels {
            let [pressure, area] = self.errors(panel);
            errors[0] += pressure;
            errors[1] += area;
        }
        let rules = (errors[0] / sums.pressure_pa).max(errors[1] / sums.area_fraction);
        let saturates = self.saturation.is_some_and(|(from, _)| from <= self.window.high);
        error_estimate(rules + self.window.left_out(self.u, saturates), self.u)
    }

    /// Share of the load, at the separation last summed at, that is carried at interferences for which the law was not
    /// fitted.
    pub fn out_of_range_load_share(&self, sums: &Sums) -> f64 {
        if self.hertz.is_some() {
            return 0.0;
        }
        let load_pa: f64 = self
            .asperities
            .out_of_fitted_range(self.window.high * self.sigma_s_m)
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
                let Summed { pressures_pa, densities, .. } = self.nodes.summed(panel.nodes);
                let loads = pressures_pa.as_flattened().iter().zip(densities.as_flattened());
                let loads = loads.map(|(pressure_pa, density)| density * pressure_pa);
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
        let mut wholes = [f64x2::ZERO; 2];
        let mut coefficients = [[f64x2::ZERO; 4]; 2];
        let Summed { pressures_pa, area_fractions, densities, .. } = self.nodes.summed(panel.nodes);
        for (((pressure_pa, area_fraction), density), probes) in
            pressures_pa.iter().zip(area_fractions).zip(densities).zip(&rule.probes)
        {
            let density = f64x2::new(*density);
            let values = [pressure_pa, area_fraction].map(|lanes| density * f64x2::new(*lanes));
            for i in 0..2 {
                wholes[i] += values[i];
                for k in 0..4 {
                    coefficients[i][k] += values[i] * probes[k];
                }
            }
        }
        [0, 1].map(|i| {
            let (whole, [a, b, c, d]) = (total(wholes[i]), coefficients[i].map(total));
            let (middle, high) = (a.abs().max(b.abs()), c.abs().max(d.abs()));
            if high == 0.0 {
                return 0.0;
            }
            let first_fall = elementary::ln(whole.abs() / middle).max(0.1);
            let second_fall = elementary::ln(middle / high).max(0.0);
            let falls = 1.0 + onward * (second_fall / first_fall).min(1.0);
            DENSITY_SCALE * high * elementary::exp(-COUNTED_ON * second_fall * falls)
        })
    }
}

impl Panel {
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
