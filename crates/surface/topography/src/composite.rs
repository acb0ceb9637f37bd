//! One spectrum from many measurements.

use std::collections::BTreeMap;
use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{BinMean, centre_m, log_bins, profile};
use crate::degrees_of_freedom::bias_of_logarithm;
use crate::error::TransformError;
use crate::kept_moments::{Holdings, keeping};
use crate::recipe::Average;
use crate::scan_bins::ScanBin;
use spectrum::ProfilePsd;

/// Options for averaging measurements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CompositeOptions {
    /// Number N of bins per decade; bin j begins at 10^(j/N) rad/m.
    pub bins_per_decade: NonZeroU32,
    /// Mean over the samples of a measurement inside a bin. Arithmetic by default, which estimates the spectrum; the
    /// geometric mean of a periodogram lies below it.
    pub inside: BinMean,
    /// Mean over the measurements that reach a bin. Geometric by default, which Jackson & Jacobs call the log-space
    /// average; contact.engineering takes the arithmetic mean.
    pub across: BinMean,
}

impl Default for CompositeOptions {
    fn default() -> Self {
        Self {
            bins_per_decade: NonZeroU32::new(10).expect("ten is not zero"),
            inside: BinMean::Arithmetic,
            across: BinMean::Geometric,
        }
    }
}

/// A composite spectrum, from long to short wavelengths; bins that no measurement reaches are left out.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Composite {
    /// The bins, from long to short wavelengths.
    pub bins: Vec<CompositeBin>,
}

/// One bin of a composite, 10^(j/N) <= q < 10^((j + 1)/N) in rad/m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CompositeBin {
    /// Wavelength of the centre \[m\], q = 10^((j + 1/2)/N) rad/m.
    pub centre_m: f64,
    /// Geometric mean of the wavelengths at which the bin stands in the measurements \[m\].
    pub wavelength_m: f64,
    /// Spectrum C1D \[m^3\]: the mean of the measurements times [`kept`](Self::kept).
    pub c1d_m3: f64,
    /// Factor on the mean that keeps variance and slope of the measurements in a spectrum that is a power law between its
    /// samples; 1 where the spectrum is smooth.
    pub kept: f64,
    /// Number of measurements, at least 1.
    pub measurements: usize,
    /// Standard error of the mean \[m^3\] from the scatter of the measurements; `None` for a single one. Repeated data
    /// count once.
    pub standard_error_m3: Option<f64>,
    /// Degrees of freedom: equivalent number of independent squared Gaussian numbers in the bin. Repeated data count
    /// once; `None` if nothing is known of the lines.
    pub degrees_of_freedom: Option<f64>,
}

/// Averages measurements, each already limited to its reliable band ([`LineSpectrum::profile`]).
///
/// Each measurement is averaged inside the bins, then each bin over the measurements that reach it, with equal weights. The
/// means stay as they are: only scans, whose samples stand for Fourier steps, have a variance to keep.
///
/// [`LineSpectrum::profile`]: crate::LineSpectrum::profile
///
/// # Errors
/// [`TransformError::NoMeasurements`] without measurements, [`TransformError::SingleBin`] if all samples share a bin.
pub fn composite(
    measurements: &[ProfilePsd],
    options: &CompositeOptions,
) -> Result<Composite, TransformError> {
    let binned = |measurement: &ProfilePsd| {
        let bins = log_bins(measurement, options.bins_per_decade, options.inside);
        bins.into_iter().map(ScanBin::from).collect()
    };
    let binned: Vec<Vec<ScanBin>> = measurements.iter().map(binned).collect();
    average_bins(&binned, options.bins_per_decade, options.across, |_| 1.0)
}

/// Averages scans that are in bins already.
///
/// # Errors
/// As [`composite`].
pub(crate) fn average_scan_bins(
    scans: &[Vec<ScanBin>],
    bins_per_decade: NonZeroU32,
    average: Average,
) -> Result<Composite, TransformError> {
    average_bins(scans, bins_per_decade, average.across(), |bin| average.counted_m3(bin) / bin.c1d_m3)
}

impl Average {
    /// Value of a scan in a bin \[m^3\]; for the unbiased mean of several logarithms freed from the bias of its own.
    #[must_use]
    pub fn counted_m3(self, bin: &ScanBin) -> f64 {
        match (self, bin.degrees_of_freedom) {
            (Average::LogUnbiased, Some(freedom)) => bin.c1d_m3 * (-bias_of_logarithm(freedom)).exp(),
            _ => bin.c1d_m3,
        }
    }
}

