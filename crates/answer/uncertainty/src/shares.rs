//! The shares of groups of inputs in the variance of ln A.

use study::Progress;
use study::plan::Work;

use crate::areas::Areas;
use crate::draws::{self, Drawn};
use crate::group::{Group, Index, Indices};
use crate::inputs::Inputs;
use crate::quantiles::interval;
use crate::sobol::{NOTHING, indices};
use crate::surface_scatter::DrawOf;
use crate::tables::LARGEST_ERROR_OF_A_SHARE;

/// The size of the small design: a share has a standard error of 0.04 at most.
pub(crate) const SMALL_DESIGN: usize = 256;

/// The indices of an only group.
const ALL: Indices = Indices {
    first_order: Index { value: 1.0, standard_error: 0.0 },
    total: Index { value: 1.0, standard_error: 0.0 },
};

/// Saltelli's design over the uncertain groups. A and B reuse draws that were made already.
pub(crate) struct Design {
    /// Draws of A, and as many of B.
    pub size: usize,
}

impl Design {
    /// The design for this number of draws; the full one if its size is given.
    pub fn new(draws: usize, size: Option<usize>) -> Self {
        Design { size: size.unwrap_or(SMALL_DESIGN.min(draws / 2)) }
    }

    /// The number of draws beyond those that were made.
    pub fn further_draws(&self, made: usize, groups: usize) -> usize {
        if groups < 2 { 0 } else { (2 * self.size).saturating_sub(made) + groups * self.size }
    }

    /// Computes the indices of every group for every area; `None` if cancelled.
    pub fn run(
        &self,
        inputs: &Inputs,
        areas: &Areas,
        made: &Drawn,
        progress: &dyn Progress,
    ) -> Option<(Vec<Vec<Indices>>, Work, usize)> {
        let groups = &inputs.groups;
        if groups.len() < 2 {
            let of_area = |area: usize| {
                let draws = made.of(area);
                let varies = draws.iter().any(|draw| *draw != draws[0]);
                vec![if varies { ALL } else { NOTHING }; groups.len()]
            };
            return Some(((0..areas.count()).map(of_area).collect(), Work::default(), 0));
        }
        let (size, known) = (self.size, made.ln_areas.len());
        let missing = (2 * size).saturating_sub(known);
        let mut work = Work::default();
        let further =
            draws::all(inputs, areas, None, missing, |draw| DrawOf::all(known as u64 + draw), progress);
        work += further.work;
        let base: Vec<&Vec<Option<f64>>> = made.ln_areas.iter().chain(&further.ln_areas).collect();
        let mut plans = further.ln_areas.len();
        let mut of_groups = Vec::new();
        for &group in groups {
            let mixed = |draw: u64| DrawOf::all(draw).with(group, draw + size as u64);
            let found = draws::all(inputs, areas, None, size, mixed, progress);
            work += found.work;
            plans += found.ln_areas.len();
            of_groups.push(found);
        }
        if base.len() < 2 * size || of_groups.iter().any(|found| found.ln_areas.len() < size) {
            return None;
        }
        let of_area =
            |area: usize| of_groups.iter().map(|mixed| of_group(&base, mixed, size, area)).collect();
        Some(((0..areas.count()).map(of_area).collect(), work, plans))
    }
}

/// The indices of a group for an area, from the draws of the design that have one.
fn of_group(base: &[&Vec<Option<f64>>], mixed: &Drawn, size: usize, area: usize) -> Indices {
    let (mut a, mut b, mut ab) = (Vec::new(), Vec::new(), Vec::new());
    for draw in 0..size {
        let found = (base[draw][area], base[draw + size][area], mixed.ln_areas[draw][area]);
        if let (Some(of_a), Some(of_b), Some(of_mixed)) = found {
            a.push(of_a);
            b.push(of_b);
            ab.push(of_mixed);
        }
    }
    let tails = Tails::new(a.iter().chain(&b).copied().collect());
    let [a, b, ab] =
        [a, b, ab].map(|draws| draws.into_iter().map(|draw| tails.held(draw)).collect::<Vec<_>>());
    indices(&a, &b, &ab)
}

/// The bounds of heavy tails, which would otherwise dominate the variance: Student's distribution of few scans has
/// none. Tails are cut at the ends of the 95 % interval, which does not move these ends.
struct Tails {
    ends: [f64; 2],
}

impl Tails {
    /// The range of draws, in interval widths, above which tails are heavy; a thousand normal draws have 1.7.
    const HEAVY: f64 = 2.5;

    fn new(draws: Vec<f64>) -> Self {
        let everything = Tails { ends: [f64::NEG_INFINITY, f64::INFINITY] };
        let Some(found) = interval(&draws, 0.95) else { return everything };
        let ends = [found.low.value, found.high.value];
        let range = draws.iter().copied().fold(f64::NEG_INFINITY, f64::max)
            - draws.iter().copied().fold(f64::INFINITY, f64::min);
        if range > Self::HEAVY * (ends[1] - ends[0]) { Tails { ends } } else { everything }
    }

    fn held(&self, draw: f64) -> f64 {
        draw.clamp(self.ends[0], self.ends[1])
    }
}

/// The first-order index of a group, if it is uncertain and its index is known.
pub(crate) fn first_order(groups: &[Group], indices: &[Indices], group: Group) -> Option<f64> {
    let at = groups.iter().position(|other| *other == group)?;
    let index = indices.get(at)?.first_order;
    (index.standard_error <= LARGEST_ERROR_OF_A_SHARE).then_some(index.value)
}
