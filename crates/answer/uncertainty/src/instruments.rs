//! The instruments of a composite: their scans, their data in every bin, and their description.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{LN_10, TAU};

use indexmap::IndexMap;
use measurements::CompositeOfFiles;
use topography::{Average, CompositeBin, ScanBin, ScanSpectrum};

use crate::instrument_bins::{Beside, InstrumentBin, InstrumentBins, variance_of_logarithm};
use crate::results::{InstrumentInput, InstrumentName, Resampled};
use crate::smooth_spectrum::SmoothSpectrum;

/// The assumed standard uncertainty of an unknown height scale.
pub const ASSUMED_Z_CALIBRATION: f64 = 0.03;

/// The distance over which the scatter between places is compared with that of Fourier bins \[decades\].
const POOLED_DECADES: f64 = 0.5;

/// Most instruments that are told apart; the cost grows with the fourth power of their number.
const MOST_INSTRUMENTS: usize = 10;

/// The instruments of a composite in the order of their first scans, and their descriptions. Beyond
/// [`MOST_INSTRUMENTS`], all further ones count as one, which widens the range.
pub(crate) fn instruments(scans: &CompositeOfFiles) -> (Vec<InstrumentBins>, Vec<InstrumentInput>) {
    let mut own: IndexMap<&str, Vec<usize>> = IndexMap::new();
    for (scan, source) in scans.sources.iter().enumerate() {
        own.entry(source.instrument.name.as_str()).or_default().push(scan);
    }
    let mut own: Vec<Vec<usize>> = own.into_values().collect();
    if own.len() > MOST_INSTRUMENTS {
        let further = own.split_off(MOST_INSTRUMENTS - 1).concat();
        own.push(further);
    }
    let places = scans.spectrum.places();
    let offsets = offsets_of_scans(scans);
    let of_instruments: Vec<OwnScans<'_>> =
        own.iter().map(|own| OwnScans::new(scans, own, &places, &offsets)).collect();
    let mut bins: Vec<InstrumentBins> = of_instruments.iter().map(OwnScans::in_bins).collect();
    lend_place_scatter(&mut bins, &of_instruments);
    let descriptions = of_instruments.iter().zip(&bins).map(|(own, bins)| own.description(bins)).collect();
    (bins, descriptions)
}

/// Known offsets of ln C of a scan in a bin from that of the surface in the composite's bin.
#[derive(Debug, Clone, Copy, Default)]
struct Offsets {
    /// The excess that window and trend add.
    excess: f64,
    /// Scans of other lengths have their Fourier bins elsewhere in the bin, where the spectrum is another.
    of_wavelength: f64,
}

/// The offsets of every scan in its bins. The surface is taken to have a smooth spectrum through the composite.
fn offsets_of_scans(scans: &CompositeOfFiles) -> Vec<BTreeMap<i64, Offsets>> {
    let found = &scans.spectrum;
    let surface = SmoothSpectrum::through(&found.composite.bins);
    let c1d_m3 = |q_rad_per_m: f64| surface.c1d_m3(TAU / q_rad_per_m);
    let indices: BTreeSet<i64> = found.in_bins.iter().flatten().map(|bin| bin.index).collect();
    let wavelengths_m: BTreeMap<i64, f64> = indices
        .into_iter()
        .zip(&found.composite.bins)
        .map(|(index, bin)| (index, bin.wavelength_m))
        .collect();
    let of_scan = |(scan, bins): (&ScanSpectrum, &Vec<ScanBin>)| {
        let excess = scan.window_excess(bins, &found.recipe, c1d_m3);
        let of_bin = |(bin, excess): (&ScanBin, f64)| {
            let [own_m3, shared_m3] =
                [bin.wavelength_m, wavelengths_m[&bin.index]].map(|m| surface.c1d_m3(m));
            (bin.index, Offsets { excess, of_wavelength: (own_m3 / shared_m3).ln() })
        };
        bins.iter().zip(excess).map(of_bin).collect()
    };
    found.scans.iter().zip(&found.in_bins).map(of_scan).collect()
}

