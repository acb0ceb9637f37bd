//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod cautions;
mod drawn_scenes;
mod flatness;
mod maps;
mod next_steps;
mod publications;
mod questions;
mod ranges;
mod relations;
mod stickiness;
