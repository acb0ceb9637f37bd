//! The judgement in words: yielding, and the elements that were pressed.

use judge::{Basis, Extent, Judgement, MapVerdict, Reference};
use scene::Scene;
use units::display::{counted, length, pressure, three_digits};

use crate::listing::at_loads;

/// The least growth of the area by peaks of the pressure that flow which is worth a word.
const FELT: f64 = 1.005;

/// The notes below the verdicts: on yielding, maps, steep slopes, and the surfaces that were pressed.
pub(crate) fn about_elements(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut sentences = yields(judgement, scene);
    sentences.extend(phases(judgement, scene));
    sentences.extend(steep(judgement));
    sentences.extend(judgement.extent.as_ref().map(pressed));
    sentences
}

/// The yielding of the contact: the pressure of an elastic contact against the hardness.
fn yields(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    // What would have to bear more than the hardness, and whether elements that flow are the answer.
    type Kind = (Option<String>, bool);
    let mut groups: Vec<(Kind, Vec<usize>)> = Vec::new();
    for yielding in judgement.yielding.iter().filter(|yielding| yielding.flowing_over_elastic.is_some()) {
        let growing = match (yielding.hardness_grows, yielding.above_growing) {
            (false, _) => "",
            (true, None) => "; a hardness that grows at small scales as the material's does is not exceeded",
            (true, Some(_)) => {
                "; a hardness that grows as the material's does is exceeded as well, at some scale"
            }
        };
        let above = yielding.above_constant.map(|above| {
            format!(
                "roughness finer than {} would need more than the hardness, {}, to stay elastic{growing}",
                length(above.wavelength_m),
                pressure(above.hardness_pa)
            )
        });
        let flows = judgement
            .headline(yielding.load)
            .is_some_and(|headline| matches!(headline.basis, Basis::Elements(Reference::Yielding { .. })));
        let kind = (above, flows);
        match groups.iter_mut().find(|(other, _)| *other == kind) {
            Some((_, loads)) => loads.push(yielding.load),
            None => groups.push((kind, vec![yielding.load])),
        }
    }
    let ratio = |load: &usize| judgement.yielding[*load].flowing_over_elastic.unwrap_or(1.0);
    let sentence = |((above, flows), loads): (Kind, Vec<usize>)| {
        let (at, ratio) = (at_loads(scene, &loads), loads.iter().map(ratio).fold(1.0, f64::max));
        let below = "the mean pressure of an elastic contact stays below the hardness at every scale";
        match above {
            Some(above) => format!("The contact yields {at}: {above}."),
            None if flows => format!(
                "Peaks of the map yield: {at} {below}, but peaks of the map bear more, and it touches more as they flow."
            ),
            None if ratio < FELT => format!("Nothing yields: {at} {below}."),
            None => format!(
                "Only peaks of the pressure yield: {at} {below}. By Persson's theory they make the area up to {} times that of elastic \
                 elements, to which the range reaches.",
                three_digits(ratio)
            ),
        }
    };
    groups.into_iter().map(sentence).collect()
}

/// The effect on measured maps of what their spectrum leaves out.
fn phases(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let of_map = |of: &MapVerdict| {
        format!(
            "The map {} at {} has {} ± {} times the contact area of Gaussian surfaces with its spectrum: {}.",
            of.map,
            scene.needs.loads[of.load].label,
            three_digits(of.ratio()),
            three_digits(of.ratio_error()),
            match (of.differs(), of.has_direction()) {
                (true, true) => "its slopes differ by direction, and its spectrum runs along its lines",
                (true, false) => "its heights are not Gaussian, which no spectrum shows",
                (false, _) => "the spectrum is enough",
            }
        )
    };
    judgement.maps.iter().map(of_map).collect()
}

/// The wavelength at which slopes become too steep for every method.
fn steep(judgement: &Judgement) -> Option<String> {
    let from_m = judgement.steep_from_m?;
    Some(format!(
        "Below {} slopes are too steep for every method used here, boundary elements included: the rms pressure of full contact \
         exceeds E*/10 (rms gradient {} over the whole band).",
        length(from_m),
        three_digits(judgement.rms_gradient)
    ))
}

fn pressed(extent: &Extent) -> String {
    let left_out = match extent.left_out {
        0 => String::new(),
        some => format!(" ({} without roughness left out)", counted(some, "window")),
    };
    let windows = match extent.windows {
        1 => "the whole band".to_owned(),
        some => format!("{} half a decade apart", counted(some, "window")),
    };
    let (points, surfaces) = (extent.grid_of_last, extent.realisations_of_last);
    let last = match (points != extent.grid, surfaces != extent.realisations) {
        (false, false) => String::new(),
        (true, false) => format!(" ({points} x {points} on the last window)"),
        (false, true) => format!(" ({surfaces} on the last window)"),
        (true, true) => format!(" ({surfaces} of {points} x {points} on the last window)"),
    };
    format!(
        "Boundary elements pressed {windows}{left_out}: {}, {} each of {} x {} points{last}, seed {}; cost {} of a budget of {}.",
        counted(extent.solved, "pressure"),
        counted(extent.realisations, "surface"),
        extent.grid,
        extent.grid,
        extent.seed,
        three_digits(extent.spent),
        three_digits(extent.budget)
    )
}
