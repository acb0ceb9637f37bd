#![doc = include_str!("../README.md")]
//!
//! The nouns:
//! * [`Population`]: radius, density and height spread of the asperities, three plain numbers.
//! * [`NayakSummits`]: the summits of a Gaussian surface, of every curvature that it has.
//! * [`AsperityLaw`]: how one of them answers, and what it is made of: strength, hardness, [`InterferenceLaw`].
//! * [`StatisticalContact`]: the two under a material; asked for its state at a separation or at a pressure.
//! * [`LinearLaw`]: the area in proportion to the load, to hold elastic areas against.
//! * [`Sweep`]: the same population and material asked for many states, which share what they can.
//! * [`ContactState`]: the answer, also in logarithms, since pressures span hundreds of decades, with its error estimate
//!   and its cost.
#![deny(missing_docs)]

mod asperities;
mod contact;
mod far;
mod gaussian;
mod law;
mod linear_law;
mod population;
mod quadrature;
mod search;
mod state;
mod summits;
mod sweep;

pub use contact::StatisticalContact;
pub use law::{AsperityLaw, InterferenceLaw};
pub use linear_law::LinearLaw;
pub use population::Population;
pub use state::ContactState;
pub use summits::nayak::NayakSummits;
pub use sweep::Sweep;
