//! Two maps that face each other, as one map that a flat is pressed onto.

use scans::{HeightMap, MeasuredScan, MissingPoints, Scan, ScanError};
use topography::{Detrend, detrended_m, without_trend_m};
use units::display::{length, three_digits};
use units::{Remark, RemarkCode};

/// Relative difference up to which spacings are the same.
const SAME_SPACING: f64 = 1e-6;
/// Ratio of the sizes of two maps from which a unit may be wrong.
const SIZES_APART: f64 = 3.0;

/// Heights on a grid, with missing points.
#[derive(Debug, Clone, PartialEq)]
pub struct PartialMap {
    /// Heights \[m\]; those of missing points mean nothing.
    pub map: HeightMap,
    /// Points without a height.
    pub missing: MissingPoints,
}

impl PartialMap {
    /// Adds the heights of a map that faces this one. The other map is turned over: its column i meets column n - 1 - i of this one,
    /// row by row. The sum covers the middle that both maps cover, with the finer spacing of the two along each axis; heights of the
    /// coarser map are interpolated linearly between its points. A point is missing where either map has no height.
    ///
    /// Exchanged maps have the mirror image of the sum. Only with equal spacings and an odd difference of their numbers of points the
    /// middles are half a point apart.
    ///
    /// # Errors
    /// [`ScanError`] for sums that are no heights.
    pub fn facing(&self, other: &Self) -> Result<Self, ScanError> {
        let axes = |of: &Self| {
            let map = &of.map;
            [(map.columns(), map.spacing_x_m()), (map.rows(), map.spacing_y_m())]
        };
        let ([own_x, own_y], [other_x, other_y]) = (axes(self), axes(other));
        let (along_x, along_y) = (Shared::of(own_x, other_x), Shared::of(own_y, other_y));
        let [own, faced] = [
            self.at(&along_x.places(own_x), &along_y.places(own_y)),
            other.at(&along_x.places(other_x), &along_y.places(other_y)),
        ];
        let columns = along_x.points;
        let sums_m: Vec<Option<f64>> = own
            .chunks(columns)
            .zip(faced.chunks(columns))
            .flat_map(|(own, faced)| own.iter().zip(faced.iter().rev()))
            .map(|(own_m, faced_m)| Some((*own_m)? + (*faced_m)?))
            .collect();
        let missing = (0..sums_m.len()).filter(|&point| sums_m[point].is_none()).collect();
        let heights_m = sums_m.iter().map(|sum_m| sum_m.unwrap_or(0.0)).collect();
        let map = HeightMap::new(columns, along_x.spacing_m, along_y.spacing_m, heights_m)?;
        Ok(Self { map, missing })
    }

    /// Returns true if both maps have the same points.
    #[must_use]
    pub fn has_grid_of(&self, other: &Self) -> bool {
        let (own, other) = (&self.map, &other.map);
        (own.columns(), own.rows()) == (other.columns(), other.rows())
            && are_same(own.spacing_x_m(), other.spacing_x_m())
            && are_same(own.spacing_y_m(), other.spacing_y_m())
    }

    /// Returns the heights \[m\] without the trend through the points that have one; 0 at missing points.
    #[must_use]
    pub fn detrended_m(&self, detrend: Detrend) -> Vec<f64> {
        if self.missing.is_empty() {
            return detrended_m(&self.map, detrend);
        }
        let scan = MeasuredScan::with_missing_points(Scan::Map(self.map.clone()), self.missing.clone());
        without_trend_m(&scan, detrend).into_iter().map(|rest_m| rest_m.unwrap_or(0.0)).collect()
    }

    /// Returns for each point, row by row, true if it is missing; nothing if none is.
    #[must_use]
    pub fn is_missing(&self) -> Vec<bool> {
        let points = if self.missing.is_empty() { 0 } else { self.map.heights_m().len() };
        (0..points).map(|point| self.missing.contains(point)).collect()
    }

