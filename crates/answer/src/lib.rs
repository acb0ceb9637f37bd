#![doc = include_str!("../README.md")]

pub mod doubts;
mod scene_answer;
mod tables;

pub use scene_answer::{
    Answer, DISAGREEMENT, Disagreement, LEAST_DECADES, LEAST_SCALES, LoadAnswer, SettingScale,
};
