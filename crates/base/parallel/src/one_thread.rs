//! Work that stays on the thread that asks for it.

use std::cell::Cell;

thread_local! {
    static IS_ASKED_FOR: Cell<bool> = const { Cell::new(false) };
}

/// Carries work out with every map in it on this thread: for callers that have threads or processes of their own, each with
/// a piece of the work. The digits are the same.
pub fn on_this_thread<T>(work: impl FnOnce() -> T) -> T {
    let _until_the_end = Asked { before: IS_ASKED_FOR.replace(true) };
    work()
}

/// Whether this thread has been asked to do all by itself.
#[cfg(any(feature = "threads", test))]
pub(crate) fn is_asked_for() -> bool {
    IS_ASKED_FOR.get()
}

/// Puts back what was before, however the work ends.
struct Asked {
    before: bool,
}

impl Drop for Asked {
    fn drop(&mut self) {
        IS_ASKED_FOR.set(self.before);
    }
}

#[cfg(test)]
mod tests {
    use std::thread::current;

    use super::on_this_thread;
    use crate::{map, map_indices};

    #[test]
    fn work_stays_on_the_thread_that_asks_for_it() {
        let here = current().id();
        on_this_thread(|| {
            on_this_thread(|| ());
            let by_map = map(&[(); 1000], |()| current().id());
            let by_index = map_indices(1000, |_| current().id());
            assert!(by_map.into_iter().chain(by_index).all(|thread| thread == here));
        });
        assert!(!super::is_asked_for());
    }
}
