//! Populations of asperities under their laws, as a quadrature over the interference sees them: [`answers`] says what
//! it has to know, [`pieces`] where a law is smooth and in which coordinate, and each law has a file.

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
