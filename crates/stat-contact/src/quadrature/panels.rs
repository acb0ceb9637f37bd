//! A law at the nodes of a quadrature, and its sums against the density of the heights.

use wide::f64x2;

use super::coordinate::Coordinate;
use super::heights::Density;
use super::nodes::{Block, Nodes, Rows, Summed, split, total};
use super::panel::{Panel, Variable};
use super::rules::Rule;
use super::sums::Sums;
use super::trapezoid::Trapezoid;
use crate::asperities::answers::{Asperities, Response};
use crate::asperities::pieces::Points;
use crate::gaussian::density::{DENSITY_SCALE, density, tail};

/// What of a law is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantities {
    PressureAndArea,
    /// The areas are zero.
    Pressure,
}

/// Panels with the law at their nodes, and the density there at one separation.
pub(crate) struct Panels<'a> {
    pub asperities: &'a dyn Asperities,
    pub sigma_s_m: f64,
    quantities: Quantities,
    /// The separation that they are laid around.
    centre: f64,
    list: Vec<Panel<'a>>,
    /// With the density at every node at the separation `u`, over the reference density.
    nodes: Nodes,
    u: f64,
    /// The interference, in units of sigma_s, from which on the response is this one.
    pub saturation: Option<(f64, Response)>,
    /// Law evaluations spent.
    pub evaluations: usize,
    scratch: Scratch,
}

/// What is known of the nodes of one panel while the law is evaluated at them.
#[derive(Default)]
struct Scratch {
    values: Vec<f64>,
}

/// A row of [`Scratch`] for each quantity.
struct ScratchRows<'a> {
    /// The nodes.
    coordinates: &'a mut [f64],
    /// Their weights in the interference, in units of sigma_s.
    weights: &'a mut [f64],
    interferences_m: &'a mut [f64],
    /// Derivative of the interference by the coordinate.
    slopes: &'a mut [f64],
}

impl<'a> Panels<'a> {
    /// None yet, around a separation, and room for some nodes.
    pub fn around(
        centre: f64,
        asperities: &'a dyn Asperities,
        sigma_s_m: f64,
        quantities: Quantities,
        nodes: usize,
    ) -> Self {
        Panels {
            asperities,
            sigma_s_m,
            quantities,
            centre,
            list: Vec::new(),
            nodes: Nodes::with_room_for(nodes),
            u: centre,
            saturation: None,
            evaluations: 0,
            scratch: Scratch::default(),
        }
    }

