#![doc = include_str!("../README.md")]
//!
//! The nouns:
//! * [`Grid`]: the points, and how far they are apart.
//! * [`PeriodicElements`] and [`FreeElements`]: a surface laid out on them, which may be pressed again and again.
//! * [`Loading`]: modulus, pressure, saturation and tolerance.
//! * [`Contact`]: pressures and gaps in equilibrium, and what follows from them.
//! * [`OpenPaths`]: whether what is not in contact lets a fluid across.

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
