//! Harmonic filling of the holes of a map.

use scans::MeasuredScan;

use crate::holes::{Holes, Run, extent, points};
use crate::multigrid::{Cells, Multigrid, NONE, Ties};

/// Correction, over the range of the heights around the hole, at which the iteration ends: a tenth of the promised
/// error.
const TOLERANCE: f64 = 1e-11;
/// First correction that counts as rounding; the plane through the points around the hole is then kept.
const ROUNDING: f64 = 1e-14;
/// Largest number of iterations; a few dozen suffice for the largest holes.
const MOST_ITERATIONS: usize = 1000;
/// Points per batch, enough to outweigh handing it to a thread.
const BATCH: usize = 1 << 14;
/// Largest aspect ratio of pixels that counts, so that their weights stay finite.
const LARGEST_RATIO: f64 = 1e6;

/// Computes heights \[m\] for the missing points of a map in ascending order of index; the map has at least one height.
///
/// Solves Laplace's equation in each hole by the five-point formula with the spacings of the map. Heights around the
/// hole are boundary values; at the edge of the map the surface runs flat. No height then lies beyond those around its
/// hole, and a plane is continued exactly.
pub(crate) fn harmonic_m(map: &MeasuredScan, holes: &Holes) -> Vec<f64> {
    let grid = MapGrid::new(map);
    let batches = batches(holes);
    let filled: Vec<Vec<f64>> = numerics::parallel::map(&batches, |batch| {
        batch.clone().flat_map(|hole| Hole { runs: holes.hole(hole), grid: &grid }.filled_m()).collect()
    });
    let mut heights_m = vec![0.0; map.missing_points().count()];
    for (batch, filled_m) in batches.into_iter().zip(filled) {
        let mut filled_m = filled_m.into_iter();
        for run in batch.flat_map(|hole| holes.hole(hole)) {
            let of_run = &mut heights_m[run.first..][..run.columns.len()];
            of_run.iter_mut().zip(&mut filled_m).for_each(|(to_m, height_m)| *to_m = height_m);
        }
    }
    heights_m
}

fn batches(holes: &Holes) -> Vec<std::ops::Range<usize>> {
    let (mut batches, mut first, mut gathered) = (Vec::new(), 0, 0);
    for hole in 0..holes.count() {
        gathered += points(holes.hole(hole));
        if gathered >= BATCH || hole + 1 == holes.count() {
            batches.push(first..hole + 1);
            (first, gathered) = (hole + 1, 0);
        }
    }
    batches
}

/// The grid of a map with the weights of its neighbours.
struct MapGrid<'a> {
    map: &'a MeasuredScan,
    columns: usize,
    rows: usize,
    weight_x: f64,
    weight_y: f64,
}

impl<'a> MapGrid<'a> {
    fn new(map: &'a MeasuredScan) -> Self {
        let (columns, rows) = map.points();
        let (x_m, y_m) = map.spacing_m();
        let ratio = (y_m.unwrap_or(x_m) / x_m).clamp(LARGEST_RATIO.recip(), LARGEST_RATIO);
        let (weight_x, weight_y) =
            if ratio >= 1.0 { (1.0, (ratio * ratio).recip()) } else { (ratio * ratio, 1.0) };
        Self { map, columns, rows: rows.unwrap_or(1), weight_x, weight_y }
    }

    /// Height \[m\] at a place on the map; `None` at a missing point.
    fn height_m(&self, row: usize, column: usize) -> Option<f64> {
        self.map.height_m(row * self.columns + column)
    }
}

/// A point beside a missing point.
struct Neighbour {
    row: usize,
    column: usize,
    is_along_x: bool,
    /// Offset from the missing point in rows and columns.
    step: [f64; 2],
}

struct Hole<'a> {
    runs: &'a [Run],
    grid: &'a MapGrid<'a>,
}

/// The plane through the points around a hole, relative to its pivot, with slopes per row and column.
struct Plane {
    pivot_m: f64,
    lowest_m: f64,
    highest_m: f64,
    centre: [f64; 2],
    level_m: f64,
    slopes_m: [f64; 2],
}

