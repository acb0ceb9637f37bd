//! Random numbers, with a separate stream for everything that is drawn.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Normal numbers of mean 0 and variance 1.
#[derive(Debug)]
pub(crate) struct Normals(ChaCha8Rng);

impl Normals {
    /// Creates the stream of a seed and a number, independent of earlier draws.
    pub(crate) fn new(seed: u64, number: u64) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(number);
        Normals(stream)
    }

    pub(crate) fn next(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}
