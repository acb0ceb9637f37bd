//! The composite drawn over the spectra it is made of.

use spectrum::ProfilePsd;
use topography::{BinMean, ScanSpectrum, log_binned};

use super::{FigureData, Series, psd_figure};
use measurements::CompositeOfFiles;

const COMPOSITE_COLOUR: usize = 5;

/// Makes the figure of a composite: every scan in its reliable band, and the composite on top.
#[must_use]
pub fn composite_figure(scans: &CompositeOfFiles, name: &str) -> FigureData {
    let composite = scans.spectrum.composite.profile();
    let points = series("composite", COMPOSITE_COLOUR, 1, "c1d_m3", &composite);
    let series = scan_series(scans).into_iter().chain([points]).collect();
    psd_figure(name, series).with_holes(&scans.spectrum.holes())
}

/// A figure of the composite, with the scans beneath it.
#[must_use]
pub fn over_scans(scans: &CompositeOfFiles, figure: FigureData) -> FigureData {
    let on_top =
        |series| Series { curve: "composite".to_owned(), colour: COMPOSITE_COLOUR, dash: 1, ..series };
    let series = scan_series(scans).into_iter().chain(figure.series.into_iter().map(on_top)).collect();
    FigureData { series, ..figure }
}

/// Averages the spectrum of every scan, in its reliable band, in the composite's bins.
fn scan_series(scans: &CompositeOfFiles) -> Vec<Series> {
    let names = scans.spectrum.series_names();
    let line = |(index, scan): (usize, &ScanSpectrum)| {
        let binned = log_binned(&scan.reliable, scans.spectrum.recipe.bins_per_decade, BinMean::Arithmetic);
        let colour = index + usize::from(index >= COMPOSITE_COLOUR);
        series(&names[index], colour, 0, &format!("c1d_m3 of {}", names[index]), &binned)
    };
    scans.spectrum.scans.iter().enumerate().map(line).collect()
}

fn series(name: &str, colour: usize, dash: usize, column: &str, psd: &ProfilePsd) -> Series {
    let wavevectors = psd.wavelengths_m().iter().map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
    Series {
        column: column.to_owned(),
        curve: if dash == 0 { "scans".to_owned() } else { "composite".to_owned() },
        condition: String::new(),
        condition_in_full: if dash == 0 { name.to_owned() } else { String::new() },
        load: None,
        colour,
        dash,
        points: wavevectors.zip(psd.c1d_m3().iter().copied()).collect(),
    }
}
