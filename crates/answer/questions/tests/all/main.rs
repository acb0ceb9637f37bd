//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod adhesion;
mod bodies;
mod common;
mod curves;
mod elements;
mod elements_laws;
#[cfg(feature = "transport")]
mod flow;
mod indenters;
mod laws;
mod lubrication;
mod rows;
mod scenes;
mod tangential;
mod yielding;
