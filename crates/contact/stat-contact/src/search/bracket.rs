//! Bracket of separations that a search has not yet ruled out.

use crate::quadrature::Cell;

/// Side of a separation on which the solution lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// At smaller separations: pressure is missing.
    Nearer,
    /// At larger ones, or here.
    Farther,
}

impl Side {
    /// Side of the solution if this much of ln p is missing.
    pub fn of_missing(missing: f64) -> Side {
        if missing > 0.0 { Side::Nearer } else { Side::Farther }
    }
}

/// Separations between which the solution lies: ln p is above the target at `low`, below it at `high`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bracket {
    pub low: f64,
    pub high: f64,
    /// Possible displacement of the solution by the quadrature, relative to 1 + |u|.
    margin: f64,
}

impl Bracket {
    /// Bracket of all separations, for rough quadratures.
    pub const EVERYTHING: Bracket = Self::between(f64::NEG_INFINITY, f64::INFINITY);
    const ROUGH_MARGIN: f64 = 0.02;
    /// Margin on fine quadratures: small enough for bisection to end in one cell, even a million standard deviations
    /// below the mean plane.
    const FINE_MARGIN: f64 = 1e-8;
    /// Step if an end is not known, beside |u|: past every bend of ln p that a start may be stuck in.
    const STRIDE: f64 = 8.0;
    /// Largest share of the bracket that a step may cross. Where the pressure jumps, longer steps from both sides
    /// would keep landing at each other's ends.
    const LONGEST_SHARE: f64 = 0.75;

    /// Bracket between two separations, for rough quadratures.
    pub const fn between(low: f64, high: f64) -> Self {
        Bracket { low, high, margin: Self::ROUGH_MARGIN }
    }

    /// Returns this bracket for fine quadratures.
    pub fn on_fine_quadratures(self) -> Self {
        Bracket { margin: Self::FINE_MARGIN, ..self }
    }

    /// Starting point in a cell: its centre, where its quadrature is summed already, or as near to it as the bracket
    /// allows.
    pub fn inside(&self, cell: Cell) -> f64 {
        cell.centre().clamp(self.low, self.high)
    }

    /// Narrows the bracket to the side of u on which the solution lies. The margin keeps it, which is there to stop
    /// runaway steps, from cutting off the solution of the next quadrature, which differs by the error of this one.
    pub fn narrow(&mut self, u: f64, side: Side) {
        let margin = self.margin * (1.0 + u.abs());
        match side {
            Side::Nearer => self.high = self.high.min(u + margin),
            Side::Farther => self.low = self.low.max(u - margin),
        }
    }

    /// Returns `next`, the step from u, if it stays inside; [`halve`](Self::halve) if it does not, or is not a
    /// number.
    pub fn step(&self, u: f64, next: f64, side: Side) -> f64 {
        let longest = (Self::LONGEST_SHARE * (self.high - self.low)).max(2.0 * self.margin * (1.0 + u.abs()));
        let longest = longest.min(Self::stride(u));
        if self.low <= next && next <= self.high && (next - u).abs() <= longest {
            next
        } else {
            self.halve(u, side)
        }
    }

    /// Returns the middle or, if an end is not known yet, a stride from u towards the side of the solution.
    pub fn halve(&self, u: f64, side: Side) -> f64 {
        if self.low.is_finite() && self.high.is_finite() {
            return 0.5 * (self.low + self.high);
        }
        let stride = match side {
            Side::Nearer => -Self::stride(u),
            Side::Farther => Self::stride(u),
        };
        (u + stride).clamp(self.low, self.high)
    }

    fn stride(u: f64) -> f64 {
        Self::STRIDE + u.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_outside_is_replaced_by_the_middle_or_by_a_stride() {
        let mut bracket = Bracket::EVERYTHING.on_fine_quadratures();
        assert_eq!(bracket.step(1.0, 0.5, Side::Nearer), 0.5);
        assert_eq!(bracket.step(1.0, f64::NAN, Side::Nearer), -8.0);
        assert_eq!(bracket.step(1.0, 1e9, Side::Farther), 10.0);
        bracket.narrow(1.0, Side::of_missing(0.1));
        bracket.narrow(-1.0, Side::of_missing(-0.1));
        assert_eq!(bracket.step(1.0, 0.5, Side::Nearer), 0.5);
        for outside in [-3.0, 3.0, f64::NAN] {
            assert!(bracket.step(1.0, outside, Side::Nearer).abs() < 1e-7);
        }
        assert_eq!(bracket.inside(Cell::containing(7.0)), bracket.high);
    }
}
