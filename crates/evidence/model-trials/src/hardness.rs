//! Plastic area of Persson's theory compared with saturated boundary elements.

use persson::constant_hardness;

use crate::elements::ElementsRow;

/// Plastic areas on one spectrum under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlasticAreas {
    /// Spread over hardness s/H.
    pub spread_over_hardness: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Area by saturated boundary elements.
    pub judged: f64,
    /// Area by Persson's theory at the same constant hardness.
    pub persson: f64,
}

/// Plastic areas of every row with a hardness.
#[must_use]
pub fn plastic_areas(elements: &[ElementsRow]) -> Vec<PlasticAreas> {
    let of_row = |row: &ElementsRow| {
        let load = row.load();
        let areas = constant_hardness::areas(
            load.nominal_pressure_pa(),
            crate::spectra::spread_pa(),
            load.hardness_pa()?,
        );
        Some(PlasticAreas {
            spread_over_hardness: row.spread_over_hardness?,
            pressure_over_gradient: row.pressure_over_gradient,
            judged: row.plastic_area_fraction,
            persson: areas.plastic,
        })
    };
    elements.iter().filter_map(of_row).collect()
}
