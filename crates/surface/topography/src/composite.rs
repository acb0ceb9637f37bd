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
    let mut gathered: BTreeMap<i64, Vec<Measured<'_>>> = BTreeMap::new();
    for (at, measurement) in measurements.iter().enumerate() {
        let is_repeated = measurements[..at].contains(measurement);
        for bin in measurement {
            gathered.entry(bin.index).or_default().push((bin, is_repeated));
        }
    }
    let average = |(index, measured): (&i64, &Vec<Measured<'_>>)| {
        let distinct = || measured.iter().filter(|(_, is_repeated)| !is_repeated);
        let is_mean = distinct().count() > 1;
        let value_m3 = |(bin, _): &Measured<'_>| bin.c1d_m3 * if is_mean { unbiasing(bin) } else { 1.0 };
        let wavelengths_m: Vec<f64> = measured.iter().map(|(bin, _)| bin.wavelength_m).collect();
        let bin = CompositeBin {
            centre_m: centre_m(*index, bins_per_decade),
            wavelength_m: BinMean::Geometric.mean(&wavelengths_m),
            c1d_m3: across.mean(&measured.iter().map(value_m3).collect::<Vec<f64>>()),
            kept: 1.0,
            measurements: measured.len(),
            standard_error_m3: across.standard_error(&distinct().map(value_m3).collect::<Vec<f64>>()),
            degrees_of_freedom: distinct().map(|(bin, _)| bin.degrees_of_freedom).sum(),
        };
        // Of all together: the logarithms of what is held and of means have different biases.
        let held_m3: Option<f64> = measured.iter().map(|(bin, _)| bin.held_m3).sum();
        let means_m3: f64 = measured.iter().map(|(bin, _)| bin.c1d_m3).sum();
        (bin, held_m3.map(|held_m3| held_m3 / means_m3))
    };
    let (bins, held_over_means): (Vec<CompositeBin>, Vec<Option<f64>>) = gathered.iter().map(average).unzip();
    match (&bins[..], held_over_means.into_iter().collect::<Option<Vec<f64>>>()) {
        ([CompositeBin { centre_m, .. }], _) => Err(TransformError::SingleBin { centre_m: *centre_m }),
        (_, None) => Ok(Composite { bins }),
        (_, Some(ratios)) => Ok(Composite { bins }.keeping(&ratios)),
    }
}

/// The bin of a measurement, and whether the measurement repeats an earlier one.
type Measured<'m> = (&'m ScanBin, bool);

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
