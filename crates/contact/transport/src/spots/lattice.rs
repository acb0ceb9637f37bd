//! Potential of a point source and its periodic images: the sum of 1/r over a lattice, less its mean.

use std::f64::consts::PI;

/// Argument beyond which erfc is below 1e-15.
const END: f64 = 5.8;

/// Intervals of the table over half of the shorter side.
const INTERVALS: f64 = 48.0;

/// Most points of the table, reached by cells of 1:80.
const MOST_POINTS: f64 = 2e5;

/// Sum of 1/|d + L| over a rectangular lattice, less its mean over the cell, by the method of Ewald (1921), Ann. Phys. 369:253, for
/// sources on a plane. Without the nearest image it is smooth, and interpolated by cubics.
#[derive(Debug, Clone)]
pub(super) struct LatticeSum {
    lengths_m: [f64; 2],
    /// Intervals along x and y.
    intervals: [usize; 2],
    /// Sum without the nearest image \[1/m\], from one interval before the origin to one beyond the half of the cell.
    without_nearest: Vec<f64>,
}

impl LatticeSum {
    /// Tabulates the sum of a cell.
    pub(super) fn new(lengths_m: [f64; 2]) -> Self {
        let shorter_m = lengths_m[0].min(lengths_m[1]);
        let stretch = lengths_m[0].max(lengths_m[1]) / shorter_m;
        let finest = INTERVALS.min((MOST_POINTS / stretch).sqrt());
        let intervals = lengths_m.map(|length_m| (finest * length_m / shorter_m).ceil() as usize);
        let place_m =
            |axis: usize, at: usize| (at as f64 - 1.0).abs() * 0.5 * lengths_m[axis] / intervals[axis] as f64;
        let rows = 0..intervals[1] + 3;
        let places = rows
            .flat_map(|row| (0..intervals[0] + 3).map(move |column| [place_m(0, column), place_m(1, row)]));
        let without_nearest = places.map(|distance_m| without_nearest(distance_m, lengths_m)).collect();
        LatticeSum { lengths_m, intervals, without_nearest }
    }

    /// Sum over all images but the source itself, at its own place \[1/m\].
    pub(super) fn own_per_m(&self) -> f64 {
        self.without_nearest[self.intervals[0] + 4]
    }

    /// Sum at a distance along x and y \[1/m\]; infinite at a source.
    #[inline]
    pub(super) fn at_per_m(&self, distance_m: [f64; 2]) -> f64 {
        let nearest_m = [0, 1].map(|axis| {
            let length_m = self.lengths_m[axis];
            (distance_m[axis] - length_m * (distance_m[axis] / length_m).round()).abs()
        });
        let mut weights = [[0.0; 4]; 2];
        let mut first = [0; 2];
        for axis in [0, 1] {
            let at = nearest_m[axis] * 2.0 / self.lengths_m[axis] * self.intervals[axis] as f64;
            first[axis] = (at as usize).min(self.intervals[axis] - 1);
            weights[axis] = cubic(at - first[axis] as f64);
        }
        let width = self.intervals[0] + 3;
        let smooth: f64 = (0..4)
            .map(|row| {
                let values = &self.without_nearest[(first[1] + row) * width + first[0]..][..4];
                weights[1][row] * (0..4).map(|column| weights[0][column] * values[column]).sum::<f64>()
            })
            .sum();
        (nearest_m[0].powi(2) + nearest_m[1].powi(2)).sqrt().recip() + smooth
    }
}

/// Lagrange's weights of the values at -1, 0, 1 and 2.
fn cubic(at: f64) -> [f64; 4] {
    let [before, past, far] = [at + 1.0, at - 1.0, at - 2.0];
    [-at * past * far / 6.0, before * past * far / 2.0, -before * at * far / 2.0, before * at * past / 6.0]
}

