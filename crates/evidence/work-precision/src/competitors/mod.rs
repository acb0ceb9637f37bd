//! What users have today, asked in its own language: `competitors/` beside `src/` has the Python.

mod environment;
mod worker;

pub use environment::{Environment, Missing};
pub use worker::{Asked, At, Row, Setting, Worker};

use crate::point::Engine;

/// The package that an engine comes with.
pub fn package(engine: Engine) -> Option<&'static str> {
    match engine {
        Engine::Ours | Engine::OursBatch => None,
        Engine::Fn => Some("ContactMechanics"),
        Engine::Quad | Engine::QuadNumpy | Engine::Grid | Engine::GridBatch => Some("scipy"),
    }
}
