//! Groups of states besides those of the statistical model.

use std::fmt::Debug;

use crate::run::try_case;
use crate::tally::{Refused, Tally, Trial};
use crate::{
    AdhesionCase, AsperityCase, BallCase, Draw, ElementsCase, InterfacesCase, IntervalsCase, LawTablesCase,
    PerssonCase, Reach, RoughnessCase, ScansCase, SpectraCase, StackCase, SummitsCase,
};

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

/// Group of states, each with a seed of its own, so that groups draw independently.
#[derive(Debug, Clone, Copy)]
pub struct Group {
    /// Name in reports.
    pub name: &'static str,
    /// Number of states of the statistical model for each state of the group.
    pub every: u64,
    /// Bits that distinguish the seed of the group from that of a run.
    pub(crate) seed: u64,
    /// Draws and tests the state with a number, with the seed of a run; with `true` it catches a panic.
    pub(crate) try_case: TryCase,
}

type TryCase = fn(Group, u64, u64, &mut Tally, bool);

impl Group {
    /// All groups.
    pub const ALL: [Group; 13] = [
        Group::new("single asperity", 20, 0x0061_7370_6572_6974, try_case::<AsperityCase>),
        Group::new("stack", 40, 0x0073_7461_636b, try_case::<StackCase>),
        Group::new("persson", 40, 0x7065_7273_736f_6e00, try_case::<PerssonCase>),
        Group::new("summits", 20, 0x7375_6d6d_6974_7300, try_case::<SummitsCase>),
        Group::new("elements", 100, 0x656c_656d_656e_7473, try_case::<ElementsCase>),
        Group::new("adhesion", 400, 0x6164_6865_7369_6f6e, try_case::<AdhesionCase>),
        Group::new("balls", 400, 0x6261_6c6c_7300_0000, try_case::<BallCase>),
        Group::new("spectra", 40, 0x7370_6563_7472_6100, try_case::<SpectraCase>),
        Group::new("scans", 50, 0x7363_616e_7300_0000, try_case::<ScansCase>),
        Group::new("intervals", 20, 0x696e_7465_7276_616c, try_case::<IntervalsCase>),
        Group::new("interfaces", 10, 0x696e_7465_7266_6163, try_case::<InterfacesCase>),
        Group::new("law-tables", 50, 0x6c61_772d_7461_626c, try_case::<LawTablesCase>),
        Group::new("roughness", 50, 0x726f_7567_686e_6573, try_case::<RoughnessCase>),
    ];

    const fn new(name: &'static str, every: u64, seed: u64, try_case: TryCase) -> Self {
        Group { name, every, seed, try_case }
    }

    /// Returns the group with a name.
    ///
    /// # Errors
    /// The names that there are.
    pub fn named(name: &str) -> Result<Self, String> {
        let group = Self::ALL.into_iter().find(|group| group.name == name);
        group.ok_or_else(|| format!("there are: {}", Self::ALL.map(|group| group.name).join("; ")))
    }
}
