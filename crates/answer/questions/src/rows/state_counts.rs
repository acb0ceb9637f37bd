//! Counts of states, and of spectra without summits, that deserve a note.

use stat_contact::{ContactState, NoSeparation};
use units::{Remark, RemarkCode, number};

/// Counts of states that are limited by a bound, or rest on asperities outside the range of their law.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StateCounts {
    /// All states.
    pub all: usize,
    /// States beyond complete contact of every asperity.
    pub incomplete: usize,
    /// States with more load than all asperities carry once flattened.
    pub flattened: usize,
    /// Largest share of flattened asperities among the touching ones, over the other states.
    pub flattened_share: f64,
    /// States with more contact area than nominal area.
    pub clamped: usize,
    /// States with most of their load on asperities outside the range of their law.
    pub out_of_range: usize,
}

impl StateCounts {
    /// Remarks on those states, a kind each.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        // Below this share flattened asperities do not show.
        const VISIBLE_SHARE: f64 = 0.01;
        let kinds = [
            (RemarkCode::IncompleteStates, self.incomplete),
            (RemarkCode::FlattenedStates, self.flattened),
            (RemarkCode::ClampedStates, self.clamped),
            (RemarkCode::StatesOutOfRange, self.out_of_range),
        ];
        let found = kinds.into_iter().filter(|(_, states)| *states > 0);
        let counted =
            found.map(|(code, states)| Remark::new(code).with("states", states).with("all", self.all));
        let flattened = (self.flattened_share > VISIBLE_SHARE)
            .then(|| Remark::new(RemarkCode::FlattenedAsperities).with("share", self.flattened_share));
        counted.chain(flattened).collect()
    }

    /// Counts states.
    pub fn add<'s>(&mut self, states: impl IntoIterator<Item = &'s ContactState>) {
        for state in states {
            self.all += 1;
            match state.no_separation() {
                Some(NoSeparation::CompleteContact) => self.incomplete += 1,
                Some(NoSeparation::AllFlattened) => self.flattened += 1,
                None => self.flattened_share = self.flattened_share.max(state.flattened_share.unwrap_or(0.0)),
            }
            self.clamped += usize::from(state.clamped);
            self.out_of_range += usize::from(state.out_of_range_load_share > 0.5);
        }
    }
}

impl std::ops::AddAssign for StateCounts {
    fn add_assign(&mut self, other: Self) {
        self.all += other.all;
        self.incomplete += other.incomplete;
        self.flattened += other.flattened;
        self.flattened_share = self.flattened_share.max(other.flattened_share);
        self.clamped += other.clamped;
        self.out_of_range += other.out_of_range;
    }
}

/// The number of spectra without summits, and the range of their alpha = m0 m4/m2^2.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct NarrowSpectra {
    /// The number of such spectra.
    pub count: usize,
    /// The lowest and the highest alpha; `None` if the number is 0.
    pub alphas: Option<[f64; 2]>,
}

impl NarrowSpectra {
    /// The remark on such spectra among the spectra of all rows, if there are any.
    #[must_use]
    pub fn remark(&self, all: usize) -> Option<Remark> {
        // Rounded down, so that none reads 1.5.
        let [lowest, highest] = self.alphas?.map(|alpha| number((1e3 * alpha).floor() / 1e3));
        let alphas = if lowest == highest { lowest } else { format!("{lowest} to {highest}") };
        let remark = Remark::new(RemarkCode::NarrowSpectra).with("narrow", self.count).with("all", all);
        Some(remark.with("alphas", alphas))
    }

    /// Counts a spectrum.
    pub fn add(&mut self, alpha: f64) {
        let [lowest, highest] = self.alphas.unwrap_or([alpha; 2]);
        self.count += 1;
        self.alphas = Some([lowest.min(alpha), highest.max(alpha)]);
    }
}

impl std::ops::AddAssign for NarrowSpectra {
    fn add_assign(&mut self, other: Self) {
        let both = self.alphas.into_iter().chain(other.alphas);
        self.alphas = both.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        self.count += other.count;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_of_alpha_is_kept() {
        let mut narrow = NarrowSpectra::default();
        [1.3, 1.1, 1.2].into_iter().for_each(|alpha| narrow.add(alpha));
        assert_eq!(narrow, NarrowSpectra { count: 3, alphas: Some([1.1, 1.3]) });
    }
}
