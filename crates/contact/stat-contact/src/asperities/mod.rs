//! Populations of asperities under their laws, as seen by a quadrature over the interference: [`answers`] has the
//! trait, [`pieces`] the intervals and coordinates in which a law is smooth. Each law has a file.

pub mod answers;
pub mod bem_sines;
pub mod elastic_plastic_sines;
pub mod elastic_plastic_spheres;
pub mod elastic_sines;
pub mod gradient_breaks;
pub mod gradient_law;
pub mod gradient_sines;
pub mod hertz_ellipses;
pub mod hertz_spheres;
pub mod pieces;
pub mod sine_charts;
