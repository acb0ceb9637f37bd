//! Quantities of an interface besides its area, computed from the results of a scene's plan.

mod states;
mod table;

pub use states::{InterfaceError, InterfaceInputs, InterfaceStates};
pub use table::slots_table;
