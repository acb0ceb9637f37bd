//! Work done without the interpreter's lock, on the threads that were asked for; Ctrl-C ends it.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use parallel::Progress;
use pyo3::prelude::*;

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

impl Watch {
    /// Looks for Ctrl-C, and calls the observer with the steps done.
    fn look(&self, py: Python<'_>, observer: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        py.check_signals()?;
        match observer {
            Some(observer) => observer.call1((self.done.load(Ordering::Relaxed),)).map(drop),
            None => Ok(()),
        }
    }
}

/// Runs `work` on a thread beside this one, which keeps looking for Ctrl-C. `observer` is called with the steps done,
/// now and then and at the end.
///
/// # Errors
/// KeyboardInterrupt, or what the observer raises; the work has ended by then.
#[cfg(feature = "threads")]
pub fn carry_out<T: Send>(
    py: Python<'_>,
    observer: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> PyResult<T> {
    use std::sync::mpsc::{RecvTimeoutError, channel};
    use std::sync::{Mutex, PoisonError};

    /// Longest wait of Ctrl-C and progress for the interpreter.
    const PATIENCE: std::time::Duration = std::time::Duration::from_millis(50);

    let watch = &Watch::default();
    let (begun, finish) = channel::<()>();
    let finish = Mutex::new(finish);
    let wait = || finish.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PATIENCE);
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            // Dropped however the work goes, which ends the wait.
            let _begun = begun;
            crate::threads::with_threads(|| work(watch))
        });
        let mut ended = Ok(());
        while py.detach(wait) == Err(RecvTimeoutError::Timeout) {
            if ended.is_ok() {
                ended = watch.look(py, observer);
                watch.is_ended.store(ended.is_err(), Ordering::Relaxed);
            }
        }
        let made = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        ended.and_then(|()| watch.look(py, observer)).map(|()| made)
    })
}

/// Runs `work` on this thread, the only one that there is.
///
/// # Errors
/// KeyboardInterrupt, or what the observer raises, once the work is done.
#[cfg(not(feature = "threads"))]
pub fn carry_out<T: Send>(
    py: Python<'_>,
    observer: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> PyResult<T> {
    let watch = Watch::default();
    let made = light(py, || work(&watch));
    watch.look(py, observer).map(|()| made)
}

/// Runs `work` on this thread: for work that is done before another thread has begun.
pub fn light<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    py.detach(|| parallel::on_this_thread(work))
}
