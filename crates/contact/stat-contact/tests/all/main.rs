//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod error_estimates;
mod exponential;
mod greenwood_tripp;
mod hard;
mod references;
mod robustness;
mod states;
mod stiffness;
mod summits;
mod support;
mod sweeps;
mod tables;
