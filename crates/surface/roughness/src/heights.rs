//! Heights: areal parameters of ISO 25178-2, those of profiles of ISO 21920-2.

use scans::MeasuredScan;
use topography::Form;

use crate::parameter::{Parameter, ParameterValue};
use crate::relief::{Evaluation, ScaleLimitedSurface};

/// Number of sections of a profile over which Rz averages.
pub(crate) const SECTIONS: usize = 5;

/// Rounding of heights, relative to the largest as measured.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Height parameters of a map or a profile.
///
/// With z from the mean of all N points that have a height, all weighted alike:
/// Sa = mean |z|, Sq = sqrt(mean z^2), Ssk = mean z^3/Sq^3, Sku = mean z^4/Sq^4, Sp = max z, Sv = -min z, Sz = Sp + Sv
/// (ISO 25178-2), and Ra, Rq, Rsk, Rku, Rp, Rv, Rt the same of a profile, over its whole length (ISO 21920-2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct HeightParameters {
    /// Map or profile, which decides the symbols.
    pub extent: EvaluatedExtent,
    /// Sa or Ra: mean of |z| in m.
    pub mean_deviation_m: f64,
    /// Sq or Rq: root mean square of z in m.
    pub rms_m: f64,
    /// Ssk or Rsk; none of a surface that is flat within rounding.
    pub skewness: Option<f64>,
    /// Sku or Rku, 3 of Gaussian heights; none of a surface that is flat within rounding.
    pub kurtosis: Option<f64>,
    /// Sp or Rp: highest z in m.
    pub peak_m: f64,
    /// Sv or Rv: lowest z in m, counted downwards.
    pub valley_m: f64,
    /// Rz of a profile in m: mean over five sections of equal length of the highest minus the lowest z; none where a
    /// section has no heights.
    pub mean_section_height_m: Option<f64>,
    /// Number of points with a height.
    pub points: usize,
    /// Number of points without a height, which are left out.
    pub missing: usize,
}

/// Extent of the heights that parameters describe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EvaluatedExtent {
    /// A map: parameters begin with S.
    Areal,
    /// A line: parameters begin with R.
    Profile,
}

impl HeightParameters {
    /// Computes the parameters of a scan after its least-squares plane or line has been subtracted; none where no point
    /// has a height. Heights of a map are not copied, which would double the memory of a large one.
    #[must_use]
    pub fn from_scan(scan: &MeasuredScan) -> Option<Self> {
        if scan.points().1.is_none() {
            return ScaleLimitedSurface::new(scan, &Evaluation::default())
                .ok()
                .map(|relief| Self::from_relief(&relief));
        }
        let form = Form::fit(scan);
        let removed_m = || form.removed_m(scan).flatten();
        let count = removed_m().count();
        if count == 0 {
            return None;
        }
        // As for a relief: the second mean is what rounding left of the first.
        let mean_of = |sum_m: f64| sum_m / count as f64;
        let first_m = mean_of(removed_m().fold(0.0, |sum_m, height_m| sum_m + height_m));
        let second_m = mean_of(removed_m().fold(0.0, |sum_m, height_m| sum_m + (height_m - first_m)));
        let largest_given_m =
            scan.heights_m().flatten().fold(0.0, |largest: f64, height_m| largest.max(height_m.abs()));
        Some(Self::from_heights(
            EvaluatedExtent::Areal,
            largest_given_m,
            scan.missing_points().count(),
            || removed_m().map(|height_m| (height_m - first_m) - second_m),
        ))
    }

    /// Computes the parameters of prepared heights.
    #[must_use]
    pub fn from_relief(relief: &ScaleLimitedSurface) -> Self {
        let extent =
            if relief.points().1.is_some() { EvaluatedExtent::Areal } else { EvaluatedExtent::Profile };
        let heights_m = || relief.heights_m().flatten();
        let found = Self::from_heights(extent, relief.largest_given_m, relief.missing(), heights_m);
        let mean_section_height_m =
            (extent == EvaluatedExtent::Profile).then(|| mean_section_height_m(relief)).flatten();
        Self { mean_section_height_m, ..found }
    }

    fn from_heights<H: Iterator<Item = f64>>(
        extent: EvaluatedExtent,
        largest_given_m: f64,
        missing: usize,
        heights_m: impl Fn() -> H,
    ) -> Self {
        let (mut points, mut ends_m) = (0, Ends::NONE);
        for height_m in heights_m() {
            points += 1;
            ends_m.add(height_m);
        }
        let total_m = ends_m.distance_m().unwrap_or(0.0);
        // In units of the total height, so that heights in nm do not lose their fourth powers to underflow.
        let unit_m = if total_m > 0.0 { total_m } else { 1.0 };
        let mut sums = [0.0; 4];
        for height_m in heights_m() {
            let z = height_m / unit_m;
            let square = z * z;
            sums = [sums[0] + z.abs(), sums[1] + square, sums[2] + square * z, sums[3] + square * square];
        }
        let [deviation, variance, third, fourth] = sums.map(|sum| sum / points as f64);
        let rms = variance.sqrt();
        // Below the normal doubles rounding does not shrink with the numbers.
        let is_rough = rms * unit_m > ROUNDING * largest_given_m.max(f64::MIN_POSITIVE);
        Self {
            extent,
            mean_deviation_m: deviation * unit_m,
            rms_m: rms * unit_m,
            skewness: is_rough.then(|| third / (variance * rms)),
            kurtosis: is_rough.then(|| fourth / (variance * variance)),
            peak_m: ends_m.highest_m,
            valley_m: -ends_m.lowest_m,
            mean_section_height_m: None,
            points,
            missing,
        }
    }

