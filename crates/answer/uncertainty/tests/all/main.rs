//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod draws;
mod material_draws;
mod quantities;
mod tables;
