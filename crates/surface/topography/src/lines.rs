//! The transform of evenly spaced lines, and of maps line by line.

use std::sync::Arc;

use numerics::transforms::{Complex, RealToComplex};

use crate::detrend::Trend;
use crate::line::LineSpectrum;
use crate::preparation::Preparation;
use crate::rows::{BLOCK_ROWS, Rows};
use crate::sums::Spread;
use scans::{HeightMap, UniformLineScan};

/// Computes the spectrum C1D of evenly spaced heights.
pub fn uniform_line_spectrum(scan: &UniformLineScan, preparation: Preparation) -> LineSpectrum {
    rows_spectrum(Rows::from_line(scan), preparation)
}

/// Computes the mean of the spectra C1D of the rows of a map; with the feature `parallel` on all threads.
pub fn map_line_spectrum(map: &HeightMap, preparation: Preparation) -> LineSpectrum {
    rows_spectrum(Rows::from_map(map), preparation)
}

/// Computes the mean of the spectra C1D of lines.
pub(crate) fn rows_spectrum(rows: Rows, preparation: Preparation) -> LineSpectrum {
    let lines = MapLines::from_rows(rows, preparation);
    let sums: Vec<LineSums> = numerics::parallel::map_indices(lines.blocks(), |block| lines.block(block));
    lines.spectrum(&sums)
}

/// The rows of a map, or other lines, in blocks, for any order and any number of threads. Sums are added in the order
/// of the map, so every digit of the spectrum is the same.
pub struct MapLines<'a> {
    rows: Rows<'a>,
    preparation: Preparation,
    trend: Trend,
    transform: RowTransform,
}

/// Number of parts of a map, groups of neighbouring lines whose spectra are kept apart.
const PARTS: usize = 8;

/// Contribution of a block of rows to the spectrum of a map.
#[derive(Clone, Debug)]
pub struct LineSums {
    /// Power of the block's rows for each part of the map, as (part, power).
    power_of_parts_m2: Vec<(usize, Vec<f64>)>,
    variances_m2: f64,
    /// The first bins of each row, row after row.
    first_bins_m: Vec<Complex<f64>>,
}

impl<'a> MapLines<'a> {
    /// Fits the trend and plans the transform.
    pub fn new(map: &'a HeightMap, preparation: Preparation) -> Self {
        Self::from_rows(Rows::from_map(map), preparation)
    }

    pub(crate) fn from_rows(rows: Rows<'a>, preparation: Preparation) -> Self {
        let (trend, transform) =
            (rows.trend(preparation.detrend), RowTransform::new(rows.points, preparation));
        Self { rows, preparation, trend, transform }
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.rows.count().div_ceil(BLOCK_ROWS)
    }

    /// Sums a block, counted from 0; empty for blocks beyond the last.
    pub fn block(&self, block: usize) -> LineSums {
        let mut transform = self.transform.clone();
        let bins = self.rows.points / 2;
        let mut sums =
            LineSums { power_of_parts_m2: Vec::new(), variances_m2: 0.0, first_bins_m: Vec::new() };
        for (row, heights_m) in self.rows.block(block) {
            sums.variances_m2 += transform.run(&self.trend, row, heights_m).variance();
            let values = &transform.output[1..];
            let power_m2 = sums.power_of_part_m2(self.part_of(row), bins);
            power_m2.iter_mut().zip(values).for_each(|(power_m2, value)| *power_m2 += value.norm_sqr());
            if self.rows.count() > 1 {
                sums.first_bins_m.extend(&values[..bins.min(FIRST_BINS)]);
            }
        }
        sums
    }

    /// Returns the part of the map that a row belongs to.
    fn part_of(&self, row: usize) -> usize {
        row * self.parts() / self.rows.count()
    }

    /// Number of parts; one if several would have fewer than two rows each.
    fn parts(&self) -> usize {
        if self.rows.count() >= 2 * PARTS { PARTS } else { 1 }
    }

    /// Assembles the spectrum from the sums of all blocks, in their order.
    pub fn spectrum(&self, sums: &[LineSums]) -> LineSpectrum {
        let mut parts_m2 = vec![vec![0.0; self.rows.points / 2]; self.parts()];
        for (part, of_block_m2) in sums.iter().flat_map(|sums| &sums.power_of_parts_m2) {
            add(&mut parts_m2[*part], of_block_m2);
        }
        let mut power_m2 = vec![0.0; self.rows.points / 2];
        parts_m2.iter().for_each(|of_part_m2| add(&mut power_m2, of_part_m2));
        let variances_m2 = sums.iter().map(|sums| sums.variances_m2).sum();
        let Rows { spacing_m, points, .. } = self.rows;
        let flagged_bins = self.preparation.flagged_bins();
        let lines = self.rows.count();
        let spectrum = |lines, power_m2| {
            LineSpectrum::from_even_lines(spacing_m, points, lines, power_m2, variances_m2, flagged_bins)
        };
        let rows_of_part = |part| (0..lines).filter(|&row| self.part_of(row) == part).count();
        let several = parts_m2.into_iter().enumerate().filter(|_| self.parts() > 1);
        let parts_m3 =
            several.map(|(part, power_m2)| spectrum(rows_of_part(part), power_m2).c1d_m3).collect();
        let first_bins_m: Vec<&[Complex<f64>]> = sums.iter().map(|sums| &sums.first_bins_m[..]).collect();
        let independent = independent_lines(&first_bins_m.concat(), FIRST_BINS.min(points / 2));
        LineSpectrum { parts_m3, independent, ..spectrum(lines, power_m2) }
    }
}

