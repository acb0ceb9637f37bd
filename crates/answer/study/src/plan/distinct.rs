//! Removal of repetitions.

use std::collections::HashMap;
use std::hash::Hash;

/// Distinct values, and the index of each original value among them.
#[derive(Debug)]
pub struct Distinct<T> {
    /// The things that differ, in the order of their first appearance.
    pub items: Vec<T>,
    /// For each of the things, repetitions included, its index among `items`.
    pub index_of: Vec<usize>,
}

impl<T> Distinct<T> {
    /// Removes repetitions in one pass, for things that can be hashed.
    pub fn of(things: impl IntoIterator<Item = T>) -> Self
    where
        T: Copy + Hash + Eq,
    {
        Self::by_key(things, |thing| *thing)
    }

    /// Removes repetitions in one pass, for things that have the same key if they are the same.
    pub fn by_key<K: Hash + Eq>(things: impl IntoIterator<Item = T>, key: impl Fn(&T) -> K) -> Self {
        let mut known = HashMap::new();
        let mut items = Vec::new();
        let index_of = |thing| {
            *known.entry(key(&thing)).or_insert_with(|| {
                items.push(thing);
                items.len() - 1
            })
        };
        let index_of = things.into_iter().map(index_of).collect();
        Distinct { items, index_of }
    }

    /// Each against every other, for few things that can only be compared.
    pub fn compared(things: impl IntoIterator<Item = T>) -> Self
    where
        T: PartialEq,
    {
        let mut items: Vec<T> = Vec::new();
        let index_of = |thing| {
            items.iter().position(|item| *item == thing).unwrap_or_else(|| {
                items.push(thing);
                items.len() - 1
            })
        };
        let index_of = things.into_iter().map(index_of).collect();
        Distinct { items, index_of }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetitions_lead_to_the_first_of_their_like() {
        let things = ["b", "a", "b", "c", "a"];
        for distinct in [Distinct::of(things), Distinct::compared(things)] {
            assert_eq!(distinct.items, ["b", "a", "c"]);
            assert_eq!(distinct.index_of, [0, 1, 0, 2, 1]);
        }
    }
}
