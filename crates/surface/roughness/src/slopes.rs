//! Slopes and developed areas, which depend on how neighbouring points are joined.

use units::named;

use crate::relief::ScaleLimitedSurface;

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

/// Offsets in points, and the factors of the heights there.
type Stencil = [(isize, f64)];

impl Differences {
    /// The stencil of a slope, in m per point.
    fn stencil(self) -> &'static Stencil {
        match self {
            Differences::Neighbours => &[(0, -1.0), (1, 1.0)],
            Differences::Central => &[(-1, -0.5), (1, 0.5)],
            Differences::SevenPoints => &[
                (-3, -1.0 / 60.0),
                (-2, 9.0 / 60.0),
                (-1, -45.0 / 60.0),
                (1, 45.0 / 60.0),
                (2, -9.0 / 60.0),
                (3, 1.0 / 60.0),
            ],
        }
    }
}

/// Computes the rms gradient: Sdq of a map, Rdq of a profile, 1. Differences that a missing point takes part in are left
/// out. None where no difference is left, and for uneven profiles but between neighbours.
#[must_use]
pub fn rms_gradient(relief: &ScaleLimitedSurface, differences: Differences) -> Option<f64> {
    if let Some(positions_m) = &relief.positions_m {
        return (differences == Differences::Neighbours).then(|| rms_of_uneven(relief, positions_m))?;
    }
    let stencil = differences.stencil();
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    let mut square = mean_square(&Lines::along_x(relief), stencil)? / spacing_x_m.powi(2);
    if let (Some(columns), Some(spacing_y_m)) = (Lines::along_y(relief), spacing_y_m) {
        square += mean_square(&columns, stencil)? / spacing_y_m.powi(2);
    }
    Some(square.sqrt())
}

/// Computes the rms gradient from heights a distance apart, given in points along x and, of a map, along y: between neighbours it
/// is Sdq or Rdq. None where no difference is left, and for uneven profiles.
pub(crate) fn rms_gradient_at(relief: &ScaleLimitedSurface, points: [usize; 2]) -> Option<f64> {
    along_axes(relief, points, |lines, points| mean_square(lines, &[(0, -1.0), (points, 1.0)]), 1)
        .map(|[x, y]| (x + y).sqrt())
}

/// Computes the rms curvature \[1/m\] from three heights a distance apart, given in points along x and, of a map, along y: that of a
/// profile, or of the profiles of a map along both axes. None where no difference is left, and for uneven profiles.
pub(crate) fn rms_curvature_at(relief: &ScaleLimitedSurface, points: [usize; 2]) -> Option<f64> {
    let stencil = |points: isize| [(-points, 1.0), (0, -2.0), (points, 1.0)];
    let [x, y] = along_axes(relief, points, |lines, points| mean_square(lines, &stencil(points)), 2)?;
    Some(if relief.points().1.is_some() { (0.5 * (x + y)).sqrt() } else { x.sqrt() })
}

/// Mean squares along x and along y over the distances to a power; 0 along y of a profile.
fn along_axes(
    relief: &ScaleLimitedSurface,
    [along_x, along_y]: [usize; 2],
    mean_square: impl Fn(&Lines<'_>, isize) -> Option<f64>,
    power: i32,
) -> Option<[f64; 2]> {
    if relief.positions_m.is_some() {
        return None;
    }
    let of_axis = |lines: &Lines<'_>, points: usize, spacing_m: f64| {
        let distance_m = points as f64 * spacing_m;
        Some(mean_square(lines, isize::try_from(points).ok()?)? / distance_m.powi(2 * power))
    };
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    let x = of_axis(&Lines::along_x(relief), along_x, spacing_x_m)?;
    let y = match (Lines::along_y(relief), spacing_y_m) {
        (Some(columns), Some(spacing_y_m)) => of_axis(&columns, along_y, spacing_y_m)?,
        _ => 0.0,
    };
    Some([x, y])
}

/// The lines of a relief along an axis: `count` of them, `apart` points apart in memory, each of `points` points that are `step`
/// apart.
struct Lines<'r> {
    relief: &'r ScaleLimitedSurface,
    points: usize,
    step: usize,
    count: usize,
    apart: usize,
}

impl<'r> Lines<'r> {
    fn along_x(relief: &'r ScaleLimitedSurface) -> Self {
        let (columns, rows) = relief.points();
        Lines { relief, points: columns, step: 1, count: rows.unwrap_or(1), apart: columns }
    }

    fn along_y(relief: &'r ScaleLimitedSurface) -> Option<Self> {
        let (columns, rows) = relief.points();
        Some(Lines { relief, points: rows?, step: columns, count: columns, apart: 1 })
    }

    /// Height \[m\] of a point of a line, if there is one.
    fn height_m(&self, line: usize, point: usize) -> Option<f64> {
        self.relief.height_m(line * self.apart + point * self.step)
    }
}

/// Computes the mean square \[m^2\] of a combination of heights along lines; combinations that a missing point takes part in are
/// left out.
fn mean_square(lines: &Lines<'_>, stencil: &Stencil) -> Option<f64> {
    let before = stencil.iter().map(|(offset, _)| -offset).max().unwrap_or(0).max(0).unsigned_abs();
    let behind = stencil.iter().map(|(offset, _)| *offset).max().unwrap_or(0).max(0).unsigned_abs();
    let (mut sum_m2, mut count) = (0.0, 0usize);
    for line in 0..lines.count {
        for point in before..lines.points.saturating_sub(behind) {
            let combined_m = stencil.iter().try_fold(0.0, |sum_m, (offset, factor)| {
                Some(sum_m + factor * lines.height_m(line, point.checked_add_signed(*offset)?)?)
            });
            if let Some(combined_m) = combined_m {
                sum_m2 += combined_m * combined_m;
                count += 1;
            }
        }
    }
    (count > 0).then(|| sum_m2 / count as f64)
}

/// Computes the rms slope of straight lines between uneven points, each weighted by its length.
fn rms_of_uneven(relief: &ScaleLimitedSurface, positions_m: &[f64]) -> Option<f64> {
    let (heights_m, _) = relief.parts();
    let pieces = positions_m.windows(2).zip(heights_m.windows(2));
    let squares_m: f64 = pieces.map(|(x, z)| (z[1] - z[0]).powi(2) / (x[1] - x[0])).sum();
    Some((squares_m / (positions_m.last()? - positions_m.first()?)).sqrt())
}

/// Computes Sdr of a map as a share: developed over projected area less one, over the cells of four points that all have a
/// height. None where there is no such cell, and for lines.
#[must_use]
pub fn developed_area_excess(relief: &ScaleLimitedSurface, triangles: Triangles) -> Option<f64> {
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
    use scans::{HeightMap, MeasuredScan, Scan, UniformLineScan};

    use crate::relief::{Evaluation, FormRemoval};

    use super::*;

    fn relief(scan: Scan) -> ScaleLimitedSurface {
        let evaluation = Evaluation { form: FormRemoval::None, ..Evaluation::default() };
        ScaleLimitedSurface::new(&MeasuredScan::from(scan), &evaluation).unwrap()
    }

    fn map(height_m: impl Fn(f64, f64) -> f64) -> ScaleLimitedSurface {
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
