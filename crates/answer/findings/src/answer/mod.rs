//! The answer of a scene under each load: the area, the scales that decide it, and disagreements between models.

mod scene_answer;
mod table_rows;

pub use scene_answer::{
    DISAGREEMENT, Disagreement, LoadAnswer, MIN_DECADES, MIN_SCALES, SceneAnswer, SettingScale,
};
