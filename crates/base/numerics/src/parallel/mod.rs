//! Maps over independent items, on one thread or, with the feature `threads`, on all of them.
//!
//! No other module or crate of truearea uses a thread pool. [`on_this_thread`] keeps work on one thread for callers that have
//! threads of their own; [`fill_blocks`] fills columns of numbers in place.

mod blocks;
mod one_thread;
mod progress;

pub use blocks::fill_blocks;
pub use one_thread::on_this_thread;
pub use progress::{NestedProgress, Progress, Unobserved};

#[cfg(feature = "threads")]
use rayon::prelude::*;

/// Applies `apply` to every item and returns the results in order.
pub fn map<T: Sync, U: Send>(items: &[T], apply: impl Fn(&T) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_confined() {
        return items.par_iter().map(&apply).collect();
    }
    items.iter().map(apply).collect()
}

/// Applies `apply` to every item by value and returns the results in order.
pub fn map_owned<T: Send, U: Send>(items: Vec<T>, apply: impl Fn(T) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_confined() {
        return items.into_par_iter().map(&apply).collect();
    }
    items.into_iter().map(apply).collect()
}

/// Applies `apply` to the indices 0 to `count - 1` and returns the results in order.
pub fn map_indices<U: Send>(count: usize, apply: impl Fn(usize) -> U + Sync) -> Vec<U> {
    #[cfg(feature = "threads")]
    if !one_thread::is_confined() {
        return (0..count).into_par_iter().map(&apply).collect();
    }
    (0..count).map(apply).collect()
}

/// Applies a fallible `apply` to every item and returns the results in order.
///
/// # Errors
/// The first error in the order of the items, for any number of threads.
pub fn try_map<T: Sync, U: Send, E: Send>(
    items: &[T],
    apply: impl Fn(&T) -> Result<U, E> + Sync,
) -> Result<Vec<U>, E> {
    map(items, apply).into_iter().collect()
}
