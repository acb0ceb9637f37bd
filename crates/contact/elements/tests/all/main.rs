//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod adhesion;
mod always_ends;
mod approach;
mod common;
mod exact;
mod in_turn;
mod indenter;
mod invariances;
mod pressed;
mod separation;
mod specimen;
