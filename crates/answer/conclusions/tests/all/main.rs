//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod drawn_scenes;
mod maps;
mod ranges;
mod relations;
mod stickiness;
