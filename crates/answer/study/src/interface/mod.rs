//! Quantities of an interface besides its area, and the scene's request for them.

mod flat;
mod gas;
mod quantity;
mod request;
mod shear;
mod sources;
mod states;
mod table;
mod with_flatness;

pub use flat::FlatnessAdds;
pub use gas::{GasError, GasInput};
pub use quantity::{Quantity, Slot};
pub use request::{AdhesionRequest, Asks, InterfaceRequest, Seal};
pub use shear::{Shear, ShearLoad, sheared_pair};
pub use states::{InterfaceError, InterfaceInputs, InterfaceStates};
pub use table::slots_table;
pub use with_flatness::FlatnessRange;
