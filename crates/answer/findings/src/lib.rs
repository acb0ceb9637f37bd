#![doc = include_str!("../README.md")]

pub mod answer;
pub mod doubts;
pub mod features;
pub mod sensitivity;