impl Hole<'_> {
    fn filled_m(&self) -> Vec<f64> {
        let plane = Plane::fit(self);
        let range_m = plane.highest_m - plane.lowest_m;
        let corrections =
            if range_m > 0.0 { self.corrections(&plane, range_m) } else { vec![0.0; self.points()] };
        let height_m = |((row, column), correction): ((usize, usize), f64)| {
            let height_m = plane.pivot_m + (plane.at_m(row, column) + range_m * correction);
            height_m.clamp(plane.lowest_m, plane.highest_m)
        };
        self.places().zip(corrections).map(height_m).collect()
    }

    fn points(&self) -> usize {
        points(self.runs)
    }

    fn places(&self) -> impl Iterator<Item = (usize, usize)> {
        self.runs.iter().flat_map(|run| run.columns.clone().map(|column| (run.row, column)))
    }

    /// Yields the points of the map beside a point: left, right, above, below.
    fn neighbours(&self, row: usize, column: usize) -> impl Iterator<Item = Neighbour> {
        let left = column.checked_sub(1).map(|column| (row, column, true, [0.0, -1.0]));
        let right = Some((row, column + 1, true, [0.0, 1.0])).filter(|_| column + 1 < self.grid.columns);
        let above = row.checked_sub(1).map(|row| (row, column, false, [-1.0, 0.0]));
        let below = Some((row + 1, column, false, [1.0, 0.0])).filter(|_| row + 1 < self.grid.rows);
        let neighbour = |(row, column, is_along_x, step)| Neighbour { row, column, is_along_x, step };
        [left, right, above, below].into_iter().flatten().map(neighbour)
    }

    /// Yields the points around the hole with their heights \[m\], once for each missing point beside them.
    fn boundary(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let beside = |(row, column)| self.neighbours(row, column);
        self.places()
            .flat_map(beside)
            .filter_map(|Neighbour { row, column, .. }| Some((row, column, self.grid.height_m(row, column)?)))
    }

    fn weight(&self, is_along_x: bool) -> f64 {
        if is_along_x { self.grid.weight_x } else { self.grid.weight_y }
    }

    /// Computes the harmonic surface minus the plane, over the range of the heights around the hole.
    fn corrections(&self, plane: &Plane, range_m: f64) -> Vec<f64> {
        let mut rest: Vec<f64> = self.loads_m(plane).map(|load_m| load_m / range_m).collect();
        let mut multigrid = self.multigrid();
        let diagonals = self.diagonals();
        let mut found = vec![0.0; rest.len()];
        let mut direction = vec![0.0; rest.len()];
        let mut product = vec![0.0; rest.len()];
        let mut before = 0.0;
        for iteration in 0..MOST_ITERATIONS {
            let guess = multigrid.solve(rest.iter().map(|&rest| rest as f32));
            let largest = guess.iter().fold(0.0f32, |largest, guess| largest.max(guess.abs()));
            if f64::from(largest) <= if iteration == 0 { ROUNDING } else { TOLERANCE } {
                break;
            }
            let now: f64 = rest.iter().zip(guess).map(|(rest, &guess)| rest * f64::from(guess)).sum();
            let kept = if iteration == 0 { 0.0 } else { now / before };
            for (direction, &guess) in direction.iter_mut().zip(guess) {
                *direction = f64::from(guess) + kept * *direction;
            }
            self.multiply(&diagonals, multigrid.lower(), &direction, &mut product);
            let bend: f64 =
                direction.iter().zip(&product).map(|(direction, product)| direction * product).sum();
            let length = now / bend;
            if !(length.is_finite() && length > 0.0) {
                break; // only rounding is left
            }
            found.iter_mut().zip(&direction).for_each(|(found, direction)| *found += length * direction);
            rest.iter_mut().zip(&product).for_each(|(rest, product)| *rest -= length * product);
            before = now;
        }
        found
    }

    /// Residual of Laplace's equation for the plane at each missing point, times its weights \[m\].
    fn loads_m<'a>(&'a self, plane: &'a Plane) -> impl Iterator<Item = f64> + 'a {
        self.places().map(move |(row, column)| {
            let here_m = plane.at_m(row, column);
            let rise_m = |neighbour: Neighbour| {
                let rise_m = match self.grid.height_m(neighbour.row, neighbour.column) {
                    Some(height_m) => (height_m - plane.pivot_m) - here_m,
                    // Between missing points the plane rises by its slope, so that both sides cancel exactly.
                    None => neighbour.step[0] * plane.slopes_m[0] + neighbour.step[1] * plane.slopes_m[1],
                };
                self.weight(neighbour.is_along_x) * rise_m
            };
            self.neighbours(row, column).map(rise_m).sum()
        })
    }

    /// Sums the weights of the neighbours of each missing point.
    fn diagonals(&self) -> Vec<f64> {
        let diagonal =
            |(row, column)| self.neighbours(row, column).map(|beside| self.weight(beside.is_along_x)).sum();
        self.places().map(diagonal).collect()
    }

    fn multigrid(&self) -> Multigrid {
        let (rows, columns) = extent(self.runs);
        let (mut cells, mut ties) = (Cells::default(), Ties::default());
        for (row, column) in self.places() {
            cells.rows.push((row - rows.start) as u32);
            cells.columns.push((column - columns.start) as u32);
            let (mut right, mut below, mut boundary) = (0.0, 0.0, [0.0, 0.0]);
            for beside in self.neighbours(row, column) {
                let weight = self.weight(beside.is_along_x) as f32;
                match self.grid.height_m(beside.row, beside.column) {
                    Some(_) => boundary[usize::from(!beside.is_along_x)] += weight,
                    None if beside.step == [0.0, 1.0] => right = weight,
                    None if beside.step == [1.0, 0.0] => below = weight,
                    None => {}
                }
            }
            ties.right.push(right);
            ties.below.push(below);
            ties.boundary_x.push(boundary[0]);
            ties.boundary_y.push(boundary[1]);
        }
        Multigrid::new(cells, ties)
    }

    /// Applies the positive Laplace operator to values that are 0 outside the hole.
    fn multiply(&self, diagonals: &[f64], lower: &[u32], values: &[f64], product: &mut [f64]) {
        for (product, (diagonal, value)) in product.iter_mut().zip(diagonals.iter().zip(values)) {
            *product = diagonal * value;
        }
        let mut first = 0;
        for run in self.runs {
            let (from, to) = (first, first + run.columns.len());
            for right in from + 1..to {
                product[right - 1] -= self.grid.weight_x * values[right];
                product[right] -= self.grid.weight_x * values[right - 1];
            }
            first = to;
        }
        for (cell, &below) in lower.iter().enumerate().filter(|&(_, &below)| below != NONE) {
            product[cell] -= self.grid.weight_y * values[below as usize];
            product[below as usize] -= self.grid.weight_y * values[cell];
        }
    }
}

