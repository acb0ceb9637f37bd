//! Narrow lines in the spectrum of a scan: waves of one length, as turning, milling and gratings leave.

use std::f64::consts::TAU;

use numerics::transforms::Complex;
use scans::{HeightMap, Scan};
use units::{Remark, RemarkCode};

use crate::detrend::Detrend;
use crate::line::LineSpectrum;
use crate::lines::{RowTransform, rows_spectrum};
use crate::preparation::{Preparation, Window};
use crate::rows::Rows;

/// Ratio of a line to the samples on either side of it. Of exponential noise one sample in e^21 stands so far above the median.
const ABOVE: f64 = 30.0;
/// Samples on either side of a line that tell what it rises from.
const FLANK: usize = 8;
/// Fewest waves on the length of a scan that are told from drift.
const LEAST_WAVES: usize = 5;
/// Share of the variance from which on a line is named.
const LARGE_SHARE: f64 = 0.3;
/// Pairs of columns of a map in which lines along them are sought.
const COLUMN_PAIRS: usize = 32;

/// A line that carries a large share of the variance of a scan.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NarrowLine {
    /// Length of the waves \[m\]; for a profile along the trace.
    pub wavelength_m: f64,
    /// Share of the variance of the heights, as detrended and windowed.
    pub share: f64,
    /// Angle between the rows of a map and the direction in which the waves follow each other, from -90 to 90 degrees.
    pub angle_degrees: Option<f64>,
}

/// Samples of a spectrum that belong to one line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Peak {
    /// Number n of its highest sample.
    pub(crate) highest: usize,
    /// Number n of its first sample and the power \[m^3\] of each beyond that of the samples beside the line.
    pub(crate) first: usize,
    pub(crate) powers_m3: Vec<f64>,
}

impl Peak {
    /// Number of waves on the length of the scan.
    fn waves(&self) -> f64 {
        let numbered = self.powers_m3.iter().zip(self.first..);
        let moment: f64 = numbered.map(|(power_m3, n)| power_m3 * n as f64).sum();
        moment / self.powers_m3.iter().sum::<f64>()
    }

    fn share(&self, spectrum: &LineSpectrum) -> f64 {
        2.0 / spectrum.length_m * self.powers_m3.iter().sum::<f64>() / spectrum.variance_m2
    }
}

/// Finds the lines of a spectrum: samples that stand far above those on either side, beyond the width of the window. Drift and
/// roughness without a roll-off rise towards long waves, and so do not stand above their longer neighbours.
pub(crate) fn peaks(spectrum: &LineSpectrum, window: Window) -> Vec<Peak> {
    let half_width = if window == Window::Hann { 2 } else { 1 };
    let c1d_m3 = &spectrum.c1d_m3;
    let of_sample = |at: usize| {
        let value_m3 = c1d_m3[at];
        let is_highest = value_m3 > 0.0 && value_m3 >= c1d_m3[at - 1] && value_m3 > c1d_m3[at + 1];
        if !is_highest {
            return None;
        }
        let before = at - half_width;
        let behind = (at + half_width + 1).min(c1d_m3.len());
        let flanks = [before.saturating_sub(FLANK)..before, behind..(behind + FLANK).min(c1d_m3.len())];
        let levels = flanks.map(|flank| median(&c1d_m3[flank]));
        let level_m3 = levels[0].max(levels[1]);
        (value_m3 > ABOVE * level_m3).then(|| Peak {
            highest: at + 1,
            first: before + 1,
            powers_m3: c1d_m3[before..behind].iter().map(|c1d_m3| (c1d_m3 - level_m3).max(0.0)).collect(),
        })
    };
    (LEAST_WAVES - 1..c1d_m3.len().saturating_sub(1)).filter_map(of_sample).collect()
}

/// The upper median; 0 for no values.
fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

