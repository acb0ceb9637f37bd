//! A run short enough for every change; `cargo xtask stress` is the long one.

use rayon::ThreadPoolBuilder;
use stress::{Group, Kind, Scope, Tally};

fn run(states: u64, seed: u64, threads: usize) -> Tally {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| stress::run(Scope::Everything, 0..states, seed, |_| ()))
}

#[test]
fn seven_thousand_states_break_nothing() {
    let tally = run(7_000, 20261121, 0);
    let broken: Vec<_> = tally
        .records
        .iter()
        .flat_map(|((family, promise), record)| {
            let line = move |example: &stress::WorstCase| format!("{family}: {promise}: {example:?}");
            record.examples.iter().map(line)
        })
        .collect();
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert_eq!(tally.states.len(), Kind::ALL.len() + Group::ALL.len());
    for ((family, quantity), spread) in &tally.spreads {
        if *quantity == "error over its estimate" {
            assert!(spread.len() > 15 && spread.quantile(0.95) < 1.0, "{family}: {spread:?}");
        }
    }
    assert!(tally.records.values().map(|record| record.tested).sum::<u64>() > 70_000);
}

#[test]
fn the_result_does_not_depend_on_the_threads() {
    assert_eq!(run(2_500, 7, 1), run(2_500, 7, 3));
}

#[test]
fn a_run_of_one_law_tries_its_states_alone_and_finds_the_same() {
    let family = Kind::EpSine.name();
    let whole = run(1_400, 7, 0);
    let alone = stress::run(Scope::Law(Kind::EpSine), 0..1_400, 7, |_| ());
    assert_eq!(alone.states.keys().collect::<Vec<_>>(), [&family]);
    let of_the_law = |tally: &Tally| -> Vec<_> {
        tally.records.clone().into_iter().filter(|((of, _), _)| *of == family).collect()
    };
    assert_eq!(of_the_law(&alone), of_the_law(&whole));
}

#[test]
fn a_run_of_one_group_finds_what_a_run_of_everything_finds() {
    let group = Group::named("interfaces").unwrap();
    let alone = stress::run(Scope::Group(group), 0..1, 7, |_| ());
    let whole = stress::run(Scope::Everything, 0..1, 7, |_| ());
    assert_eq!(alone.states.keys().collect::<Vec<_>>(), [&group.name]);
    let of_the_group = |tally: &Tally| -> Vec<_> {
        tally.records.clone().into_iter().filter(|((of, _), _)| *of == group.name).collect()
    };
    assert_eq!(of_the_group(&alone), of_the_group(&whole));
}
