//! Heights to evaluate: what is left of a scan without its form, and of a filter.

use numerics::solve;
use scans::MeasuredScan;
use thiserror::Error;
use topography::without_form_m;
use units::named;

use crate::gaussian_filter::GaussianFilter;

/// Form that is subtracted from the heights before anything else, fitted by least squares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum FormRemoval {
    /// Nothing but the mean.
    None,
    /// A plane; of a profile a straight line.
    #[default]
    Plane,
    /// A polynomial of the second order in x and y.
    SecondOrder,
}

named!(FormRemoval, "form", { None => "none", Plane => "plane", SecondOrder => "second-order" });

/// Treatment of the heights before they are evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// The form to subtract.
    pub form: FormRemoval,
    /// Cut-off \[m\] of the Gaussian filter that removes longer waves (L-filter).
    pub longest_m: Option<f64>,
    /// Cut-off \[m\] of the Gaussian filter that removes shorter waves (S-filter).
    pub shortest_m: Option<f64>,
}

/// Errors of preparing heights.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ScaleLimitedSurfaceError {
    /// No point has a height, or none of those that a filter leaves.
    #[error("no point has a height")]
    NoHeights,
    /// A filter needs evenly spaced points.
    #[error("its points are unevenly spaced, which the filter does not take; leave out the filter")]
    UnevenlySpaced,
    /// A cut-off is not longer than two points.
    #[error(
        "the cut-off of {} is not above two points, {}; give a longer one",
        units::display::length(*cutoff_m),
        units::display::length(2.0 * spacing_m)
    )]
    CutoffTooShort {
        /// The cut-off \[m\].
        cutoff_m: f64,
        /// Distance \[m\] of neighbouring points.
        spacing_m: f64,
    },
    /// A cut-off is too long for the scan: longer than a side of a map, or than half a profile, which loses half a cut-off
    /// at each end.
    #[error(
        "the cut-off of {} needs a scan of at least {}, and this one has {}; give a shorter one",
        units::display::length(*cutoff_m),
        units::display::length(*needed_m),
        units::display::length(*size_m)
    )]
    CutoffTooLong {
        /// The cut-off \[m\].
        cutoff_m: f64,
        /// The size that it needs \[m\].
        needed_m: f64,
        /// The shortest side of the scan \[m\].
        size_m: f64,
    },
}

/// Heights from their mean, row by row, on a line or a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaleLimitedSurface {
    columns: usize,
    rows: Option<usize>,
    spacing_m: (f64, Option<f64>),
    /// Positions \[m\] of unevenly spaced points.
    pub(crate) positions_m: Option<Vec<f64>>,
    /// Heights \[m\]; 0 where none was measured.
    heights_m: Vec<f64>,
    /// Points that have a height; all of them if there is no list.
    measured: Option<Vec<bool>>,
    /// Largest absolute height \[m\] as measured, which bounds the rounding of all others.
    pub(crate) largest_given_m: f64,
}

impl ScaleLimitedSurface {
    /// Subtracts the form, filters, and takes the mean as the origin of heights. From each end of a filtered profile
    /// half of the longest cut-off is dropped, where the filter looks beyond the end.
    ///
    /// # Errors
    /// [`ScaleLimitedSurfaceError`] for a scan without heights and for cut-offs that it cannot take.
    pub fn new(scan: &MeasuredScan, evaluation: &Evaluation) -> Result<Self, ScaleLimitedSurfaceError> {
        let (columns, rows) = scan.points();
        let mut largest_given_m = 0.0f64;
        let mut first_m = None;
        for height_m in scan.heights_m().flatten() {
            largest_given_m = largest_given_m.max(height_m.abs());
            first_m = first_m.or(Some(height_m));
        }
        let first_m = first_m.ok_or(ScaleLimitedSurfaceError::NoHeights)?;
        let heights_m: Vec<Option<f64>> = match evaluation.form {
            FormRemoval::None => {
                scan.heights_m().map(|height_m| height_m.map(|height_m| height_m - first_m)).collect()
            }
            FormRemoval::Plane | FormRemoval::SecondOrder => without_form_m(scan),
        };
        let is_complete = heights_m.iter().all(Option::is_some);
        let mut relief = ScaleLimitedSurface {
            columns,
            rows,
            spacing_m: scan.spacing_m(),
            positions_m: scan.positions_m().map(<[f64]>::to_vec),
            measured: (!is_complete).then(|| heights_m.iter().map(Option::is_some).collect()),
            heights_m: heights_m.into_iter().map(Option::unwrap_or_default).collect(),
            largest_given_m,
        };
        if evaluation.form == FormRemoval::SecondOrder {
            relief.subtract_second_order();
        }
        relief.filter(evaluation)?;
        // The ends of a filtered profile may have been all that was measured.
        if relief.heights_m().all(|height_m| height_m.is_none()) {
            return Err(ScaleLimitedSurfaceError::NoHeights);
        }
        relief.subtract_mean();
        Ok(relief)
    }

