//! Choice of the panels around a separation and of their nodes, at which the law is evaluated.

use super::panels::{Block, Density, Nodes, Panel, Panels, Rows, Variable, split};
use super::rules::{Coordinate, MOST, Rule};
use super::{Cell, Precision};
use crate::asperities::answers::Asperities;
use crate::asperities::pieces::{Chart, Piece, Points};
use crate::gaussian::density::log_reference_density;
use crate::gaussian::window::Window;

/// Law evaluations after which the error is accepted as it is, and reported.
const MOST_EVALUATIONS: usize = 3000;
/// Nodes of a rule above which a panel is halved rather than given more.
const MOST_NODES: usize = 28;
/// Halvings of a panel after which its error is accepted: seven decades down, a kink that no law announced is left
/// alone.
const MOST_HALVINGS: usize = 24;

/// Lays the panels that serve a cell of separations at a precision: the smooth pieces of the law within the window,
/// refined until their errors at the centre of the cell are within the tolerance.
pub(crate) fn for_cell<'a>(
    asperities: &'a dyn Asperities,
    sigma_s_m: f64,
    cell: Cell,
    precision: Precision,
    window: &Window,
    scratch: &mut Scratch,
) -> Panels<'a> {
    // Capacity for nearly all.
    const NODES: usize = 96;
    let centre = cell.centre();
    let coordinate = Coordinate::around(centre, cell.farthest(), precision.digits);
    let mut panels = Panels::around(centre, asperities, sigma_s_m, NODES);
    panels.saturation = asperities.saturation().map(|(from_m, at)| (from_m / sigma_s_m, at));
    let mut builder = Builder { panels, quantities: Quantities::PressureAndArea, scratch };
    let (low_m, high_m) = (window.low * sigma_s_m, window.high * sigma_s_m);
    for piece in asperities.pieces(low_m, high_m) {
        add_piece(&mut builder, piece, window, coordinate, precision.digits);
    }
    builder.panels.relative_error = refine(&mut builder, precision.tolerance);
    builder.panels
}

/// Evaluates the force at a few nodes around one separation, ignoring all breaks of the law but the strongest. It is
/// within a percent or so, and so within the right cell for all but one search in fifty (three in four if the
/// strongest break is ignored as well).
pub(crate) fn rough<'a>(
    asperities: &'a dyn Asperities,
    sigma_s_m: f64,
    u: f64,
    precision: Precision,
    window: &Window,
    scratch: &mut Scratch,
) -> Panels<'a> {
    // Nodes of the rules on the two sides of the strongest break.
    const NODES_BELOW: usize = 8;
    const NODES_ABOVE: usize = 5;
    let coordinate = Coordinate::around(u, u, precision.digits);
    let panels = Panels::around(u, asperities, sigma_s_m, NODES_BELOW + NODES_ABOVE);
    let mut builder = Builder { panels, quantities: Quantities::Pressure, scratch };
    let kink = asperities.strongest_kink_m().map(|at_m| at_m / sigma_s_m);
    let Some(kink) = kink.filter(|&kink| window.low < kink && kink < window.high) else {
        let ends = [window.low, window.high].map(|s| coordinate.at(s));
        builder.add_trapezoid(coordinate, ends, precision.digits);
        return builder.panels;
    };
    let [low, middle, high] = [window.low, kink, window.high].map(|s| coordinate.at(s));
    builder.add(Variable::Own(coordinate), [low, middle], 0, Rule::of_at_least(NODES_BELOW));
    builder.panels.saturation = asperities.saturation().map(|(_, response)| (kink, response));
    if builder.panels.saturation.is_none() {
        builder.add(Variable::Own(coordinate), [middle, high], 0, Rule::of_at_least(NODES_ABOVE));
    }
    builder.panels
}

