//! Runs chunks of states on any number of threads, with the same digits on each.

use std::fmt::Debug;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use crate::group::{Case, Group};
use crate::statistical::{Kind, StatisticalCase};
use crate::statistical_trial::{Sample, try_state};
use crate::tally::{Refused, Tally, Trial};
use crate::{Draw, Reach};

/// Number of states in a chunk.
const CHUNK: u64 = 2000;

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
pub(crate) fn try_case<C: Case>(group: Group, seed: u64, index: u64, tally: &mut Tally, catch: bool) {
    let mut draw = Draw::new(seed ^ group.seed, index);
    // A case that needs laws to be drawn may panic as well.
    let drawn = catch_unwind(AssertUnwindSafe(|| C::draw(&mut draw)));
    let Ok((case, reach)) = drawn else {
        Trial::new(tally, group.name, index, (&"drawing", Reach::Edge), draw).hold("no panic", false);
        return;
    };
    one(group.name, index, (&case, reach), draw, tally, catch, C::test);
}

/// Tests one state of a family; with `catch` a panic becomes a broken promise with its inputs.
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
    let trial = Trial::new(&mut own, family, index, case, draw.clone());
    if catch_unwind(AssertUnwindSafe(|| trial.run(test))).is_err() {
        own = Tally::default();
        Trial::new(&mut own, family, index, case, draw).hold("no panic", false);
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
