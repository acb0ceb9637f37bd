//! Spectra that are too narrow for any surface.

/// The number of spectra without summits, and the range of their alpha = m0 m4/m2^2.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct NarrowSpectra {
    /// The number of such spectra.
    pub count: usize,
    /// The lowest and the highest alpha; `None` if the number is 0.
    pub alphas: Option<[f64; 2]>,
}

impl NarrowSpectra {
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
