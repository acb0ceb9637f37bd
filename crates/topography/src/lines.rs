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
    power_m2: Vec<f64>,
    variances_m2: f64,
    /// The same power for every part of the map that the block has rows of, with the part's number.
    power_of_parts_m2: Vec<(usize, Vec<f64>)>,
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
        let mut sums = LineSums {
            power_m2: vec![0.0; bins],
            variances_m2: 0.0,
            power_of_parts_m2: Vec::new(),
            first_bins_m: Vec::new(),
        };
        for (row, heights_m) in self.rows.block(block) {
            sums.variances_m2 += transform.run(&self.trend, row, heights_m).variance();
            let values = &transform.output[1..];
            add_power(&mut sums.power_m2, values);
            if let Some(part) = self.part_of(row) {
                add_power(sums.part(part, bins), values);
            }
            if self.rows.count() > 1 {
                sums.first_bins_m.extend(&values[..bins.min(FIRST_BINS)]);
            }
        }
        sums
    }

    /// The part of the map that a row belongs to; none where each part would be less than two rows.
    fn part_of(&self, row: usize) -> Option<usize> {
        let rows = self.rows.count();
        (rows >= 2 * PARTS).then(|| row * PARTS / rows)
    }

    /// The spectrum from the sums of all blocks, in their order.
    pub fn spectrum(&self, sums: &[LineSums]) -> LineSpectrum {
        let mut power_m2 = vec![0.0; self.rows.points / 2];
        for sums in sums {
            power_m2.iter_mut().zip(&sums.power_m2).for_each(|(total, part)| *total += part);
        }
        let variances_m2 = sums.iter().map(|sums| sums.variances_m2).sum();
        let Rows { spacing_m, points, .. } = self.rows;
        let flagged_bins = self.preparation.flagged_bins();
        let lines = self.rows.count();
        let spectrum = |lines, power_m2| {
            LineSpectrum::of_even_spacing(spacing_m, points, lines, power_m2, variances_m2, flagged_bins)
        };
        let rows_of_part = |part| (0..lines).filter(|&row| self.part_of(row) == Some(part)).count();
        let parts = power_of_parts_m2(sums, points / 2).into_iter().enumerate();
        let of_parts = parts.map(|(part, power_m2)| spectrum(rows_of_part(part), power_m2).c1d_m3).collect();
        let first_bins_m: Vec<&[Complex<f64>]> = sums.iter().map(|sums| &sums.first_bins_m[..]).collect();
        let independent = independent_lines(&first_bins_m.concat(), FIRST_BINS.min(points / 2));
        LineSpectrum { of_parts, independent, ..spectrum(lines, power_m2) }
    }
}

fn add_power(power_m2: &mut [f64], values: &[Complex<f64>]) {
    power_m2.iter_mut().zip(values).for_each(|(power_m2, value)| *power_m2 += value.norm_sqr());
}

impl LineSums {
    /// The power of a part, of which rows come one after the other.
    fn part(&mut self, part: usize, bins: usize) -> &mut [f64] {
        if self.power_of_parts_m2.last().is_none_or(|(last, _)| *last != part) {
            self.power_of_parts_m2.push((part, vec![0.0; bins]));
        }
        let last = self.power_of_parts_m2.len() - 1;
        &mut self.power_of_parts_m2[last].1
    }
}

/// The power of every part of a map; none where it has no parts.
fn power_of_parts_m2(sums: &[LineSums], bins: usize) -> Vec<Vec<f64>> {
    let mut parts: Vec<Vec<f64>> = Vec::new();
    for (part, power_m2) in sums.iter().flat_map(|sums| &sums.power_of_parts_m2) {
        parts.resize_with(parts.len().max(part + 1), || vec![0.0; bins]);
        parts[*part].iter_mut().zip(power_m2).for_each(|(total, of_block)| *total += of_block);
    }
    parts
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
