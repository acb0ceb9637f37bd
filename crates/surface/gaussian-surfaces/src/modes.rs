//! The waves of a periodic box, and the random numbers of each.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Words of 32 bits that belong to one wave: two numbers of 64 bits.
const WORDS: u128 = 4;

/// Random numbers by the wave that they belong to, whatever the grid, the band and the order in which waves are asked for.
///
/// The stream of ChaCha with 8 rounds has for its key the seed and the realisation, eight bytes each and the lowest first,
/// and then the sixteen bytes `truearea surface`; for its nonce of 64 bits the row of the wave, 2 n for n >= 0 and
/// -2 n - 1 below. The wave with m lengths along x (0 <= m) and n along y has the words 4 m to 4 m + 3 of that stream: two
/// numbers of 64 bits, the lower half first, of which the upper 53 bits are taken as a number from 0 to 1.
pub(crate) struct Draws {
    of_realisation: ChaCha8Rng,
}

/// The two numbers of a wave, both from 0 to below 1.
pub(crate) struct Draw {
    /// The phase, in turns.
    pub(crate) turn: f64,
    /// What decides the modulus, where that is random.
    pub(crate) share: f64,
}

impl Draws {
    pub(crate) fn new(seed: u64, realisation: u64) -> Self {
        let mut key = *b"________________truearea surface";
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&realisation.to_le_bytes());
        Self { of_realisation: ChaCha8Rng::from_seed(key) }
    }

    /// The draws of row n from the wave m on.
    pub(crate) fn row(&self, n: i64, m: usize) -> impl Iterator<Item = Draw> {
        let mut words = self.of_realisation.clone();
        words.set_stream(if n >= 0 { 2 * n.unsigned_abs() } else { 2 * n.unsigned_abs() - 1 });
        words.set_word_pos(WORDS * m as u128);
        std::iter::repeat_with(move || Draw { turn: unit(words.next_u64()), share: unit(words.next_u64()) })
    }
}

/// The upper 53 bits as a number from 0 to below 1.
fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}
