//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod committed;
mod joints;
mod predictions;
mod resistances;
