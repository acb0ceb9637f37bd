//! Logarithmic bins of wavevectors, common to all measurements.

use std::f64::consts::TAU;
use std::num::NonZeroU32;
use std::ops::Range;

use serde::{Deserialize, Serialize};

use spectrum::ProfilePsd;
use units::named;

/// Kind of mean over values of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum BinMean {
    /// The mean of the logarithms.
    Geometric,
    /// The mean of the values.
    Arithmetic,
}

named!(BinMean, "mean of spectra", { Geometric => "geometric", Arithmetic => "arithmetic" });

/// The samples of a spectrum in one bin.
#[derive(Clone, Debug)]
pub(crate) struct Bin {
    /// Index j of the lower edge 10^(j/N) rad/m.
    pub(crate) index: i64,
    /// Geometric mean of the wavelengths of the samples \[m\].
    pub(crate) wavelength_m: f64,
    /// Mean of the samples \[m^3\].
    pub(crate) c1d_m3: f64,
    /// Its samples in the spectrum.
    pub(crate) samples: Range<usize>,
}

/// Averages a spectrum in bins: bin j of N per decade covers 10^(j/N) <= q < 10^((j + 1)/N), q in rad/m.
///
/// Each bin with samples gives one, at the geometric mean of their wavelengths. Bins of a single sample, the rule at
/// the long end of a scan, keep it unchanged, and a power law stays one. With [`BinMean::Arithmetic`] the noise of a
/// periodogram averages out; the geometric mean of the periodogram of a single line is e^-0.577 = 0.56 of its
/// expectation.
pub fn log_binned(psd: &ProfilePsd, bins_per_decade: NonZeroU32, mean: BinMean) -> ProfilePsd {
    let bins = log_bins(psd, bins_per_decade, mean);
    profile(bins.iter().map(|bin| (bin.wavelength_m, bin.c1d_m3)))
}

/// Makes a spectrum of bins, each as (wavelength \[m\], mean \[m^3\]), from long to short wavelengths.
pub(crate) fn profile(bins: impl Iterator<Item = (f64, f64)>) -> ProfilePsd {
    let (wavelengths_m, values_m3) = bins.unzip();
    ProfilePsd::new(wavelengths_m, values_m3).expect("means over the samples of spectra are samples of one")
}

pub(crate) fn log_bins(psd: &ProfilePsd, bins_per_decade: NonZeroU32, mean: BinMean) -> Vec<Bin> {
    let index = |&wavelength_m: &f64| bin_index(TAU / wavelength_m, bins_per_decade);
    let mut from = 0;
    let groups = psd.wavelengths_m().chunk_by(|a, b| index(a) == index(b));
    groups
        .map(|wavelengths_m| {
            let samples = from..from + wavelengths_m.len();
            from = samples.end;
            let values_m3 = &psd.c1d_m3()[samples.clone()];
            Bin {
                index: index(&wavelengths_m[0]),
                wavelength_m: BinMean::Geometric.mean(wavelengths_m),
                c1d_m3: mean.mean(values_m3),
                samples,
            }
        })
        .collect()
}

/// Returns the index of the bin of a wavevector.
pub(crate) fn bin_index(q_rad_per_m: f64, bins_per_decade: NonZeroU32) -> i64 {
    (q_rad_per_m.log10() * f64::from(bins_per_decade.get())).floor() as i64
}

/// Returns the wavevector \[rad/m\] at a share of a bin, 0 at its lower edge and 1 at its upper one.
pub(crate) fn wavevector_in_bin(index: i64, share: f64, bins_per_decade: NonZeroU32) -> f64 {
    10f64.powf((index as f64 + share) / f64::from(bins_per_decade.get()))
}

/// Returns the wavelength \[m\] of the logarithmic centre of a bin.
pub(crate) fn centre_m(index: i64, bins_per_decade: NonZeroU32) -> f64 {
    TAU / wavevector_in_bin(index, 0.5, bins_per_decade)
}

impl BinMean {
    /// Computes the mean of positive values, at least one.
    pub(crate) fn mean(self, values: &[f64]) -> f64 {
        // Relative to the first value: a single value stays unchanged, and no sum or product overflows.
        let ratios = values.iter().map(|value| value / values[0]);
        let count = values.len() as f64;
        values[0]
            * match self {
                Self::Geometric => (ratios.map(f64::ln).sum::<f64>() / count).exp(),
                Self::Arithmetic => ratios.sum::<f64>() / count,
            }
    }

    /// Computes the standard error of the mean of two values or more; for the geometric mean to first order, the mean
    /// times the standard error of the logarithms.
    pub(crate) fn standard_error(self, values: &[f64]) -> Option<f64> {
        let mean = self.mean(values);
        let deviation = |value: &f64| match self {
            Self::Geometric => (value / mean).ln(),
            Self::Arithmetic => value / mean - 1.0,
        };
        let count = values.len() as f64;
        let squares: f64 = values.iter().map(|value| deviation(value).powi(2)).sum();
        (values.len() >= 2).then(|| mean * (squares / (count * (count - 1.0))).sqrt())
    }
}
