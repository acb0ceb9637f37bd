//! Where to look for a load, and which of several separations that carry it is the answer.

use super::bracket::Bracket;
use super::converge::is_near;
use super::problem::{Answer, Found, Neighbour, Search};
use crate::asperities::answers::Course;
use crate::far::FAR;
use crate::quadrature::cell::Cell;

/// Where a search begins that has no start: light loads are the common ones.
const USUAL_SEPARATION: f64 = 2.0;

impl Search<'_, '_> {
    /// The largest separation that carries the pressure, `None` where none does. A neighbour saves work, and changes no digit:
    /// what is found from it counts where the solution is the only one and lies in its cell beyond doubt.
    pub fn largest(&mut self, neighbour: Option<Neighbour>) -> Option<Answer> {
        if self.frames.are_one() {
            // Always from the same start, a few steps off: so the digits are always the same.
            let mut bracket = Bracket::EVERYTHING.on_fine_quadratures();
            let u = self.solve_on(Cell::ANY, USUAL_SEPARATION, &mut bracket)?;
            return Some(Found { cell: Cell::ANY, u }.into());
        }
        let near = neighbour.and_then(|neighbour| self.solution_near(neighbour)).map(Answer::from);
        let answer = near.or_else(|| self.solution_anywhere())?;
        // Above the mean plane there is no other.
        if answer.found.u >= 0.0 {
            return Some(answer);
        }
        Some(self.before_dip(answer.found.u).map_or(answer, |found| self.answer(found)))
    }

    /// A crossing with what it is off by.
    fn answer(&mut self, found: Found) -> Answer {
        Answer { found, missed_by: self.missed_by(found) }
    }

    /// The solution near that of another pressure; `None` where it may not be the one that is found without a neighbour.
    fn solution_near(&mut self, neighbour: Neighbour) -> Option<Found> {
        if !matches!(self.course(), Course::Rises | Course::Peaks { certain: true }) {
            return None;
        }
        let near = self.near(neighbour);
        let found = self.settle(near, Bracket::EVERYTHING)?;
        (self.is_carried_by(found) && self.leeway(found).is_some()).then_some(found)
    }

    /// Where to look for the solution on fine quadratures.
    fn near(&mut self, neighbour: Neighbour) -> f64 {
        let next =
            neighbour.sums.and_then(|sums| self.next(neighbour.u, &sums, &mut { Bracket::EVERYTHING }));
        let Some(next) = next else { return self.approach(neighbour.u, Bracket::EVERYTHING) };
        // A frame that is there costs less than a rough one.
        let is_near = is_near(neighbour.u, next) || self.frames.have(Cell::of(next));
        if is_near { next } else { self.approach(next, Bracket::EVERYTHING) }
    }

    /// The solution from the usual start, or, where steps from there do not converge, from crossings of the load.
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

    /// The solution nearest to the separation that carries most: the peak of the pressure, or the depth at which searches
    /// end.
    fn solution_beside_most_loaded(&mut self) -> Option<Found> {
        let peak = self.peak();
        let most_loaded = peak.unwrap_or(-FAR);
        if self.missing_at(most_loaded) <= 0.0 {
            return Some(self.crossing_beyond(most_loaded));
        }
        // What is carried beyond that depth is not looked for here: a load that is missing all the way is missing by the
        // error of the quadrature.
        let falls_before_end =
            self.frames.asperities.falls_from_m().is_some_and(|at_m| at_m <= FAR * self.frames.sigma_s_m);
        (!falls_before_end).then_some(Found { cell: Cell::of(-FAR), u: -FAR })
    }
}