/// Lends the scatter between places, known of instruments with several, to the others.
fn lend_place_scatter(instruments: &mut [InstrumentBins], own: &[OwnScans<'_>]) {
    let known: Vec<f64> = own.iter().filter_map(OwnScans::place_variance).collect();
    let mean = if known.is_empty() { 0.0 } else { known.iter().sum::<f64>() / known.len() as f64 };
    for (instrument, own) in instruments.iter_mut().zip(own) {
        instrument.place_sd = own.place_variance().unwrap_or(mean).sqrt();
    }
}

/// The scans of one instrument.
struct OwnScans<'s> {
    scans: &'s CompositeOfFiles,
    /// Its scans, by index.
    own: Vec<usize>,
    /// The distinct places of these scans.
    places: Vec<usize>,
    /// The place of each scan, by index.
    place_of: Vec<usize>,
    /// The data in each bin of the composite, by scan.
    in_bins: Vec<Vec<(usize, &'s ScanBin)>>,
    /// The mean offsets of these scans in each bin of the composite.
    offsets: Vec<Offsets>,
}

impl<'s> OwnScans<'s> {
    fn new(
        scans: &'s CompositeOfFiles,
        own: &[usize],
        places: &[usize],
        offsets: &[BTreeMap<i64, Offsets>],
    ) -> Self {
        let found = &scans.spectrum;
        let distinct: Vec<usize> =
            own.iter().map(|&scan| places[scan]).collect::<BTreeSet<_>>().into_iter().collect();
        let place_of =
            own.iter().map(|&scan| distinct.partition_point(|&place| place < places[scan])).collect();
        let indices: BTreeSet<i64> = found.in_bins.iter().flatten().map(|bin| bin.index).collect();
        let of_bin = |index: &i64| {
            let of_scan = |(at, &scan): (usize, &usize)| {
                let bins = &found.in_bins[scan];
                let bin = bins.binary_search_by_key(index, |bin| bin.index).ok()?;
                Some((at, &bins[bin]))
            };
            own.iter().enumerate().filter_map(of_scan).collect()
        };
        let in_bins = indices.iter().map(of_bin).collect();
        let mean_offsets = |index: &i64| {
            let of_scans: Vec<Offsets> =
                own.iter().filter_map(|&scan| offsets[scan].get(index).copied()).collect();
            let mean =
                |of: fn(&Offsets) -> f64| of_scans.iter().map(of).sum::<f64>() / of_scans.len().max(1) as f64;
            Offsets { excess: mean(|of| of.excess), of_wavelength: mean(|of| of.of_wavelength) }
        };
        let offsets = indices.iter().map(mean_offsets).collect();
        OwnScans { scans, own: own.to_vec(), places: distinct, place_of, in_bins, offsets }
    }

    fn average(&self) -> Average {
        self.scans.spectrum.recipe.average
    }

    fn bins(&self) -> &'s [CompositeBin] {
        &self.scans.spectrum.composite.bins
    }

    /// The only map of the instrument, if its parts can represent places.
    fn only_map(&self) -> Option<&'s ScanSpectrum> {
        let only = &self.scans.spectrum.scans[self.own[0]];
        (self.places.len() == 1 && !only.spectrum.parts_m3.is_empty()).then_some(only)
    }

    fn in_bins(&self) -> InstrumentBins {
        let reached: Vec<f64> = self.reached().map(|bin| -bin.wavelength_m.ln()).collect();
        let middle = 0.5 * (reached[0] + reached[reached.len() - 1]);
        let bins = self.in_bins.iter().zip(self.bins());
        let mut bins: Vec<Option<InstrumentBin>> = bins
            .zip(&self.offsets)
            .map(|((scans, bin), offsets)| self.bin(scans, bin, middle, *offsets))
            .collect();
        self.split_scatter(&mut bins);
        let units = self.only_map().map_or(self.places.len(), |map| map.spectrum.parts_m3.len());
        InstrumentBins { units, place_sd: 0.0, is_one_place: self.places.len() == 1, bins }
    }

    /// Splits the scatter between places into that of their Fourier bins, which is chi-squared and independent from bin
    /// to bin, and the rest, which keeps the deviations, made smaller. The ratio of both variances is averaged over
    /// [`POOLED_DECADES`] to either side, since two or three scans do not tell it in a single bin.
    fn split_scatter(&self, bins: &mut [Option<InstrumentBin>]) {
        if self.only_map().is_some() {
            return;
        }
        let of_bin = |(bin, scans): (&Option<InstrumentBin>, &Vec<(usize, &ScanBin)>)| {
            let bin = bin.as_ref().filter(|bin| bin.deviations.len() > 1)?;
            let count = bin.deviations.len() as f64;
            let freedom = scans.iter().map(|(_, scan)| scan.degrees_of_freedom.unwrap_or(2.0));
            let freedom = (freedom.sum::<f64>() / count).max(1.0);
            let squares: f64 = bin.deviations.iter().map(|(_, off)| off * off).sum();
            let ratio = squares / (count - 1.0) / variance_of_logarithm(freedom);
            Some((bin.ln_q, freedom, ratio))
        };
        let found: Vec<Option<(f64, f64, f64)>> = bins.iter().zip(&self.in_bins).map(of_bin).collect();
        for (bin, here) in bins.iter_mut().zip(&found) {
            let (Some(bin), Some((ln_q, degrees_of_freedom, _))) = (bin.as_mut(), here) else { continue };
            let near =
                found.iter().flatten().filter(|(other, ..)| (other - ln_q).abs() < POOLED_DECADES * LN_10);
            let ratios: Vec<f64> = near.map(|(.., ratio)| *ratio).collect();
            let ratio = ratios.iter().sum::<f64>() / ratios.len() as f64;
            let rest = (1.0 - 1.0 / ratio).max(0.0).sqrt();
            let places = bin.deviations.len();
            bin.beside = Beside::OwnBinsOfPlaces { degrees_of_freedom: *degrees_of_freedom, places };
            bin.deviations.iter_mut().for_each(|(_, off)| *off *= rest);
        }
    }

    /// The bins that the instrument reaches, from long to short wavelengths; there is one at least.
    fn reached(&self) -> impl Iterator<Item = &'s CompositeBin> {
        self.in_bins.iter().zip(self.bins()).filter(|(scans, _)| !scans.is_empty()).map(|(_, bin)| bin)
    }

    fn bin(
        &self,
        scans: &[(usize, &ScanBin)],
        bin: &CompositeBin,
        middle: f64,
        offsets: Offsets,
    ) -> Option<InstrumentBin> {
        let (_, first) = scans.first()?;
        let average = self.average();
        let weight = match average {
            Average::Arithmetic => {
                let own: f64 = scans.iter().map(|(_, scan)| scan.c1d_m3).sum();
                own * bin.kept / (bin.c1d_m3 * bin.measurements as f64)
            }
            _ => scans.len() as f64 / bin.measurements as f64,
        };
        let ln_of_places = self.ln_of_places(scans);
        let ln_mean = ln_of_places.iter().map(|(_, ln)| ln).sum::<f64>() / ln_of_places.len() as f64;
        let (deviations, beside) = match (self.only_map(), ln_of_places.len()) {
            (Some(_), _) if !first.parts_m3.is_empty() => parts(first),
            (_, 1) => (Vec::new(), own_bins(first, bin.measurements)),
            _ => (ln_of_places.iter().map(|(place, ln)| (*place, ln - ln_mean)).collect(), Beside::Nothing),
        };
        Some(InstrumentBin {
            places: ln_of_places.len(),
            weight,
            ln_q: -bin.wavelength_m.ln() - middle,
            ln_mean: ln_mean - offsets.excess - offsets.of_wavelength,
            excess: offsets.excess,
            deviations,
            beside,
        })
    }

    /// ln C at each place without bias, for any average of the composite; the mean over several scans.
    fn ln_of_places(&self, scans: &[(usize, &ScanBin)]) -> Vec<(usize, f64)> {
        let at_place = |place: usize| {
            let ln: Vec<f64> = scans
                .iter()
                .filter(|(at, _)| self.place_of[*at] == place)
                .map(|(_, bin)| Average::LogUnbiased.counted_m3(bin).ln())
                .collect();
            (!ln.is_empty()).then(|| (place, ln.iter().sum::<f64>() / ln.len() as f64))
        };
        (0..self.places.len()).filter_map(at_place).collect()
    }

    /// The variance of ln C between places beyond that of the Fourier bins, over bins with several places; `None`
    /// without such a bin.
    fn place_variance(&self) -> Option<f64> {
        let of_bin = |scans: &Vec<(usize, &ScanBin)>| {
            let places = self.ln_of_places(scans);
            let count = places.len() as f64;
            let mean = places.iter().map(|(_, ln)| ln).sum::<f64>() / count;
            let squares: f64 = places.iter().map(|(_, ln)| (ln - mean).powi(2)).sum();
            let own: f64 =
                scans.iter().map(|(_, bin)| own_bins(bin, 2).variance()).sum::<f64>() / scans.len() as f64;
            (places.len() > 1).then(|| squares / (count - 1.0) - own)
        };
        let of_bins: Vec<f64> = self.in_bins.iter().filter_map(of_bin).collect();
        let mean = of_bins.iter().sum::<f64>() / of_bins.len() as f64;
        (!of_bins.is_empty()).then(|| mean.max(0.0))
    }

    fn description(&self, bins: &InstrumentBins) -> InstrumentInput {
        let instruments = || self.own.iter().map(|&scan| &self.scans.sources[scan].instrument);
        let files = || self.own.iter().map(|&scan| self.scans.sources[scan].file.as_str());
        let are_texts = instruments().all(|instrument| instrument.layout.is_some());
        let names: BTreeSet<&str> = instruments().map(|instrument| instrument.name.as_str()).collect();
        let name = match names.len() {
            1 => self.scans.sources[self.own[0]].instrument.name.clone(),
            count => format!("{count} further instruments"),
        };
        let is_shared = names.len() > 1 || are_texts && files().any(|file| Some(file) != files().next());
        let largest = |a: f64, b: f64| a.max(b);
        let z_calibration = instruments().filter_map(|instrument| instrument.z_calibration).reduce(largest);
        let mut reached = self.reached().map(|bin| bin.wavelength_m);
        let longest_m = reached.next().unwrap_or_default();
        InstrumentInput {
            name: match instruments().all(|instrument| instrument.is_guessed) {
                _ if is_shared => InstrumentName::Shared(name),
                true => InstrumentName::Guessed(name),
                false => InstrumentName::Given(name),
            },
            scans: self.places.len(),
            resampled: match (self.places.len(), self.only_map()) {
                (1, Some(_)) => Resampled::BlocksOfLines(bins.units),
                (1, None) => Resampled::SingleLine,
                (places, _) => Resampled::Scans(places),
            },
            z_calibration: z_calibration.unwrap_or(ASSUMED_Z_CALIBRATION),
            z_calibration_is_assumed: z_calibration.is_none(),
            slope_uncertainty: instruments().filter_map(|found| found.slope_uncertainty).fold(0.0, f64::max),
            gain: [0.0; 2],
            band_m: [longest_m, reached.last().unwrap_or(longest_m)],
        }
    }
}

