//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod bodies;
mod hardness;
mod judge;
mod loads;
mod material_spreads;
mod outcomes;
mod roughness;
mod scenes;
mod si_units;
mod uncertainty;
