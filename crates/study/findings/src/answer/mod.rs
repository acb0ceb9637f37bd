//! The answer of a scene under each load: the area, the scales that decide it, and where models disagree.

mod scene_answer;
mod table_rows;

pub use scene_answer::{
    Answer, DISAGREEMENT, Disagreement, LEAST_DECADES, LEAST_SCALES, LoadAnswer, SettingScale,
};