/// Averages measurements in bins with equal weights. Where several are averaged, each is freed of its bias by a factor.
fn average_bins(
    measurements: &[Vec<ScanBin>],
    bins_per_decade: NonZeroU32,
    across: BinMean,
    unbiasing: impl Fn(&ScanBin) -> f64,
) -> Result<Composite, TransformError> {
    if measurements.is_empty() {
        return Err(TransformError::NoMeasurements);
    }
    let mut gathered: BTreeMap<i64, Gathered> = BTreeMap::new();
    for (at, measurement) in measurements.iter().enumerate() {
        let is_repeated = measurements[..at].contains(measurement);
        for bin in measurement {
            gathered.entry(bin.index).or_default().add(bin, unbiasing(bin), is_repeated);
        }
    }
    let ratios: Option<Vec<f64>> = gathered.values().map(Gathered::held_over_mean).collect();
    let bins: Vec<CompositeBin> = gathered
        .into_iter()
        .map(|(index, gathered)| gathered.bin(centre_m(index, bins_per_decade), across))
        .collect();
    match (&bins[..], ratios) {
        ([CompositeBin { centre_m, .. }], _) => Err(TransformError::SingleBin { centre_m: *centre_m }),
        (_, None) => Ok(Composite { bins }),
        (_, Some(ratios)) => Ok(Composite { bins }.keeping(&ratios)),
    }
}

/// Values of all measurements in a bin.
#[derive(Default)]
struct Gathered {
    wavelengths_m: Vec<f64>,
    values_m3: Vec<f64>,
    held_m3: Vec<Option<f64>>,
    /// The factors that free the values of their bias.
    unbiasing: Vec<f64>,
    /// The numbers of the values that do not repeat an earlier one.
    distinct: Vec<usize>,
    /// The degrees of freedom of the distinct values.
    freedoms: Vec<Option<f64>>,
}

impl Gathered {
    fn add(&mut self, bin: &ScanBin, unbiasing: f64, is_repeated: bool) {
        if !is_repeated {
            self.distinct.push(self.values_m3.len());
            self.freedoms.push(bin.degrees_of_freedom);
        }
        self.wavelengths_m.push(bin.wavelength_m);
        self.values_m3.push(bin.c1d_m3);
        self.held_m3.push(bin.held_m3);
        self.unbiasing.push(unbiasing);
    }

    /// Values \[m^3\] without their bias, which only the mean of several logarithms has.
    fn unbiased_m3(&self) -> Vec<f64> {
        let is_mean = self.distinct.len() > 1;
        let freed = |(value, factor): (&f64, &f64)| if is_mean { value * factor } else { *value };
        self.values_m3.iter().zip(&self.unbiasing).map(freed).collect()
    }

    /// What the measurements hold about the bin over what their means would, of all together: logarithms of the two have
    /// different biases.
    fn held_over_mean(&self) -> Option<f64> {
        let held_m3: Option<Vec<f64>> = self.held_m3.iter().copied().collect();
        Some(BinMean::Arithmetic.mean(&held_m3?) / BinMean::Arithmetic.mean(&self.values_m3))
    }

    fn bin(self, centre_m: f64, across: BinMean) -> CompositeBin {
        let values_m3 = self.unbiased_m3();
        let distinct_m3: Vec<f64> = self.distinct.iter().map(|&at| values_m3[at]).collect();
        CompositeBin {
            centre_m,
            wavelength_m: BinMean::Geometric.mean(&self.wavelengths_m),
            c1d_m3: across.mean(&values_m3),
            kept: 1.0,
            measurements: values_m3.len(),
            standard_error_m3: across.standard_error(&distinct_m3),
            degrees_of_freedom: self.freedoms.iter().copied().sum(),
        }
    }
}

impl Composite {
    /// Changes the values so that the spectrum holds about each bin so many times what its mean would.
    fn keeping(mut self, ratios: &[f64]) -> Self {
        let psd = self.profile();
        let of_level = Holdings::of_level(psd.wavelengths_m());
        let means = self.bins.iter().map(|bin| bin.c1d_m3);
        let holdings =
            means.zip(ratios).zip(&of_level).map(|((mean_m3, ratio), level)| mean_m3 * ratio * level);
        let kept = keeping(&psd, &holdings.collect::<Vec<f64>>());
        for (bin, c1d_m3) in self.bins.iter_mut().zip(kept.c1d_m3()) {
            bin.kept = c1d_m3 / bin.c1d_m3;
            bin.c1d_m3 = *c1d_m3;
            bin.standard_error_m3 = bin.standard_error_m3.map(|error_m3| bin.kept * error_m3);
        }
        self
    }

    /// Returns the spectrum with each bin at its sampled wavelength, not at its centre. At the long end of a scan a bin
    /// holds one sample, up to 12 % of the wavelength off the centre, where a steep spectrum differs by a third.
    pub fn profile(&self) -> ProfilePsd {
        profile(self.bins.iter().map(|bin| (bin.wavelength_m, bin.c1d_m3)))
    }
}
