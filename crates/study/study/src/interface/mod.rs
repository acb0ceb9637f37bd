//! Quantities of an interface besides its area, and the request of them that a scene makes.

mod asked;
mod quantity;

pub use asked::{Adhesion, Asked, Seal};
pub use quantity::{Quantity, Slot};
