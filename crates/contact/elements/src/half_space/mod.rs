//! Boundary elements for an elastic half-space under a rigid rough surface: pressures and gaps in equilibrium, and from these
//! the area, plastic area, mean gap, largest pressure, energy, stiffness and open channels.
//!
//! The surface is periodic on a rectangular grid of any size ([`Elements::periodic`]), or alone on the half-space
//! ([`Elements::free`]). A saturation limits the pressure to an indentation hardness. A mean gap or an indentation can be held
//! in place of the load ([`Elements::press_to`]).
//!
//! ```
//! use elements::half_space::{Grid, HalfSpaceError, Loading, Elements, Sides, open_paths};
//! use numerics::parallel::Unobserved;
//! use std::f64::consts::{PI, TAU};
//!
//! fn main() -> Result<(), HalfSpaceError> {
//!     // A wave of 1 nm over 1 um: a line is a grid of one row.
//!     let (points, length_m, height_m) = (512, 1e-6, 1e-9);
//!     let heights_m: Vec<f64> = (0..points).map(|k| height_m * (TAU * k as f64 / points as f64).cos()).collect();
//!     let mut elements = Elements::periodic(Grid::new(1, points, length_m, length_m)?, &heights_m)?;
//!
//!     // Pressed with a quarter of the closing pressure: the area is (2/pi) asin(sqrt(1/4)) = 1/3 (Westergaard 1939).
//!     let contact_modulus_pa = 100e9;
//!     let closing_pa = PI * contact_modulus_pa * height_m / length_m;
//!     let mut loading =
//!         Loading { contact_modulus_pa, nominal_pressure_pa: 0.25 * closing_pa, saturation_pa: None, tolerance: 1e-8 };
//!     let contact = elements.press(&loading, &Unobserved)?;
//!     assert!((contact.numbers.area_fraction - 1.0 / 3.0).abs() < 2.0 / points as f64);
//!     assert!((contact.numbers.largest_pressure_pa / closing_pa - 1.0).abs() < 1e-3);
//!     let stiffness_pa_per_m = elements.stiffness_pa_per_m(&contact, contact_modulus_pa, &Unobserved)?;
//!     assert!(stiffness_pa_per_m.is_some());
//!
//!     // A fluid passes along the crests, not across them.
//!     let paths = open_paths(elements.grid(), Sides::Periodic, &contact.touching())?;
//!     assert!(paths.along_y && !paths.along_x);
//!
//!     // With a hardness of 0.4 of the closing pressure most of the contact flows.
//!     loading.saturation_pa = Some(0.4 * closing_pa);
//!     let yielding = elements.press(&loading, &Unobserved)?;
//!     let [yielding, elastic] = [yielding.numbers, contact.numbers];
//!     assert!(yielding.area_fraction > elastic.area_fraction && yielding.plastic_area_fraction > 0.4);
//!     Ok(())
//! }
//! ```
//!
//! Not here: the origin of heights, detrending, averages over surfaces, parallelism (elements are `Send`; solve maps and
//! loads in parallel).
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
    Adhesion, AdhesionError, AdhesiveContact, AdhesiveElements, AdhesiveNumbers, Control, GOOD_RESOLUTION,
    LEAST_RESOLUTION, Start,
};
pub use area::extrapolated_area;
pub use contact::{Contact, ContactNumbers, Ending};
pub use elements::{Elements, PROGRESS_STEPS};
pub use error::HalfSpaceError;
pub use grid::Grid;
pub use loading::{Approach, Closing, Loading};
pub use patches::{Patch, Places, patches, patches_with_places};
pub use percolation::{OpenPaths, Sides, open_paths};