fn add(total: &mut [f64], part: &[f64]) {
    total.iter_mut().zip(part).for_each(|(total, part)| *total += part);
}

impl LineSums {
    /// Returns the power of a part; rows of a part are consecutive.
    fn power_of_part_m2(&mut self, part: usize, bins: usize) -> &mut [f64] {
        if self.power_of_parts_m2.last().is_none_or(|(last, _)| *last != part) {
            self.power_of_parts_m2.push((part, vec![0.0; bins]));
        }
        let last = self.power_of_parts_m2.len() - 1;
        &mut self.power_of_parts_m2[last].1
    }
}

/// Detrends, windows and transforms one row after the other.
#[derive(Clone)]
pub(crate) struct RowTransform {
    factors: Vec<f64>,
    plan: Arc<dyn RealToComplex<f64>>,
    input: Vec<f64>,
    scratch: Vec<Complex<f64>>,
    /// Unnormalised transform of the last row, n = 0, 1, ..., columns/2.
    pub(crate) output: Vec<Complex<f64>>,
}

impl RowTransform {
    pub(crate) fn new(columns: usize, preparation: Preparation) -> Self {
        let plan = numerics::transforms::forward_of_real(columns);
        Self {
            factors: preparation.window.factors(columns),
            input: plan.make_input_vec(),
            scratch: plan.make_scratch_vec(),
            output: plan.make_output_vec(),
            plan,
        }
    }

    /// Transforms a row and returns the spread of the prepared heights \[m\].
    pub(crate) fn run(&mut self, trend: &Trend, row: usize, heights_m: &[f64]) -> Spread {
        let spread = trend.subtract(row, heights_m, &self.factors, &mut self.input);
        self.plan
            .process_with_scratch(&mut self.input, &mut self.output, &mut self.scratch)
            .expect("the buffers come from the plan");
        spread
    }
}

/// Number of first bins in which the independent lines are measured. Beyond them a square map has far more than a
/// hundred, whose number hardly matters.
const FIRST_BINS: usize = 64;

/// Estimates the number of independent lines for each of the first bins, from their values row by row, `bins` per row;
/// empty without rows.
///
/// Across the lines a bin is a sum of waves with independent random amplitudes, whose powers s add up to the mean over
/// the lines. For M waves of equal expectation (Sum s)^2/Sum s^2 is about (M + 1)/2, because the mean square of an
/// exponential variable is twice its squared mean. Hence the estimate 2 (Sum s)^2/Sum s^2 - 1.
fn independent_lines(values: &[Complex<f64>], bins: usize) -> Vec<f64> {
    if values.is_empty() {
        return Vec::new();
    }
    let rows = values.len() / bins;
    let transform = numerics::transforms::forward(rows);
    let mut across = vec![Complex::default(); rows];
    let of_bin = |bin: usize| {
        across.iter_mut().zip(values[bin..].iter().step_by(bins)).for_each(|(to, from)| *to = *from);
        transform.process(&mut across);
        let powers = || across.iter().map(Complex::norm_sqr);
        let (sum, squares) = (powers().sum::<f64>(), powers().map(|power| power * power).sum::<f64>());
        if squares > 0.0 { 2.0 * (sum * (sum / squares)) - 1.0 } else { 1.0 }
    };
    (0..bins).map(of_bin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of one wave across, or of several of equal power.
    fn rows(waves: &[usize], rows: usize) -> Vec<Complex<f64>> {
        let phase = |row: usize, wave: usize| {
            Complex::cis(std::f64::consts::TAU * ((row * wave) % rows) as f64 / rows as f64 + wave as f64)
        };
        (0..rows).map(|row| waves.iter().map(|&wave| phase(row, wave)).sum()).collect()
    }

    #[test]
    fn equal_waves_are_counted() {
        // For powers that do not scatter, the formula yields twice their number less one.
        assert!((independent_lines(&rows(&[3], 64), 1)[0] - 1.0).abs() < 1e-12);
        assert!((independent_lines(&rows(&[1, 5, 9, 20], 64), 1)[0] - 7.0).abs() < 1e-12);
        assert!(independent_lines(&[], 8).is_empty());
    }
}
