//! The composite of scans as tables.

use tables::Table;

use crate::composite::CompositeOfFiles;

impl CompositeOfFiles {
    /// The composite: `wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3, measurements, degrees_of_freedom`, a row per bin
    /// from long to short wavelengths.
    #[must_use]
    pub fn table(&self) -> Table {
        let bins = self.spectrum.composite.bins();
        Table::default()
            .with_numbers("wavelength_m", bins.iter().map(|bin| bin.wavelength_m))
            .with_numbers("wavevector_rad_per_m", bins.iter().map(|bin| wavevector(bin.wavelength_m)))
            .with_numbers("C1D_m3", bins.iter().map(|bin| bin.c1d_m3))
            .with_numbers("C1D_se_m3", bins.iter().map(|bin| bin.standard_error_m3))
            .with_numbers("measurements", bins.iter().map(|bin| bin.measurements as f64))
            .with_numbers("degrees_of_freedom", bins.iter().map(|bin| bin.degrees_of_freedom))
    }

    /// Every spectrum in blocks: `series, wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3`. Each scan stands where it is
    /// trusted under its name, and whole under its name and `(incl. unreliable data)`; the composite comes last.
    #[must_use]
    pub fn series_table(&self) -> Table {
        let found = &self.spectrum;
        let mut rows: Vec<(String, f64, f64, Option<f64>)> = Vec::new();
        for (scan, name) in found.scans.iter().zip(found.series_names()) {
            let reliable = scan.reliable.wavelengths_m().iter().zip(scan.reliable.c1d_m3());
            rows.extend(reliable.map(|(wavelength_m, c1d_m3)| (name.clone(), *wavelength_m, *c1d_m3, None)));
            let whole = scan.spectrum.wavelengths_m().zip(scan.spectrum.c1d_m3());
            rows.extend(whole.filter(|(_, c1d_m3)| **c1d_m3 > 0.0).map(|(wavelength_m, c1d_m3)| {
                (format!("{name} (incl. unreliable data)"), wavelength_m, *c1d_m3, None)
            }));
        }
        let bins = found.composite.bins().iter();
        rows.extend(
            bins.map(|bin| ("composite".to_owned(), bin.wavelength_m, bin.c1d_m3, bin.standard_error_m3)),
        );
        Table::default()
            .with_text("series", rows.iter().map(|row| row.0.clone()))
            .with_numbers("wavelength_m", rows.iter().map(|row| row.1))
            .with_numbers("wavevector_rad_per_m", rows.iter().map(|row| wavevector(row.1)))
            .with_numbers("C1D_m3", rows.iter().map(|row| row.2))
            .with_numbers("C1D_se_m3", rows.iter().map(|row| row.3))
    }
}

fn wavevector(wavelength_m: f64) -> f64 {
    std::f64::consts::TAU / wavelength_m
}