/// Sum without the nearest image \[1/m\].
fn without_nearest([x_m, y_m]: [f64; 2], [length_x_m, length_y_m]: [f64; 2]) -> f64 {
    let area_m2 = length_x_m * length_y_m;
    let split_per_m = (PI / area_m2).sqrt();
    let distance_m = x_m.hypot(y_m);
    let mut sum = if distance_m > 0.0 {
        -libm::erf(split_per_m * distance_m) / distance_m
    } else {
        -2.0 * split_per_m / PI.sqrt()
    };
    let reach = |end: f64, length: f64| (end / length) as i64 + 1;
    let end_m = END / split_per_m;
    for row in -reach(end_m, length_y_m)..=reach(end_m, length_y_m) {
        for column in -reach(end_m, length_x_m)..=reach(end_m, length_x_m) {
            let image_m = (x_m + column as f64 * length_x_m).hypot(y_m + row as f64 * length_y_m);
            if (row, column) != (0, 0) && image_m < end_m {
                sum += libm::erfc(split_per_m * image_m) / image_m;
            }
        }
    }
    let (end_per_m, [unit_x_per_m, unit_y_per_m]) =
        (2.0 * split_per_m * END, [length_x_m, length_y_m].map(|length_m| 2.0 * PI / length_m));
    for row in 0..reach(end_per_m, unit_y_per_m) {
        for column in 0..reach(end_per_m, unit_x_per_m) {
            let [along_x, along_y] = [column as f64 * unit_x_per_m, row as f64 * unit_y_per_m];
            let wave_per_m = along_x.hypot(along_y);
            if (row, column) != (0, 0) && wave_per_m < end_per_m {
                let opposite = [row, column].into_iter().filter(|&periods| periods > 0).count();
                let factor = f64::from(1 << opposite) * 2.0 * PI / (area_m2 * wave_per_m);
                sum += factor
                    * libm::erfc(0.5 * wave_per_m / split_per_m)
                    * (along_x * x_m).cos()
                    * (along_y * y_m).cos();
            }
        }
    }
    // Mean of the part that is summed over the images.
    sum - 2.0 * PI.sqrt() / (split_per_m * area_m2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sums_of_square_lattices_are_those_of_the_literature() {
        // Madelung's constant of a square lattice of charges in a neutral plane; Bonsall & Maradudin (1977), Phys. Rev. B 15:1959.
        let square = LatticeSum::new([2.0, 2.0]);
        assert!((2.0 * square.own_per_m() + 3.900_264_920_0).abs() < 1e-9);
        // Alternating charges: -1.615542627 for the nearest distance.
        let spread = LatticeSum::new([2.0, 2.0]);
        let alternating = spread.own_per_m() + spread.at_per_m([1.0, 1.0])
            - spread.at_per_m([1.0, 0.0])
            - spread.at_per_m([0.0, 1.0]);
        assert!((alternating + 1.615_542_627).abs() < 1e-5, "{alternating}");
    }

    #[test]
    fn several_cells_are_one_cell() {
        let (cell, six) = (LatticeSum::new([1.0, 0.7]), LatticeSum::new([2.0, 2.1]));
        for distance_m in [[0.1, 0.2], [0.5, 0.35], [-0.3, 1.04], [0.013, -0.009]] {
            let cells = (0..2).flat_map(|column| (0..3).map(move |row| [f64::from(column), f64::from(row)]));
            let sum: f64 = cells
                .map(|[column, row]| six.at_per_m([distance_m[0] + column, distance_m[1] + 0.7 * row]))
                .sum();
            assert!(
                (sum - cell.at_per_m(distance_m)).abs() < 1e-5 * sum.abs().max(1.0),
                "{distance_m:?} {sum}"
            );
        }
    }

    #[test]
    fn the_table_has_the_digits_of_the_sum() {
        for lengths_m in [[1.0, 1.0], [9.0, 1.0]] {
            let sum = LatticeSum::new(lengths_m);
            for at in 1..200 {
                let distance_m = [
                    0.5 * lengths_m[0] * (0.618 * f64::from(at)).fract(),
                    0.5 * (0.414 * f64::from(at)).fract(),
                ];
                let exact =
                    without_nearest(distance_m, lengths_m) + distance_m[0].hypot(distance_m[1]).recip();
                assert!((sum.at_per_m(distance_m) - exact).abs() < 2e-6, "{distance_m:?}");
            }
        }
    }
}
