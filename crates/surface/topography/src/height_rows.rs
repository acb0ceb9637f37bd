//! Lines of equal length: those that follow each other in memory, or the columns of a map.

use scans::HeightMap;

/// Lines of equal length, wherever their heights lie.
pub(crate) trait HeightRows {
    /// Number of points of a line.
    fn points(&self) -> usize;
    /// Number of lines.
    fn count(&self) -> usize;
    /// Height of a point of a line \[m\].
    fn height_m(&self, row: usize, point: usize) -> f64;
    /// Hands over all lines with their numbers, in their order.
    fn for_each_row(&self, each: impl FnMut(usize, &[f64]));
}

/// Lines one after the other in memory.
#[derive(Clone, Copy)]
pub(crate) struct Slices<'a> {
    pub(crate) heights_m: &'a [f64],
    pub(crate) points: usize,
}

impl<'a> Slices<'a> {
    /// Takes heights as one line.
    pub(crate) fn one(heights_m: &'a [f64]) -> Self {
        Slices { heights_m, points: heights_m.len() }
    }
}

impl HeightRows for Slices<'_> {
    fn points(&self) -> usize {
        self.points
    }

    fn count(&self) -> usize {
        self.heights_m.len() / self.points
    }

    fn height_m(&self, row: usize, point: usize) -> f64 {
        self.heights_m[row * self.points + point]
    }

    fn for_each_row(&self, mut each: impl FnMut(usize, &[f64])) {
        let rows = self.heights_m.chunks_exact(self.points);
        rows.enumerate().for_each(|(row, heights_m)| each(row, heights_m));
    }
}

/// The columns of a map as lines, a few of them copied at a time.
pub(crate) struct Columns<'a>(pub(crate) &'a HeightMap);

impl Columns<'_> {
    /// Columns copied together: a cache line of every row.
    const BLOCK: usize = 8;
}

impl HeightRows for Columns<'_> {
    fn points(&self) -> usize {
        self.0.rows()
    }

    fn count(&self) -> usize {
        self.0.columns()
    }

    fn height_m(&self, row: usize, point: usize) -> f64 {
        self.0.heights_m()[point * self.0.columns() + row]
    }

    fn for_each_row(&self, mut each: impl FnMut(usize, &[f64])) {
        let (points, columns) = (self.points(), self.count());
        let mut block_m = vec![0.0; points * Self::BLOCK.min(columns)];
        for first in (0..columns).step_by(Self::BLOCK) {
            let block = first..columns.min(first + Self::BLOCK);
            for (point, row_m) in self.0.heights_m().chunks_exact(columns).enumerate() {
                for (at, height_m) in row_m[block.clone()].iter().enumerate() {
                    block_m[at * points + point] = *height_m;
                }
            }
            for (row, line_m) in block.zip(block_m.chunks_exact(points)) {
                each(row, line_m);
            }
        }
    }
}
