//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod agreement;
mod persson_options;
mod roughness;
mod uncertainty;
