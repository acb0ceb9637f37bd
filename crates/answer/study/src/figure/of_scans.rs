//! The composite drawn over the spectra it is made of.

use spectrum::ProfilePsd;
use topography::{BinMean, ScanSpectrum, log_binned};

use super::{FigureData, Series, psd_figure};
use measurements::CompositeOfFiles;

/// Makes the figure of a composite: every scan in its reliable band, and the composite on top.
#[must_use]
pub fn composite_figure(scans: &CompositeOfFiles, name: &str) -> FigureData {
    let composite = Series::alone("c1d_m3", points(&scans.spectrum.composite.profile()));
    over_scans(scans, psd_figure(name, vec![composite])).with_holes(&scans.spectrum.holes())
}

/// A figure of the composite, with the scans beneath it.
#[must_use]
pub fn over_scans(scans: &CompositeOfFiles, figure: FigureData) -> FigureData {
    let on_top = |series| Series { curve: "composite".to_owned(), ..series };
    let series = scan_series(scans).into_iter().chain(figure.series.into_iter().map(on_top)).collect();
    FigureData { series, ..figure }
}

/// Averages the spectrum of every scan, in its reliable band, in the composite's bins.
fn scan_series(scans: &CompositeOfFiles) -> Vec<Series> {
    let line = |(index, (scan, name)): (usize, (&ScanSpectrum, String))| {
        let binned = log_binned(&scan.reliable, scans.spectrum.recipe.bins_per_decade, BinMean::Arithmetic);
        Series {
            curve: "scans".to_owned(),
            curve_index: 1,
            condition_in_full: name.clone(),
            condition_index: Some(index),
            ..Series::alone(&format!("c1d_m3 of {name}"), points(&binned))
        }
    };
    scans.spectrum.scans.iter().zip(scans.spectrum.series_names()).enumerate().map(line).collect()
}

fn points(psd: &ProfilePsd) -> Vec<(f64, f64)> {
    let wavevectors = psd.wavelengths_m().iter().map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
    wavevectors.zip(psd.c1d_m3().iter().copied()).collect()
}
