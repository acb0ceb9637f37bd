//! Rows of a curve that are limited by a bound or lie outside the range of a law.

use crate::rows::{NarrowSpectra, StateCounts};
use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use persson::Cut;
use stacked_contact::Level;
use study::plan::{CurveResult, CutoffState};
use study::validity::SMALL_SLOPE_GRADIENT;
use units::{Remark, RemarkCode};

/// Counts of a curve, whose parts may come one by one.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CurveCounts {
    /// Statistical states.
    pub states: StateCounts,
    /// Cutoffs without summits.
    pub narrow: NarrowSpectra,
    /// Levels of a stack.
    pub levels: LevelCounts,
    /// Cuts of Persson's theory.
    pub cuts: CutCounts,
}

/// Levels beyond the range in which the elastic-plastic sinusoid is trusted.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LevelCounts {
    /// All levels.
    pub all: usize,
    /// Levels with B/B_c above [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`].
    pub beyond: usize,
}

/// Cutoffs at which the slopes are too steep for Persson's theory, and loads under which the whole contact yields.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CutCounts {
    /// All cutoffs, over all loads.
    pub all: usize,
    /// Cutoffs with an rms gradient above [`SMALL_SLOPE_GRADIENT`].
    pub steep: usize,
    /// The longest of their wavelengths \[m\].
    pub longest_steep_m: f64,
    /// The largest rms gradient.
    pub steepest: f64,
    /// Loads whose nominal pressure is not below the hardness.
    pub flowing: usize,
}

impl CurveCounts {
    /// Remarks on the rows counted so far.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        let narrow = self.narrow.remark(self.states.all + self.narrow.count);
        let of_states = self.states.remarks().into_iter().chain(narrow);
        of_states.chain(self.levels.remark()).chain(self.cuts.remarks()).collect()
    }

    /// Counts the rows of a curve, or of a part of one.
    pub fn add(&mut self, part: &CurveResult) {
        part.stacked().into_iter().flatten().for_each(|levels| self.levels.add(levels));
        part.persson().into_iter().flatten().for_each(|cuts| self.cuts.add(cuts));
        part.statistical().into_iter().flatten().for_each(|rows| self.add_states(rows));
    }

    fn add_states(&mut self, rows: &[CutoffState]) {
        let contacts = rows.iter().filter_map(|row| row.contact.as_ref());
        self.states.add(contacts.map(|(_, state)| state));
        rows.iter().filter_map(|row| row.too_narrow_alpha).for_each(|alpha| self.narrow.add(alpha));
    }
}

impl LevelCounts {
    /// The remark on levels beyond the trusted range, if there are any.
    #[must_use]
    pub fn remark(&self) -> Option<Remark> {
        let remark =
            Remark::new(RemarkCode::LevelsOutOfRange).with("levels", self.beyond).with("all", self.all);
        (self.beyond > 0).then(|| remark.with("bound", FLAGGED_ASPECT_RATIO_OVER_CRITICAL))
    }

    /// Counts levels.
    pub fn add(&mut self, levels: &[Level]) {
        let flagged =
            |level: &&Level| level.aspect_ratio_over_critical > Some(FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        self.all += levels.len();
        self.beyond += levels.iter().filter(flagged).count();
    }
}

impl CutCounts {
    fn remarks(&self) -> Vec<Remark> {
        let flowing = Remark::new(RemarkCode::FlowingLoads).with("loads", self.flowing);
        let steep = Remark::new(RemarkCode::SteepCutoffs)
            .with("steep", self.steep)
            .with("all", self.all)
            .with("longest_steep_m", self.longest_steep_m)
            .with("bound", SMALL_SLOPE_GRADIENT)
            .with("steepest", self.steepest);
        let found = [(self.flowing > 0, flowing), (self.steep > 0, steep)];
        found.into_iter().filter_map(|(is_found, remark)| is_found.then_some(remark)).collect()
    }

    fn add(&mut self, block: &[Cut]) {
        self.flowing += usize::from(block.first().is_some_and(|cut| cut.areas.plastic == 1.0));
        self.all += block.len();
        for cut in block.iter().filter(|cut| cut.rms_gradient > SMALL_SLOPE_GRADIENT) {
            self.steep += 1;
            self.longest_steep_m = self.longest_steep_m.max(cut.wavelength_m);
            self.steepest = self.steepest.max(cut.rms_gradient);
        }
    }
}
