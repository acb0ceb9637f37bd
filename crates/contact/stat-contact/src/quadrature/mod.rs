//! Integrals over the heights of the asperities.
//!
//! p(d) = eta Int_0^inf F(w) g(d + w) dw, and likewise with the area A (Greenwood & Williamson 1966). The law is
//! costly and does not depend on d; the density is cheap and does. So a [`frame`] holds the law's values at the nodes
//! of a quadrature that [`build`] has laid around one separation, and sums them against the density at any separation
//! nearby. A search for the separation that carries a load therefore evaluates the law once, not once per step.

pub mod build;
pub mod builder;
pub mod cell;
pub mod coordinate;
pub mod frame;
pub mod frames;
pub mod heights;
pub mod hertz_integrals;
pub mod nodes;
pub mod panel;
pub mod panels;
pub mod precision;
pub mod rules;
pub mod sums;
pub mod trapezoid;
