//! Panels with the law evaluated at their nodes.

use super::coordinate::Coordinate;
use super::heights::Density;
use super::nodes::{Block, Nodes, Rows, split};
use super::panel::{Panel, Variable};
use super::panels::Panels;
use super::rules::{MOST, Rule};
use super::trapezoid::Trapezoid;
use crate::asperities::pieces::Points;

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
        for (v, x) in rows.coordinates.iter_mut().zip(rule.gauss.nodes()) {
            *v = middle + half * x;
        }
        let weights = rule.gauss.weights().iter().map(|weight| scale * weight);
        let nodes = self.evaluate(variable, rule.count(), weights);
        self.panels.list.push(Panel { variable, from, to, halvings, rule: Some(rule), nodes });
    }

    /// Adds a panel under the trapezoidal rule.
    pub fn add_trapezoid(&mut self, coordinate: Coordinate, [from, to]: [f64; 2], trapezoid: Trapezoid) {
        let variable = Variable::Own(coordinate);
        let rows = self.scratch.rows(trapezoid.count);
        for (k, v) in rows.coordinates[..trapezoid.count].iter_mut().enumerate() {
            *v = trapezoid.at(k);
        }
        let nodes = self.evaluate(variable, trapezoid.count, std::iter::repeat(trapezoid.step));
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
