//! Statistical contact: a population of asperities of one curvature and Gaussian heights, pressed by a flat
//! (Greenwood & Williamson 1966), under four laws of the single asperity.
//!
//! ```
//! use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
//! use stat_contact::{AsperityLaw, Population, StatisticalContact};
//!
//! let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2)?);
//! let population = Population::new(45.6e-9, 26e12, 6.66e-9)?;
//! let law = AsperityLaw::EpSphere { strength: NixGao::constant(1.8e9)?, hardness: Hardness::default() };
//! let contact = StatisticalContact::new(&pair, &population, &law);
//! let state = contact.at_pressure(50e6, 1e-10, None)?;
//! let back = contact.at_separation(state.separation_m.unwrap(), 1e-10)?;
//! assert!((back.pressure_pa / 50e6 - 1.0).abs() < 1e-10);
//! # Ok::<(), asperity::AsperityError>(())
//! ```
//!
//! The nouns:
//! * [`Population`]: radius, density and height spread of the asperities, three plain numbers.
//! * [`AsperityLaw`]: how one of them answers; [`Model`] and [`InterferenceLaw`] are the names for it.
//! * [`StatisticalContact`]: the two under a material; asked for its state at a separation or at a pressure.
//! * [`Sweep`]: the same population and material asked for many states, which share what they can.
//! * [`ContactState`]: the answer, also in logarithms, since pressures span hundreds of decades, with its error estimate
//!   and its cost.
//!
//! Not here: where the population comes from (moments of a spectrum, McCool's parameters), the distance between the mean
//! plane of the surface and that of its summits, parallelism, units. SI throughout; everything is
//! serial and `Sync`.
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
pub use law::{AsperityLaw, InterferenceLaw, Model, UnknownName};
pub use population::Population;
pub use state::ContactState;
pub use sweep::Sweep;
