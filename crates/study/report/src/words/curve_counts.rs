//! Counts of what is remarkable in the rows of a curve, and the notes that they make.

use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use persson::Cut;
use stacked_contact::Level;
use state_tables::{NarrowSpectra, StateCounts};
use study::plan::{CurveResult, CutoffState};
use study::validity::SMALL_SLOPE_GRADIENT;
use units::display::{counted, length, three_digits};
use units::number;

/// The notes on the states of a statistical curve, or on the cuts of Persson's theory.
pub fn statistical_notes(result: &CurveResult) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add(result);
    counts.notes()
}

/// The notes on one block of a curve.
pub(crate) fn notes_of_block(result: &CurveResult, block: usize) -> Vec<String> {
    let mut counts = CurveCounts::default();
    match result {
        CurveResult::Stacked(blocks) => counts.levels.add(&blocks[block..=block]),
        CurveResult::Persson(blocks) => counts.cuts.add(&blocks[block..=block]),
        CurveResult::Statistical(blocks) => {
            counts.add_states(&blocks[block]);
        }
    }
    counts.notes()
}

/// The note on levels beyond the range of the elastic-plastic sinusoid, if there are any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let mut counts = LevelCounts::default();
    counts.add(curve);
    counts.note()
}

/// Counts of remarkable rows of a curve, which may come part by part.
#[derive(Debug, Default)]
pub struct CurveCounts {
    states: StateCounts,
    narrow: NarrowSpectra,
    levels: LevelCounts,
    cuts: CutCounts,
}

impl CurveCounts {
    /// Counts the rows of a curve, or of a part of one.
    pub fn add(&mut self, part: &CurveResult) {
        match part {
            CurveResult::Stacked(blocks) => self.levels.add(blocks),
            CurveResult::Persson(blocks) => self.cuts.add(blocks),
            CurveResult::Statistical(blocks) => {
                blocks.iter().for_each(|rows| self.add_states(rows));
            }
        }
    }

    fn add_states(&mut self, rows: &[CutoffState]) {
        let contacts = rows.iter().filter_map(|row| row.contact.as_ref());
        self.states.add(contacts.map(|(_, state)| state));
        rows.iter().filter_map(|row| row.too_narrow_alpha).for_each(|alpha| self.narrow.add(alpha));
    }

    /// The notes on all rows so far.
    pub fn notes(&self) -> Vec<String> {
        let all = counted(self.states.all + self.narrow.count, "row");
        let narrow = narrow_spectra(&self.narrow, &all);
        let of_states = notes_of_states(&self.states).into_iter().chain(narrow);
        of_states.chain(self.levels.note()).chain(self.cuts.notes()).collect()
    }
}

/// The note on spectra without summits, if there are any.
pub(crate) fn narrow_spectra(narrow: &NarrowSpectra, of: &str) -> Option<String> {
    // Rounded down, so that none reads 1.5.
    let [lowest, highest] = narrow.alphas?.map(|alpha| number((1e3 * alpha).floor() / 1e3));
    let alphas = if lowest == highest { lowest } else { format!("{lowest} to {highest}") };
    Some(format!(
        "{} of {of}: alpha = m0 m4/m2^2 is {alphas}, below the 1.5 that every surface reaches: no summits, no result",
        narrow.count
    ))
}

/// The notes on states, with those beyond complete contact.
pub fn notes_of_states(counts: &StateCounts) -> Vec<String> {
    let what = "beyond complete contact of every asperity, area fraction 1, no separation";
    of_states(counts.incomplete, counts, what).into_iter().chain(state_notes(counts)).collect()
}

/// The notes on states but those beyond complete contact.
pub(crate) fn state_notes(counts: &StateCounts) -> Vec<String> {
    let clamped = of_states(
        counts.clamped,
        counts,
        "more contact area than there is nominal area, held at an area fraction of 1",
    );
    let out_of_range = of_states(
        counts.out_of_range,
        counts,
        "most of the load on asperities outside the fitted range of their law",
    );
    clamped.into_iter().chain(out_of_range).collect()
}

fn of_states(found: usize, counts: &StateCounts, what: &str) -> Option<String> {
    (found > 0).then(|| format!("{found} of {}: {what}", counted(counts.all, "state")))
}

/// Levels beyond the range of their law.
#[derive(Debug, Default)]
struct LevelCounts {
    all: usize,
    beyond: usize,
}

impl LevelCounts {
    fn add(&mut self, curve: &[Vec<Level>]) {
        let flagged =
            |level: &&Level| level.aspect_ratio_over_critical > Some(FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        self.all += curve.iter().map(Vec::len).sum::<usize>();
        self.beyond += curve.iter().flatten().filter(flagged).count();
    }

    fn note(&self) -> Option<String> {
        let LevelCounts { all, beyond } = self;
        (*beyond > 0).then(|| {
            format!(
                "{beyond} of {}: B/B_c above {FLAGGED_ASPECT_RATIO_OVER_CRITICAL}, beyond the range of the elastic-plastic sinusoid",
                counted(*all, "level")
            )
        })
    }
}

/// Cutoffs at which slopes are too steep for the theory, and loads under which everything that touches flows.
#[derive(Debug, Default)]
pub(crate) struct CutCounts {
    all: usize,
    steep: usize,
    longest_steep_m: f64,
    steepest: f64,
    /// Loads whose nominal pressure is not below the hardness.
    flowing: usize,
}

impl CutCounts {
    pub fn add(&mut self, blocks: &[Vec<Cut>]) {
        for block in blocks {
            self.flowing += usize::from(block.first().is_some_and(|cut| cut.areas.plastic == 1.0));
            self.all += block.len();
            for cut in block.iter().filter(|cut| cut.rms_gradient > SMALL_SLOPE_GRADIENT) {
                self.steep += 1;
                self.longest_steep_m = self.longest_steep_m.max(cut.wavelength_m);
                self.steepest = self.steepest.max(cut.rms_gradient);
            }
        }
    }

    pub fn notes(&self) -> impl Iterator<Item = String> {
        let CutCounts { all, steep, longest_steep_m, steepest, flowing } = self;
        let of_slopes = (*steep > 0).then(|| {
            format!(
                "{steep} of {}, from {} down: the rms gradient h' exceeds {SMALL_SLOPE_GRADIENT} (up to {}) and with it s = E* h'/2 exceeds \
                 E*/10; the theory assumes small slopes",
                counted(*all, "cutoff"),
                length(*longest_steep_m),
                three_digits(*steepest)
            )
        });
        let of_flow = (*flowing > 0).then(|| {
            format!(
                "{}: the nominal pressure is not below the hardness; everything touches and flows, at every cutoff",
                counted(*flowing, "load")
            )
        });
        of_flow.into_iter().chain(of_slopes)
    }
}
