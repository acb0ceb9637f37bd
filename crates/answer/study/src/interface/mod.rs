//! Quantities of an interface besides its area, and the scene's request for them.

mod quantity;
mod request;
mod shear;

pub use quantity::{Quantity, Slot};
pub use request::{Adhesion, InterfaceRequest, Seal};
pub use shear::{Shear, ShearLoad, sheared_pair};
