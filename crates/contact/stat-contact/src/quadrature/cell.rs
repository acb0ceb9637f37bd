//! Cells of separations that share a quadrature.

use asperity::elementary;

/// Range of separations, in units of sigma_s, that one quadrature serves.
///
/// The cells are fixed. Every search that ends in a cell ends on the same quadrature, and so on the same digits,
/// whatever its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    index: f64,
}

impl Cell {
    /// Width of a cell: absolute at negative separations, relative to 1 + u at positive ones, where the density in
    /// contact is narrower by that factor.
    const WIDTH: f64 = 0.1;

    /// Arbitrary cell, for quadratures that serve every cell.
    pub const ANY: Cell = Cell { index: 0.0 };

    /// Cell of a separation.
    pub fn containing(u: f64) -> Cell {
        let position = if u > 0.0 { elementary::ln_1p(u) } else { u };
        Cell { index: (position / Self::WIDTH).round() }
    }

    /// Separation in the middle of the cell.
    pub fn centre(self) -> f64 {
        Self::separation(self.index)
    }

    /// Smallest separation in the cell.
    pub fn nearest(self) -> f64 {
        Self::separation(self.index - 0.5)
    }

    /// Largest separation in the cell.
    pub fn farthest(self) -> f64 {
        Self::separation(self.index + 0.5)
    }

    /// True if another cell is next to this one.
    pub fn is_beside(self, other: Cell) -> bool {
        (self.index - other.index).abs() == 1.0
    }

    /// True if the separations of this cell are smaller than those of another cell.
    pub fn is_nearer_than(self, other: Cell) -> bool {
        self.index < other.index
    }

    fn separation(index: f64) -> f64 {
        let position = index * Self::WIDTH;
        if position > 0.0 { elementary::exp_m1(position) } else { position }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_contains_its_separations() {
        for u in [-1e4, -60.0, -0.03, 0.0, 0.07, 1.0, 59.9, 1e5] {
            let cell = Cell::containing(u);
            assert!(cell.nearest() <= u && u <= cell.farthest(), "{u}");
            assert_eq!(Cell::containing(cell.centre()), cell);
        }
    }
}
