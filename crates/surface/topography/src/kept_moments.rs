//! Values of a binned spectrum that keep the variance and the mean square slope of its samples.
//!
//! Models take a spectrum as a power law between its samples. Through the means of bins such a spectrum lies far below the
//! peak of a line: of a turned profile it keeps half of the variance. So the values are chosen by their integrals.
//!
//! An interval between two samples holds Int C dq and Int q^2 C dq. Two masses at its ends hold the same, and the masses of
//! both intervals at a sample are its *holding*. In the same way each Fourier sample of a scan is split between the two bins
//! that it lies between. If the holdings of all samples are those of the scan, m0 and m2 are kept, wherever the samples lie.
//!
//! Values that keep every single holding may swing between neighbours, because a deep bin cannot hold less than the flanks of
//! its neighbours. So no bin is lowered: what it holds too much is taken from the neighbour whose flank it is. The last
//! percents are closed by the smallest change of the logarithms that keeps both sums. Smooth spectra stay as they are.

use std::f64::consts::TAU;

use spectrum::{ProfilePsd, interval_integrals};

use crate::bins::profile;

/// Largest factor on a mean; a line of one wave in a bin of a decade needs less than the number of its waves.
const MOST: f64 = 1e9;
/// Most sweeps over all bins; lines need about fifty.
const SWEEPS: usize = 200;
/// Relative change of values after which sweeps end.
const SETTLED: f64 = 1e-4;
/// Relative errors of both sums at which they are kept.
const KEPT: f64 = 1e-5;

/// Splits masses at wavevectors between the samples on either side, so that their sum and that of q^2 stay.
pub(crate) fn split(masses: impl Iterator<Item = (f64, f64)>, q_rad_per_m: &[f64]) -> Vec<f64> {
    let mut held = vec![0.0; q_rad_per_m.len()];
    for (q, mass) in masses {
        let next = q_rad_per_m.partition_point(|&sample| sample <= q).clamp(1, held.len() - 1);
        let [from, to] = [q_rad_per_m[next - 1], q_rad_per_m[next]];
        let share = ((q * q - from * from) / (to * to - from * from)).clamp(0.0, 1.0);
        held[next - 1] += (1.0 - share) * mass;
        held[next] += share * mass;
    }
    held
}

/// The holdings of the samples of a spectrum.
pub(crate) struct Holdings {
    /// Parts from the interval before each sample; 0 for the first.
    before: Vec<f64>,
    /// Parts from the interval behind it; 0 for the last.
    behind: Vec<f64>,
}

impl Holdings {
    pub(crate) fn new(psd: &ProfilePsd) -> Self {
        let mut holdings = Self { before: vec![0.0; psd.len()], behind: vec![0.0; psd.len()] };
        for (at, [height, slope]) in interval_integrals(psd).into_iter().enumerate() {
            let [from, to] = [at, at + 1].map(|at| (TAU / psd.wavelengths_m()[at]).powi(2));
            let farther = ((slope - from * height) / (to - from)).clamp(0.0, height);
            holdings.before[at + 1] = farther;
            holdings.behind[at] = height - farther;
        }
        holdings
    }

    /// Holdings of a spectrum that is 1 m^3 everywhere.
    pub(crate) fn of_level(wavelengths_m: &[f64]) -> Vec<f64> {
        Self::new(&profile(wavelengths_m.iter().map(|&wavelength_m| (wavelength_m, 1.0)))).all()
    }

    fn all(&self) -> Vec<f64> {
        self.before.iter().zip(&self.behind).map(|(before, behind)| before + behind).collect()
    }
}

/// Returns a spectrum at the same wavelengths that keeps the sums of the holdings and of their q^2; itself if its values
/// would leave the range of densities.
pub(crate) fn keeping(psd: &ProfilePsd, holdings: &[f64]) -> ProfilePsd {
    let raised = raised(psd, holdings).unwrap_or_else(|| psd.clone());
    closed(raised, holdings).unwrap_or_else(|| psd.clone())
}

/// Raises bins until none holds too little.
fn raised(psd: &ProfilePsd, wanted: &[f64]) -> Option<ProfilePsd> {
    let mut now = psd.clone();
    for _ in 0..SWEEPS {
        let held = Holdings::new(&now);
        let all = held.all();
        let mut left = wanted.to_vec();
        for at in 0..all.len() {
            let is_raised = now.c1d_m3()[at] > psd.c1d_m3()[at];
            let excess = (all[at] - wanted[at]) / all[at];
            if !is_raised && excess > 0.0 {
                if at > 0 {
                    left[at - 1] -= excess * held.before[at];
                }
                if at + 1 < all.len() {
                    left[at + 1] -= excess * held.behind[at];
                }
            }
        }
        let value = |at: usize| {
            let mean_m3 = psd.c1d_m3()[at];
            (now.c1d_m3()[at] * (left[at] / all[at]).max(0.0)).clamp(mean_m3, MOST * mean_m3)
        };
        let values: Vec<f64> = (0..all.len()).map(value).collect();
        let change = |(new, old): (&f64, &f64)| (new / old - 1.0).abs();
        let largest = values.iter().zip(now.c1d_m3()).map(change).fold(0.0, f64::max);
        now = ProfilePsd::new(psd.wavelengths_m().to_vec(), values).ok()?;
        if largest < SETTLED {
            break;
        }
    }
    Some(now)
}

/// Closes both sums by the smallest change of the logarithms, Newton's method for two multipliers.
fn closed(psd: ProfilePsd, wanted: &[f64]) -> Option<ProfilePsd> {
    let mut now = psd;
    let squares: Vec<f64> =
        now.wavelengths_m().iter().map(|wavelength_m| (TAU / wavelength_m).powi(2)).collect();
    let weighted =
        |holdings: &[f64]| holdings.iter().zip(&squares).map(|(held, square)| held * square).collect();
    for _ in 0..SWEEPS {
        let heights = Holdings::new(&now).all();
        let slopes: Vec<f64> = weighted(&heights);
        let wanted_slopes: Vec<f64> = weighted(wanted);
        let sum = |values: &[f64]| values.iter().sum::<f64>();
        let missing = [sum(wanted) / sum(&heights), sum(&wanted_slopes) / sum(&slopes)].map(f64::ln);
        if missing.iter().all(|off| off.abs() < KEPT) {
            return Some(now);
        }
        let shares = [&heights, &slopes].map(|of| of.iter().map(|held| held / sum(of)).collect::<Vec<f64>>());
        let product = |a: usize, b: usize| shares[a].iter().zip(&shares[b]).map(|(a, b)| a * b).sum::<f64>();
        let [hh, hs, ss] = [product(0, 0), product(0, 1), product(1, 1)];
        // A single line has both sums; a little stiffness divides the change between them.
        let (hh, ss) = (hh * (1.0 + 1e-9), ss * (1.0 + 1e-9));
        let determinant = hh * ss - hs * hs;
        let multipliers = [
            (ss * missing[0] - hs * missing[1]) / determinant,
            (hh * missing[1] - hs * missing[0]) / determinant,
        ];
        let value = |(at, value_m3): (usize, &f64)| {
            let step = multipliers[0] * shares[0][at] + multipliers[1] * shares[1][at];
            value_m3 * step.clamp(-0.5, 0.5).exp()
        };
        let values = now.c1d_m3().iter().enumerate().map(value).collect();
        now = ProfilePsd::new(now.wavelengths_m().to_vec(), values).ok()?;
    }
    Some(now)
}
