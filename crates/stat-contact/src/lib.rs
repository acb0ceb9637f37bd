#![doc = include_str!("../README.md")]
//!
//! The nouns:
//! * [`Population`]: radius, density and height spread of the asperities, three plain numbers.
//! * [`AsperityLaw`]: how one of them answers; [`Model`] and [`InterferenceLaw`] are the names for it.
//! * [`StatisticalContact`]: the two under a material; asked for its state at a separation or at a pressure.
//! * [`Sweep`]: the same population and material asked for many states, which share what they can.
//! * [`ContactState`]: the answer, also in logarithms, since pressures span hundreds of decades, with its error estimate
//!   and its cost.
#![deny(missing_docs)]

mod asperities;
mod contact;
mod far;
mod gaussian;
mod law;
mod population;
mod quadrature;
mod search;
mod state;
mod sweep;

pub use contact::StatisticalContact;
pub use law::{AsperityLaw, InterferenceLaw, Model};
pub use population::Population;
pub use state::ContactState;
pub use sweep::Sweep;
