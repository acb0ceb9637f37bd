//! The study: every question to every engine.

use crate::competitors::{MissingPackage, Question, Row, Setting, States, Worker, package};
use crate::ours;
use crate::point::{Answer, Engine, GivenQuantity, Outcome, Point};
use crate::reference::Group;

/// Seconds for the repetitions of one of our states, before the competitors' and again after them.
const OUR_BUDGET_S: f64 = 2e-3;
/// Seconds for the competitors' repetitions, of which there are at least two.
const THEIR_BUDGET_S: f64 = 0.03;

/// Returns every answer to the states of a group. Ours are measured before and after theirs, so that a machine that
/// slows down or speeds up favours nobody.
pub fn points(group: &Group, worker: Option<&mut Worker>, missing: &[MissingPackage]) -> Vec<Point> {
    let mut worker = worker;
    let mut points = Vec::new();
    for given in GivenQuantity::ALL {
        let before = our_points(group, given);
        for engine in Engine::ALL.into_iter().filter(|engine| engine.knows(&group.case.model)) {
            let there = package(engine).is_some_and(|package| missing.iter().all(|m| m.package != package));
            let Some(worker) = worker.as_deref_mut().filter(|_| there) else { continue };
            for &setting in engine.settings() {
                points.extend(their_points(group, given, engine, setting, worker));
            }
        }
        let after = our_points(group, given);
        points.extend(before.into_iter().zip(after).map(|(a, b)| if a.seconds <= b.seconds { a } else { b }));
        points.extend(our_batches(group, given));
    }
    points
}

fn our_points(group: &Group, given: GivenQuantity) -> Vec<Point> {
    let mut points = Vec::new();
    for &tolerance in Engine::Ours.settings() {
        for at in 0..group.states.len() {
            let (answer, seconds) =
                ours::timed_answer(group, &group.states[at], given, tolerance, OUR_BUDGET_S);
            let outcome = Outcome::new(given, &answer, &group.states[at]);
            points.push(point(group, at, given, Engine::Ours, tolerance, seconds, outcome));
        }
    }
    points
}

fn our_batches(group: &Group, given: GivenQuantity) -> Vec<Point> {
    let mut points = Vec::new();
    for &tolerance in Engine::OursBatch.settings() {
        let (answers, seconds) = ours::timed_batch(group, given, tolerance, OUR_BUDGET_S);
        points.extend(answers.iter().enumerate().map(|(at, answer)| {
            let outcome = Outcome::new(given, answer, &group.states[at]);
            point(group, at, given, Engine::OursBatch, tolerance, seconds, outcome)
        }));
    }
    points
}

fn their_points(
    group: &Group,
    given: GivenQuantity,
    engine: Engine,
    setting: f64,
    worker: &mut Worker,
) -> Vec<Point> {
    let at = group.states.iter().map(|state| match given {
        GivenQuantity::Separation => state.separation_over_sigma,
        GivenQuantity::Pressure => state.pressure_pa.ln(),
    });
    let asked = Question {
        engine: worker_name(engine),
        setting: Setting::from_number(setting),
        by_pressure: given == GivenQuantity::Pressure,
        case: &group.case,
        at: States::Many(at.collect()),
        seconds: THEIR_BUDGET_S,
    };
    let rows = worker.ask(&asked);
    let outcome = |at: usize| match &rows {
        Ok(rows) => match rows.get(at) {
            Some(row) => (row.seconds, Outcome::new(given, &answer(row), &group.states[at])),
            None => (0.0, Outcome::Failed("no answer".to_owned())),
        },
        Err(reason) => (0.0, Outcome::Failed(reason.clone())),
    };
    let states = 0..group.states.len();
    states
        .map(|at| {
            let (seconds, outcome) = outcome(at);
            point(group, at, given, engine, setting, seconds, outcome)
        })
        .collect()
}

/// Name of an engine in `worker.py`.
fn worker_name(engine: Engine) -> &'static str {
    match engine {
        Engine::Ours | Engine::OursBatch => unreachable!("we answer for ourselves"),
        Engine::Quad => "quad",
        Engine::QuadNumpy => "quad numpy",
        Engine::Fn => "Fn",
        Engine::Grid => "grid",
        Engine::GridBatch => "grid batch",
    }
}

fn answer(row: &Row) -> Answer {
    Answer { separation_over_sigma: row.number(0), pressure_pa: row.number(1), area_fraction: row.number(2) }
}

fn point(
    group: &Group,
    at: usize,
    given: GivenQuantity,
    engine: Engine,
    setting: f64,
    seconds: f64,
    outcome: Outcome,
) -> Point {
    Point {
        population: group.population.clone(),
        law: group.case.law(),
        given,
        separation_over_sigma: group.states[at].separation_over_sigma.round(),
        engine,
        setting,
        seconds,
        outcome,
    }
}