impl NarrowLine {
    /// Finds the line of a scan with the largest share, if that is large; of a map also one along its columns.
    pub(crate) fn find(scan: &Scan, spectrum: &LineSpectrum, preparation: Preparation) -> Option<Self> {
        let along = Self::largest(spectrum, preparation);
        let Scan::Map(map) = scan else {
            return along.map(|(peak, share)| Self {
                wavelength_m: spectrum.length_m / peak.waves(),
                share,
                angle_degrees: None,
            });
        };
        let columns = columns_in_pairs(map);
        let detrend = if preparation.detrend == Detrend::Plane { Detrend::Line } else { preparation.detrend };
        let of_columns = Preparation { detrend, ..preparation };
        let spectrum_of_columns =
            columns.as_ref().map(|columns| rows_spectrum(Rows::from_map(columns), of_columns));
        let across = spectrum_of_columns.as_ref().and_then(|spectrum| Self::largest(spectrum, of_columns));
        let share_of = |found: &Option<(Peak, f64)>| found.as_ref().map_or(0.0, |(_, share)| *share);
        if share_of(&along) >= share_of(&across) {
            let (peak, share) = along?;
            let turn = turn_between_rows(&Rows::from_map(map), preparation, peak.highest, 1);
            let q = [TAU * peak.waves() / spectrum.length_m, turn / map.spacing_y_m()];
            Some(Self::of_wave(q, share))
        } else {
            let ((peak, share), columns) = (across?, columns?);
            let turn = turn_between_rows(&Rows::from_map(&columns), of_columns, peak.highest, 2);
            let length_m = map.spacing_y_m() * map.rows() as f64;
            let q = [turn / map.spacing_x_m(), TAU * peak.waves() / length_m];
            Some(Self::of_wave(q, share))
        }
    }

    /// The remark on it.
    pub(crate) fn remark(self) -> Remark {
        let remark = Remark::new(RemarkCode::NarrowLine).with("wavelength_m", self.wavelength_m);
        let remark = remark.with("share", self.share);
        match self.angle_degrees {
            Some(angle) => remark.with("angle", format!("{angle:.0}")),
            None => remark,
        }
    }

    fn largest(spectrum: &LineSpectrum, preparation: Preparation) -> Option<(Peak, f64)> {
        let shares = peaks(spectrum, preparation.window).into_iter().map(|peak| {
            let share = peak.share(spectrum);
            (peak, share)
        });
        shares.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, share)| *share > LARGE_SHARE)
    }

    /// The line of a plane wave with these wavevectors along x and y \[rad/m\].
    fn of_wave([along, across]: [f64; 2], share: f64) -> Self {
        let half_turned = if along < 0.0 { [-along, -across] } else { [along, across] };
        Self {
            wavelength_m: TAU / along.hypot(across),
            share,
            angle_degrees: Some(half_turned[1].atan2(half_turned[0]).to_degrees()),
        }
    }
}

/// Columns of a map as rows, in pairs of neighbours; `None` for a map of one row.
fn columns_in_pairs(map: &HeightMap) -> Option<HeightMap> {
    let (columns, rows) = (map.columns(), map.rows());
    let step = (columns / COLUMN_PAIRS).max(2);
    let firsts = (0..columns.saturating_sub(1)).step_by(step);
    let taken = firsts.flat_map(|first| [first, first + 1]);
    let heights_m =
        taken.flat_map(|column| (0..rows).map(move |row| map.heights_m()[row * columns + column]));
    HeightMap::new(rows, map.spacing_y_m(), map.spacing_x_m(), heights_m.collect()).ok()
}

/// Mean angle \[rad\] by which the wave n of a row is ahead of that of the row before, over rows in groups of `stride`, or over
/// all neighbours for a stride of 1.
fn turn_between_rows(rows: &Rows, preparation: Preparation, n: usize, stride: usize) -> f64 {
    let trend = rows.trend(preparation.detrend);
    let mut transform = RowTransform::new(rows.points, preparation);
    let mut sum = Complex::default();
    let mut before: Option<Complex<f64>> = None;
    for (row, heights_m) in rows.iter().enumerate() {
        transform.run(&trend, row, heights_m);
        let wave = transform.output[n];
        if let Some(before) = before.filter(|_| stride == 1 || row % stride > 0) {
            sum += wave * before.conj();
        }
        before = Some(wave);
    }
    sum.arg()
}
