//! Start of a search, and choice among several separations that carry the load.

use super::bracket::Bracket;
use super::converge::is_near;
use super::problem::{Answer, CellSolution, Neighbour, Search};
use crate::asperities::answers::Course;
use crate::far::FAR;
use crate::quadrature::Cell;

/// Start of a search without a neighbour: light loads are the common ones.
const USUAL_SEPARATION: f64 = 2.0;

impl Search<'_, '_> {
    /// Returns the largest separation that carries the pressure; `None` if none does. A neighbour saves work and
    /// changes no digit: a result found from it is used only if the solution is unique and lies in its cell beyond
    /// doubt.
    pub fn largest(&mut self, neighbour: Option<Neighbour>) -> Option<Answer> {
        if self.frames.are_one() {
            // A fixed start, a few steps off, makes the digits reproducible.
            let mut bracket = Bracket::EVERYTHING.on_fine_quadratures();
            let u = self.solve_on(Cell::ANY, USUAL_SEPARATION, &mut bracket)?;
            return Some(CellSolution { cell: Cell::ANY, u }.into());
        }
        let near = neighbour.and_then(|neighbour| self.solution_near(neighbour)).map(Answer::from);
        let answer = near.or_else(|| self.solution_anywhere())?;
        // Above the mean plane the solution is unique.
        if answer.found.u >= 0.0 {
            return Some(answer);
        }
        Some(self.before_dip(answer.found.u).map_or(answer, |found| self.answer(found)))
    }

    /// Solution with its residual.
    fn answer(&mut self, found: CellSolution) -> Answer {
        Answer { found, missed_by: self.missed_by(found) }
    }

    /// Solution near that of another pressure; `None` if it may differ from the one found without a neighbour.
    fn solution_near(&mut self, neighbour: Neighbour) -> Option<CellSolution> {
        if !matches!(self.course(), Course::Rises | Course::Peaks { certain: true }) {
            return None;
        }
        let near = self.near(neighbour);
        let found = self.settle(near, Bracket::EVERYTHING)?;
        (self.is_carried_by(found) && self.leeway(found).is_some()).then_some(found)
    }

    /// Start on fine quadratures.
    fn near(&mut self, neighbour: Neighbour) -> f64 {
        let next =
            neighbour.sums.and_then(|sums| self.next(neighbour.u, &sums, &mut { Bracket::EVERYTHING }));
        let Some(next) = next else { return self.approach(neighbour.u, Bracket::EVERYTHING) };
        // An existing frame costs less than a rough one.
        let is_near = is_near(neighbour.u, next) || self.frames.have(Cell::containing(next));
        if is_near { next } else { self.approach(next, Bracket::EVERYTHING) }
    }

    /// Solution from the usual start or, if steps from there do not converge, from crossings of the load.
    fn solution_anywhere(&mut self) -> Option<Answer> {
        let bracket = match self.course() {
            Course::StepsDown { at_m } if at_m < FAR * self.frames.sigma_s_m => {
                self.bracket_across(at_m / self.frames.sigma_s_m)
            }
            _ => Bracket::EVERYTHING,
        };
        let near = self.approach(USUAL_SEPARATION.clamp(bracket.low, bracket.high), bracket);
        if let Some(found) = self.settle(near, bracket) {
            if self.is_carried_by(found) {
                return Some(found.into());
            }
            if let Some(crossing) = self.crossing_around(found.u) {
                return Some(self.answer(crossing));
            }
        }
        self.solution_beside_most_loaded().map(|found| self.answer(found))
    }

    /// Solution nearest to the separation that carries most: the peak of the pressure, or the depth at which searches
    /// end.
    fn solution_beside_most_loaded(&mut self) -> Option<CellSolution> {
        let peak = self.peak();
        let most_loaded = peak.unwrap_or(-FAR);
        if self.missing_at(most_loaded) <= 0.0 {
            return Some(self.crossing_beyond(most_loaded));
        }
        // Loads carried beyond that depth are not searched for here: a load that is missing all the way is missing by
        // the error of the quadrature.
        let falls_before_end =
            self.frames.asperities.falls_from_m().is_some_and(|at_m| at_m <= FAR * self.frames.sigma_s_m);
        (!falls_before_end).then_some(CellSolution { cell: Cell::containing(-FAR), u: -FAR })
    }
}
