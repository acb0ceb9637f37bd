//! Random numbers of draws. Every group and draw has a stream of its own, so that draws do not depend on their order or
//! on the number of threads, and one group can be redrawn while the others stay.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use crate::group::Group;

/// The most draws of one group.
const MAX_DRAWS: u64 = 1 << 48;

/// An upper bound on the number of groups.
const GROUPS: u64 = 16;

/// The random numbers of a scene.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Streams {
    seed: u64,
}

impl Streams {
    pub fn new(seed: u64) -> Self {
        Streams { seed }
    }

    /// The random numbers of a group in a draw.
    pub fn of(self, group: Group, draw: u64) -> ChaCha8Rng {
        self.of_surface(group, draw, 0)
    }

    /// Draws a standard normal number that belongs to no group.
    pub fn deviate_beside(self, draw: u64) -> f64 {
        let mut numbers = ChaCha8Rng::seed_from_u64(self.seed);
        numbers.set_stream((GROUPS - 1) * MAX_DRAWS + draw);
        StandardNormal.sample(&mut numbers)
    }

    /// Returns the random numbers of a group in a draw, for the first or the second surface.
    pub fn of_surface(self, group: Group, draw: u64, surface: u64) -> ChaCha8Rng {
        let mut numbers = ChaCha8Rng::seed_from_u64(self.seed);
        numbers.set_stream((group as u64 + GROUPS * surface) * MAX_DRAWS + draw);
        numbers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_group_and_draw_has_numbers_of_its_own() {
        let first =
            |group, draw| -> f64 { rand_distr::StandardNormal.sample(&mut Streams::new(1).of(group, draw)) };
        assert_eq!(first(Group::Scans, 3), first(Group::Scans, 3));
        assert_ne!(first(Group::Scans, 3), first(Group::Scans, 4));
        assert_ne!(first(Group::Scans, 3), first(Group::Material, 3));
    }
}
