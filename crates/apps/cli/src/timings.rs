//! Times of reading, computing and writing, printed on request.

use std::time::{Duration, Instant};

use crate::stderr::say;

/// A stopwatch with named laps.
pub struct Timings {
    since: Instant,
    laps: Vec<(&'static str, Duration)>,
}

impl Timings {
    /// Starts.
    pub fn start() -> Self {
        Timings { since: Instant::now(), laps: Vec::new() }
    }

    /// Ends the lap that has just been run.
    pub fn lap(&mut self, name: &'static str) {
        self.laps.push((name, self.since.elapsed()));
        self.since = Instant::now();
    }

    /// Ends a lap in which something else was done as well, for so long in all.
    pub fn lap_with(&mut self, name: &'static str, other: &'static str, for_other: Duration) {
        self.laps.push((name, self.since.elapsed().saturating_sub(for_other)));
        self.laps.push((other, for_other));
        self.since = Instant::now();
    }

    /// Says the laps on stderr, if `wanted`.
    pub fn report(&self, wanted: bool) {
        if wanted {
            let laps: Vec<String> = self
                .laps
                .iter()
                .map(|(name, time)| format!("{name} {:.1} ms", time.as_secs_f64() * 1e3))
                .collect();
            say(&format!("timings: {}", laps.join(", ")));
        }
    }
}
