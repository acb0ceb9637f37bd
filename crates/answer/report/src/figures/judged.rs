//! The areas of boundary elements on figures of areas.

use judge::{BodyKind, ERRORS_GIVEN, Judgement};
use scene::Scene;
use study::figure::{FigureData, Mark};

const ELASTIC: &str = "boundary elements, elastic";
const SATURATED: &str = "boundary elements, saturated at the hardness";

/// Adds the areas of boundary elements under the loads that a figure shows: the area of each window, carried
/// over to the surface, with two standard errors either way.
pub(crate) fn with_marks(figure: FigureData, judgement: &Judgement, scene: &Scene) -> FigureData {
    let shown = |load: usize| figure.series.iter().any(|series| series.load == Some(load));
    let mut marks: Vec<Mark> = Vec::new();
    let of_windows = judgement.windows.iter().filter(|on| !on.is_whole_band);
    for on in of_windows.filter(|on| shown(on.load)) {
        let Some(judged) = on.elements_of_whole else { continue };
        let given = ERRORS_GIVEN * judged.standard_error;
        let (label, is_ring) = match BodyKind::from_model(&scene.needs.curves[on.curve].model) {
            BodyKind::Hard { .. } => (SATURATED, true),
            _ => (ELASTIC, false),
        };
        let mark = Mark {
            label: label.to_owned(),
            is_ring,
            condition_index: Some(on.load),
            x: on.shortest_m,
            y: judged.area_fraction,
            low: (judged.area_fraction - given).max(0.1 * judged.area_fraction),
            high: (judged.area_fraction + given).min(1.0),
        };
        // Curves of one body share their elements.
        if !marks.contains(&mark) {
            marks.push(mark);
        }
    }
    FigureData { marks, ..figure }
}
