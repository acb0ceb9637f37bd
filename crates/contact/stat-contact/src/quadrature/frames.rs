//! Frames built by earlier searches, kept for later ones.
//!
//! A frame depends on its cell alone, so that a state has the same digits on a kept frame as on a new one.

use super::builder::Scratch;
use super::cell::Cell;
use super::frame::Frame;
use super::precision::Precision;
use super::sums::Sums;
use crate::asperities::answers::Asperities;
use crate::state::Integrals;

/// Largest number of frames kept, of a few kilobytes each: all between fifty standard deviations on the far side and
/// ten below.
const MOST_FRAMES: usize = 150;

/// Frames of a population at a precision, by their cells.
pub(crate) struct Frames<'a> {
    pub asperities: &'a dyn Asperities,
    pub sigma_s_m: f64,
    pub precision: Precision,
    /// The one frame of all cells, if they can share it.
    everywhere: Option<Frame<'a>>,
    /// Cells in the order of their frames.
    cells: Vec<Cell>,
    built: Vec<Frame<'a>>,
    /// Index of the frame last used, which is usually the next one used.
    last: usize,
    /// Index of the oldest frame, which is replaced next.
    oldest: usize,
    /// Law evaluations spent on frames of cells.
    spent_on_cells: usize,
    scratch: Scratch,
}

impl<'a> Frames<'a> {
    /// Creates an empty store.
    pub fn new(asperities: &'a dyn Asperities, sigma_s_m: f64, precision: Precision) -> Self {
        Frames {
            asperities,
            sigma_s_m,
            precision,
            everywhere: Frame::for_every_cell(asperities, sigma_s_m),
            cells: Vec::new(),
            built: Vec::new(),
            last: 0,
            oldest: 0,
            spent_on_cells: 0,
            scratch: Scratch::default(),
        }
    }

    /// Frame of a cell, built if missing.
    pub fn frame(&mut self, cell: Cell) -> &mut Frame<'a> {
        if !self.are_one() && self.cells.get(self.last) != Some(&cell) {
            self.last =
                self.cells.iter().position(|&other| other == cell).unwrap_or_else(|| self.build(cell));
        }
        match &mut self.everywhere {
            Some(frame) => frame,
            None => &mut self.built[self.last],
        }
    }

    /// Frame of the cell of a separation.
    pub fn at(&mut self, u: f64) -> &mut Frame<'a> {
        if self.are_one() { self.frame(Cell::ANY) } else { self.frame(Cell::containing(u)) }
    }

    /// Law evaluations spent.
    pub fn evaluations(&self) -> usize {
        self.spent_on_cells + self.everywhere.as_ref().map_or(0, Frame::evaluations)
    }

    /// True if all cells share one frame.
    pub fn are_one(&self) -> bool {
        self.everywhere.is_some()
    }

    /// True if the frame of a cell exists.
    pub fn have(&self, cell: Cell) -> bool {
        self.are_one() || self.cells.contains(&cell)
    }

    /// True if one closed form serves all separations.
    pub fn have_closed_form(&self) -> bool {
        self.everywhere.as_ref().is_some_and(Frame::is_closed)
    }

    /// The integrals of a state at a separation.
    pub fn integrals_at(&mut self, u: f64) -> Integrals {
        self.at(u).at(u).integrals()
    }

    /// The integrals at a separation, on the frame of its cell.
    pub fn sums_at(&mut self, u: f64) -> Sums {
        self.at(u).sums_at(u)
    }

    /// The integrals at a separation from a few nodes around it.
    pub fn rough_sums_at(&mut self, u: f64) -> Sums {
        if let Some(everywhere) = &mut self.everywhere {
            return everywhere.sums_at(u);
        }
        let mut frame = Frame::rough(self.asperities, self.sigma_s_m, u, &mut self.scratch);
        self.spent_on_cells += frame.evaluations();
        frame.sums_at(u)
    }

    /// Builds a frame, and returns its index.
    fn build(&mut self, cell: Cell) -> usize {
        let frame = Frame::for_cell(self.asperities, self.sigma_s_m, cell, self.precision, &mut self.scratch);
        self.spent_on_cells += frame.evaluations();
        if self.built.len() < MOST_FRAMES {
            self.cells.push(cell);
            self.built.push(frame);
            return self.built.len() - 1;
        }
        let place = self.oldest;
        self.oldest = (place + 1) % MOST_FRAMES;
        (self.cells[place], self.built[place]) = (cell, frame);
        place
    }
}

#[cfg(test)]
mod tests {
    use asperity::{ElasticBody, MaterialPair};

    use super::*;
    use crate::Population;
    use crate::asperities::elastic_sines::ElasticSines;

    #[test]
    fn a_frame_is_built_once_until_it_is_replaced() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap());
        let asperities = ElasticSines::new(&pair, &Population::new(1e-8, 1e13, 1e-9).unwrap());
        let mut frames = Frames::new(&asperities, 1e-9, Precision::new(1e-6));
        let first = frames.sums_at(0.0).pressure_pa;
        let once = frames.evaluations();
        assert_eq!(frames.sums_at(0.0).pressure_pa, first);
        assert_eq!(frames.evaluations(), once);
        for place in 1..MOST_FRAMES {
            frames.sums_at(-0.1 * place as f64);
        }
        assert!(frames.have(Cell::containing(0.0)));
        frames.sums_at(-0.1 * MOST_FRAMES as f64);
        assert!(!frames.have(Cell::containing(0.0)));
        assert_eq!(frames.built.len(), MOST_FRAMES);
        let before = frames.evaluations();
        assert_eq!(frames.sums_at(0.0).pressure_pa, first);
        assert_eq!(frames.evaluations(), before + once);
    }
}
