//! Load to be found, and the pressure as a function of separation.

use numerics::zero_in_bracket;

use crate::asperities::answers::Course;
use crate::far::FAR;
use crate::gaussian::density::{log_reference_density, reference_density};
use crate::quadrature::Cell;
use crate::quadrature::Sums;
use crate::quadrature::frames::Frames;

/// Standard deviations beyond which a feature of the law is invisible.
pub(crate) const OUT_OF_SIGHT: f64 = 9.0;

/// Search for a pressure that is carried no farther below the mean plane than [`FAR`].
pub(crate) struct Search<'s, 'a> {
    pub frames: &'s mut Frames<'a>,
    pub pressure_pa: f64,
}

/// Separation, with the cell on whose frame it carries the pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CellSolution {
    pub cell: Cell,
    pub u: f64,
}

/// Solution with the relative residual of its pressure; 0 if within rounding. The residual is at most the error of
/// the quadratures if the pressures of two cells leave the load between them, at their common edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer {
    pub found: CellSolution,
    pub missed_by: f64,
}

impl From<CellSolution> for Answer {
    /// Result of a search that has converged.
    fn from(found: CellSolution) -> Self {
        Answer { found, missed_by: 0.0 }
    }
}

/// State from which a search starts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Neighbour {
    pub u: f64,
    /// Integrals there, if known.
    pub sums: Option<Sums>,
}

/// Pressure at a separation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pressure {
    pub pa: f64,
    /// Derivative of ln p by u.
    pub log_slope: f64,
}

impl Search<'_, '_> {
    /// Shape of the force over the interference.
    pub fn course(&self) -> Course {
        self.frames.asperities.course(self.frames.sigma_s_m)
    }

    /// Shortfall of ln p below the target at u. The quotient of the pressures keeps the digits that their logarithms
    /// would round off; near complete contact only these distinguish one separation from another.
    pub fn missing(&self, u: f64, sums: &Sums) -> f64 {
        let quotient = self.pressure_pa / sums.pressure_pa;
        let log_quotient =
            if quotient.is_normal() { quotient.ln() } else { self.pressure_pa.ln() - sums.pressure_pa.ln() };
        log_quotient - log_reference_density(u)
    }

    /// Shortfall of ln p at a separation, on the quadrature of its cell.
    pub fn missing_at(&mut self, u: f64) -> f64 {
        let sums = self.frames.sums_at(u);
        self.missing(u, &sums)
    }

    /// Pressure at a separation, on the quadrature of its cell.
    pub fn pressure_at(&mut self, u: f64) -> Pressure {
        let sums = self.frames.sums_at(u);
        Pressure { pa: sums.pressure_pa * reference_density(u), log_slope: sums.log_pressure_slope() }
    }

    /// Highest pressure \[Pa\] that a separation carries, or its limit.
    pub fn highest_pressure_pa(&mut self) -> f64 {
        match self.peak() {
            Some(peak) => self.pressure_at(peak).pa,
            None => self.frames.asperities.highest_response_pa(),
        }
    }

    /// Separation at which the pressure of a force with a maximum peaks.
    pub fn peak(&mut self) -> Option<f64> {
        let edge = self.far_edge()?;
        let at_edge = self.pressure_at(edge);
        if at_edge.log_slope <= 0.0 {
            return Some(edge);
        }
        let level = zero_in_bracket(edge, 0.0, |u| self.pressure_at(u).log_slope);
        // If the pressure hardly changes over thousands of standard deviations, slopes drown in the rounding of u,
        // and one of them may be zero anywhere.
        Some(if self.pressure_at(level).pa >= at_edge.pa { level } else { edge })
    }

    /// Separation beyond which the pressure of a force with a maximum only falls as the surfaces approach, or the end
    /// of the search.
    pub fn far_edge(&self) -> Option<f64> {
        let falls_from = self.frames.asperities.falls_from_m()? / self.frames.sigma_s_m;
        Some((-OUT_OF_SIGHT - falls_from).max(-FAR))
    }
}
