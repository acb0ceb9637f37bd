//! What an interface does besides touching: its gap and stiffness, the heat and current that cross it, what leaks through, and what
//! friction and adhesion would be. `quantity` names what there is, `asked` is what a scene wants of it, `states` computes that from
//! the results of its plan.

mod asked;
mod quantity;
mod states;
mod table;

pub use asked::{Adhesion, Asked, Seal};
pub use quantity::{Quantity, Slot};
pub use states::{InterfaceError, InterfaceStates, Pressed};
pub use table::of_slots;
