//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod common;
mod curves;
mod elements;
mod rows;
mod tangential;
mod yielding;
