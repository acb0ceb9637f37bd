#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`Population`]: radius, density and height spread of the asperities, three plain numbers.
//! * [`SummitHeights`]: Gaussian heights, or exponential ones.
//! * [`NayakSummits`]: the summits of a Gaussian surface, of every curvature that it has.
//! * [`AsperityLaw`]: the response of one asperity, with its strength, hardness, [`Flattening`] and
//!   [`InterferenceLaw`].
//! * [`StatisticalContact`]: population and law under a material; computes states at a separation or at a pressure.
//! * [`GreenwoodTripp`]: elastic contact of two rough faces, and its fit to any curve of pressure and area.
//! * [`PartialMoment`]: the integrals F_n of Gaussian heights.
//! * [`LinearLaw`]: area in proportion to the load, as a yardstick for elastic areas.
//! * [`Sweep`]: many states of one population and material, which share work.
//! * [`StateTable`]: states over a range of separations, from polynomials.
//! * [`Condition`]: a pressure or a separation, at which a state is wanted.
//! * [`ContactState`]: a state with its error estimate and its cost; also in logarithms, because pressures span
//!   hundreds of decades.
#![deny(missing_docs)]

mod asperities;
mod condition;
mod contact;
mod exponential;
mod far;
mod gaussian;
mod greenwood_tripp;
mod linear_law;
mod population;
mod quadrature;
mod search;
mod state;
mod summit_heights;
mod summits;
mod sweep;
mod table;

pub use asperities::{AsperityLaw, Flattening, InterferenceLaw};
pub use condition::Condition;
pub use contact::StatisticalContact;
pub use gaussian::moments::PartialMoment;
pub use greenwood_tripp::{GreenwoodTripp, GreenwoodTrippFit, SeparationPoint};
pub use linear_law::LinearLaw;
pub use population::Population;
pub use state::{ContactState, NoSeparation};
pub use summit_heights::SummitHeights;
pub use summits::nayak::NayakSummits;
pub use sweep::Sweep;
pub use table::StateTable;
