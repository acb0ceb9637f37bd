//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod hardness_and_strength;
mod linear_laws;
mod persson_options;
