//! Work done without the interpreter's lock, on the threads that were asked for; Ctrl-C ends it.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

use parallel::Progress;
use pyo3::prelude::*;

use crate::threads;

/// Longest wait of Ctrl-C and progress for the interpreter.
const PATIENCE: Duration = Duration::from_millis(50);

/// Steps done of some work, and the request to end it.
#[derive(Debug, Default)]
struct Watch {
    done: AtomicUsize,
    is_ended: AtomicBool,
}

impl Progress for Watch {
    fn advance(&self, steps: usize) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.is_ended.load(Ordering::Relaxed)
    }
}

/// Signal that some work has come to its end.
#[derive(Debug, Default)]
struct Finish {
    is_reached: Mutex<bool>,
    changed: Condvar,
}

impl Finish {
    fn reach(&self) {
        *self.is_reached.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.changed.notify_all();
    }

    /// Waits for the end, and tells whether it has come.
    fn wait(&self) -> bool {
        let is_reached = self.is_reached.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.changed.wait_timeout_while(is_reached, PATIENCE, |is_reached| !*is_reached);
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }
}

/// Reaches the end however the work goes.
struct Reach<'f>(&'f Finish);

impl Drop for Reach<'_> {
    fn drop(&mut self) {
        self.0.reach();
    }
}

/// Runs `work` on a thread beside this one, which keeps looking for Ctrl-C. `observer` is called with the steps done,
/// now and then and at the end.
///
/// # Errors
/// KeyboardInterrupt, or what the observer raises; the work has ended by then.
pub fn carry_out<T: Send>(
    py: Python<'_>,
    observer: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> PyResult<T> {
    let (watch, finish) = (Watch::default(), Finish::default());
    let (watch, finish) = (&watch, &finish);
    let look = || -> PyResult<()> {
        py.check_signals()?;
        if let Some(observer) = observer {
            observer.call1((watch.done.load(Ordering::Relaxed),))?;
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let _reach = Reach(finish);
            threads::with_threads(|| work(watch))
        });
        let mut ended = Ok(());
        while !py.detach(|| finish.wait()) {
            if ended.is_ok() {
                ended = look();
                watch.is_ended.store(ended.is_err(), Ordering::Relaxed);
            }
        }
        let made = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        ended.and_then(|()| look()).map(|()| made)
    })
}

/// Runs `work` on this thread: for work that is done before another thread has begun.
pub fn light<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    py.detach(|| parallel::on_this_thread(work))
}
