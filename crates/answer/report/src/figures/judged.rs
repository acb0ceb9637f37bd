//! The areas of boundary elements on figures of areas.

use judge::{Judgement, Reference, ReferenceArea};
use scene::Scene;
use study::figure::{FigureData, Mark, Shows};
use study::plan::Load;

/// The labels of elements, and their columns.
const ELASTIC: [&str; 2] = ["boundary elements", "elastic elements"];
const YIELDING: [&str; 2] = ["boundary elements, yielding", "yielding elements"];

/// Adds the areas of boundary elements to a figure of areas: against the cutoff under the loads that it shows, against the
/// load those of the whole surface.
pub(crate) fn with_marks(
    figure: FigureData,
    scene: &Scene,
    judgement: &Judgement,
    shortest_m: f64,
) -> FigureData {
    let under = |load: usize| element_marks(judgement, load, shortest_m).into_iter();
    let loads = scene.needs.loads.iter().enumerate();
    let marks = match figure.shows {
        Shows::Area => {
            let shown = loads.filter(|(at, _)| figure.series.iter().any(|series| series.load == Some(*at)));
            let named =
                |mark: Mark, label: &str| Mark { column: format!("{} at {label}", mark.column), ..mark };
            shown.flat_map(|(at, load)| under(at).map(move |mark| named(mark, &load.label))).collect()
        }
        Shows::AreaAgainstLoad => {
            let of_whole = |at| under(at).filter(|mark| mark.x == shortest_m);
            let along = |mark, x| Mark { condition_index: None, x, ..mark };
            let of_load = |(at, load): (usize, &Load)| {
                let pressure_pa = load.nominal_pressure_pa();
                of_whole(at).map(move |mark| along(mark, pressure_pa)).collect::<Vec<_>>()
            };
            loads.flat_map(of_load).collect()
        }
        _ => Vec::new(),
    };
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
        let [label, column] = if is_ring { YIELDING } else { ELASTIC }.map(str::to_owned);
        marks.push(Mark { label, column, is_ring, condition_index: Some(load), x, y, low, high });
        drawn.push(reference);
    }
    marks
}
