//! Nodes of a quadrature: a row for each quantity, so that several nodes are processed at once.

/// Number of nodes that are added up side by side.
pub(crate) const LANES: usize = 4;

/// Values of nodes side by side.
pub(crate) type Lanes = [f64; LANES];

/// Number of nodes that rows are filled up to a multiple of, so that no node is left over for a loop over single ones.
const FILLED_TO: usize = 8;

/// Rows of all panels, one panel after the other.
pub(crate) struct Nodes {
    values: Vec<f64>,
}

/// Position of the nodes of a panel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    at: usize,
    row: usize,
}

/// Nodes of a panel, an entry in each row for each of them, filled up with nodes of no weight. Lengths are in units of
/// sigma_s.
pub(crate) struct Rows<'a> {
    /// Height u + s at the separation u of the frame if that is not positive, else the interference s.
    pub places: &'a mut [f64],
    /// Weight times the pressure of the law.
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
    /// Density at the separation of the last sums.
    pub densities: &'a mut [f64],
}

/// Summands over the nodes of a panel, in lanes.
pub(crate) struct Summands<'a> {
    pub places: &'a [Lanes],
    pub pressures_pa: &'a [Lanes],
    pub area_fractions: &'a [Lanes],
    pub densities: &'a [Lanes],
}

impl Nodes {
    const ROWS: usize = 4;

    /// Creates an empty set of nodes with a capacity.
    pub fn with_room_for(count: usize) -> Self {
        Nodes { values: Vec::with_capacity(Self::ROWS * count) }
    }

    /// Length of the rows of a panel.
    pub fn row(count: usize) -> usize {
        count.next_multiple_of(FILLED_TO)
    }

    /// Adds the nodes of one more panel, all zero.
    pub fn add(&mut self, count: usize) -> Block {
        let (at, row) = (self.values.len(), Self::row(count));
        self.values.resize(at + Self::ROWS * row, 0.0);
        Block { at, row }
    }

    /// Rows of a panel.
    pub fn rows(&mut self, block: Block) -> Rows<'_> {
        let Block { at, row } = block;
        let [places, pressures_pa, area_fractions, densities] =
            split(&mut self.values[at..at + Self::ROWS * row], row);
        Rows { places, pressures_pa, area_fractions, densities }
    }

    /// Rows of a panel as summands.
    pub fn summed(&self, block: Block) -> Summands<'_> {
        let (places, rest) = self.values[block.at..].split_at(block.row);
        let (pressures_pa, rest) = rest.split_at(block.row);
        let (area_fractions, rest) = rest.split_at(block.row);
        Summands {
            places: places.as_chunks().0,
            pressures_pa: pressures_pa.as_chunks().0,
            area_fractions: area_fractions.as_chunks().0,
            densities: rest[..block.row].as_chunks().0,
        }
    }
}

/// Splits a slice into `ROWS` rows of a length.
pub(crate) fn split<const ROWS: usize>(rows: &mut [f64], length: usize) -> [&mut [f64]; ROWS] {
    let mut rest = rows;
    std::array::from_fn(|_| {
        let (row, others) = std::mem::take(&mut rest).split_at_mut(length);
        rest = others;
        row
    })
}

/// The sum of the lanes.
pub(crate) fn total([a, b, c, d]: Lanes) -> f64 {
    (a + b) + (c + d)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_keep_their_nodes() {
        let mut nodes = Nodes::with_room_for(2);
        let blocks = [7, 8].map(|count| nodes.add(count));
        for (block, value) in blocks.into_iter().zip([1.0, 2.0]) {
            let rows = nodes.rows(block);
            assert_eq!(rows.area_fractions.len(), 8);
            rows.places.fill(value);
            rows.densities.fill(-value);
        }
        let first = nodes.summed(blocks[0]);
        assert_eq!(first.places, [[1.0; 4]; 2]);
        assert_eq!(first.densities, [[-1.0; 4]; 2]);
        assert_eq!(first.pressures_pa, [[0.0; 4]; 2]);
        assert_eq!(nodes.summed(blocks[1]).places, [[2.0; 4]; 2]);
        assert_eq!(total([1.0, 2.0, 3.0, 4.0]), 10.0);
    }
}
