//! Slopes and developed areas, which depend on how neighbouring points are joined.

use units::named;

use crate::relief::Relief;

/// Differences from which slopes are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Differences {
    /// Differences of neighbouring points, each axis over its own pairs.
    Neighbours,
    /// Differences of the points on both sides of one.
    Central,
    /// Differences of seven points, as in ISO 4287.
    SevenPoints,
}

named!(Differences, "differences", {
    Neighbours => "differences of neighbours", Central => "central differences", SevenPoints => "seven points"
});

/// Triangles that join the points of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Triangles {
    /// Each cell of four points by both of its diagonals, ISO 25178-2:2021, D.3; the mean of the two areas.
    BothDiagonals,
    /// Four triangles to a point in the middle, at the mean of the four heights.
    MiddlePoint,
}

named!(Triangles, "triangles", {
    BothDiagonals => "mean of two triangulations", MiddlePoint => "four triangles with a middle point"
});

impl Differences {
    /// Offsets in points and their factors, for the half towards larger x; the other half has the opposite sign.
    fn stencil(self) -> &'static [(usize, f64)] {
        match self {
            Differences::Neighbours => &[],
            Differences::Central => &[(1, 0.5)],
            Differences::SevenPoints => &[(1, 45.0 / 60.0), (2, -9.0 / 60.0), (3, 1.0 / 60.0)],
        }
    }
}

/// Computes the rms gradient: Sdq of a map, Rdq of a profile, 1. Differences that a missing point takes part in are left
/// out. None where no difference is left, and for uneven profiles but between neighbours.
#[must_use]
pub fn rms_gradient(relief: &Relief, differences: Differences) -> Option<f64> {
    let (columns, rows) = relief.points();
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    if let Some(positions_m) = relief.positions_m() {
        return (differences == Differences::Neighbours).then(|| rms_of_uneven(relief, positions_m))?;
    }
    let rows_of_all = rows.unwrap_or(1);
    let mut mean_square =
        mean_square_slope(relief, differences, [columns, 1, rows_of_all, columns])? / spacing_x_m.powi(2);
    if let (Some(rows), Some(spacing_y_m)) = (rows, spacing_y_m) {
        mean_square +=
            mean_square_slope(relief, differences, [rows, columns, columns, 1])? / spacing_y_m.powi(2);
    }
    Some(mean_square.sqrt())
}

/// Computes the mean square of the slope along rows of `points` points `step` apart, in m per point; there are `count` rows,
/// `apart` apart.
fn mean_square_slope(
    relief: &Relief,
    differences: Differences,
    [points, step, count, apart]: [usize; 4],
) -> Option<f64> {
    let stencil = differences.stencil();
    let reach = stencil.last().map_or(0, |(offset, _)| *offset);
    let (mut sum_m2, mut pairs) = (0.0, 0usize);
    for row in 0..count {
        let height_m = |point: usize| relief.height_m(row * apart + point * step);
        let slope_m = |point: usize| match stencil {
            [] => Some(height_m(point + 1)? - height_m(point)?),
            _ => stencil.iter().try_fold(0.0, |sum_m, (offset, factor)| {
                Some(sum_m + factor * (height_m(point + offset)? - height_m(point - offset)?))
            }),
        };
        let last = if stencil.is_empty() { points.saturating_sub(1) } else { points.saturating_sub(reach) };
        for slope_m in (reach..last).filter_map(slope_m) {
            sum_m2 += slope_m * slope_m;
            pairs += 1;
        }
    }
    (pairs > 0).then(|| sum_m2 / pairs as f64)
}

/// Computes the rms slope of straight lines between uneven points, each weighted by its length.
fn rms_of_uneven(relief: &Relief, positions_m: &[f64]) -> Option<f64> {
    let (heights_m, _) = relief.parts();
    let pieces = positions_m.windows(2).zip(heights_m.windows(2));
    let squares_m: f64 = pieces.map(|(x, z)| (z[1] - z[0]).powi(2) / (x[1] - x[0])).sum();
    Some((squares_m / (positions_m.last()? - positions_m.first()?)).sqrt())
}