/// The parts of a map as places, and the variance that they lack, since parts side by side are alike at long
/// wavelengths.
fn parts(bin: &ScanBin) -> (Vec<(usize, f64)>, Beside) {
    let deviations: Vec<(usize, f64)> =
        bin.parts_m3.iter().map(|part_m3| part_m3 / bin.c1d_m3 - 1.0).enumerate().collect();
    let count = deviations.len() as f64;
    let shown = deviations.iter().map(|(_, off)| off * off).sum::<f64>() / (count * (count - 1.0));
    let missing = own_bins(bin, 2).variance() - shown;
    (deviations, if missing > 0.0 { Beside::Variance(missing) } else { Beside::Nothing })
}

/// The scatter of a single scan by its own Fourier bins. The composite of several is freed from the bias of its logarithm, and
/// so are the deviations from it.
fn own_bins(bin: &ScanBin, measurements: usize) -> Beside {
    // Fewer than the two of one Fourier bin of one line there are none.
    let degrees_of_freedom = bin.degrees_of_freedom.unwrap_or(2.0);
    let is_unbiased = measurements > 1;
    let bias = if is_unbiased { -(Average::LogUnbiased.counted_m3(bin) / bin.c1d_m3).ln() } else { 0.0 };
    Beside::OwnBins { degrees_of_freedom, bias }
}