/// Adds the part of a piece that lies within the window, with as many nodes as it is likely to need.
fn add_piece<'a>(
    builder: &mut Builder<'a, '_>,
    piece: Piece<'a>,
    window: &Window,
    coordinate: Coordinate,
    digits: f64,
) {
    // Factor on the nodes over decades, where the law and not the density needs them: right for nine of ten panels of
    // the UNCD scenes.
    const RESOLUTION_OVER_DECADES: f64 = 1.4;
    // Width over depth of a window in which a law without a break is smooth in the interference itself.
    const NARROW: f64 = 1e-3;
    // Assumed power of growth of a response without a coordinate of its own, on the high side: too few nodes cost
    // more than too many.
    const GROWTH: f64 = 2.0;
    let Panels { centre, sigma_s_m, .. } = builder.panels;
    let low = window.low.max(piece.from_m / sigma_s_m);
    let high = window.high.min(piece.to_m / sigma_s_m);
    if low >= high {
        return;
    }
    let whole_window = low == window.low && high == window.high;
    let (variable, resolution, growth) = match piece.chart {
        // The law's own coordinate would round the heights to the digits of the interference.
        Chart::Law(_) if whole_window && high - low < NARROW * low => {
            (Variable::Own(coordinate), 1.0, GROWTH)
        }
        Chart::Interference => {
            let coordinate = coordinate.between(low, high);
            let resolution = if coordinate.spans_decades() { RESOLUTION_OVER_DECADES } else { 1.0 };
            (Variable::Own(coordinate), resolution, GROWTH)
        }
        Chart::Law(chart) => (Variable::Law(chart), chart.resolution(low == 0.0), chart.growth()),
    };
    let ends = [low, high].map(|s| variable.at(s, s * sigma_s_m));
    let nodes = resolution * nodes_between([low, high], growth, centre, digits);
    builder.add(variable, ends, 0, Rule::of_at_least(nodes.ceil() as usize));
}

/// Nodes that a Gauss-Legendre rule needs between two interferences for exp(-digits) of the whole. It depends on the
/// range of the exponent of the density at the centre (as its square root, as for a Gaussian), on what else has to be
/// resolved, and on how little of the whole lies there for a response that grows with a power of the interference.
/// [`refine`] corrects an underestimate.
fn nodes_between([low, high]: [f64; 2], growth: f64, centre: f64, digits: f64) -> f64 {
    // Weight of the range of the exponent if the stretch holds its minimum, and if it does not.
    const RUN_ACROSS_PEAK: f64 = 1.75;
    const RUN_BESIDE_PEAK: f64 = 0.95;
    // Digits of a smooth function that a node is worth without the density.
    const DIGITS_PER_NODE: f64 = 0.85;
    // Fall of the density from which the stretch is taken for a small part of the whole.
    const NEGLIGIBLE_FALL: f64 = 3.0;
    let exponent = |s: f64| log_reference_density(centre) + 0.5 * (centre + s).powi(2);
    let (at_low, at_high) = (exponent(low), exponent(high));
    let holds_peak = centre + low < 0.0 && centre + high > 0.0;
    let (run, least) = if holds_peak {
        (RUN_ACROSS_PEAK * (at_low + at_high), 0.0)
    } else {
        (RUN_BESIDE_PEAK * (at_high - at_low).abs(), at_low.min(at_high))
    };
    // Interferences that carry the load.
    let reach = if centre > 1.0 { 1.0 / centre } else { 1.0 - centre.min(0.0) };
    let log_share = (growth * (high / reach).ln()).min(0.0) - (least - NEGLIGIBLE_FALL).max(0.0);
    let digits = (digits + log_share).max(1.0);
    let smooth = digits / DIGITS_PER_NODE;
    0.5 * (digits * run + smooth * smooth).sqrt()
}

