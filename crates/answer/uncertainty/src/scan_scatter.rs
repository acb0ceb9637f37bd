//! Draws of the composite of scans: scans at other places, and instruments with other height scales.
//!
//! A scan j of an instrument i at the bin k is taken to be ln C_ijk = mu_k + a_i + b_i ln(q_k/q_i) + s_ijk + e_ijk + w_ik: gain and
//! slope of the instrument, the place, the scatter of its own Fourier bins, and the excess that window and trend add.

use chacha20::rand_core::Rng;
use measurements::CompositeOfFiles;
use spectrum::ProfilePsd;
use topography::Average;

use crate::gains::{Gains, Prior};
use crate::instrument_bins::{InstrumentBin, InstrumentBins};
use crate::instruments::instruments;
use crate::overlap::overlaps;
use crate::results::{InstrumentInput, OverlapMisfit};

/// The largest deviation of ln C in a draw, a factor of 22,000. Student's t of two scans has no variance, and an
/// interval this wide means that nothing is known.
const MAX_DEVIATION: f64 = 10.0;

/// An uncertain composite of scans.
#[derive(Debug)]
pub(crate) struct ScanScatter {
    wavelengths_m: Vec<f64>,
    /// The logarithm of C of the composite as it is.
    pub ln_c1d: Vec<f64>,
    average: Average,
    instruments: Vec<InstrumentBins>,
    gains: Gains,
    /// The instruments, for the report.
    pub descriptions: Vec<InstrumentInput>,
    /// Their overlaps, for the report.
    pub overlaps: Vec<OverlapMisfit>,
}

impl ScanScatter {
    pub fn from_scans(scans: &CompositeOfFiles) -> Self {
        let (instruments, mut descriptions) = instruments(scans);
        let bins = &scans.spectrum.composite.bins;
        let priors: Vec<Prior> = descriptions.iter().map(Prior::new).collect();
        let found = overlaps(&instruments, &priors, bins);
        let gains = Gains::new(&priors, &found.observations);
        for (at, descriptions) in descriptions.iter_mut().enumerate() {
            descriptions.gain = gains.gain_of(at);
        }
        ScanScatter {
            wavelengths_m: bins.iter().map(|bin| bin.wavelength_m).collect(),
            ln_c1d: bins.iter().map(|bin| bin.c1d_m3.ln()).collect(),
            average: scans.spectrum.recipe.average,
            instruments,
            gains,
            descriptions,
            overlaps: found.misfits,
        }
    }

    /// True if any of its scans scatter.
    pub fn scatters(&self) -> bool {
        self.instruments.iter().any(InstrumentBins::scatters)
    }

    /// True if any height scale is uncertain.
    pub fn has_gains(&self) -> bool {
        self.gains.scatter()
    }

    /// The deviations of ln C of every instrument in a draw of its scans, in every bin.
    pub fn places(&self, numbers: &mut impl Rng) -> Vec<Vec<f64>> {
        self.instruments.iter().map(|instrument| instrument.draw(numbers)).collect()
    }

    /// The deviations of ln C that the gains of instruments make in a draw, in every bin.
    pub fn gains(&self, numbers: &mut impl Rng) -> Vec<Vec<f64>> {
        self.of_gains(&self.gains.draw(numbers))
    }

    /// ln C of the best estimates: scans without deviations and excess, and the mean gains after all overlaps.
    pub fn best(&self) -> Vec<f64> {
        let no_places = vec![vec![0.0; self.ln_c1d.len()]; self.instruments.len()];
        self.composed(&no_places, &self.of_gains(&self.gains.mean))
    }

    /// The median number of places of an instrument in the bins that it reaches.
    pub fn places_in_a_bin(&self, instrument: usize) -> usize {
        let instrument = &self.instruments[instrument];
        let mut places: Vec<usize> = instrument.bins.iter().flatten().map(|bin| bin.places).collect();
        places.sort_unstable();
        places.get(places.len() / 2).copied().unwrap_or(0)
    }

    /// For every instrument, all gains if its own were known exactly.
    pub fn gains_without_each(&self) -> Vec<Gains> {
        (0..self.instruments.len()).map(|instrument| self.gains.without(instrument)).collect()
    }

    /// The deviations of ln C that gains and slopes make, for every instrument in every bin.
    pub fn of_gains(&self, gains: &[[f64; 2]]) -> Vec<Vec<f64>> {
        let of_instrument = |(instrument, [gain, slope]): (&InstrumentBins, &[f64; 2])| {
            let of_bin =
                |bin: &Option<InstrumentBin>| bin.as_ref().map_or(0.0, |bin| -(gain + slope * bin.ln_q));
            instrument.bins.iter().map(of_bin).collect()
        };
        self.instruments.iter().zip(gains).map(of_instrument).collect()
    }

    /// ln C of the composite of instruments with these deviations, in every bin.
    pub fn composed(&self, places: &[Vec<f64>], gains: &[Vec<f64>]) -> Vec<f64> {
        let of_bin = |(at, centre): (usize, &f64)| {
            let of_instruments = self.instruments.iter().enumerate().filter_map(|(i, instrument)| {
                let bin = instrument.bins[at].as_ref()?;
                let deviation = places[i][at] + gains[i][at] - bin.excess;
                Some((bin.weight, deviation.clamp(-MAX_DEVIATION, MAX_DEVIATION)))
            });
            let moved: f64 = match self.average {
                Average::Arithmetic => {
                    of_instruments.map(|(weight, deviation)| weight * deviation.exp()).sum::<f64>().ln()
                }
                _ => of_instruments.map(|(weight, deviation)| weight * deviation).sum(),
            };
            centre + moved
        };
        self.ln_c1d.iter().enumerate().map(of_bin).collect()
    }

    /// The composite of a draw as a spectrum.
    pub fn psd(&self, ln_c1d: &[f64]) -> Option<ProfilePsd> {
        let values = ln_c1d.iter().map(|ln| ln.exp()).collect();
        ProfilePsd::new(self.wavelengths_m.clone(), values).ok()
    }

    /// The part of an instrument in the composite, in every bin.
    pub fn weights(&self, instrument: usize) -> Vec<f64> {
        self.instruments[instrument]
            .bins
            .iter()
            .map(|bin| bin.as_ref().map_or(0.0, |bin| bin.weight))
            .collect()
    }
}