    /// The panel in a place.
    pub fn get(&self, place: usize) -> Option<Panel<'a>> {
        self.list.get(place).copied()
    }

    /// Takes a panel away; its nodes no longer count.
    pub fn remove(&mut self, place: usize) {
        self.list.remove(place);
    }

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
        for (weight, of_rule) in rows.weights.iter_mut().zip(rule.gauss.weights()) {
            *weight = scale * of_rule;
        }
        let nodes = self.evaluate(variable, rule.count());
        self.list.push(Panel { variable, from, to, halvings, rule: Some(rule), nodes });
    }

    /// Adds a panel under the trapezoidal rule.
    pub fn add_trapezoid(&mut self, coordinate: Coordinate, [from, to]: [f64; 2], trapezoid: Trapezoid) {
        let variable = Variable::Own(coordinate);
        let rows = self.scratch.rows(trapezoid.count);
        for (k, v) in rows.coordinates.iter_mut().enumerate() {
            *v = trapezoid.at(k);
        }
        rows.weights.fill(trapezoid.step);
        let nodes = self.evaluate(variable, trapezoid.count);
        self.list.push(Panel { variable, from, to, halvings: 0, rule: None, nodes });
    }

    /// The unit of the interference, in sigma_s, in which slopes by a variable come.
    fn interference_per_slope(&self, variable: Variable<'_>) -> f64 {
        match variable {
            Variable::Own(_) => 1.0,
            Variable::Law(_) => 1.0 / self.sigma_s_m,
        }
    }

    /// Evaluates the law at the nodes of a new panel, which stand in the scratch with their weights, and then the densities
    /// at the centre.
    fn evaluate(&mut self, variable: Variable<'a>, count: usize) -> Block {
        let (centre, sigma_s_m) = (self.centre, self.sigma_s_m);
        let nodes = self.nodes.add(count);
        self.evaluations += count;
        let Rows { places, pressures_pa, area_fractions, densities } = self.nodes.rows(nodes);
        let ScratchRows { coordinates, weights, interferences_m, slopes } = self.scratch.rows(count);
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
                        self.asperities.at_interferences(interferences_m, pressures_pa, area_fractions);
                    }
                    Quantities::Pressure => {
                        self.asperities.pressures_at_interferences(interferences_m, pressures_pa);
                    }
                }
            }
            Variable::Law(chart) => {
                let points = Points {
                    interferences_m: &mut *interferences_m,
                    slopes_m: &mut *slopes,
                    pressures_pa: &mut *pressures_pa,
                    area_fractions: &mut *area_fractions,
                };
                chart.at_coordinates(coordinates, points);
                let origin = if density.around_peak { centre } else { 0.0 };
                for (place, interference_m) in places.iter_mut().zip(&*interferences_m) {
                    *place = interference_m / sigma_s_m + origin;
                }
            }
        }
        let values = pressures_pa.iter_mut().zip(area_fractions);
        for (((pressure_pa, area_fraction), slope), weight) in values.zip(&*slopes).zip(&*weights) {
            let weight = slope * weight;
            (*pressure_pa, *area_fraction) = (weight * *pressure_pa, weight * *area_fraction);
        }
        density.at(places, densities);
        nodes
    }

    /// Goes to a separation near the centre: from now on the sums are those there.
    pub fn go_to(&mut self, u: f64) {
        let density = Density::new(self.centre, u);
        for panel in &self.list {
            let Rows { places, densities, .. } = self.nodes.rows(panel.nodes);
            density.at(places, densities);
        }
        self.u = u;
    }

    /// The integrals.
    pub fn sums(&self) -> Sums {
        let (u, shift) = (self.u, Density::new(self.centre, self.u).shift);
        let mut sums = [f64x2::ZERO; 5];
        for panel in &self.list {
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

    /// Estimated errors of the pressure \[Pa\] and the area fraction that a panel adds.
    pub fn errors(&self, panel: &Panel<'_>) -> [f64; 2] {
        panel.errors(&self.nodes.summed(panel.nodes))
    }

    /// Estimate of the larger relative error of the rules in the two integrals.
    pub fn relative_error(&self, sums: &Sums) -> f64 {
        let mut errors = [0.0; 2];
        for panel in &self.list {
            let [pressure, area] = self.errors(panel);
            errors[0] += pressure;
            errors[1] += area;
        }
        (errors[0] / sums.pressure_pa).max(errors[1] / sums.area_fraction)
    }

    /// The part of the pressure \[Pa\], over the reference density, that is carried beyond an interference \[m\].
    pub fn load_above_pa(&self, interference_m: f64) -> f64 {
        let s = interference_m / self.sigma_s_m;
        let panels: f64 = self
            .list
            .iter()
            .map(|panel| {
                let Summed { pressures_pa, densities, .. } = self.nodes.summed(panel.nodes);
                let loads = pressures_pa.as_flattened().iter().zip(densities.as_flattened());
                let loads = loads.map(|(pressure_pa, density)| density * pressure_pa);
                panel.sum_above(loads, panel.variable.of(s, interference_m))
            })
            .sum();
        let saturated =
            self.saturation.map_or(0.0, |(from, response)| tail(self.u, from.max(s)) * response.pressure_pa);
        panels * DENSITY_SCALE + saturated
    }
}

impl Scratch {
    const ROWS: usize = 4;

    /// Its rows, of so many nodes.
    fn rows(&mut self, count: usize) -> ScratchRows<'_> {
        if self.values.len() < Self::ROWS * count {
            self.values.resize(Self::ROWS * count, 0.0);
        }
        let [coordinates, weights, interferences_m, slopes] =
            split::<{ Self::ROWS }>(&mut self.values[..Self::ROWS * count], count);
        ScratchRows { coordinates, weights, interferences_m, slopes }
    }
}
