//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod committed;
mod coverage;
mod flatness;
mod flattening;
mod gap_trials;
mod judge_trials;
mod scene_trials;
mod window_excess;
mod yielding;
