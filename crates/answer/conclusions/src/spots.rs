//! Spots through which the current flows, on the measured map that was pressed.

use serde::Serialize;
use study::interface::InterfaceStates;

use super::evidence::Evidence;

/// Spots of the measured map that stands for the surface, under a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SpotsUnderLoad {
    /// Number of spots on the map.
    pub on_map: usize,
    /// Number of spots on the nominal area, as many per area as on the map; `None` if no area is given.
    pub on_nominal_area: Option<f64>,
    /// Largest share of the current through the map that one spot carries.
    pub largest_share: f64,
    /// Sides of the map along x and y \[m\].
    pub map_m: [f64; 2],
    /// Resistance of these spots on the nominal area \[ohm\]; `None` if no area is given, or if they lie too close for discs.
    pub resistance_ohm: Option<f64>,
}

impl SpotsUnderLoad {
    /// Finds the spots under a load; `None` unless current is asked for, and a map was pressed.
    #[cfg(feature = "transport")]
    pub(crate) fn new(evidence: &Evidence<'_>, states: &InterfaceStates<'_>, load: usize) -> Option<Self> {
        use elements::{Boundary, half_space::Grid};
        use transport::spots::{SpotConduction, Spots};

        let conduction =
            SpotConduction::new(states.request.resistivities.filter(|_| states.request.asks.current)?);
        let surface = evidence.judgement?.surface.as_ref().filter(|surface| surface.map.is_some())?;
        let touching = &surface.contacts.iter().find(|contact| contact.load == load)?.touching;
        let map_m = [surface.length_x_m, surface.length_y_m];
        let grid = Grid::new(touching.len() / surface.columns, surface.columns, map_m[0], map_m[1]).ok()?;
        // Maps are pressed as if they repeated themselves.
        let found = Spots::solve(&grid, Boundary::Periodic, touching, 1.0, &conduction).ok()?;
        let maps = states.request.nominal_area_m2.map(|area_m2| area_m2 / (map_m[0] * map_m[1]));
        let resistance_ohm = maps.map(|maps| found.resistance_ohm / maps).filter(|_| found.is_in_range);
        Some(SpotsUnderLoad {
            on_map: found.spots.len(),
            on_nominal_area: maps.map(|maps| maps * found.spots.len() as f64),
            largest_share: found.largest_share(),
            map_m,
            resistance_ohm,
        })
    }

    /// Finds no spots: the feature `transport` is off.
    #[cfg(not(feature = "transport"))]
    pub(crate) fn new(_: &Evidence<'_>, _: &InterfaceStates<'_>, _: usize) -> Option<Self> {
        None
    }
}
