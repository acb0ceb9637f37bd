//! The nodes of a quadrature: a row for each of their quantities, so that the compiler works on several nodes at once.

use std::ops::Range;

/// Nodes that are added up side by side; rows hold a multiple of them, and zeros beyond the last node.
pub(crate) const LANES: usize = 2;

/// The rows of all nodes, in one stretch of memory.
pub(crate) struct Nodes {
    values: Vec<f64>,
    /// Length of a row, of which `len` are in use.
    stride: usize,
    len: usize,
}

/// Some nodes, an entry in each row for each of them. Lengths are in units of sigma_s.
pub(crate) struct Rows<'a> {
    /// The height u + s at the separation u of the frame where that is not positive, else the interference s.
    pub places: &'a mut [f64],
    /// Weight times what the law answers.
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
    /// The density at the separation last summed at.
    pub densities: &'a mut [f64],
    /// Weight of the rule, and derivative of the interference by the coordinate: of use while nodes are added.
    pub weights: &'a mut [f64],
    pub slopes: &'a mut [f64],
}

impl Nodes {
    const ROWS: usize = 6;

    /// No nodes yet, and room for some.
    pub fn with_room_for(count: usize) -> Self {
        let stride = count.next_multiple_of(LANES);
        Nodes { values: vec![0.0; Self::ROWS * stride], stride, len: 0 }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Some more nodes, all zero.
    pub fn add(&mut self, count: usize) -> Rows<'_> {
        let first = self.len;
        if first + count > self.stride {
            self.widen((first + count).next_multiple_of(LANES).max(2 * self.stride));
        }
        self.len += count;
        self.rows(first..self.len)
    }

    fn widen(&mut self, stride: usize) {
        let mut values = vec![0.0; Self::ROWS * stride];
        for (wide, narrow) in values.chunks_exact_mut(stride).zip(self.values.chunks_exact(self.stride)) {
            wide[..self.len].copy_from_slice(&narrow[..self.len]);
        }
        (self.values, self.stride) = (values, stride);
    }

    /// Keeps these ranges, which must not overlap, in their order.
    pub fn keep(&mut self, ranges: impl Iterator<Item = Range<usize>>) {
        let mut kept = Nodes::with_room_for(self.stride);
        for range in ranges {
            let to = kept.len..kept.len + range.len();
            for row in 0..Self::ROWS {
                let from = self.row(row, range.clone());
                kept.values[row * kept.stride + to.start..][..to.len()].copy_from_slice(from);
            }
            kept.len = to.end;
        }
        *self = kept;
    }

    /// Those of a range.
    pub fn rows(&mut self, range: Range<usize>) -> Rows<'_> {
        let mut rows = self.values.chunks_exact_mut(self.stride).map(|row| &mut row[range.clone()]);
        let mut next = || rows.next().expect("as many rows as there are quantities");
        Rows {
            places: next(),
            pressures_pa: next(),
            area_fractions: next(),
            densities: next(),
            weights: next(),
            slopes: next(),
        }
    }

    /// Places, pressures, areas and densities of a range.
    pub fn summed(&self, range: Range<usize>) -> [&[f64]; 4] {
        [0, 1, 2, 3].map(|row| self.row(row, range.clone()))
    }

    /// The same of all nodes, with as many zeros as make up whole lanes.
    pub fn in_lanes(&self) -> [&[[f64; LANES]]; 4] {
        self.summed(0..self.len.next_multiple_of(LANES)).map(|row| row.as_chunks().0)
    }

    fn row(&self, row: usize, range: Range<usize>) -> &[f64] {
        &self.values[row * self.stride..][range]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_stay_what_they_are_as_more_are_added_and_some_are_dropped() {
        let mut nodes = Nodes::with_room_for(3);
        for panel in 0..4 {
            let rows = nodes.add(3);
            rows.places.fill(f64::from(panel));
            rows.densities.fill(-f64::from(panel));
        }
        nodes.keep([3..6, 9..12].into_iter());
        let [places, pressures, _, densities] = nodes.summed(0..nodes.len());
        assert_eq!(places, [1.0, 1.0, 1.0, 3.0, 3.0, 3.0]);
        assert_eq!(densities, [-1.0, -1.0, -1.0, -3.0, -3.0, -3.0]);
        assert_eq!(pressures, [0.0; 6]);
        nodes.add(1).places.fill(7.0);
        assert_eq!(nodes.in_lanes()[0][3], [7.0, 0.0]);
    }
}
