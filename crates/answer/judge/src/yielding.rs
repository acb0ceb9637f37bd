//! Yielding: the pressure of an elastic contact against the hardness, scale by scale.

use serde::Serialize;

use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};

/// The scales at which an elastic contact would exceed the hardness, under one load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Yielding {
    /// The load, by index.
    pub load: usize,
    /// The mean real pressure of Persson's elastic contact at the shortest wavelength \[Pa\].
    pub elastic_pressure_pa: f64,
    /// The first scale whose pressure exceeds a constant hardness, if there is one.
    pub above_constant: Option<AboveHardness>,
    /// The first scale whose pressure exceeds a hardness that grows at small scales, if there is one.
    pub above_growing: Option<AboveHardness>,
    /// The area of a contact that flows at the constant hardness over that of an elastic one, by Persson's theory on the whole band;
    /// `None` if the material has no hardness. Peaks of the pressure flow before the mean reaches the hardness.
    pub flowing_over_elastic: Option<f64>,
    /// True if its hardness grows at small scales.
    pub hardness_grows: bool,
}

impl Yielding {
    /// Compares elastic pressures \[Pa\] against wavelength \[m\], from long to short, with both hardnesses.
    pub(crate) fn new(
        load: usize,
        elastic: &[(f64, f64)],
        constant: Option<&HardnessOfScales>,
        growing: Option<&HardnessOfScales>,
        flowing_over_elastic: Option<f64>,
    ) -> Self {
        let above = |hardness: Option<&HardnessOfScales>| hardness?.first_above(elastic.iter().copied());
        Yielding {
            load,
            elastic_pressure_pa: elastic.last().map_or(0.0, |(_, pressure_pa)| *pressure_pa),
            above_constant: above(constant),
            above_growing: above(growing),
            flowing_over_elastic,
            hardness_grows: growing.is_some(),
        }
    }
}
