//! Random numbers, with a separate stream for every state.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Random stream of one state: it depends on seed and number alone, not on earlier draws or on the thread.
#[derive(Debug)]
pub struct Draw(ChaCha8Rng);

impl Draw {
    /// Creates the stream of the state `index` of a run with a seed.
    pub fn new(seed: u64, index: u64) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(index);
        Draw(stream)
    }

    /// Draws uniformly from \[low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Draws between 10^low and 10^high, uniformly in the exponent.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }

    /// Returns true with the probability `share`.
    pub fn chance(&mut self, share: f64) -> bool {
        self.between(0.0, 1.0) < share
    }

    /// Draws one of several with equal probability.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.0.next_u64() % choices.len() as u64) as usize]
    }

    /// Returns a value, or the double next to it on either side, or one up to 1e-6 of it away.
    pub fn near(&mut self, value: f64) -> f64 {
        match self.0.next_u64() % 4 {
            0 => value,
            1 => value.next_up(),
            2 => value.next_down(),
            _ => value * (1.0 + self.one_of(&[-1.0, 1.0]) * self.decades(-16.0, -6.0)),
        }
    }

    /// Draws a positive double from the edges of their range, or anywhere in it.
    pub fn edge(&mut self) -> f64 {
        const SMALLEST: f64 = 5e-324;
        let anywhere = self.decades(-323.0, 308.0);
        self.one_of(&[
            SMALLEST,
            f64::MIN_POSITIVE,
            1e-300,
            1e-155,
            1.0,
            1e155,
            1e300,
            f64::MAX,
            anywhere,
            anywhere,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::Draw;

    #[test]
    fn a_stream_depends_on_seed_and_number_alone() {
        let first = |seed, index| Draw::new(seed, index).between(0.0, 1.0);
        assert_eq!(first(1, 7), first(1, 7));
        assert_ne!(first(1, 7), first(1, 8));
        assert_ne!(first(1, 7), first(2, 7));
    }

    #[test]
    fn numbers_lie_within_their_ranges() {
        let mut draw = Draw::new(3, 0);
        for _ in 0..1000 {
            assert!((-2.0..5.0).contains(&draw.between(-2.0, 5.0)));
            assert!((1e-4..1e3).contains(&draw.decades(-4.0, 3.0)));
            assert!(draw.edge() > 0.0);
            assert!((draw.near(2.0) / 2.0 - 1.0).abs() < 2e-6);
        }
    }
}
