//! The median over the lines of a map instead of their mean, which a few outlying lines do not move.

use statrs::function::gamma::digamma;

use crate::line::LineSpectrum;
use crate::lines::RowTransform;
use crate::preparation::Preparation;
use crate::rows::Rows;

/// Median over mean of chi-squared numbers with one degree of freedom, as the real Nyquist wave has it.
const OF_NYQUIST: f64 = 0.454_936_423_119_573;
/// Quartile distance over median of a power below which all lines share a wave, which does not scatter; that of
/// chi-squared numbers with two degrees of freedom is ln 3/ln 2.
const SHARED: f64 = 0.8;

/// Fewest lines of which a median is taken.
pub(crate) const LEAST_LINES: usize = 3;

/// Replaces the means over lines by medians, divided by the median of chi-squared numbers of that mean.
///
/// The power of a Fourier sample of a line is chi-squared with two degrees of freedom. The median of N such numbers has the
/// expectation psi(N + 1) - psi((N + 1)/2), ln 2 for many; N counts independent lines. Of waves that are the same in all lines
/// median and mean agree.
pub(crate) fn median_spectrum(rows: Rows, spectrum: LineSpectrum, preparation: Preparation) -> LineSpectrum {
    let count = rows.count();
    let bins = spectrum.c1d_m3.len();
    let trend = rows.trend(preparation.detrend);
    let mut transform = RowTransform::new(rows.points, preparation);
    let unit_m = rows.spacing_m / rows.points as f64;
    let mut powers_m3 = vec![0.0; bins * count];
    for (row, heights_m) in rows.iter().enumerate() {
        transform.run(&trend, row, heights_m);
        for (bin, value) in transform.output[1..].iter().enumerate() {
            powers_m3[bin * count + row] = unit_m * value.norm_sqr();
        }
    }
    let parts = spectrum.parts_m3.len();
    let median_of = |bin: usize, from: usize, to: usize| {
        let share = (to - from) as f64 / count as f64;
        let lines = (share * spectrum.independent_lines(bin + 1)).max(1.0);
        let is_nyquist = spectrum.ends_at_nyquist && bin + 1 == bins;
        let mut sorted = powers_m3[bin * count + from..bin * count + to].to_vec();
        sorted.sort_by(f64::total_cmp);
        let quantile = |quarters: usize| {
            let at = quarters * (sorted.len() - 1);
            0.5 * (sorted[at / 4] + sorted[at.div_ceil(4)])
        };
        let middle = quantile(2);
        match middle > 0.0 && quantile(3) - quantile(1) > SHARED * middle {
            true if is_nyquist => middle / OF_NYQUIST,
            true => middle / (digamma(lines + 1.0) - digamma(0.5 * (lines + 1.0))),
            false => middle,
        }
    };
    let all = |from: usize, to: usize| (0..bins).map(|bin| median_of(bin, from, to)).collect::<Vec<f64>>();
    let first_of = |part: usize| (part * count).div_ceil(parts.max(1));
    let parts_m3 = (0..parts).map(|part| all(first_of(part), first_of(part + 1))).collect();
    let median = LineSpectrum { c1d_m3: all(0, count), parts_m3, ..spectrum };
    // The heights that the spectrum stands for are no longer those of all lines.
    LineSpectrum { variance_m2: median.spectral_variance_m2(), ..median }
}
