//! The transform of evenly spaced lines, and of maps line by line.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};

use crate::detrend::Trend;
use crate::independent_lines::{FIRST_BINS, independent_lines};
use crate::line::LineSpectrum;
use crate::preparation::Preparation;
use crate::rows::{BLOCK_ROWS, Rows};
use crate::sums::Spread;
use scans::{HeightMap, UniformLineScan};

/// The spectrum C1D of evenly spaced heights.
pub fn uniform_line_spectrum(scan: &UniformLineScan, preparation: Preparation) -> LineSpectrum {
    rows_spectrum(Rows::of_line(scan), preparation)
}

/// The mean of the spectra C1D of the rows of a map; with the feature `parallel` on all threads.
pub fn map_line_spectrum(map: &HeightMap, preparation: Preparation) -> LineSpectrum {
    rows_spectrum(Rows::of_map(map), preparation)
}

/// The mean of the spectra C1D of lines.
pub(crate) fn rows_spectrum(rows: Rows, preparation: Preparation) -> LineSpectrum {
    let lines = MapLines::of_rows(rows, preparation);
    let sums: Vec<LineSums> = parallel::map_indices(lines.blocks(), |block| lines.block(block));
    lines.spectrum(&sums)
}

/// The rows of a map, or other lines, in blocks, which may be transformed in any order and on any number of threads: their sums are added in
/// the order of the map, so every digit of the spectrum is the same.
pub struct MapLines<'a> {
    rows: Rows<'a>,
    preparation: Preparation,
    trend: Trend,
    transform: RowTransform,
}

/// Parts that a map is divided into across its lines, so that they can be told from each other.
const PARTS: usize = 8;

/// What a block of rows adds to the spectrum of a map.
#[derive(Clone, Debug)]
pub struct LineSums {
    /// For every part of the map that the block has rows of, its number and the power of these rows.
    power_of_parts_m2: Vec<(usize, Vec<f64>)>,
    variances_m2: f64,
    /// The first bins of each row, row after row.
    first_bins_m: Vec<Complex<f64>>,
}

impl<'a> MapLines<'a> {
    /// Fits the trend and plans the transform.
    pub fn new(map: &'a HeightMap, preparation: Preparation) -> Self {
        Self::of_rows(Rows::of_map(map), preparation)
    }

    pub(crate) fn of_rows(rows: Rows<'a>, preparation: Preparation) -> Self {
        let (trend, transform) =
            (rows.trend(preparation.detrend), RowTransform::new(rows.points, preparation));
        Self { rows, preparation, trend, transform }
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.rows.count().div_ceil(BLOCK_ROWS)
    }

    /// The sums of a block, counted from 0; nothing for blocks beyond the last.
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

    /// The part of the map that a row belongs to.
    fn part_of(&self, row: usize) -> usize {
        row * self.parts() / self.rows.count()
    }

    /// How many parts there are: one where each of several would be less than two rows.
    fn parts(&self) -> usize {
        if self.rows.count() >= 2 * PARTS { PARTS } else { 1 }
    }

    /// The spectrum from the sums of all blocks, in their order.
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
            LineSpectrum::of_even_spacing(spacing_m, points, lines, power_m2, variances_m2, flagged_bins)
        };
        let rows_of_part = |part| (0..lines).filter(|&row| self.part_of(row) == part).count();
        let several = parts_m2.into_iter().enumerate().filter(|_| self.parts() > 1);
        let of_parts =
            several.map(|(part, power_m2)| spectrum(rows_of_part(part), power_m2).c1d_m3).collect();
        let first_bins_m: Vec<&[Complex<f64>]> = sums.iter().map(|sums| &sums.first_bins_m[..]).collect();
        let independent = independent_lines(&first_bins_m.concat(), FIRST_BINS.min(points / 2));
        LineSpectrum { of_parts, independent, ..spectrum(lines, power_m2) }
    }
}

fn add(total: &mut [f64], part: &[f64]) {
    total.iter_mut().zip(part).for_each(|(total, part)| *total += part);
}

impl LineSums {
    /// The power of a part, whose rows come one after the other.
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
    /// The transform of the last row, n = 0, 1, ..., columns/2, not normalised.
    pub(crate) output: Vec<Complex<f64>>,
}

impl RowTransform {
    pub(crate) fn new(columns: usize, preparation: Preparation) -> Self {
        let plan = RealFftPlanner::new().plan_fft_forward(columns);
        Self {
            factors: preparation.window.factors(columns),
            input: plan.make_input_vec(),
            scratch: plan.make_scratch_vec(),
            output: plan.make_output_vec(),
            plan,
        }
    }

    /// Transforms a row and returns the spread in m of what was transformed.
    pub(crate) fn run(&mut self, trend: &Trend, row: usize, heights_m: &[f64]) -> Spread {
        let spread = trend.subtract(row, heights_m, &self.factors, &mut self.input);
        self.plan
            .process_with_scratch(&mut self.input, &mut self.output, &mut self.scratch)
            .expect("the buffers come from the plan");
        spread
    }
}
