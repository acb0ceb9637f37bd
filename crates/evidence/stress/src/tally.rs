//! Tally of promises: how often each was tested and broken, and its worst case.

use std::collections::BTreeMap;
use std::fmt::Debug;

use crate::{Draw, Reach};

/// Position of a state in a run: its family and its number. Among equally bad states the first is kept, so that a
/// report does not depend on the order of the threads.
type Place = u64;

/// Promise of a family.
type Key = (&'static str, &'static str);

/// State that came closest to breaking a promise, or broke it most.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstCase {
    /// Measured value over the allowed one; above 1 the promise is broken.
    pub over_allowance: f64,
    /// Measured value.
    pub value: f64,
    /// Number of the state.
    pub index: Place,
    /// Range of its numbers.
    pub reach: Reach,
    /// Inputs, as a literal.
    pub case: String,
}

/// Record of one promise.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Number of tests.
    pub tested: u64,
    /// Number of failures.
    pub broken: u64,
    /// Worst state.
    pub worst: WorstCase,
    /// First states that broke it.
    pub examples: Vec<WorstCase>,
}

/// Histogram of values, even in the logarithm: fine enough for a median.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Spread {
    /// Number of values by tenths of decades.
    counts: BTreeMap<i32, u64>,
}

impl Spread {
    const PER_DECADE: f64 = 10.0;

    /// Adds a value; one that is not positive and finite counts as the smallest or the largest.
    pub fn note(&mut self, value: f64) {
        let place = (value.log10() * Self::PER_DECADE).floor();
        let place = if value > 0.0 { place.clamp(-4000.0, 4000.0) } else { -4000.0 };
        *self.counts.entry(place as i32).or_default() += 1;
    }

    /// Value below which a share of all lie, to a tenth of a decade; NaN without values.
    pub fn quantile(&self, share: f64) -> f64 {
        let wanted = share * self.len() as f64;
        let mut passed = 0;
        for (place, count) in &self.counts {
            passed += count;
            if passed as f64 >= wanted {
                return 10f64.powf((f64::from(*place) + 0.5) / Self::PER_DECADE);
            }
        }
        f64::NAN
    }

    /// Number of values.
    pub fn len(&self) -> u64 {
        self.counts.values().sum()
    }

    /// True if there are no values.
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }

    fn add(&mut self, other: Spread) {
        for (place, count) in other.counts {
            *self.counts.entry(place).or_default() += count;
        }
    }
}

/// Everything found in a range of states.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    /// Number of states by family.
    pub states: BTreeMap<&'static str, u64>,
    /// Number of states by family whose numbers a constructor refused.
    pub refused: BTreeMap<&'static str, u64>,
    /// Records of the promises.
    pub records: BTreeMap<Key, Record>,
    /// Spreads of measured quantities.
    pub spreads: BTreeMap<Key, Spread>,
}

impl Tally {
    /// Number of states kept as literals for each broken promise.
    const EXAMPLES: usize = 12;

    /// Adds the findings of another tally.
    pub fn joined(mut self, other: Tally) -> Tally {
        for (family, count) in other.states {
            *self.states.entry(family).or_default() += count;
        }
        for (family, count) in other.refused {
            *self.refused.entry(family).or_default() += count;
        }
        for (key, record) in other.records {
            match self.records.entry(key) {
                std::collections::btree_map::Entry::Vacant(entry) => {
                    entry.insert(record);
                }
                std::collections::btree_map::Entry::Occupied(mut entry) => entry.get_mut().add(record),
            }
        }
        for (key, spread) in other.spreads {
            self.spreads.entry(key).or_default().add(spread);
        }
        self
    }

    /// Number of promises broken.
    pub fn broken(&self) -> u64 {
        self.records.values().map(|record| record.broken).sum()
    }
}

impl Record {
    fn add(&mut self, other: Record) {
        self.tested += other.tested;
        self.broken += other.broken;
        self.examples.extend(other.examples);
        self.examples.sort_by_key(|example| example.index);
        self.examples.truncate(Tally::EXAMPLES);
        if other.worst.is_worse_than(&self.worst) {
            self.worst = other.worst;
        }
    }
}

impl WorstCase {
    fn is_worse_than(&self, other: &WorstCase) -> bool {
        let order = self.over_allowance.total_cmp(&other.over_allowance);
        order.is_gt() || (order.is_eq() && self.index < other.index)
    }
}

/// State that can be drawn and tested; printed, it is a literal that recreates it.
pub trait Case: Debug + Sized {
    /// Draws a random case, with the range of its numbers.
    fn draw(draw: &mut Draw) -> (Self, Reach);

