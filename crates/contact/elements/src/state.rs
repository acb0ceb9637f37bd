//! State of one surface under one load.

use crate::half_space::{ContactNumbers, OpenPaths};

/// State of one surface under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PressedState {
    /// Numbers of the contact.
    pub numbers: ContactNumbers,
    /// Corrected area fraction on every second point of the grid; `None` without such a grid.
    pub area_fraction_coarser: Option<f64>,
    /// Pressure that would close the bodies by 1 m \[Pa/m\], without the compliance of the specimen as a whole where that is taken
    /// out; `None` if no gap is left, or if it was not computed.
    pub stiffness_pa_per_m: Option<f64>,
    /// Compliance of the specimen as a whole \[m/Pa\] that was taken out of the stiffness; 0 if none was.
    pub compliance_m_per_pa: f64,
    /// Open paths across the surface; they may be as narrow as a point of the grid.
    pub open: OpenPaths,
}
