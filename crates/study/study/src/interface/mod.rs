//! Quantities of an interface besides its area, and the scene's request for them.

mod quantity;
mod request;

pub use quantity::{Quantity, Slot};
pub use request::{Adhesion, InterfaceRequest, Seal};
