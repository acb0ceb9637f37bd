//! Groups of states besides those of the statistical model.

use std::fmt::Debug;

use crate::tally::Trial;
use crate::{Draw, Reach};

/// State that can be drawn and tested; printed, it is a literal that recreates it.
pub trait Case: Debug + Sized {
    /// Draws a random case, with the range of its numbers.
    fn draw(draw: &mut Draw) -> (Self, Reach);

    /// Tests every promise of the case; `draw` chooses between alternatives, such as a second load.
    fn test(&self, reach: Reach, draw: &mut Draw, trial: &mut Trial<Self>);
}

/// Group of states, each with a seed of its own, so that groups draw independently.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// Laws of single asperities.
    Asperities,
    /// Stacks of scales.
    Stacks,
    /// Persson's theory.
    Persson,
    /// Theory of summits.
    Summits,
    /// Boundary elements.
    Elements,
    /// Boundary elements with adhesion.
    Adhesion,
    /// Balls on maps.
    Balls,
    /// Tables of spectra.
    Spectra,
    /// Scans with missing points.
    Scans,
    /// Intervals and shares from draws.
    Intervals,
    /// Conductance, leaks and tangential loads.
    Interfaces,
    /// Contact laws as tables.
    LawTables,
    /// Roughness parameters.
    Roughness,
}

impl Group {
    /// All groups.
    pub const ALL: [Group; 13] = [
        Group::Asperities,
        Group::Stacks,
        Group::Persson,
        Group::Summits,
        Group::Elements,
        Group::Adhesion,
        Group::Balls,
        Group::Spectra,
        Group::Scans,
        Group::Intervals,
        Group::Interfaces,
        Group::LawTables,
        Group::Roughness,
    ];

    /// Name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Group::Asperities => "single asperity",
            Group::Stacks => "stack",
            Group::Persson => "persson",
            Group::Summits => "summits",
            Group::Elements => "elements",
            Group::Adhesion => "adhesion",
            Group::Balls => "balls",
            Group::Spectra => "spectra",
            Group::Scans => "scans",
            Group::Intervals => "intervals",
            Group::Interfaces => "interfaces",
            Group::LawTables => "law-tables",
            Group::Roughness => "roughness",
        }
    }

    /// Number of states of the statistical model for each state of the group.
    #[must_use]
    pub fn every(self) -> u64 {
        match self {
            Group::Interfaces => 10,
            Group::Asperities | Group::Summits | Group::Intervals => 20,
            Group::Stacks | Group::Persson | Group::Spectra => 40,
            Group::Scans | Group::LawTables | Group::Roughness => 50,
            Group::Elements => 100,
            Group::Adhesion | Group::Balls => 400,
        }
    }

    /// Bits that distinguish the seed of the group from that of a run.
    pub(crate) fn seed(self) -> u64 {
        match self {
            Group::Asperities => 0x0061_7370_6572_6974,
            Group::Stacks => 0x0073_7461_636b,
            Group::Persson => 0x7065_7273_736f_6e00,
            Group::Summits => 0x7375_6d6d_6974_7300,
            Group::Elements => 0x656c_656d_656e_7473,
            Group::Adhesion => 0x6164_6865_7369_6f6e,
            Group::Balls => 0x6261_6c6c_7300_0000,
            Group::Spectra => 0x7370_6563_7472_6100,
            Group::Scans => 0x7363_616e_7300_0000,
            Group::Intervals => 0x696e_7465_7276_616c,
            Group::Interfaces => 0x696e_7465_7266_6163,
            Group::LawTables => 0x6c61_772d_7461_626c,
            Group::Roughness => 0x726f_7567_686e_6573,
        }
    }
}
