//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod calculix;
mod calculix_conductance;
mod conductance;
mod finite_elements;
mod support;
