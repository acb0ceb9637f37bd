//! Counts of states that deserve a note.

use stat_contact::ContactState;

/// Counts of states that are limited by a bound, or rest on asperities outside the range of their law.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct StateCounts {
    /// All states.
    pub all: usize,
    /// States beyond complete contact of every asperity.
    pub incomplete: usize,
    /// States with more contact area than nominal area.
    pub clamped: usize,
    /// States with most of their load on asperities outside the range of their law.
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