    /// Sz or Rt: highest minus lowest z in m.
    #[must_use]
    pub fn total_height_m(&self) -> f64 {
        self.peak_m + self.valley_m
    }

    /// Lists the parameters by their symbols, without those that have no value.
    #[must_use]
    pub fn parameters(&self) -> Vec<Parameter> {
        use ParameterValue::{LengthM, Number};
        let [mean, rms, skewness, kurtosis, peak, valley, total] = match self.extent {
            EvaluatedExtent::Areal => ["Sa", "Sq", "Ssk", "Sku", "Sp", "Sv", "Sz"],
            EvaluatedExtent::Profile => ["Ra", "Rq", "Rsk", "Rku", "Rp", "Rv", "Rt"],
        };
        let values = [
            (mean, Some(LengthM(self.mean_deviation_m))),
            (rms, Some(LengthM(self.rms_m))),
            (skewness, self.skewness.map(Number)),
            (kurtosis, self.kurtosis.map(Number)),
            (peak, Some(LengthM(self.peak_m))),
            (valley, Some(LengthM(self.valley_m))),
            (total, Some(LengthM(self.total_height_m()))),
        ];
        let given = |(symbol, value): (_, Option<_>)| Some(Parameter::new(symbol, value?));
        let sections =
            self.mean_section_height_m.map(|rz_m| Parameter::new("Rz", LengthM(rz_m)).by("five sections"));
        values.into_iter().filter_map(given).chain(sections).collect()
    }
}

/// Computes Ra and Rq as ISO 4287 did, as means over the sections of a profile; none where a section has no heights.
pub(crate) fn section_means_m(relief: &ScaleLimitedSurface) -> Option<[f64; 2]> {
    let mut sums = [[0.0; 3]; SECTIONS];
    for (section, height_m) in in_sections(relief) {
        let [count, deviation_m, square_m2] = sums[section];
        sums[section] = [count + 1.0, deviation_m + height_m.abs(), square_m2 + height_m * height_m];
    }
    let means: Option<Vec<[f64; 2]>> = sums
        .iter()
        .map(|[count, deviation_m, square_m2]| {
            (*count > 0.0).then(|| [deviation_m / count, (square_m2 / count).sqrt()])
        })
        .collect();
    means.map(|means| [0, 1].map(|of| means.iter().map(|mean| mean[of]).sum::<f64>() / SECTIONS as f64))
}

/// Iterates over the heights \[m\] of a profile with their sections of equal length.
fn in_sections(relief: &ScaleLimitedSurface) -> impl Iterator<Item = (usize, f64)> + '_ {
    let points = relief.points().0;
    let share = move |index: usize| match &relief.positions_m {
        Some(positions_m) => {
            (positions_m[index] - positions_m[0]) / (positions_m[points - 1] - positions_m[0])
        }
        None => index as f64 / points as f64,
    };
    relief.heights_m().enumerate().filter_map(move |(index, height_m)| {
        Some((((share(index) * SECTIONS as f64) as usize).min(SECTIONS - 1), height_m?))
    })
}

fn mean_section_height_m(relief: &ScaleLimitedSurface) -> Option<f64> {
    let mut sections = [Ends::NONE; SECTIONS];
    in_sections(relief).for_each(|(section, height_m)| sections[section].add(height_m));
    let total_m: Option<f64> = sections.iter().map(Ends::distance_m).sum();
    total_m.map(|total_m| total_m / SECTIONS as f64)
}

/// The lowest and the highest of some heights \[m\].
#[derive(Debug, Clone, Copy)]
struct Ends {
    lowest_m: f64,
    highest_m: f64,
}

impl Ends {
    /// The ends of no heights.
    const NONE: Ends = Ends { lowest_m: f64::INFINITY, highest_m: f64::NEG_INFINITY };

    fn add(&mut self, height_m: f64) {
        self.lowest_m = self.lowest_m.min(height_m);
        self.highest_m = self.highest_m.max(height_m);
    }

