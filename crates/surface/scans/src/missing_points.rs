//! Missing points of a scan.

/// The points of a scan that were not measured, by their index in the order of the heights.
///
/// A scan without any takes no memory for them, any other a bit for each of its points.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MissingPoints {
    words: Vec<u64>,
    count: usize,
}

const BITS: usize = u64::BITS as usize;

impl MissingPoints {
    /// Returns true if every point has a height.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Number of points without a height.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns true if this point has no height.
    #[inline]
    #[must_use]
    pub fn contains(&self, index: usize) -> bool {
        self.words.get(index / BITS).is_some_and(|word| word >> (index % BITS) & 1 == 1)
    }

    /// The points without a height, in rising order.
    pub fn indices(&self) -> impl Iterator<Item = usize> {
        self.words.iter().enumerate().flat_map(|(at, &word)| {
            (0..BITS).filter(move |bit| word >> bit & 1 == 1).map(move |bit| at * BITS + bit)
        })
    }

    /// Adds a point.
    pub(crate) fn insert(&mut self, index: usize) {
        if self.contains(index) {
            return;
        }
        if self.words.len() <= index / BITS {
            self.words.resize(index / BITS + 1, 0);
        }
        self.words[index / BITS] |= 1 << (index % BITS);
        self.count += 1;
    }
}

impl FromIterator<usize> for MissingPoints {
    fn from_iter<I: IntoIterator<Item = usize>>(indices: I) -> Self {
        let mut missing = Self::default();
        indices.into_iter().for_each(|index| missing.insert(index));
        missing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_found_where_they_were_put() {
        let missing: MissingPoints = [3, 64, 3, 200].into_iter().collect();
        assert_eq!((missing.count(), missing.indices().collect::<Vec<_>>()), (3, vec![3, 64, 200]));
        assert!(missing.contains(64) && !missing.contains(65) && !missing.contains(100_000));
        assert!(MissingPoints::default().is_empty() && MissingPoints::default().indices().next().is_none());
    }
}
