//! Holes of a map: connected patches of missing points.

use std::ops::Range;

/// Neighbouring missing points of a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) row: usize,
    pub(crate) columns: Range<usize>,
    /// Number of its first point among all missing points of the map in ascending order of index.
    pub(crate) first: usize,
}

/// The holes of a map: missing points that are neighbours along x or y belong together.
#[derive(Debug)]
pub(crate) struct Holes {
    /// Runs of all holes, hole by hole and row by row.
    runs: Vec<Run>,
    /// End of the runs of each hole.
    ends: Vec<usize>,
}

impl Holes {
    /// Groups missing points, given by ascending index in rows of `columns` points.
    pub(crate) fn new(gaps: impl Iterator<Item = usize>, columns: usize) -> Self {
        let runs = runs(gaps, columns);
        let mut joined = DisjointSets::new(runs.len());
        let mut above = 0;
        for (at, run) in runs.iter().enumerate() {
            while runs[above].row + 1 < run.row
                || (runs[above].row + 1 == run.row && runs[above].columns.end <= run.columns.start)
            {
                above += 1;
            }
            // A run above that reaches beyond this one may also touch the next one, so `above` stays.
            let touching = (above..at).take_while(|&other| {
                runs[other].row + 1 == run.row && runs[other].columns.start < run.columns.end
            });
            touching.for_each(|other| joined.join(other, at));
        }
        let mut hole_of_root = vec![usize::MAX; runs.len()];
        let mut holes = 0;
        let mut numbered: Vec<(usize, Run)> = Vec::with_capacity(runs.len());
        for (at, run) in runs.into_iter().enumerate() {
            let hole = &mut hole_of_root[joined.root(at)];
            if *hole == usize::MAX {
                *hole = holes;
                holes += 1;
            }
            numbered.push((*hole, run));
        }
        numbered.sort_by_key(|&(hole, _)| hole); // keeps the rows of a hole in their order
        let ends = numbered.chunk_by(|a, b| a.0 == b.0).scan(0, |end, of_hole| {
            *end += of_hole.len();
            Some(*end)
        });
        Self { ends: ends.collect(), runs: numbered.into_iter().map(|(_, run)| run).collect() }
    }

    pub(crate) fn count(&self) -> usize {
        self.ends.len()
    }

    /// Returns the runs of a hole, counted from 0, row by row.
    pub(crate) fn hole(&self, hole: usize) -> &[Run] {
        let start = if hole == 0 { 0 } else { self.ends[hole - 1] };
        &self.runs[start..self.ends[hole]]
    }
}

/// Counts the points of a hole.
pub(crate) fn points(hole: &[Run]) -> usize {
    hole.iter().map(|run| run.columns.len()).sum()
}

/// Returns the ranges of rows and columns of a hole with at least one run.
pub(crate) fn extent(hole: &[Run]) -> (Range<usize>, Range<usize>) {
    let rows = hole[0].row..hole[hole.len() - 1].row + 1;
    let columns = hole.iter().fold(hole[0].columns.clone(), |all, run| {
        all.start.min(run.columns.start)..all.end.max(run.columns.end)
    });
    (rows, columns)
}

fn runs(gaps: impl Iterator<Item = usize>, columns: usize) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (number, index) in gaps.enumerate() {
        let (row, column) = (index / columns, index % columns);
        match runs.last_mut() {
            Some(run) if run.row == row && run.columns.end == column => run.columns.end += 1,
            _ => runs.push(Run { row, columns: column..column + 1, first: number }),
        }
    }
    runs
}

/// Disjoint sets; the smallest number of a set is its root.
struct DisjointSets {
    parents: Vec<usize>,
}

impl DisjointSets {
    fn new(count: usize) -> Self {
        Self { parents: (0..count).collect() }
    }

    fn root(&mut self, mut at: usize) -> usize {
        while self.parents[at] != at {
            self.parents[at] = self.parents[self.parents[at]];
            at = self.parents[at];
        }
        at
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The holes of a picture as the numbers of their points.
    fn holes(picture: &[&str]) -> Vec<Vec<usize>> {
        let columns = picture[0].len();
        let marks = picture.concat();
        let gaps = marks.bytes().enumerate().filter(|&(_, mark)| mark == b'#').map(|(index, _)| index);
        let holes = Holes::new(gaps, columns);
        let numbers =
            |hole: &[Run]| hole.iter().flat_map(|run| run.first..run.first + run.columns.len()).collect();
        (0..holes.count()).map(|hole| numbers(holes.hole(hole))).collect()
    }

    #[test]
    fn missing_points_connect_along_rows_and_columns_but_not_across_corners() {
        assert_eq!(holes(&["#.", ".#"]), [[0], [1]]);
        assert_eq!(holes(&["#.#", "###", "..."]), [[0, 1, 2, 3, 4]]);
        // A long run touches several below and above; the end of a row is not a neighbour of the next one's start.
        assert_eq!(
            holes(&["#####", "#.#.#", ".#...", "##..#"]),
            [vec![0, 1, 2, 3, 4, 5, 6, 7], vec![8, 9, 10], vec![11]]
        );
        assert_eq!(holes(&["..##", "##.."]), [[0, 1], [2, 3]]);
        assert!(holes(&["..", ".."]).is_empty());
    }

    #[test]
    fn a_spiral_is_one_hole() {
        let spiral = ["#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"];
        let found = holes(&spiral);
        assert_eq!(found.len(), 1);
        let gaps = (0..49).filter(|index| spiral[index / 7].as_bytes()[index % 7] == b'#');
        let of_map = Holes::new(gaps, 7);
        assert_eq!(extent(of_map.hole(0)), (0..7, 0..7));
        assert_eq!(points(of_map.hole(0)), found[0].len());
    }
}
