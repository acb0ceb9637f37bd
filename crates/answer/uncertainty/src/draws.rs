//! Draws, block by block.

use study::Progress;
use study::plan::Work;

use crate::areas::{Areas, DrawnAreas, Points};
use crate::inputs::Inputs;
use crate::quantities::{DrawnQuantities, Quantities};
use crate::surface_scatter::DrawOf;

/// The number of draws that are computed together, on all threads; draws can be cancelled between blocks.
const BLOCK: usize = 64;

/// ln A of every curve and load in every draw, and the work that it took.
#[derive(Debug, Default)]
pub(crate) struct Drawn {
    /// ln A, draw by draw.
    pub ln_areas: Vec<Vec<Option<f64>>>,
    /// The quantities of an interface, draw by draw; none where none were asked for.
    pub quantities: Vec<Option<DrawnQuantities>>,
    /// The work that the draws took.
    pub work: Work,
}

impl Drawn {
    /// ln A of one curve and load, for the draws that have it.
    pub fn of(&self, area: usize) -> Vec<f64> {
        self.ln_areas.iter().filter_map(|draw| draw[area]).collect()
    }

    fn add(&mut self, (areas, quantities): (DrawnAreas, Option<DrawnQuantities>)) {
        self.ln_areas.push(areas.ln_areas);
        self.quantities.push(quantities);
        self.work += areas.work;
    }
}

impl FromIterator<DrawnAreas> for Drawn {
    fn from_iter<I: IntoIterator<Item = DrawnAreas>>(draws: I) -> Self {
        let mut all = Drawn::default();
        draws.into_iter().for_each(|draw| all.add((draw, None)));
        all
    }
}

/// Computes the final areas of a draw, and the quantities of an interface from the same spectrum.
fn drawn(
    inputs: &Inputs,
    areas: &Areas,
    quantities: Option<&Quantities<'_>>,
    draw: DrawOf,
) -> (DrawnAreas, Option<DrawnQuantities>) {
    let curves = inputs.curves(areas.distinct_curves(), draw);
    let material = inputs.material(draw);
    match inputs.psd(draw) {
        Some(None) => (
            areas.at_the_end(None, curves),
            quantities.and_then(|quantities| quantities.with_bodies(material)),
        ),
        Some(Some(psd)) => match areas.ends_on(&psd, curves) {
            Some((found, results)) => {
                (found, quantities.and_then(|quantities| quantities.of(&results, material)))
            }
            None => (areas.nothing(), None),
        },
        None => (areas.nothing(), None),
    }
}

/// Computes the final areas of `count` draws, and the quantities of an interface, fewer if cancelled; `which` selects the
/// random numbers of each. `progress` advances once per draw.
pub(crate) fn all(
    inputs: &Inputs,
    areas: &Areas,
    quantities: Option<&Quantities<'_>>,
    count: usize,
    which: impl Fn(u64) -> DrawOf + Sync,
    progress: &dyn Progress,
) -> Drawn {
    let mut found = Drawn::default();
    for from in (0..count).step_by(BLOCK) {
        if progress.is_cancelled() {
            break;
        }
        let numbers: Vec<u64> = (from..count.min(from + BLOCK)).map(|draw| draw as u64).collect();
        let block = numerics::parallel::map(&numbers, |&draw| drawn(inputs, areas, quantities, which(draw)));
        progress.advance(block.len());
        block.into_iter().for_each(|draw| found.add(draw));
    }
    found
}

/// The areas of a draw along the cutoff: for every curve and load that differ.
pub(crate) type Along = Vec<Vec<Points>>;

/// Computes the areas of the first draws along the cutoff; draws out of the range of the models are left out.
pub(crate) fn along(
    inputs: &Inputs,
    areas: &Areas,
    count: usize,
    progress: &dyn Progress,
) -> (Vec<Along>, Work) {
    let numbers: Vec<u64> = (0..count as u64).collect();
    let found = numerics::parallel::map(&numbers, |&draw| {
        if progress.is_cancelled() {
            return None;
        }
        let draw = DrawOf::all(draw);
        let psd = inputs.psd(draw)?;
        let found = areas.along(psd.as_ref(), inputs.curves(areas.distinct_curves(), draw));
        progress.advance(1);
        found
    });
    let mut work = Work::default();
    let mut draws = Vec::new();
    for (along, of_draw) in found.into_iter().flatten() {
        work += of_draw;
        draws.push(along);
    }
    (draws, work)
}
