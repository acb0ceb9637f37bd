//! What yields: the pressure of an elastic contact against the hardness, scale by scale.

use serde::Serialize;

use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};

/// Where an elastic contact would be pressed beyond the hardness, under one load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Yielding {
    /// The load, by index.
    pub load: usize,
    /// The mean real pressure of Persson's elastic contact at the shortest wavelength \[Pa\].
    pub elastic_pressure_pa: f64,
    /// The first scale whose pressure is above a hardness that is the same everywhere; `None` where none is, or there is
    /// no strength.
    pub above_constant: Option<AboveHardness>,
    /// The same with a hardness that grows at small scales; `None` where none is, or the material has no such length.
    pub above_growing: Option<AboveHardness>,
    /// Whether the material has a hardness at all.
    pub has_hardness: bool,
    /// Whether it has one that grows at small scales.
    pub hardness_grows: bool,
}

impl Yielding {
    /// From the elastic pressures \[Pa\] against wavelength \[m\], from long to short, which are not empty.
    pub(crate) fn of(
        load: usize,
        elastic: &[(f64, f64)],
        constant: Option<&HardnessOfScales>,
        growing: Option<&HardnessOfScales>,
    ) -> Self {
        let above = |hardness: Option<&HardnessOfScales>| hardness?.first_above(elastic.iter().copied());
        Yielding {
            load,
            elastic_pressure_pa: elastic.last().map_or(0.0, |(_, pressure_pa)| *pressure_pa),
            above_constant: above(constant),
            above_growing: above(growing),
            has_hardness: constant.is_some(),
            hardness_grows: growing.is_some(),
        }
    }
}
