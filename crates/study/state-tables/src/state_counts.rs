//! States that want a word.

use stat_contact::ContactState;

/// How many states are held at a bound, or rest on asperities that their law was not fitted for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct StateCounts {
    /// All that were counted.
    pub all: usize,
    /// Beyond complete contact of every asperity.
    pub incomplete: usize,
    /// With more contact area than there is nominal area.
    pub clamped: usize,
    /// With most of their load on asperities outside the range of their law.
    pub out_of_range: usize,
}

impl StateCounts {
    /// Counts states.
    pub fn add<'s>(&mut self, states: impl IntoIterator<Item = &'s ContactState>) {
        for state in states {
            self.all += 1;
            self.incomplete += usize::from(state.separation_m.is_none());
            self.clamped += usize::from(state.clamped);
            self.out_of_range += usize::from(state.out_of_range_load_share > 0.5);
        }
    }
}

impl std::ops::AddAssign for StateCounts {
    fn add_assign(&mut self, other: Self) {
        self.all += other.all;
        self.incomplete += other.incomplete;
        self.clamped += other.clamped;
        self.out_of_range += other.out_of_range;
    }
}
