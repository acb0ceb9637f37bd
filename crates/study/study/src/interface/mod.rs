//! Quantities of an interface besides its area, and the request of them that a scene makes.

mod quantity;
mod request;

pub use quantity::{Quantity, Slot};
pub use request::{Adhesion, InterfaceRequest, Seal};
