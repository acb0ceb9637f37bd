//! Rows of a curve that are limited by a bound or lie outside the range of a law.

use crate::rows::{NarrowSpectra, StateCounts};
use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use persson::Cut;
use stacked_contact::Level;
use study::plan::{CurveResult, CutoffState};
use study::validity::SMALL_SLOPE_GRADIENT;

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
    /// Counts levels.
    pub fn add(&mut self, levels: &[Level]) {
        let flagged =
            |level: &&Level| level.aspect_ratio_over_critical > Some(FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        self.all += levels.len();
        self.beyond += levels.iter().filter(flagged).count();
    }
}

impl CutCounts {
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
