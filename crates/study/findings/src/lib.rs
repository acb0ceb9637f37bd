#![doc = include_str!("../README.md")]

pub mod answer;
pub mod doubts;
pub mod features;
pub mod interface;
mod scene_findings;
pub mod sensitivity;

pub use scene_findings::SceneFindings;
