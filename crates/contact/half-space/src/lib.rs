#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`Grid`]: the points and their spacing.
//! * [`PeriodicElements`] and [`FreeElements`]: a surface laid out on them, which can be pressed many times.
//! * [`Loading`]: modulus, pressure, saturation and tolerance.
//! * [`Contact`]: pressures and gaps in equilibrium, with areas, mean gap and energy.
//! * [`OpenPaths`]: channels through which a fluid crosses the contact.

mod area;
mod contact;
mod descent;
mod elements;
mod error;
mod free;
mod grid;
mod loading;
mod love;
mod percolation;
mod periodic;
mod problem;
mod projection;
mod stiffness;
mod sums;
mod transform;

pub use area::extrapolated_area;
pub use contact::{Contact, Ending};
pub use elements::PROGRESS_STEPS;
pub use error::HalfSpaceError;
pub use free::FreeElements;
pub use grid::Grid;
pub use loading::Loading;
pub use percolation::{OpenPaths, Sides, open_paths};
pub use periodic::PeriodicElements;