    /// The distance of both; none without heights.
    fn distance_m(&self) -> Option<f64> {
        (self.lowest_m <= self.highest_m).then_some(self.highest_m - self.lowest_m)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use approx::assert_relative_eq;
    use scans::{HeightMap, MissingPoints, NonuniformLineScan, Scan, UniformLineScan};

    use super::*;

    const AMPLITUDE_M: f64 = 10e-9;

    fn parameters(scan: Scan) -> HeightParameters {
        HeightParameters::from_scan(&scan.into()).unwrap()
    }

    fn line(height_m: impl Fn(f64) -> f64, points: usize) -> Scan {
        Scan::UniformLine(
            UniformLineScan::new(1e-9, (0..points).map(|index| height_m(index as f64)).collect()).unwrap(),
        )
    }

    /// A cosine over whole periods about its middle, which has no slope of its own.
    fn cosine_m(index: f64) -> f64 {
        AMPLITUDE_M * (TAU * (index + 0.5) / 1000.0).cos()
    }

    #[test]
    fn a_wave_has_its_closed_forms_as_map_and_profile_whatever_its_tilt() {
        let heights_m = (0..20_000).map(|index| cosine_m((index % 10_000) as f64)).collect();
        let map = Scan::Map(HeightMap::new(10_000, 1e-9, 1e-9, heights_m).unwrap());
        let tilted = line(|index| cosine_m(index) + 1e-6 + 3e-10 * index, 10_000);
        for found in [parameters(map), parameters(line(cosine_m, 10_000)), parameters(tilted)] {
            assert_relative_eq!(found.mean_deviation_m, 2.0 * AMPLITUDE_M / PI, max_relative = 1e-5);
            assert_relative_eq!(found.rms_m, AMPLITUDE_M / 2f64.sqrt(), max_relative = 1e-9);
            assert!(found.skewness.unwrap().abs() < 1e-9);
            assert_relative_eq!(found.kurtosis.unwrap(), 1.5, max_relative = 1e-9);
            assert_relative_eq!(found.total_height_m(), 2.0 * AMPLITUDE_M, max_relative = 1e-5);
            if let Some(rz_m) = found.mean_section_height_m {
                assert_relative_eq!(rz_m, 2.0 * AMPLITUDE_M, max_relative = 1e-5);
            }
        }
    }

    #[test]
    fn gaussian_heights_have_their_ratios() {
        // Quantiles of the normal distribution, in an order without a trend.
        use statrs::distribution::{ContinuousCDF, Normal};
        let normal = Normal::standard();
        let points = 20_000;
        let height_m = |index: f64| {
            1e-9 * normal.inverse_cdf(((index as usize * 7919) % points) as f64 / points as f64 + 2.5e-5)
        };
        let found = parameters(line(height_m, points));
        assert_relative_eq!(found.mean_deviation_m / found.rms_m, (2.0 / PI).sqrt(), max_relative = 1e-3);
        assert!((found.kurtosis.unwrap() - 3.0).abs() < 0.02);
        assert!(found.skewness.unwrap().abs() < 1e-3);
    }

    #[test]
    fn missing_points_are_left_out_of_form_and_heights_and_counted() {
        let (columns, rows) = (40, 30);
        let rough_m =
            |index: usize| if (index / columns + index % columns).is_multiple_of(2) { 1e-9 } else { -1e-9 };
        let tilt_m = |index: usize| 1e-8 * (index % columns) as f64 - 2e-8 * (index / columns) as f64;
        let missing: MissingPoints = (0..columns * rows).filter(|index| index % columns < 10).collect();
        let heights_m = (0..columns * rows).map(|index| rough_m(index) + tilt_m(index)).collect();
        let map = Scan::Map(HeightMap::new(columns, 1e-6, 1e-6, heights_m).unwrap());
        let scan = MeasuredScan::with_missing_points(map, missing);
        let found = HeightParameters::from_scan(&scan).unwrap();
        assert_eq!((found.points, found.missing), (900, 300));
        // A copy of the heights gives the same digits.
        let relief = ScaleLimitedSurface::new(&scan, &Evaluation::default()).unwrap();
        assert_eq!(found, HeightParameters::from_relief(&relief));
        assert_relative_eq!(found.rms_m, 1e-9, max_relative = 1e-5);
        let symbols: Vec<_> = found.parameters().iter().map(|parameter| parameter.symbol).collect();
        assert_eq!(symbols, ["Sa", "Sq", "Ssk", "Sku", "Sp", "Sv", "Sz"]);
    }

    #[test]
    fn a_scan_without_heights_has_no_parameters_and_a_flat_one_no_shape() {
        let nothing = MeasuredScan::with_missing_points(line(|_| 0.0, 4), (0..4).collect());
        assert_eq!(HeightParameters::from_scan(&nothing), None);
        let flat = parameters(line(|index| 2e-9 * index, 8));
        assert_eq!((flat.skewness, flat.kurtosis), (None, None));
        assert!(flat.rms_m < 1e-23);
    }

    #[test]
    fn sections_of_an_uneven_line_have_equal_lengths() {
        // Four dense points and a spike in the first fifth, one point in each other fifth.
        let positions_m = vec![0.0, 0.1, 0.2, 0.3, 1.5, 2.5, 3.5, 5.0];
        let uneven =
            NonuniformLineScan::new(positions_m, vec![0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).unwrap();
        let found = parameters(Scan::NonuniformLine(uneven));
        assert!((found.mean_section_height_m.unwrap() - 1.0).abs() < 0.05, "{found:?}");
    }
}