impl Plane {
    /// Fits by least squares; level if the points around the hole lie on a line.
    fn fit(hole: &Hole) -> Self {
        let pivot_m = hole.boundary().next().map_or(0.0, |(_, _, height_m)| height_m);
        let (rows, columns) = extent(hole.runs);
        let middle = |range: std::ops::Range<usize>| (range.start + range.end - 1) as f64 / 2.0;
        let centre = [middle(rows), middle(columns)];
        let (mut count, mut sum_m) = (0.0, 0.0);
        let (mut lowest_m, mut highest_m) = (pivot_m, pivot_m);
        let (mut means, mut squares, mut rises_m) = ([0.0; 2], [[0.0; 2]; 2], [0.0; 2]);
        for (row, column, height_m) in hole.boundary() {
            (lowest_m, highest_m) = (lowest_m.min(height_m), highest_m.max(height_m));
            let (place, height_m) = ([row as f64 - centre[0], column as f64 - centre[1]], height_m - pivot_m);
            count += 1.0;
            sum_m += height_m;
            for i in 0..2 {
                means[i] += place[i];
                rises_m[i] += place[i] * height_m;
                for j in 0..2 {
                    squares[i][j] += place[i] * place[j];
                }
            }
        }
        let mean_m = sum_m / f64::max(count, 1.0);
        let means = means.map(|sum| sum / f64::max(count, 1.0));
        let square = |i: usize, j: usize| squares[i][j] - count * means[i] * means[j];
        let rise_m = |i: usize| rises_m[i] - count * means[i] * mean_m;
        let determinant = square(0, 0) * square(1, 1) - square(0, 1) * square(0, 1);
        let is_level = determinant <= 1e-9 * square(0, 0) * square(1, 1);
        let slopes_m = if is_level {
            [0.0; 2]
        } else {
            [
                (rise_m(0) * square(1, 1) - rise_m(1) * square(0, 1)) / determinant,
                (rise_m(1) * square(0, 0) - rise_m(0) * square(0, 1)) / determinant,
            ]
        };
        let level_m = mean_m - slopes_m[0] * means[0] - slopes_m[1] * means[1];
        Self { pivot_m, lowest_m, highest_m, centre, level_m, slopes_m }
    }

    /// Height above the pivot \[m\].
    fn at_m(&self, row: usize, column: usize) -> f64 {
        self.level_m
            + self.slopes_m[0] * (row as f64 - self.centre[0])
            + self.slopes_m[1] * (column as f64 - self.centre[1])
    }
}
