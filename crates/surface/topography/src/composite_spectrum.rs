//! The composite spectrum of several scans, and comparisons between them.

use std::collections::{BTreeMap, HashMap, HashSet};

use indexmap::IndexMap;
use scans::ScanAxis;
use spectrum::{Convention, Hole, Psd};
use units::display::{length, three_digits};
use units::{Remark, RemarkCode, RemarkLevel};

use crate::composite::average_scan_bins;
use crate::models_get::ModelsGet;
use crate::overlap::{DIRECTIONS_DIFFER, mixed_units};
use crate::recipe::{Average, Recipe};
use crate::remark::{SPECTRA_DIFFER, differ};
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
        let bins = &self.composite.bins;
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
        let mut places: Vec<usize> = (0..self.scans.len()).collect();
        self.both_directions().for_each(|(x, y)| places[y] = x);
        self.repeated.iter().for_each(|&(first, second)| places[second] = first);
        (0..places.len()).for_each(|at| places[at] = places[places[at]]);
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
            (!ratios.is_empty()).then(|| remark_on_directions(both([x, y]), &ratios, fast))
        });
        let overlaps = self.overlap_remarks(&names);
        let holes = Hole::remark(RemarkCode::ScanHoles, &self.holes());
        let kept = ModelsGet::new(&self.composite.profile(), &self.scans).map(ModelsGet::remark);
        let of_all = kept.into_iter().chain(self.bias()).chain(holes);
        of_scans.chain(same).chain(directions).chain(overlaps).chain(of_all).collect()
    }

    /// Remarks on single scans; scans of which the same holds share a remark.
    fn scan_remarks(&self, names: &[String]) -> Vec<Remark> {
        let mut gathered: IndexMap<String, (Remark, Vec<String>)> = IndexMap::new();
        for (scan, name) in self.scans.iter().zip(names) {
            for remark in scan.remarks() {
                let same = gathered.entry(format!("{remark:?}")).or_insert((remark, Vec::new()));
                same.1.push(name.clone());
            }
        }
        gathered.into_values().map(|(remark, names)| remark.about(names)).collect()
    }

    /// Remarks on scans that hold the same data, one for each group of them.
    fn same_data(&self, names: &[String]) -> Vec<Remark> {
        let mut alike: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for &(first, repeat) in &self.repeated {
            alike.entry(first).or_insert_with(|| vec![names[first].clone()]).push(names[repeat].clone());
        }
        alike.into_values().map(|names| Remark::new(RemarkCode::SameData).about(names)).collect()
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
            let remark = Remark::new(RemarkCode::OtherOverlaps).with("pairs", rest.len());
            let mut remark = remark.with("lowest", lowest).with("highest", highest);
            if differ(lowest) || differ(highest) {
                remark.level = RemarkLevel::Caution;
            }
            others = Some(remark);
        }
        let one = |overlap: &Overlap| {
            remark_on_overlap(overlap).about([overlap.first, overlap.second].map(|scan| names[scan].clone()))
        };
        listed.into_iter().map(one).chain(others).collect()
    }

    /// Remarks on the largest bias removed from the mean of logarithms.
    fn bias(&self) -> Option<Remark> {
        let average = self.recipe.average;
        let mut reached: HashMap<i64, usize> = HashMap::new();
        self.in_bins.iter().flatten().for_each(|bin| *reached.entry(bin.index).or_default() += 1);
        let is_freed = |bin: &&ScanBin| average == Average::LogUnbiased && reached[&bin.index] > 1;
        let bins = self.in_bins.iter().flatten().filter(is_freed);
        let factors = bins.map(|bin| (average.counted_m3(bin) / bin.c1d_m3, bin.wavelength_m));
        let (factor, wavelength_m) = factors.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Remark::new(RemarkCode::BiasRemoved).with("factor", factor).with("wavelength_m", wavelength_m))
    }
}

/// The remark on two scans where they overlap.
fn remark_on_overlap(overlap: &Overlap) -> Remark {
    let Overlap { ratio, bins, longest_m, shortest_m, .. } = *overlap;
    if let Some(units) = mixed_units(ratio) {
        let factor = ratio.max(1.0 / ratio).sqrt();
        return Remark::new(RemarkCode::MixedUnits).with("factor", factor).with("units", units);
    }
    let code = if differ(ratio) { RemarkCode::OverlapDiffers } else { RemarkCode::Overlap };
    let remark = Remark::new(code).with("ratio", ratio).with("bound", SPECTRA_DIFFER);
    match bins {
        1 => remark.with("wavelength_m", longest_m),
        _ => remark.with("bins", bins).with("longest_m", longest_m).with("shortest_m", shortest_m),
    }
}

/// The remark on the spectra of a map along both of its axes, compared decade by decade.
fn remark_on_directions(names: [String; 2], ratios: &[DirectionRatio], fast: Option<Direction>) -> Remark {
    let of_decade = |found: &DirectionRatio| {
        let (ratio, longest) = (three_digits(found.ratio), length(found.longest_m));
        match found.bins {
            1 => format!("{ratio} at {longest}"),
            _ => format!("{ratio} from {longest} to {}", length(found.shortest_m)),
        }
    };
    let code = match ratios.iter().any(DirectionRatio::is_anisotropic) {
        true => RemarkCode::DirectionsDiffer,
        false => RemarkCode::Directions,
    };
    let ratios = ratios.iter().map(of_decade).collect::<Vec<_>>().join(", ");
    let remark = Remark::new(code).about(names).with("ratios", ratios).with("bound", DIRECTIONS_DIFFER);
    match fast {
        Some(fast) => remark.with("fast", fast.to_string()),
        None => remark,
    }
}

/// Finds scans with the data of an earlier one, as indices (earlier, later).
fn repeated(scans: &[ScanSpectrum]) -> Vec<(usize, usize)> {
    let mut firsts: HashMap<Vec<u64>, Vec<usize>> = HashMap::new();
    let mut repeated = Vec::new();
    for (second, scan) in scans.iter().enumerate() {
        let alike =
            firsts.entry(scan.spectrum.c1d_m3.iter().map(|c1d_m3| c1d_m3.to_bits()).collect()).or_default();
        match alike.iter().find(|&&first| scans[first].spectrum == scan.spectrum) {
            Some(&first) => repeated.push((first, second)),
            None => alike.push(second),
        }
    }
    repeated
}

#[cfg(test)]
mod tests {
    use units::SceneKeys;

    use super::*;

    #[test]
    fn directions_are_compared_decade_by_decade() {
        let decade = |longest_m: f64, bins, ratio| DirectionRatio {
            longest_m,
            shortest_m: longest_m / 8.0,
            bins,
            ratio,
        };
        let names = || ["a, along x", "a, along y"].map(str::to_owned);
        let isotropic = [decade(8e-6, 9, 1.1), decade(8e-7, 1, 3.0)];
        assert_eq!(
            remark_on_directions(names(), &isotropic, Some(Direction::X)).words(&SceneKeys),
            "a, along y over a, along x: 1.1 from 8 µm to 1 µm, 3 at 800 nm; x is the fast axis of the scan"
        );
        let anisotropic = remark_on_directions(names(), &[decade(8e-6, 9, 0.5)], None);
        assert_eq!(anisotropic.level, RemarkLevel::Caution);
        assert_eq!(
            anisotropic.words(&SceneKeys),
            "a, along y over a, along x: 0.5 from 8 µm to 1 µm; a factor of 1.5 or more: the surface has a direction, or its \
             lines are offset against each other"
        );
    }
}
