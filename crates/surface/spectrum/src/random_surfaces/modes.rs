//! Random numbers of the waves of a periodic box.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Words of 32 bits per wave: two numbers of 64 bits.
const WORDS: u128 = 4;

/// Random numbers of each wave, independent of grid, band and order of evaluation.
///
/// [`AreaSpectrum::surface`](crate::random_surfaces::AreaSpectrum::surface) documents the scheme: key and nonce of the ChaCha8 stream,
/// and the words of each wave.
pub(crate) struct Draws {
    key: [u8; 32],
}

/// The two random numbers of a wave, both in [0, 1).
pub(crate) struct Draw {
    /// The phase, in turns.
    pub(crate) turn: f64,
    /// Determines the modulus if that is random.
    pub(crate) share: f64,
}

impl Draws {
    pub(crate) fn new(seed: u64, realisation: u64) -> Self {
        let mut key = *b"________________truearea surface";
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&realisation.to_le_bytes());
        Self { key }
    }

    /// Yields the draws of row n, starting at wave m.
    pub(crate) fn row(&self, n: i64, m: usize) -> impl Iterator<Item = Draw> {
        let mut words = ChaCha8Rng::from_seed(self.key);
        words.set_stream(if n >= 0 { 2 * n.unsigned_abs() } else { 2 * n.unsigned_abs() - 1 });
        words.set_word_pos(WORDS * m as u128);
        std::iter::repeat_with(move || Draw { turn: unit(words.next_u64()), share: unit(words.next_u64()) })
    }
}

/// Converts the upper 53 bits to a number in [0, 1).
fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}
