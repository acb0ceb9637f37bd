//! One spectrum from many measurements.

use std::collections::BTreeMap;
use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{BinMean, centre_m, log_bins, profile};
use crate::degrees_of_freedom::bias_of_logarithm;
use crate::error::TransformError;
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
    /// Geometric mean of the wavelengths at which the measurements were sampled inside the bin \[m\].
    pub wavelength_m: f64,
    /// Mean spectrum C1D \[m^3\].
    pub c1d_m3: f64,
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
/// Each measurement is averaged inside the bins, then each bin over the measurements that reach it, with equal weights.
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
    average_bins(&binned, options.bins_per_decade, options.across)
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
    let counted = |bins: &Vec<ScanBin>| -> Vec<ScanBin> {
        bins.iter().map(|bin| ScanBin { c1d_m3: average.counted_m3(bin), ..bin.clone() }).collect()
    };
    let counted: Vec<Vec<ScanBin>> = scans.iter().map(counted).collect();
    average_bins(&counted, bins_per_decade, average.across())
}

impl Average {
    /// Value of a scan in a bin \[m^3\]; for the unbiased mean of logarithms freed from the bias of its own logarithm.
    #[must_use]
    pub fn counted_m3(self, bin: &ScanBin) -> f64 {
        match (self, bin.degrees_of_freedom) {
            (Average::LogUnbiased, Some(freedom)) => bin.c1d_m3 * (-bias_of_logarithm(freedom)).exp(),
            _ => bin.c1d_m3,
        }
    }
}

/// Averages measurements in bins with equal weights.
fn average_bins(
    measurements: &[Vec<ScanBin>],
    bins_per_decade: NonZeroU32,
    across: BinMean,
) -> Result<Composite, TransformError> {
    if measurements.is_empty() {
        return Err(TransformError::NoMeasurements);
    }
    let mut gathered: BTreeMap<i64, Gathered> = BTreeMap::new();
    for (at, measurement) in measurements.iter().enumerate() {
        let is_repeated = measurements[..at].contains(measurement);
        for bin in measurement {
            gathered.entry(bin.index).or_default().add(bin, is_repeated);
        }
    }
    let bin = |(index, gathered): (i64, Gathered)| CompositeBin {
        centre_m: centre_m(index, bins_per_decade),
        wavelength_m: BinMean::Geometric.mean(&gathered.wavelengths_m),
        c1d_m3: across.mean(&gathered.values_m3),
        measurements: gathered.values_m3.len(),
        standard_error_m3: across.standard_error(&gathered.distinct_m3),
        degrees_of_freedom: gathered.freedoms.iter().copied().sum(),
    };
    let bins: Vec<CompositeBin> = gathered.into_iter().map(bin).collect();
    match bins[..] {
        [CompositeBin { centre_m, .. }] => Err(TransformError::SingleBin { centre_m }),
        _ => Ok(Composite { bins }),
    }
}

/// Values of all measurements in a bin.
#[derive(Default)]
struct Gathered {
    wavelengths_m: Vec<f64>,
    values_m3: Vec<f64>,
    /// The values without those of measurements that repeat an earlier one.
    distinct_m3: Vec<f64>,
    /// The degrees of freedom of the distinct values.
    freedoms: Vec<Option<f64>>,
}

impl Gathered {
    fn add(&mut self, bin: &ScanBin, is_repeated: bool) {
        self.wavelengths_m.push(bin.wavelength_m);
        self.values_m3.push(bin.c1d_m3);
        if !is_repeated {
            self.distinct_m3.push(bin.c1d_m3);
            self.freedoms.push(bin.degrees_of_freedom);
        }
    }
}

impl Composite {
    /// Returns the spectrum with each bin at its sampled wavelength, not at its centre. At the long end of a scan a bin
    /// holds one sample, up to 12 % of the wavelength off the centre, where a steep spectrum differs by a third.
    pub fn profile(&self) -> ProfilePsd {
        profile(self.bins.iter().map(|bin| (bin.wavelength_m, bin.c1d_m3)))
    }
}