/// Computes Sdr of a map as a share: developed over projected area less one, over the cells of four points that all have a
/// height. None where there is no such cell, and for lines.
#[must_use]
pub fn developed_area_excess(relief: &Relief, triangles: Triangles) -> Option<f64> {
    let (columns, rows) = relief.points();
    let (dx_m, rows, dy_m) = (relief.spacing_m().0, rows?, relief.spacing_m().1?);
    // Of a triangle with these slopes, without cancellation.
    let excess = |along_x: f64, along_y: f64| {
        let square = along_x * along_x + along_y * along_y;
        square / ((1.0 + square).sqrt() + 1.0)
    };
    let (mut sum, mut cells) = (0.0, 0usize);
    for row in 0..rows.saturating_sub(1) {
        for column in 0..columns.saturating_sub(1) {
            let at = row * columns + column;
            let corners = [at, at + 1, at + columns, at + columns + 1].map(|index| relief.height_m(index));
            let [Some(z00), Some(z10), Some(z01), Some(z11)] = corners else { continue };
            let (bottom, top) = ((z10 - z00) / dx_m, (z11 - z01) / dx_m);
            let (left, right) = ((z01 - z00) / dy_m, (z11 - z10) / dy_m);
            sum += match triangles {
                Triangles::BothDiagonals => {
                    excess(bottom, right) + excess(top, left) + excess(bottom, left) + excess(top, right)
                }
                Triangles::MiddlePoint => {
                    let (along_x, along_y) = (0.5 * (bottom + top), 0.5 * (left + right));
                    excess(bottom, along_y)
                        + excess(top, along_y)
                        + excess(along_x, left)
                        + excess(along_x, right)
                }
            };
            cells += 1;
        }
    }
    (cells > 0).then(|| 0.25 * sum / cells as f64)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use scans::{HeightMap, Measured, Scan, UniformLineScan};

    use crate::relief::{Evaluation, FormRemoval};

    use super::*;

    fn relief(scan: Scan) -> Relief {
        let evaluation = Evaluation { form: FormRemoval::None, ..Evaluation::default() };
        Relief::new(&Measured::from(scan), &evaluation).unwrap()
    }

    fn map(height_m: impl Fn(f64, f64) -> f64) -> Relief {
        let heights_m = (0..20 * 30).map(|at| height_m((at % 20) as f64, (at / 20) as f64)).collect();
        relief(Scan::Map(HeightMap::new(20, 1e-6, 2e-6, heights_m).unwrap()))
    }

    #[test]
    fn a_tilted_plane_has_its_slope_and_area_by_every_convention() {
        let tilted = map(|x, y| 0.3e-6 * x - 0.8e-6 * y);
        let line = relief(Scan::UniformLine(
            UniformLineScan::new(1e-6, (0..30).map(|x| 0.3e-6 * f64::from(x)).collect()).unwrap(),
        ));
        for differences in Differences::ALL {
            assert_relative_eq!(rms_gradient(&tilted, *differences).unwrap(), 0.5, max_relative = 1e-12);
            assert_relative_eq!(rms_gradient(&line, *differences).unwrap(), 0.3, max_relative = 1e-12);
        }
        for triangles in Triangles::ALL {
            let expected = 1.25f64.sqrt() - 1.0;
            assert_relative_eq!(
                developed_area_excess(&tilted, *triangles).unwrap(),
                expected,
                max_relative = 1e-12
            );
            assert_eq!(developed_area_excess(&line, *triangles), None);
        }
    }

    #[test]
    fn small_slopes_develop_half_their_square() {
        let rough = map(|x, y| 1e-12 * ((2.3 * x).sin() + (1.7 * y + 0.2 * x).cos()));
        let gradient = rms_gradient(&rough, Differences::Neighbours).unwrap();
        let excess = developed_area_excess(&rough, Triangles::BothDiagonals).unwrap();
        // The cells at the edges weigh differently in both.
        assert_relative_eq!(excess, 0.5 * gradient * gradient, max_relative = 0.03);
    }
}
