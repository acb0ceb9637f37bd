//! Which of some things are the same.

use std::collections::HashMap;
use std::hash::Hash;

/// Things sorted into kinds of equals, the kinds in the order of their first appearance.
pub(super) struct Distinct {
    /// The first thing of every kind, by index.
    pub firsts: Vec<usize>,
    /// The kind of every thing, by index.
    pub kinds: Vec<usize>,
}

impl Distinct {
    /// Things are equal where their keys are.
    pub fn by<K: Hash + Eq>(keys: impl IntoIterator<Item = K>) -> Self {
        let mut known = HashMap::new();
        let mut firsts = Vec::new();
        let kind_of = |(at, key)| {
            *known.entry(key).or_insert_with(|| {
                firsts.push(at);
                firsts.len() - 1
            })
        };
        let kinds = keys.into_iter().enumerate().map(kind_of).collect();
        Distinct { firsts, kinds }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_share_a_kind_in_the_order_of_their_first_appearance() {
        let distinct = Distinct::by(["b", "a", "b", "c", "a"]);
        assert_eq!(
            (distinct.firsts.as_slice(), distinct.kinds.as_slice()),
            (&[0, 1, 3][..], &[0, 1, 0, 2, 1][..])
        );
    }
}
