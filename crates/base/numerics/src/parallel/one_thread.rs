//! Work confined to the calling thread.

use std::cell::Cell;

thread_local! {
    static ONE_THREAD_ONLY: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` with every map in it on this thread, for callers that split the work over their own threads or
/// processes.
///
/// No digit changes.
pub fn on_this_thread<T>(work: impl FnOnce() -> T) -> T {
    let _restore = RestoreOnDrop { before: ONE_THREAD_ONLY.replace(true) };
    work()
}

/// Returns true if maps on this thread must stay on it.
#[cfg(any(feature = "threads", test))]
pub(crate) fn is_confined() -> bool {
    ONE_THREAD_ONLY.get()
}

/// Restores the previous setting when dropped, also on panic.
struct RestoreOnDrop {
    before: bool,
}

impl Drop for RestoreOnDrop {
    fn drop(&mut self) {
        ONE_THREAD_ONLY.set(self.before);
    }
}

#[cfg(test)]
mod tests {
    use std::thread::current;

    use super::super::{map, map_indices};
    use super::on_this_thread;

    #[test]
    fn work_stays_on_the_calling_thread() {
        let here = current().id();
        on_this_thread(|| {
            on_this_thread(|| ());
            let by_map = map(&[(); 1000], |()| current().id());
            let by_index = map_indices(1000, |_| current().id());
            assert!(by_map.into_iter().chain(by_index).all(|thread| thread == here));
        });
        assert!(!super::is_confined());
    }
}
