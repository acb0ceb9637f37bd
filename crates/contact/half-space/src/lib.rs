#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`Grid`]: the points and their spacing.
//! * [`Elements`]: a surface laid out on them, periodic or free, which can be pressed many times.
//! * [`Loading`]: modulus, pressure, saturation and tolerance; [`Closing`] holds a distance in place of the pressure.
//! * [`Contact`]: pressures and gaps in equilibrium, with areas, mean gap and energy.
//! * [`AdhesiveElements`]: a periodic surface that attracts the half-space, with the gap as the unknown.
//! * [`Patch`]: a connected region of points in contact.
//! * [`OpenPaths`]: channels through which a fluid crosses the contact.

mod adhesion;
mod area;
mod contact;
mod descent;
mod elements;
mod error;
mod grid;
mod loading;
mod love;
mod operators;
mod patches;
mod percolation;
mod problem;
mod projection;
mod stiffness;
mod sums;
mod transform;

pub use adhesion::{
    Adhesion, AdhesionError, AdhesiveContact, AdhesiveElements, Control, GOOD_RESOLUTION, LEAST_RESOLUTION,
    Start,
};
pub use area::extrapolated_area;
pub use contact::{Contact, Ending};
pub use elements::{Elements, PROGRESS_STEPS};
pub use error::HalfSpaceError;
pub use grid::Grid;
pub use loading::{Approach, Closing, Loading};
pub use patches::{Patch, patches};
pub use percolation::{OpenPaths, Sides, open_paths};
