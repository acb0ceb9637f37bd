//! The areas of boundary elements on figures of areas.

use judge::{Judgement, Reference, ReferenceArea};
use study::figure::{FigureData, Mark};

const ELASTIC: &str = "boundary elements, elastic";
const SATURATED: &str = "boundary elements, saturated at the hardness";

/// Adds the areas of boundary elements under the loads that a figure shows.
pub(crate) fn with_marks(figure: FigureData, judgement: &Judgement, shortest_m: f64) -> FigureData {
    let mut loads: Vec<usize> = figure.series.iter().filter_map(|series| series.load).collect();
    loads.sort_unstable();
    loads.dedup();
    let marks = loads.into_iter().flat_map(|load| element_marks(judgement, load, shortest_m)).collect();
    FigureData { marks, ..figure }
}

/// Returns the areas under a load with two standard errors either way: with the whole surface at its shortest wavelength
/// \[m\], and on each window, carried over to the surface; windows of Gaussian surfaces say nothing beside a map.
pub(crate) fn element_marks(judgement: &Judgement, load: usize, shortest_m: f64) -> Vec<Mark> {
    let whole = judgement
        .references
        .iter()
        .filter(|area| area.load == load)
        .filter_map(|area| Some((area.reference, shortest_m, area.elements?)));
    let on_windows = judgement.windows.iter().filter(|on| on.load == load && !on.is_whole_band);
    let on_windows = on_windows.filter_map(|on| {
        let reference = judgement.curves.iter().find(|curve| curve.curve == on.curve)?.reference;
        let is_map =
            |area: &ReferenceArea| (area.load, area.reference) == (load, reference) && area.maps.is_some();
        if judgement.references.iter().any(is_map) {
            return None;
        }
        Some((reference, on.shortest_m, on.elements_of_whole?))
    });
    let mut drawn: Vec<Reference> = Vec::new();
    let mut marks: Vec<Mark> = Vec::new();
    for (reference, x, elements) in whole.chain(on_windows) {
        // Curves of one body share their elements, and the last window ends where the spectrum does.
        let mut earlier = marks.iter().zip(&drawn);
        if earlier.any(|(mark, other)| *other == reference && (mark.x / x - 1.0).abs() < 0.01) {
            continue;
        }
        let is_ring = reference != Reference::Elastic;
        let (y, low, high) = (elements.area_fraction, elements.low(), elements.high());
        let label = if is_ring { SATURATED } else { ELASTIC }.to_owned();
        marks.push(Mark { label, is_ring, condition_index: Some(load), x, y, low, high });
        drawn.push(reference);
    }
    marks
}