    /// Tests every promise of the case of a trial.
    ///
    /// # Errors
    /// [`Refused`] if a constructor refuses its numbers.
    fn test(trial: &mut Trial<Self>) -> Result<(), Refused>;
}

/// A constructor refused the numbers of a case.
#[derive(Debug)]
pub struct Refused;

impl<E: std::error::Error> From<E> for Refused {
    fn from(_: E) -> Self {
        Refused
    }
}

/// Tests of one state, written into a tally.
#[derive(Debug)]
pub struct Trial<'a, C> {
    tally: &'a mut Tally,
    family: &'static str,
    index: Place,
    pub(crate) reach: Reach,
    pub(crate) case: &'a C,
    /// Chooses between alternatives, such as a second load.
    pub(crate) draw: Draw,
}

impl<'a, C: Debug> Trial<'a, C> {
    /// Begins the tests of a state by its family and number.
    pub fn new(
        tally: &'a mut Tally,
        family: &'static str,
        index: Place,
        (case, reach): (&'a C, Reach),
        draw: Draw,
    ) -> Self {
        *tally.states.entry(family).or_default() += 1;
        Trial { tally, family, index, reach, case, draw }
    }

    /// Runs a test, and counts a case whose numbers are refused.
    pub fn run(mut self, test: impl FnOnce(&mut Self) -> Result<(), Refused>) {
        if test(&mut self).is_err() {
            *self.tally.refused.entry(self.family).or_default() += 1;
        }
    }

    /// Records a promise that is kept or not.
    pub fn hold(&mut self, promise: &'static str, kept: bool) {
        self.bound(promise, if kept { 0.0 } else { 1.0 }, 0.5);
    }

    /// Records the promise that `value` is at most `allowed`; NaN breaks it.
    pub fn bound(&mut self, promise: &'static str, value: f64, allowed: f64) {
        let over_allowance = match value / allowed {
            ratio if !ratio.is_nan() => ratio,
            // Zero is within any allowance, even zero.
            _ if value == 0.0 || allowed == f64::INFINITY => 0.0,
            _ => f64::INFINITY,
        };
        let broken = over_allowance > 1.0;
        let (index, reach) = (self.index, self.reach);
        let worst = |case: &C| WorstCase { over_allowance, value, index, reach, case: format!("{case:?}") };
        let record = self.tally.records.entry((self.family, promise)).or_insert_with(|| Record {
            tested: 0,
            broken: 0,
            worst: worst(self.case),
            examples: Vec::new(),
        });
        record.tested += 1;
        if over_allowance > record.worst.over_allowance {
            record.worst = worst(self.case);
        }
        if broken {
            record.broken += 1;
            if record.examples.len() < Tally::EXAMPLES {
                record.examples.push(worst(self.case));
            }
        }
    }

    /// Records a quantity without a promise.
    pub fn note(&mut self, quantity: &'static str, value: f64) {
        self.tally.spreads.entry((self.family, quantity)).or_default().note(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tally_of(values: &[(u64, f64)]) -> Tally {
        let mut tally = Tally::default();
        for (index, value) in values {
            let mut trial = Trial::new(&mut tally, "family", *index, (value, Reach::Usual), Draw::new(0, 0));
            trial.bound("small", *value, 2.0);
            trial.note("size", *value);
        }
        tally
    }

    #[test]
    fn the_worst_is_kept_whatever_the_order() {
        let values = [(0, 1.0), (1, 3.0), (2, f64::NAN), (3, 0.5), (4, f64::INFINITY)];
        let whole = tally_of(&values);
        for cut in 0..values.len() {
            let (head, tail) = values.split_at(cut);
            let parts = tally_of(tail).joined(tally_of(head));
            // Compared as text, in which NaN equals NaN.
            assert_eq!(format!("{parts:?}"), format!("{whole:?}"));
        }
        let record = &whole.records[&("family", "small")];
        assert_eq!((record.tested, record.broken, record.worst.index), (5, 3, 2));
        assert_eq!(record.examples.iter().map(|example| example.index).collect::<Vec<_>>(), [1, 2, 4]);
        assert_eq!(record.examples[0].case, "3.0");
    }

    #[test]
    fn a_median_is_known_to_a_tenth_of_a_decade() {
        let mut spread = Spread::default();
        (1..=1001).for_each(|i| spread.note(f64::from(i)));
        assert!((spread.quantile(0.5) / 501.0).log10().abs() < 0.1);
        assert_eq!(spread.len(), 1001);
    }
}
