//! A measured map of a scene, pressed apart from the scene.

use measurements::Files;
use numerics::parallel::Progress;
use questions::MapQuestion;
use report::page::PressedMap;
use serde::{Deserialize, Serialize};

use crate::answer::Desk;
use crate::heights::MapHeights;
use crate::request::{Refusal, Request};

/// A map of a scene, to be shown and to be pressed elsewhere.
#[derive(Debug, Serialize)]
pub struct MapToPress {
    /// All that the elements need.
    pub question: MapQuestion,
    /// The points that are pressed, in words.
    pub words: String,
    /// Their heights.
    pub heights: Option<MapHeights>,
}

/// A map and the load on it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PressRequest {
    /// The map.
    pub question: MapQuestion,
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
}

impl Desk {
    /// Returns a map of a scene by its index.
    ///
    /// # Errors
    /// [`Refusal`] in words; also if the scene has no such map, or no bodies.
    pub fn map(&mut self, request: &Request, files: &dyn Files, map: usize) -> Result<MapToPress, Refusal> {
        let (scene, _) = self.scene(request, files)?;
        let question = MapQuestion::from_scene(scene, map)
            .ok_or_else(|| Refusal::new("there is no such map, or the bodies have no modulus"))?;
        let heights = MapHeights::of_relief(&question.relief);
        Ok(MapToPress { words: PressedMap::describe(&question), heights, question })
    }
}

/// Presses a map; `begin` receives the number of steps and returns their progress.
///
/// # Errors
/// [`Refusal`] in words.
pub fn pressed<P: Progress>(
    request: &PressRequest,
    begin: impl FnOnce(usize) -> P,
) -> Result<PressedMap, Refusal> {
    PressedMap::new(&request.question, request.nominal_pressure_pa, begin).map_err(Refusal::new)
}
