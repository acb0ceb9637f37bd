//! The composite spectrum of several scans, and comparisons between them.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::iter;

use scans::ScanAxis;
use spectrum::{Convention, Hole, Psd};

use crate::composite::average_scan_bins;
use crate::recipe::{Average, Recipe};
use crate::remark::{Remark, ScanRemark, differ};
use crate::scan_bins::ScanBin;
use crate::scan_spectrum::ScanSpectrum;
use crate::{Composite, Direction, DirectionRatio, Overlap, TransformError, overlaps};

/// Smallest number of shared bins that can show a disagreement; in fewer, single lines scatter as much.
const LEAST_SHARED_BINS: usize = 3;

/// Most pairs of scans that have a remark each.
const MOST_PAIRS: usize = 45;

/// Pairs named where there are more: those that differ most.
const MOST_PAIRS_NAMED: usize = 10;

/// Two instruments whose spectra disagree.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct InstrumentsDisagree {
    /// The names of the scans.
    pub names: [String; 2],
    /// Mean ratio of the first to the second spectrum where they overlap.
    pub ratio: f64,
    /// Longest shared wavelength \[m\].
    pub longest_m: f64,
    /// Shortest shared wavelength \[m\].
    pub shortest_m: f64,
}

/// The spectra of scans and their composite.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CompositeSpectrum {
    /// Recipe of all spectra.
    pub recipe: Recipe,
    /// Spectra of the scans.
    pub scans: Vec<ScanSpectrum>,
    /// Spectra of the scans in the bins of the composite.
    pub in_bins: Vec<Vec<ScanBin>>,
    /// Pairs of scans with the same data, as indices (earlier, later).
    pub repeated: Vec<(usize, usize)>,
    /// Comparisons of scans at shared wavelengths.
    pub overlaps: Vec<Overlap>,
    /// The composite; repeated data count once in its standard errors.
    pub composite: Composite,
}

impl CompositeSpectrum {
    /// Averages the spectra of scans, made by this recipe.
    ///
    /// # Errors
    /// [`TransformError`] without scans, or with too few bins for a spectrum.
    pub fn new(scans: Vec<ScanSpectrum>, recipe: &Recipe) -> Result<Self, TransformError> {
        let reliable: Vec<_> = scans.iter().map(|scan| scan.reliable.clone()).collect();
        let in_bins: Vec<Vec<ScanBin>> =
            scans.iter().map(|scan| scan.in_bins(recipe.bins_per_decade)).collect();
        let composite = average_scan_bins(&in_bins, recipe.bins_per_decade, recipe.average)?;
        let repeated = repeated(&scans);
        let overlaps = overlaps(&reliable, recipe.bins_per_decade);
        Ok(CompositeSpectrum { recipe: *recipe, scans, in_bins, repeated, overlaps, composite })
    }

    /// Returns the composite as a spectrum with standard errors.
    ///
    /// # Errors
    /// [`TransformError`] if its values are not valid for a spectrum.
    pub fn psd(&self) -> Result<Psd, TransformError> {
        let bins = self.composite.bins();
        let wavelengths_m = bins.iter().map(|bin| bin.wavelength_m).collect();
        let values = bins.iter().map(|bin| bin.c1d_m3).collect();
        let errors = bins.iter().map(|bin| bin.standard_error_m3).collect();
        Ok(Psd::new(wavelengths_m, values, Convention::C1D)?.with_standard_errors(errors)?)
    }