/// Gives more nodes to the panels whose error at the centre is above their share of the tolerance, or halves them. Returns
/// an estimate of the larger relative error of the two integrals that is left.
fn refine(builder: &mut Builder<'_, '_>, tolerance: f64) -> f64 {
    // Few panels reach their limit: with this share their sum stays about the tolerance.
    const SHARE: f64 = 0.3;
    let tolerance = SHARE * tolerance;
    let totals = builder.panels.sums();
    let (mut place, mut left) = (0, [0.0; 2]);
    while let Some(panel) = builder.panels.list.get(place).copied() {
        let [pressure_pa, area] = builder.panels.errors(&panel);
        let errors = [pressure_pa / totals.pressure_pa, area / totals.area_fraction];
        let is_fine = errors.iter().all(|&error| error <= tolerance);
        match panel.rule {
            Some(rule)
                if !is_fine
                    && panel.halvings < MOST_HALVINGS
                    && builder.panels.evaluations < MOST_EVALUATIONS =>
            {
                // The replacement comes last and is examined again.
                builder.panels.list.remove(place);
                replace(builder, &panel, rule);
            }
            _ => {
                place += 1;
                left = [left[0] + errors[0], left[1] + errors[1]];
            }
        }
    }
    left[0].max(left[1])
}

/// Replaces a panel by one with a third more nodes or, if it has many already, by halves with a quarter fewer.
fn replace<'a>(builder: &mut Builder<'a, '_>, panel: &Panel<'a>, rule: &'static Rule) {
    let &Panel { variable, from, to, halvings, .. } = panel;
    let nodes = rule.count();
    if nodes < MOST_NODES {
        return builder.add(variable, [from, to], halvings, Rule::of_at_least(nodes + nodes / 3 + 1));
    }
    let (middle, rule) = (0.5 * (from + to), Rule::of_at_least(nodes * 3 / 4));
    builder.add(variable, [from, middle], halvings + 1, rule);
    builder.add(variable, [middle, to], halvings + 1, rule);
}

/// Quantities of a law that are evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantities {
    PressureAndArea,
    /// Pressure alone; the areas are zero.
    Pressure,
}

/// Lays panels, one after the other.
pub(crate) struct Builder<'a, 's> {
    pub panels: Panels<'a>,
    pub quantities: Quantities,
    pub scratch: &'s mut Scratch,
}

/// Buffer for the nodes of one panel while the law is evaluated at them, shared by all panels.
#[derive(Default)]
pub(crate) struct Scratch {
    values: Vec<f64>,
}

/// Row of [`Scratch`] for each quantity.
struct ScratchRows<'a> {
    /// Coordinates of the nodes.
    coordinates: &'a mut [f64],
    interferences_m: &'a mut [f64],
    /// Derivative of the interference by the coordinate.
    slopes: &'a mut [f64],
}

