//! The response of an interface to a tangential load.

use serde::Serialize;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};

use super::load_answer::AnswerUnderLoad;

/// The response to the tangential load of a scene under one of its loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShearConclusion {
    /// The load, by index.
    pub load: usize,
    /// Tangential stress over friction times pressure; everything slides at 1 and above.
    pub share_of_sliding: f64,
    /// Stiffness before any slip, per nominal area \[Pa/m\].
    pub stiffness_pa_per_m: Option<f64>,
    /// Displacement on first loading \[m\]; absent if everything slides, like all that follow.
    pub displacement_m: Option<f64>,
    /// Share of the nominal area that sticks.
    pub stuck_area_fraction: Option<f64>,
    /// Energy lost in a cycle between both signs of the load, per nominal area \[J/m^2\].
    pub dissipation_j_per_m2: Option<f64>,
    /// Equivalent viscous damping ratio of that cycle.
    pub damping_ratio: Option<f64>,
}

impl ShearConclusion {
    /// Draws the conclusions for all loads; none without a tangential load.
    pub(crate) fn of_loads(states: &InterfaceStates<'_>, loads: &[AnswerUnderLoad]) -> Vec<Self> {
        let Some(shear) = states.request.shear else { return Vec::new() };
        let under = |(load, pressure_pa): (usize, f64)| {
            let value =
                |quantity| states.value(Slot { quantity, load: Some(load), curve: None }).ok().flatten();
            // A map that was pressed has a stiffness of its own.
            let of_map = loads.iter().find(|found| found.load == load).and_then(|found| found.area.maps);
            let stiffness_pa_per_m = of_map.and_then(|maps| maps.stiffness_pa_per_m);
            let stiffer =
                stiffness_pa_per_m.zip(value(Quantity::Stiffness)).map_or(1.0, |(map, theory)| map / theory);
            let scaled = |quantity: Quantity, factor: f64| value(quantity).map(|found| factor * found);
            ShearConclusion {
                load,
                share_of_sliding: shear.share_of_sliding(pressure_pa),
                stiffness_pa_per_m: scaled(Quantity::TangentialStiffness, stiffer),
                displacement_m: scaled(Quantity::TangentialDisplacement, 1.0 / stiffer),
                stuck_area_fraction: value(Quantity::StuckAreaFraction),
                dissipation_j_per_m2: scaled(Quantity::TangentialDissipation, 1.0 / stiffer),
                damping_ratio: value(Quantity::DampingRatio),
            }
        };
        states.inputs.pressures.iter().map(|pressure| pressure.pa()).enumerate().map(under).collect()
    }
}
