//! Searches that step towards the solution from a start: first on rough quadratures, then on those of the cells.

use super::bracket::Bracket;
use super::problem::{CellSolution, Search};
use crate::quadrature::Cell;

/// Steps after which a search ends in any case; each halves a bracket or better.
const MOST_STEPS: usize = 60;
/// Steps on rough quadratures, before fine ones are built.
const MOST_ROUGH_STEPS: usize = 12;

/// End of a search.
struct SearchEnd {
    found: CellSolution,
    /// True if it came from another cell.
    moved: bool,
}

/// Returns true if a step on a rough quadrature has led near the solution: steps converge with the fourth power, on
/// the scale of 1 + |u|, and the width of cells grows with a positive separation.
pub(crate) fn is_near(u: f64, next: f64) -> bool {
    // A twentieth of the width of a cell.
    const NEAR: f64 = 0.005;
    let step = (next - u).abs();
    let left = step * (step / (1.0 + next.abs())).powi(3);
    left < NEAR * (1.0 + next.max(0.0))
}

impl Search<'_, '_> {
    /// Gets within a few percent of a standard deviation, on quadratures of a few nodes.
    pub fn approach(&mut self, start: f64, mut bracket: Bracket) -> f64 {
        let mut u = start;
        for _ in 0..MOST_ROUGH_STEPS {
            let sums = self.frames.rough_sums_at(u);
            let Some(next) = self.next(u, &sums, &mut bracket) else { break };
            let before = u;
            u = next;
            if is_near(before, next) {
                break;
            }
        }
        u
    }

    /// Solves on the quadrature of the cell in which the solution lies; `None` above the highest pressure.
    ///
    /// From any start it ends on the same quadrature with the same digits: it solves from the centre of the last cell
    /// even if it came from another one, and of two cells that both place the solution in themselves it takes the
    /// nearer.
    pub fn settle(&mut self, near: f64, bracket: Bracket) -> Option<CellSolution> {
        let whole = bracket.on_fine_quadratures();
        let SearchEnd { found, moved } = self.move_to_cell(near, whole)?;
        let found = if moved { self.solve_again(found.cell, whole).unwrap_or(found) } else { found };
        let Some(leeway) = self.leeway(found) else { return Some(found) };
        let edge = found.cell.nearest();
        if found.u - edge > leeway {
            return Some(found);
        }
        let nearer = self.solve_again(Cell::containing(edge - leeway), whole);
        let nearer = nearer.filter(|at| found.u < edge || Cell::containing(at.u) == at.cell);
        Some(nearer.unwrap_or(found))
    }

    /// Moves from cell to cell until one places the solution in itself.
    fn move_to_cell(&mut self, near: f64, mut bracket: Bracket) -> Option<SearchEnd> {
        let (mut u, mut cell) = (bracket.inside(Cell::containing(near)), Cell::containing(near));
        let (mut from, mut steps) = (None, 0);
        loop {
            u = self.solve_on(cell, u, &mut bracket)?;
            let next = Cell::containing(u);
            // Two neighbouring cells may each place the solution just beyond their common edge; the nearer one has it.
            let undecided = from == Some(next) && next.is_beside(cell);
            if next == cell || (undecided && cell.is_nearer_than(next)) || steps == MOST_STEPS {
                return Some(SearchEnd { found: CellSolution { cell, u }, moved: steps > 0 });
            }
            from = Some(cell);
            cell = next;
            steps += 1;
        }
    }

    /// Solves again from the centre of the cell. The solution differs by rounding, or by what the bracket has cut off
    /// where two cells disagree. `None` if that leads away.
    fn solve_again(&mut self, cell: Cell, mut bracket: Bracket) -> Option<CellSolution> {
        let u = self.solve_on(cell, bracket.inside(cell), &mut bracket)?;
        (Cell::containing(u) == cell || Cell::containing(u).is_beside(cell))
            .then_some(CellSolution { cell, u })
    }

    /// Solves on the quadrature of a cell, or returns a separation that needs another one; `None` above the highest
    /// pressure.
    pub fn solve_on(&mut self, cell: Cell, start: f64, bracket: &mut Bracket) -> Option<f64> {
        // The error of a step is the fourth power of the one before: the next one would not show.
        const LAST_STEP: f64 = 1e-4;
        let mut u = start;
        for _ in 0..MOST_STEPS {
            let frame = self.frames.frame(cell);
            let sums = if u == frame.centre { frame.sums_at_centre() } else { frame.sums_at(u) };
            let next = self.next(u, &sums, bracket)?;
            let step = next - u;
            u = next;
            if step.abs() < LAST_STEP * (1.0 + u.max(0.0)) || !self.frames.frame(cell).serves(u) {
                break;
            }
        }
        Some(u)
    }

    /// Returns true if a search has converged. Near a maximum, and between several, its parabolas may not lead to the
    /// load.
    pub fn is_carried_by(&mut self, found: CellSolution) -> bool {
        self.missed_by(found) == 0.0
    }

    /// Relative residual of the pressure ([`Answer`](super::problem::Answer)).
    pub fn missed_by(&mut self, CellSolution { cell, u }: CellSolution) -> f64 {
        const CLOSE: f64 = 1e-11;
        let sums = self.frames.frame(cell).sums_at(u);
        let missing = self.missing(u, &sums).abs();
        let rounding = CLOSE + 8.0 * f64::EPSILON * self.pressure_pa.ln().abs();
        if missing <= rounding { 0.0 } else { missing }
    }

    /// Possible displacement of the solution by the quadratures; `None` if it is not a small part of a cell.
    pub fn leeway(&mut self, CellSolution { cell, u }: CellSolution) -> Option<f64> {
        // Few quadratures err by more than four times their tolerance.
        const CAUTION: f64 = 4.0;
        // Share of a cell from which on the quadratures do not determine the cell of the solution.
        const SMALL: f64 = 0.25;
        let slope = self.frames.frame(cell).sums_at(u).log_pressure_slope();
        let leeway = -CAUTION * self.frames.precision.around(cell.centre()).tolerance / slope;
        (0.0 < leeway && leeway < SMALL * (cell.farthest() - cell.nearest())).then_some(leeway)
    }
}