impl<'a> Builder<'a, '_> {
    /// Adds a panel between two values of a variable, under a Gauss-Legendre rule.
    pub fn add(
        &mut self,
        variable: Variable<'a>,
        [from, to]: [f64; 2],
        halvings: usize,
        rule: &'static Rule,
    ) {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let scale = half * self.interference_per_slope(variable);
        let rows = self.scratch.rows(rule.count());
        for (v, x) in rows.coordinates.iter_mut().zip(&rule.gauss.nodes) {
            *v = middle + half * x;
        }
        let weights = rule.gauss.weights.iter().map(|weight| scale * weight);
        let nodes = self.evaluate(variable, rule.count(), weights);
        self.panels.list.push(Panel { variable, from, to, halvings, rule: Some(rule), nodes });
    }

    /// Adds a panel under the trapezoidal rule that integrates a unit Gaussian to exp(-digits).
    pub fn add_trapezoid(&mut self, coordinate: Coordinate, [from, to]: [f64; 2], digits: f64) {
        let variable = Variable::Own(coordinate);
        let step = Coordinate::trapezoidal_step(digits);
        let (first, count) = ((from / step - 0.5).ceil(), ((to - from) / step).ceil() as usize);
        let rows = self.scratch.rows(count);
        for (k, v) in rows.coordinates[..count].iter_mut().enumerate() {
            *v = (first + f64::from(k as u32) + 0.5) * step;
        }
        let nodes = self.evaluate(variable, count, std::iter::repeat(step));
        self.panels.list.push(Panel { variable, from, to, halvings: 0, rule: None, nodes });
    }

    /// Unit of the interference, in sigma_s, of slopes by a variable.
    fn interference_per_slope(&self, variable: Variable<'_>) -> f64 {
        match variable {
            Variable::Own(_) => 1.0,
            Variable::Law(_) => 1.0 / self.panels.sigma_s_m,
        }
    }

    /// Evaluates the law at the nodes of a new panel, which are in the scratch, and then the densities at the centre.
    /// The weights are those of the coordinate, in units in which its slopes are those of the interference over
    /// sigma_s.
    fn evaluate(
        &mut self,
        variable: Variable<'a>,
        count: usize,
        weights: impl Iterator<Item = f64>,
    ) -> Block {
        let Panels { asperities, centre, sigma_s_m, .. } = self.panels;
        let nodes = self.panels.nodes.add(count);
        self.panels.evaluations += count;
        let Rows { places, pressures_pa, area_fractions, densities } = self.panels.nodes.rows(nodes);
        let ScratchRows { coordinates, interferences_m, slopes } = self.scratch.rows(count);
        let last = coordinates[count - 1];
        coordinates[count..].fill(last);
        let density = Density::new(centre, centre);
        match variable {
            Variable::Own(coordinate) => {
                let interferences = &mut *places;
                coordinate.interferences(coordinates, interferences, slopes);
                for ((place, interference_m), v) in
                    places.iter_mut().zip(&mut *interferences_m).zip(&*coordinates)
                {
                    let s = *place;
                    (*place, *interference_m) = (density.place(coordinate, *v, s), s * sigma_s_m);
                }
                match self.quantities {
                    Quantities::PressureAndArea => {
                        asperities.at_interferences(interferences_m, pressures_pa, area_fractions);
                    }
                    Quantities::Pressure => {
                        let (interferences_m, pressures_pa) =
                            (&interferences_m[..count], &mut pressures_pa[..count]);
                        asperities.pressures_at_interferences(interferences_m, pressures_pa);
                    }
                }
            }
            Variable::Law(chart) => {
                let evaluated = if chart.goes_one_by_one() { count } else { coordinates.len() };
                let points = Points {
                    interferences_m: &mut interferences_m[..evaluated],
                    slopes_m: &mut slopes[..evaluated],
                    pressures_pa: &mut pressures_pa[..evaluated],
                    area_fractions: &mut area_fractions[..evaluated],
                };
                chart.at_coordinates(&coordinates[..evaluated], points);
                let last_m = interferences_m[count - 1];
                interferences_m[count..].fill(last_m);
                let origin = if density.around_peak { centre } else { 0.0 };
                for (place, interference_m) in places.iter_mut().zip(&*interferences_m) {
                    *place = interference_m / sigma_s_m + origin;
                }
            }
        }
        let values = pressures_pa.iter_mut().zip(&mut *area_fractions).zip(&*slopes).take(count);
        for (((pressure_pa, area_fraction), slope), weight) in values.zip(weights) {
            let weight = slope * weight;
            (*pressure_pa, *area_fraction) = (weight * *pressure_pa, weight * *area_fraction);
        }
        pressures_pa[count..].fill(0.0);
        area_fractions[count..].fill(0.0);
        density.at(places, densities);
        nodes
    }
}

impl Scratch {
    const ROWS: usize = 3;
    /// Size that fits any Gauss rule.
    const USUAL: usize = Self::ROWS * MOST;

    /// Rows of `count` nodes, filled up like those of [`Nodes`].
    fn rows(&mut self, count: usize) -> ScratchRows<'_> {
        let row = Nodes::row(count);
        let length = Self::ROWS * row;
        if self.values.len() < length {
            self.values.resize(length.max(Self::USUAL), 0.0);
        }
        let [coordinates, interferences_m, slopes] = split::<{ Self::ROWS }>(&mut self.values[..length], row);
        ScratchRows { coordinates, interferences_m, slopes }
    }
}
