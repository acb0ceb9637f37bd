//! The composite drawn over the spectra it is made of.

use spectrum::ProfilePsd;
use topography::{BinMean, ScanSpectrum, log_binned};

use super::composite::CompositeOfFiles;
use crate::figure::{FigureData, Series, psd_figure};

const COMPOSITE_COLOUR: usize = 5;

impl CompositeOfFiles {
    /// Figure 1 of a composite: every scan where it is trusted, and the composite on top.
    pub fn figure(&self, name: &str) -> FigureData {
        let composite = self.spectrum.composite.profile();
        let points = self.series("composite", COMPOSITE_COLOUR, 1, "c1d_m3", &composite);
        let series = self.scan_series().into_iter().chain([points]).collect();
        psd_figure(name, series).with_holes(&self.spectrum.holes())
    }

    /// A figure of the composite, with the scans beneath it.
    pub fn beneath(&self, figure: FigureData) -> FigureData {
        let on_top =
            |series| Series { curve: "composite".to_owned(), colour: COMPOSITE_COLOUR, dash: 1, ..series };
        let series = self.scan_series().into_iter().chain(figure.series.into_iter().map(on_top)).collect();
        FigureData { series, ..figure }
    }

    /// The spectrum of every scan in the band where it is trusted, averaged in the composite's bins.
    pub fn scan_series(&self) -> Vec<Series> {
        let names = self.spectrum.series_names();
        let line = |(index, scan): (usize, &ScanSpectrum)| {
            let binned =
                log_binned(&scan.reliable, self.spectrum.recipe.bins_per_decade, BinMean::Arithmetic);
            let colour = index + usize::from(index >= COMPOSITE_COLOUR);
            self.series(&names[index], colour, 0, &format!("c1d_m3 of {}", names[index]), &binned)
        };
        self.spectrum.scans.iter().enumerate().map(line).collect()
    }

    fn series(&self, name: &str, colour: usize, dash: usize, column: &str, psd: &ProfilePsd) -> Series {
        let wavevectors = psd.wavelengths_m().iter().map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
        Series {
            column: column.to_owned(),
            curve: if dash == 0 { "scans".to_owned() } else { "composite".to_owned() },
            condition: String::new(),
            condition_in_full: if dash == 0 { name.to_owned() } else { String::new() },
            colour,
            dash,
            points: wavevectors.zip(psd.c1d_m3().iter().copied()).collect(),
        }
    }
}
