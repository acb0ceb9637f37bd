#![doc = include_str!("../README.md")]

pub mod answer;
pub mod conclusions;
pub mod doubts;
pub mod features;
pub mod sensitivity;