    /// Notes what was done with two maps of these names to get this sum of them.
    #[must_use]
    pub fn remarks_on_sum(&self, own: (&str, &Self), other: (&str, &Self)) -> Vec<Remark> {
        let mut remark = Remark::new(RemarkCode::FacingMaps).with("own", own.0).with("other", other.0);
        if !own.1.has_grid_of(other.1) {
            let differ = format!(
                "{} has {}, {} has {}; the middle of both is pressed, {}",
                own.0,
                own.1.extent(),
                other.0,
                other.1.extent(),
                self.extent()
            );
            remark = remark.with("differ", differ);
        }
        let [ratio_x, ratio_y] = [0, 1].map(|axis| own.1.sides_m()[axis] / other.1.sides_m()[axis]);
        let is_apart = |ratio: f64| ratio.max(1.0 / ratio) >= SIZES_APART;
        let ratio = if is_apart(ratio_x) { ratio_x } else { ratio_y };
        let [larger, smaller] = if ratio > 1.0 { [own.0, other.0] } else { [other.0, own.0] };
        let apart = is_apart(ratio).then(|| {
            let ratio = three_digits(ratio.max(1.0 / ratio));
            Remark::new(RemarkCode::FacingSizesApart)
                .with("larger", larger)
                .with("smaller", smaller)
                .with("ratio", ratio)
        });
        std::iter::once(remark).chain(apart).collect()
    }

    /// Words its points and its size.
    pub(crate) fn extent(&self) -> String {
        let [x_m, y_m] = self.sides_m();
        format!("{} x {} points over {} x {}", self.map.columns(), self.map.rows(), length(x_m), length(y_m))
    }

    fn sides_m(&self) -> [f64; 2] {
        let map = &self.map;
        [map.columns() as f64 * map.spacing_x_m(), map.rows() as f64 * map.spacing_y_m()]
    }

    /// Heights \[m\] at places along x and along y, row by row; none where a point that counts is missing.
    fn at(&self, along_x: &[Place], along_y: &[Place]) -> Vec<Option<f64>> {
        let height_m = |row: usize, column: usize| {
            let point = row * self.map.columns() + column;
            (!self.missing.contains(point)).then(|| self.map.heights_m()[point])
        };
        let along_row = |row: usize, x: &Place| x.between(|column| height_m(row, column));
        along_y.iter().flat_map(|y| along_x.iter().map(|x| y.between(|row| along_row(row, x)))).collect()
    }
}

/// The points that two maps share along an axis.
struct Shared {
    points: usize,
    spacing_m: f64,
}

impl Shared {
    /// Shared points of two axes, each of two points or more at a spacing \[m\]: two at least.
    fn of(own: (usize, f64), other: (usize, f64)) -> Self {
        let spacing_m = own.1.min(other.1);
        let steps = |(points, of_axis_m): (usize, f64)| {
            // No further than the outermost points: nothing is known beyond them.
            let steps = (points - 1) as f64 * of_axis_m / spacing_m;
            if are_same(of_axis_m, spacing_m) { points - 1 } else { steps as usize }
        };
        let points = steps(own).min(steps(other)) + 1;
        // The middle of the coarser axis is met by interpolation: that of the finer one lies between two of its points, or on one.
        let finer = if own.1 <= other.1 { own.0 } else { other.0 };
        let is_between = !are_same(own.1, other.1) && (finer - points) % 2 == 1;
        Self { points: if is_between { points - 1 } else { points }, spacing_m }
    }

    /// Places of the shared points on an axis, around its middle.
    fn places(&self, (points, spacing_m): (usize, f64)) -> Vec<Place> {
        let step = self.spacing_m / spacing_m;
        let place = |at: usize| {
            if are_same(spacing_m, self.spacing_m) {
                return Place { first: (points - self.points) / 2 + at, share: 0.0 };
            }
            let from_middle = step * (at as f64 - 0.5 * (self.points - 1) as f64);
            let place = (0.5 * (points - 1) as f64 + from_middle).clamp(0.0, (points - 1) as f64);
            let first = (place as usize).min(points - 2);
            Place { first, share: place - first as f64 }
        };
        (0..self.points).map(place).collect()
    }
}

/// A place between two neighbouring points of an axis.
struct Place {
    first: usize,
    /// Share of the second point.
    share: f64,
}

impl Place {
    fn between(&self, height_m: impl Fn(usize) -> Option<f64>) -> Option<f64> {
        match self.share {
            0.0 => height_m(self.first),
            1.0 => height_m(self.first + 1),
            share => Some((1.0 - share) * height_m(self.first)? + share * height_m(self.first + 1)?),
        }
    }
}

fn are_same(one_m: f64, other_m: f64) -> bool {
    (one_m / other_m - 1.0).abs() <= SAME_SPACING
}
