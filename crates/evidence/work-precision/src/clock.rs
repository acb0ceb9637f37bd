//! Stopwatch.

use std::hint::black_box;
use std::time::Instant;

/// Shortest pass; a shorter one measures the clock rather than the work.
const LEAST_PASS_S: f64 = 20e-6;

/// Seconds per call: the shortest of as many passes as fit into `budget_s` seconds, at least three.
pub fn seconds_per_call<T>(budget_s: f64, mut call: impl FnMut() -> T) -> f64 {
    let mut pass = |calls: u32| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        start.elapsed().as_secs_f64()
    };
    let mut calls = 1;
    while pass(calls) < LEAST_PASS_S && calls < 1 << 20 {
        calls *= 2;
    }
    let (mut shortest, mut spent, mut passes) = (f64::INFINITY, 0.0, 0);
    while passes < 3 || spent < budget_s {
        let took = pass(calls);
        (shortest, spent, passes) = (shortest.min(took), spent + took, passes + 1);
    }
    shortest / f64::from(calls)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_calls_are_repeated_until_the_clock_can_see_them() {
        let mut calls = 0u64;
        let seconds = seconds_per_call(1e-4, || calls += 1);
        assert!(calls > 100 && seconds > 0.0, "{calls} calls, {seconds} s");
    }
}
