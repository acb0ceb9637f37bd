//! Thermal and electrical conductance of an interface.
//!
//! The potential and the displacement of a half-space follow from flux and pressure by the same law, so that the
//! conductance of an interface is its incremental elastic stiffness in other units (Barber 2003, Proc. R. Soc. A
//! 459:53). [`RelativeStiffness`] is that of a nominal area, [`Spot`] that of one contact, or of the single circle
//! that conducts as much as a whole interface. Neither needs the number of spots or a cutoff of the spectrum.
//!
//! The correlations for plastic contact ([`PlasticCorrelation`]) need the slopes of the surface, which depend on the
//! cutoff of its spectrum ([`CutSurface`]).

mod bodies;
mod plastic;
mod spot;
mod stiffness;

pub use bodies::{Conductivities, Resistivities};
pub use plastic::{CutSurface, PlasticCorrelation, PressureRatio};
pub use spot::Spot;
pub use stiffness::RelativeStiffness;

/// Mean free path of electrons in a good metal at room temperature \[m\]; spots below it conduct less than by diffusion (Sharvin
/// 1965).
pub const ELECTRON_MEAN_FREE_PATH_M: f64 = 40e-9;

/// Largest plastic share of the contact for which the slope of an elastic loading curve is still the stiffness of the
/// contact.
pub const MOST_PLASTIC_SHARE: f64 = 0.03;
