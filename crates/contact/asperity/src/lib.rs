#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`MaterialPair`]: the body that yields, its counterface, and their composite modulus.
//! * [`Layer`]: a rough body that is a layer on a base, with its displacement under waves of pressure.
//! * the laws: [`Hertz`] and [`JacksonGreen`] for a sphere at an interference, [`HertzEllipse`] for a summit of two
//!   curvatures, [`ElasticSinusoid`] and [`ElasticPlasticSinusoid`] for a sinusoid at a mean pressure or at an
//!   interference, with its mean gap, and [`BemSinusoid`], the elastic one by boundary elements.
//!   Spheres and the first two sinusoids also take many interferences at once, to the same digits at a sixth of the cost:
//!   [`JacksonGreen::forces_and_areas`], [`ElasticPlasticSinusoid::pressures_and_areas_at_interferences`].
//! * [`NixGao`]: the yield strength, which grows as the deformation gets shallower.
//! * [`elementary`]: exponentials and logarithms for many arguments at once.
//! * [`Break`]: kinks and jumps of a law, for quadratures over it.
//!
//! The material types check their values once; the laws' arguments carry their range in their documentation.
#![deny(missing_docs)]

mod bem_sinusoid;
mod breaks;
mod elastic_body;
mod elastic_plastic_interference;
mod elastic_plastic_sinusoid;
mod elastic_sinusoid;
pub mod elementary;
mod hertz;
mod hertz_ellipse;
mod jackson_green;
mod lanes;
mod layer;
mod material;
mod mean_gap;
mod monotone_cubic;
mod nix_gao;
mod plastic_flow;
#[cfg(test)]
mod samples;
mod yielding_area;

pub use bem_sinusoid::BemSinusoid;
pub use breaks::Break;
pub use elastic_body::ElasticBody;
pub use elastic_plastic_sinusoid::{ElasticPlasticSinusoid, FLAGGED_ASPECT_RATIO_OVER_CRITICAL};
pub use elastic_sinusoid::ElasticSinusoid;
pub use hertz::Hertz;
pub use hertz_ellipse::HertzEllipse;
pub use jackson_green::{
    FITTED_CONTACT_RADIUS_OVER_RADIUS, FITTED_STRENGTH_OVER_MODULUS, Hardness, JacksonGreen,
    YIELD_INTERFERENCE_RATIO,
};
pub use layer::{Layer, LayerCompliance};
pub use material::MaterialPair;
pub use monotone_cubic::MonotoneCubic;
pub use nix_gao::NixGao;
pub use plastic_flow::{FlowPoint, PlasticFlow};
pub use units::{Bound, OutOfBounds as AsperityError};
pub use yielding_area::YieldingArea;
