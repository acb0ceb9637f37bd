//! Competitors that users have today, run in their own language: `competitors/` beside `src/` has the Python.

mod environment;
mod worker;

pub use environment::{Environment, MissingPackage};
pub use worker::{Question, Row, Setting, States, Worker};

use crate::point::Engine;

/// Package of an engine; `None` for our own.
pub fn package(engine: Engine) -> Option<&'static str> {
    match engine {
        Engine::Ours | Engine::OursBatch => None,
        Engine::Fn => Some("ContactMechanics"),
        Engine::Quad | Engine::QuadNumpy | Engine::Grid | Engine::GridBatch => Some("scipy"),
    }
}