    /// Names of the scans, numbered where two are the same.
    #[must_use]
    pub fn series_names<'s>(&'s self) -> Vec<String> {
        let mut taken = HashSet::from(["composite".to_owned()]);
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        let name_of = |scan: &'s ScanSpectrum| {
            // A number that is taken stays taken, so the search goes on where it ended last.
            let number = numbers.entry(&scan.name).or_insert(1);
            loop {
                let name = match *number {
                    1 => scan.name.clone(),
                    number => format!("{} ({number})", scan.name),
                };
                *number += 1;
                if taken.insert(name.clone()) {
                    return name;
                }
            }
        };
        self.scans.iter().map(name_of).collect()
    }

    /// Holes in the composite, from long to short wavelengths.
    #[must_use]
    pub fn holes(&self) -> Vec<Hole> {
        self.composite.profile().holes()
    }

    /// Finds the two instruments that disagree most, if by more than one surface in the same units allows; their
    /// composite is then not a spectrum of the surface.
    #[must_use]
    pub fn instruments_disagree(&self) -> Option<InstrumentsDisagree> {
        let is_significant = |overlap: &&Overlap| {
            overlap.bins >= LEAST_SHARED_BINS && differ(overlap.ratio) && !self.is_one_map(overlap)
        };
        let apart = |overlap: &&Overlap| overlap.ratio.ln().abs();
        let worst =
            self.overlaps.iter().filter(is_significant).max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        let names = self.series_names();
        Some(InstrumentsDisagree {
            names: [worst.first, worst.second].map(|scan| names[scan].clone()),
            ratio: worst.ratio,
            longest_m: worst.longest_m,
            shortest_m: worst.shortest_m,
        })
    }

    /// Yields the indices of the two spectra of each map that has one along each axis; they follow each other.
    fn both_directions(&self) -> impl Iterator<Item = (usize, usize)> {
        let is_pair = |&(x, y): &(usize, usize)| {
            [x, y].map(|scan| self.scans[scan].axis) == [Some(ScanAxis::X), Some(ScanAxis::Y)]
        };
        (1..self.scans.len()).map(|y| (y - 1, y)).filter(is_pair)
    }

    /// Place of each scan, as the index of the first scan there. The two spectra of one map share a place, and so do
    /// repeated data.
    #[must_use]
    pub fn places(&self) -> Vec<usize> {
        let mut places: Vec<usize> = Vec::new();
        for at in 0..self.scans.len() {
            let repeats = self.repeated.iter().find(|(_, second)| *second == at).map(|(first, _)| *first);
            let is_second_axis = self.both_directions().any(|(_, y)| y == at);
            let same_as = repeats.or(is_second_axis.then(|| at - 1));
            places.push(same_as.map_or(at, |other| places[other]));
        }
        places
    }

    /// Number of places.
    #[must_use]
    pub fn place_count(&self) -> usize {
        self.places().iter().enumerate().filter(|(at, place)| at == *place).count()
    }

    /// Returns true if the two spectra are those of one map along both axes, not of two instruments.
    fn is_one_map(&self, overlap: &Overlap) -> bool {
        let (x, y) = (overlap.first, overlap.second);
        y == x + 1 && self.scans[x].axis == Some(ScanAxis::X) && self.scans[y].axis == Some(ScanAxis::Y)
    }

    /// Collects remarks: assumptions of the reader, and checks of each spectrum, of overlaps and of the composite.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        let names = self.series_names();
        let both = |scans: [usize; 2]| scans.map(|scan| names[scan].clone());
        let of_scans = self.scan_remarks(&names).into_iter();
        let same = self.same_data(&names);
        let directions = self.both_directions().filter_map(|(x, y)| {
            let [of_x, of_y] = [x, y].map(|scan| &self.scans[scan].reliable);
            let ratios = DirectionRatio::per_decade(of_x, of_y, self.recipe.bins_per_decade);
            let fast = self.scans[x].fast_axis.map(Direction::from);
            (!ratios.is_empty()).then(|| Remark::Directions { names: both([x, y]), ratios, fast })
        });
        let overlaps = self.overlap_remarks(&names);
        let holes = Some(self.holes()).filter(|holes| !holes.is_empty()).map(Remark::Holes);
        of_scans.chain(same).chain(directions).chain(overlaps).chain(self.bias()).chain(holes).collect()
    }

    /// Remarks on single scans; scans of which the same holds share a remark.
    fn scan_remarks(&self, names: &[String]) -> Vec<Remark> {
        let mut gathered: Vec<(ScanRemark, Vec<String>)> = Vec::new();
        for (scan, name) in self.scans.iter().zip(names) {
            for remark in scan.remarks() {
                match gathered.iter_mut().find(|(other, _)| *other == remark) {
                    Some((_, names)) => names.push(name.clone()),
                    None => gathered.push((remark, vec![name.clone()])),
                }
            }
        }
        gathered.into_iter().map(|(remark, names)| Remark::Scan { names, remark }).collect()
    }

    /// Remarks on scans that hold the same data, one for each group of them.
    fn same_data(&self, names: &[String]) -> Vec<Remark> {
        let repeats_of = |first: usize| {
            let repeats = self.repeated.iter().filter(move |(of, _)| *of == first).map(|(_, scan)| *scan);
            iter::once(first).chain(repeats).map(|scan| names[scan].clone()).collect()
        };
        let firsts: BTreeSet<usize> = self.repeated.iter().map(|(first, _)| *first).collect();
        firsts.into_iter().map(|first| Remark::SameData { names: repeats_of(first) }).collect()
    }

    /// Remarks on each pair of scans that overlap or, of many pairs, on those that differ most and on all others together.
    fn overlap_remarks(&self, names: &[String]) -> Vec<Remark> {
        let places = self.places();
        let is_listed = |overlap: &&Overlap| places[overlap.first] != places[overlap.second];
        let mut listed: Vec<&Overlap> = self.overlaps.iter().filter(is_listed).collect();
        let mut others = None;
        if listed.len() > MOST_PAIRS {
            listed.sort_by(|a, b| b.ratio.ln().abs().total_cmp(&a.ratio.ln().abs()));
            let rest = listed.split_off(MOST_PAIRS_NAMED);
            let lowest = rest.iter().map(|overlap| overlap.ratio).fold(f64::INFINITY, f64::min);
            let highest = rest.iter().map(|overlap| overlap.ratio).fold(0.0, f64::max);
            others = Some(Remark::OtherOverlaps { pairs: rest.len(), ratios: [lowest, highest] });
        }
        let one = |overlap: &Overlap| Remark::Overlap {
            names: [overlap.first, overlap.second].map(|scan| names[scan].clone()),
            ratio: overlap.ratio,
            bins: overlap.bins,
            longest_m: overlap.longest_m,
            shortest_m: overlap.shortest_m,
        };
        listed.into_iter().map(one).chain(others).collect()
    }

    /// Remarks on the largest bias removed from the mean of logarithms.
    fn bias(&self) -> Option<Remark> {
        let average = self.recipe.average;
        let bins = self.in_bins.iter().flatten().filter(|_| average == Average::LogUnbiased);
        let factors = bins.map(|bin| (average.counted_m3(bin) / bin.c1d_m3, bin.wavelength_m));
        let (factor, wavelength_m) = factors.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Remark::BiasRemoved { factor, wavelength_m })
    }
}

/// Finds scans with the data of an earlier one, as indices (earlier, later).
fn repeated(scans: &[ScanSpectrum]) -> Vec<(usize, usize)> {
    let of_an_earlier = |second: usize| {
        let first = (0..second).find(|&first| scans[first].spectrum == scans[second].spectrum)?;
        Some((first, second))
    };
    (1..scans.len()).filter_map(of_an_earlier).collect()
}