    /// Number of points along x and, of a map, along y.
    #[must_use]
    pub fn points(&self) -> (usize, Option<usize>) {
        (self.columns, self.rows)
    }

    /// Distances \[m\] of neighbouring points along x and, of a map, along y; of an uneven profile the mean.
    #[must_use]
    pub fn spacing_m(&self) -> (f64, Option<f64>) {
        self.spacing_m
    }

    /// Number of points without a height.
    #[must_use]
    pub fn missing(&self) -> usize {
        self.measured
            .as_ref()
            .map_or(0, |measured| measured.iter().filter(|has_height| !**has_height).count())
    }

    /// Heights \[m\] row by row, where there are any.
    pub fn heights_m(&self) -> impl Iterator<Item = Option<f64>> + '_ {
        (0..self.heights_m.len()).map(|index| self.height_m(index))
    }

    /// Height \[m\] of a point, if it has one.
    pub(crate) fn height_m(&self, index: usize) -> Option<f64> {
        self.has_height(index).then(|| self.heights_m[index])
    }

    /// Heights \[m\] with 0 for missing points, and a list of the points that have one unless all do.
    pub(crate) fn parts(&self) -> (&[f64], Option<&[bool]>) {
        (&self.heights_m, self.measured.as_deref())
    }

    fn has_height(&self, index: usize) -> bool {
        self.measured.as_ref().is_none_or(|measured| measured[index])
    }

    fn subtract_mean(&mut self) {
        // Twice: the second mean is what rounding left of the first.
        for _ in 0..2 {
            let (count, sum_m) = self
                .heights_m()
                .flatten()
                .fold((0usize, 0.0), |(count, sum), height| (count + 1, sum + height));
            let mean_m = sum_m / count.max(1) as f64;
            self.change_heights(|_, height_m| height_m - mean_m);
        }
    }

    fn change_heights(&mut self, changed: impl Fn(usize, f64) -> f64) {
        let measured = self.measured.as_deref();
        for (index, height_m) in self.heights_m.iter_mut().enumerate() {
            if measured.is_none_or(|measured| measured[index]) {
                *height_m = changed(index, *height_m);
            }
        }
    }

    fn subtract_second_order(&mut self) {
        let rows = self.rows.unwrap_or(1);
        let (columns, positions_m) = (self.columns, self.positions_m.clone());
        let from_middle = |index: usize, points: usize| (2 * index + 1) as f64 / points as f64 - 1.0;
        let x = |index: usize| match &positions_m {
            Some(positions_m) => {
                let (first_m, last_m) = (positions_m[0], positions_m[columns - 1]);
                2.0 * (positions_m[index] - first_m) / (last_m - first_m) - 1.0
            }
            None => from_middle(index % columns, columns),
        };
        let y = |index: usize| from_middle(index / columns, rows);
        match rows {
            1 => self.subtract_fit(|index| [1.0, x(index), x(index).powi(2)]),
            _ => self.subtract_fit(|index| {
                let (x, y) = (x(index), y(index));
                [1.0, x, y, x * x, x * y, y * y]
            }),
        }
    }

    /// Subtracts the least-squares combination of some terms; nothing where the points do not determine one, as on two lines.
    fn subtract_fit<const N: usize>(&mut self, terms: impl Fn(usize) -> [f64; N]) {
        let measured = self.heights_m.len() - self.missing();
        // Twice: the second fit removes what rounding left of a strong curvature.
        for _ in 0..2 {
            let (mut products, mut sums) = ([[0.0; N]; N], [0.0; N]);
            for (index, height_m) in self.heights_m().enumerate() {
                let Some(height_m) = height_m else { continue };
                let terms = terms(index);
                for (row, term) in terms.iter().enumerate() {
                    sums[row] += term * height_m;
                    products[row].iter_mut().zip(terms).for_each(|(product, other)| *product += term * other);
                }
            }
            if !are_independent(products, measured) {
                return;
            }
            let Some(coefficients) = solve(products, sums) else { return };
            let form_m = |index: usize| -> f64 {
                terms(index).iter().zip(coefficients).map(|(term, c)| term * c).sum()
            };
            let square_m2 = |rest_m: f64| rest_m * rest_m;
            let [before_m2, after_m2] = [0.0, 1.0].map(|share| -> f64 {
                let rest = self.heights_m().enumerate();
                rest.filter_map(|(index, height_m)| Some(square_m2(height_m? - share * form_m(index)))).sum()
            });
            // A fit brings no more.
            if !after_m2.is_finite() || after_m2 > before_m2 {
                return;
            }
            self.change_heights(|index, height_m| height_m - form_m(index));
        }
    }

    fn filter(&mut self, evaluation: &Evaluation) -> Result<(), ScaleLimitedSurfaceError> {
        let (is_line, cutoffs_m) = (self.rows.is_none(), [evaluation.shortest_m, evaluation.longest_m]);
        for cutoff_m in cutoffs_m.into_iter().flatten() {
            self.check_cutoff(cutoff_m, if is_line { 2.0 * cutoff_m } else { cutoff_m })?;
        }
        if let Some(cutoff_m) = evaluation.shortest_m {
            self.heights_m = self.smoothed_m(cutoff_m);
        }
        if let Some(cutoff_m) = evaluation.longest_m {
            let smooth_m = self.smoothed_m(cutoff_m);
            self.change_heights(|index, height_m| height_m - smooth_m[index]);
        }
        if let Some(cutoff_m) = cutoffs_m.into_iter().flatten().reduce(f64::max).filter(|_| is_line) {
            self.drop_ends(cutoff_m);
        }
        Ok(())
    }

    fn check_cutoff(&self, cutoff_m: f64, needed_m: f64) -> Result<(), ScaleLimitedSurfaceError> {
        if self.positions_m.is_some() {
            return Err(ScaleLimitedSurfaceError::UnevenlySpaced);
        }
        let (spacing_x_m, spacing_y_m) = self.spacing_m;
        let spacing_m = spacing_y_m.map_or(spacing_x_m, |spacing_y_m| spacing_y_m.max(spacing_x_m));
        if cutoff_m <= 2.0 * spacing_m {
            return Err(ScaleLimitedSurfaceError::CutoffTooShort { cutoff_m, spacing_m });
        }
        let along_x_m = spacing_x_m * self.columns as f64;
        let along_y_m = spacing_y_m.zip(self.rows).map(|(spacing_m, rows)| spacing_m * rows as f64);
        let size_m = along_y_m.map_or(along_x_m, |along_y_m| along_y_m.min(along_x_m));
        if needed_m > size_m {
            return Err(ScaleLimitedSurfaceError::CutoffTooLong { cutoff_m, needed_m, size_m });
        }
        Ok(())
    }

    /// Computes the heights \[m\] that a filter lets pass, along x and, of a map, along y. Missing points have no weight.
    fn smoothed_m(&self, cutoff_m: f64) -> Vec<f64> {
        let mut smooth = self.heights_m.clone();
        self.smooth(&mut smooth, cutoff_m);
        if let Some(measured) = &self.measured {
            let mut weights: Vec<f64> = measured.iter().map(|has_height| f64::from(*has_height)).collect();
            self.smooth(&mut weights, cutoff_m);
            for ((height_m, weight), has_height) in smooth.iter_mut().zip(weights).zip(measured) {
                *height_m = if *has_height { *height_m / weight } else { 0.0 };
            }
        }
        smooth
    }

    fn smooth(&self, values: &mut [f64], cutoff_m: f64) {
        let along_x = GaussianFilter::new(self.columns, self.spacing_m.0, cutoff_m);
        let mut buffers = along_x.buffers();
        values.chunks_exact_mut(self.columns).for_each(|row| along_x.smooth(row, &mut buffers));
        let (Some(rows), Some(spacing_y_m)) = (self.rows, self.spacing_m.1) else { return };
        let along_y = GaussianFilter::new(rows, spacing_y_m, cutoff_m);
        let (mut buffers, mut column) = (along_y.buffers(), vec![0.0; rows]);
        for start in 0..self.columns {
            let places = || (start..).step_by(self.columns).take(rows);
            column.iter_mut().zip(places()).for_each(|(value, place)| *value = values[place]);
            along_y.smooth(&mut column, &mut buffers);
            column.iter().zip(places()).for_each(|(value, place)| values[place] = *value);
        }
    }

    /// Drops half a cut-off at each end of a profile.
    fn drop_ends(&mut self, cutoff_m: f64) {
        let dropped = (0.5 * cutoff_m / self.spacing_m.0).round() as usize;
        let kept = dropped..self.columns - dropped;
        self.heights_m = self.heights_m[kept.clone()].to_vec();
        self.measured = self.measured.take().map(|measured| measured[kept.clone()].to_vec());
        self.columns = kept.len();
    }
}

