//! Runs chunks of states on any number of threads, with the same digits on each.

use std::fmt::Debug;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use crate::statistical::{Kind, StatisticalCase};
use crate::statistical_trial::{Sample, try_state};
use crate::tally::{Case, Refused, Tally, Trial};
use crate::{
    AdhesionCase, AsperityCase, BallCase, Draw, ElementsCase, InterfacesCase, IntervalsCase, LawTablesCase,
    PerssonCase, Reach, RoughnessCase, ScansCase, SpectraCase, StackCase, SummitsCase,
};

/// Number of states in a chunk.
const CHUNK: u64 = 2000;

/// Group of states, each with a seed of its own, so that groups draw independently.
#[derive(Debug, Clone, Copy)]
pub struct Group {
    /// Name in reports.
    pub name: &'static str,
    /// Number of states of the statistical model for each state of the group.
    pub every: u64,
    /// Bits that distinguish the seed of the group from that of a run.
    seed: u64,
    /// Draws and tests the state with a number, with the seed of a run; with `true` it catches a panic.
    try_case: TryCase,
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

/// Scope of a run.
#[derive(Debug, Clone, Copy)]
pub enum Scope {
    /// States of every law of the statistical model, and of all groups in proportion.
    Everything,
    /// States of one law, out of the same states.
    Law(Kind),
    /// States of one group, one for each number.
    Group(Group),
}

/// Draws the states with these numbers, as far as they are in the scope, and tests each, on
/// the threads of the current pool. `done` receives the number of states of each finished chunk.
pub fn run(scope: Scope, states: Range<u64>, seed: u64, done: impl Fn(u64) + Sync) -> Tally {
    (states.start / CHUNK..states.end.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let range = (chunk * CHUNK).max(states.start)..((chunk + 1) * CHUNK).min(states.end);
            let length = range.end - range.start;
            let tally = try_range(scope, seed, range);
            done(length);
            tally
        })
        .reduce(Tally::default, Tally::joined)
}

/// Tests a range of states; if one of them panics, they are repeated one by one.
fn try_range(scope: Scope, seed: u64, range: Range<u64>) -> Tally {
    let whole = catch_unwind(|| {
        let mut tally = Tally::default();
        range.clone().for_each(|index| try_one(scope, seed, index, &mut tally, false));
        tally
    });
    whole.unwrap_or_else(|_| {
        let mut tally = Tally::default();
        range.for_each(|index| try_one(scope, seed, index, &mut tally, true));
        tally
    })
}

fn try_one(scope: Scope, seed: u64, index: u64, tally: &mut Tally, catch: bool) {
    match scope {
        Scope::Group(group) => (group.try_case)(group, seed, index, tally, catch),
        Scope::Law(kind) if kind != kind_of(index) => (),
        Scope::Law(_) => try_statistical(seed, index, tally, catch),
        Scope::Everything => {
            try_statistical(seed, index, tally, catch);
            let drawn = |group: &Group| index.is_multiple_of(group.every);
            Group::ALL.into_iter().filter(drawn).for_each(|group| {
                (group.try_case)(group, seed, index, tally, catch);
            });
        }
    }
}

fn kind_of(index: u64) -> Kind {
    Kind::ALL[(index % Kind::ALL.len() as u64) as usize]
}

fn try_statistical(seed: u64, index: u64, tally: &mut Tally, catch: bool) {
    let mut draw = Draw::new(seed, index);
    let kind = kind_of(index);
    // Samples are taken evenly from all kinds.
    let sample = Sample::for_state(index / Kind::ALL.len() as u64);
    let (case, reach) = StatisticalCase::draw(&mut draw, kind);
    one(kind.name(), index, (&case, reach), draw, tally, catch, |trial| try_state(sample, trial));
}

/// Draws and tests the state of a group with a number.
fn try_case<C: Case>(group: Group, seed: u64, index: u64, tally: &mut Tally, catch: bool) {
    let mut draw = Draw::new(seed ^ group.seed, index);
    // A case that needs laws to be drawn may panic as well.
    let drawn = catch_unwind(AssertUnwindSafe(|| C::draw(&mut draw)));
    let Ok((case, reach)) = drawn else {
        Trial::new(tally, group.name, index, (&"drawing", Reach::Edge), draw).hold("no panic", false);
        return;
    };
    one(group.name, index, (&case, reach), draw, tally, catch, C::test);
}

/// Tests one state of a family; with `catch` a panic becomes a broken promise with its inputs, and draws nothing.
fn one<C: Debug>(
    family: &'static str,
    index: u64,
    case: (&C, Reach),
    draw: Draw,
    tally: &mut Tally,
    catch: bool,
    test: impl FnOnce(&mut Trial<C>) -> Result<(), Refused>,
) {
    if !catch {
        return Trial::new(tally, family, index, case, draw).run(test);
    }
    let mut own = Tally::default();
    let trial = Trial::new(&mut own, family, index, case, draw);
    if catch_unwind(AssertUnwindSafe(|| trial.run(test))).is_err() {
        own = Tally::default();
        Trial::new(&mut own, family, index, case, Draw::new(0, index)).hold("no panic", false);
    }
    *tally = std::mem::take(tally).joined(own);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_reported_with_its_inputs_and_the_others_go_on() {
        let mut tally = Tally::default();
        for (index, case) in [1, 2, 3].iter().enumerate() {
            let index = index as u64;
            one("family", index, (case, Reach::Usual), Draw::new(0, index), &mut tally, true, |trial| {
                assert!(*case != 2);
                trial.hold("fine", true);
                Ok(())
            });
        }
        let panics = &tally.records[&("family", "no panic")];
        assert_eq!((panics.broken, panics.worst.index, panics.worst.case.as_str()), (1, 1, "2"));
        assert_eq!((tally.states["family"], tally.records[&("family", "fine")].tested), (3, 2));
    }
}
