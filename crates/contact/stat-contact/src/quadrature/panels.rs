//! Law at the nodes of a quadrature, and its sums against the density of the heights.

use multiversion::multiversion;

use super::heights::Density;
use super::nodes::{LANES, Lanes, Nodes, Rows, Summands, total};
use super::panel::Panel;
use super::sums::Sums;
use crate::asperities::answers::{Asperities, Response};
use crate::gaussian::density::{DENSITY_SCALE, density, tail};

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
