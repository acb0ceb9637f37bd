#![doc = include_str!("../README.md")]

mod answer;
mod choices;
mod door;
mod example;
mod file_sight;
mod heights;
mod pressed;
mod products;
mod request;

pub use answer::{Desk, Opened, Reply};
pub use choices::choices;
pub use example::EXAMPLES;
pub use file_sight::FileSight;
pub use pressed::{MapToPress, PressRequest, pressed};
pub use products::{Judged, ProductFile, judged, products};
pub use request::{FileKind, FileRequest, Refusal, Request};
