#![doc = include_str!("../README.md")]

mod blocks;
mod one_thread;
mod progress;

pub use blocks::fill_blocks;
pub use one_thread::on_this_thread;
pub use progress::{Progress, Unobserved, WithinAStep};

#[cfg(feature = "threads")]
use rayon::prelude::*;

/// What `of` makes of every item, in their order.
pub fn map<T: Sync, U: Send>(items: &[T], of: impl Fn(&T) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_asked_for() {
        return items.par_iter().map(&of).collect();
    }
    items.iter().map(of).collect()
}

/// What `of` makes of every item, which it takes, in their order.
pub fn map_taken<T: Send, U: Send>(items: Vec<T>, of: impl Fn(T) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_asked_for() {
        return items.into_par_iter().map(&of).collect();
    }
    items.into_iter().map(of).collect()
}

/// What `of` makes of every number below `count`, in their order.
pub fn map_indices<U: Send>(count: usize, of: impl Fn(usize) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_asked_for() {
        return (0..count).into_par_iter().map(&of).collect();
    }
    (0..count).map(of).collect()
}

/// What `of` makes of every item, in their order.
///
/// # Errors
/// The first error in the order of the items, however many threads there are.
pub fn try_map<T: Sync, U: Send, E: Send>(
    items: &[T],
    of: impl Fn(&T) -> Result<U, E> + Sync,
) -> Result<Vec<U>, E> {
    map(items, of).into_iter().collect()
}