/// Returns true if no term is a combination of others at all points, from the sums of products of the terms over the points.
///
/// The pivots of the elimination are the squared distances of each term from the combinations of those before it. A pivot within
/// the rounding of the sums is none.
fn are_independent<const N: usize>(mut products: [[f64; N]; N], points: usize) -> bool {
    let rounding = 16.0 * f64::EPSILON * points as f64;
    let squares: [f64; N] = std::array::from_fn(|term| products[term][term]);
    for term in 0..N {
        let above = products[term];
        // NaN is not a distance either.
        let is_distance = above[term] > rounding * squares[term];
        if !is_distance {
            return false;
        }
        for row in &mut products[term + 1..] {
            let factor = row[term] / above[term];
            row.iter_mut().zip(above).for_each(|(product, above)| *product -= factor * above);
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use scans::{HeightMap, MeasuredScan, MissingPoints, Scan, UniformLineScan};

    use super::*;

    const SECOND_ORDER: Evaluation =
        Evaluation { form: FormRemoval::SecondOrder, longest_m: None, shortest_m: None };

    #[test]
    fn a_ball_and_a_bowl_are_forms_of_the_second_order() {
        let bowl = |at: usize| {
            let (x, y) = ((at % 30) as f64, (at / 30) as f64);
            1e-6 * (1.0 + 0.3 * x - 0.2 * y + 0.01 * x * x + 0.02 * x * y - 0.03 * y * y)
        };
        let map = Scan::Map(HeightMap::new(30, 1e-6, 2e-6, (0..600).map(bowl).collect()).unwrap());
        let missing: MissingPoints = (0..600).filter(|at| at % 7 == 3).collect();
        let arc = (0..50).map(|x| 1e-8 * f64::from(x * x)).collect();
        let line = Scan::UniformLine(UniformLineScan::new(1e-6, arc).unwrap());
        for scan in [MeasuredScan::with_missing_points(map, missing), line.into()] {
            let rest = ScaleLimitedSurface::new(&scan, &SECOND_ORDER).unwrap();
            assert!(rest.heights_m().flatten().all(|height_m| height_m.abs() < 1e-19), "{rest:?}");
        }
    }

    #[test]
    fn points_on_two_lines_keep_their_heights() {
        // Three points of each of two columns: as many as a form has numbers, which the lines do not determine.
        let points = [0, 2, 6, 8, 12, 18];
        let missing: MissingPoints = (0..20).filter(|at| !points.contains(at)).collect();
        let heights_m = (0..20).map(|at| if at == 2 { 3e-9 } else { 0.0 }).collect();
        let map = Scan::Map(HeightMap::new(4, 1e-7, 1e-7, heights_m).unwrap());
        let scan = MeasuredScan::with_missing_points(map, missing);
        let [rest, plane] = [FormRemoval::SecondOrder, FormRemoval::Plane].map(|form| {
            let relief = ScaleLimitedSurface::new(&scan, &Evaluation { form, ..SECOND_ORDER }).unwrap();
            relief.heights_m().collect::<Vec<_>>()
        });
        assert_eq!(rest, plane);
    }

    #[test]
    fn points_that_determine_no_form_keep_their_heights() {
        // One row of a map has heights.
        let missing: MissingPoints = (10..200).collect();
        let heights_m = (0..200).map(|at| if at % 2 == 0 { 1e-9 } else { -1e-9 }).collect();
        let map = Scan::Map(HeightMap::new(10, 1e-6, 1e-6, heights_m).unwrap());
        let rest = ScaleLimitedSurface::new(&MeasuredScan::with_missing_points(map, missing), &SECOND_ORDER)
            .unwrap();
        assert!(rest.heights_m().flatten().all(|height_m| height_m.abs() < 2e-9));
    }

    #[test]
    fn a_short_filter_drops_the_ends_of_a_profile_as_a_long_one_does() {
        // 25 cut-offs of waves of a quarter of the cut-off, of which 2^-16 passes in the middle, and 2.7 % at the very ends.
        let heights_m = (0..2500).map(|at| 1e-6 * (TAU * (f64::from(at) + 0.3) / 25.0).sin()).collect();
        let scan = Scan::UniformLine(UniformLineScan::new(1e-7, heights_m).unwrap());
        let evaluation =
            Evaluation { form: FormRemoval::None, shortest_m: Some(1e-5), ..Evaluation::default() };
        let rest = ScaleLimitedSurface::new(&scan.into(), &evaluation).unwrap();
        assert_eq!(rest.points(), (2400, None));
        let largest_m = rest.heights_m().flatten().map(f64::abs).fold(0.0, f64::max);
        assert!(largest_m < 4e-3 * 1e-6, "{largest_m}");
    }
}
