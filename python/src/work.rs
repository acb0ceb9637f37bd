//! Work done without the interpreter's lock, on the threads that were asked for; Ctrl-C ends it.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use numerics::parallel::Progress;
use pyo3::prelude::*;
use questions::Phase;

use crate::threads::{threads, with_threads};

/// Longest wait of Ctrl-C and progress for the interpreter.
const PATIENCE: Duration = Duration::from_millis(50);

/// Callable that receives the name of the current steps, the number done, and their total.
pub type Observer<'py> = Bound<'py, PyAny>;

/// Time of the last look, observer, and what ended the work.
type OnCaller = (Instant, Option<Py<PyAny>>, PyResult<()>);

/// Steps done of some work, and the request to end it.
#[derive(Debug)]
pub struct Watch {
    /// Name of the steps, and their number if it is known.
    phase: Mutex<(&'static str, Option<usize>)>,
    done: AtomicUsize,
    is_ended: AtomicBool,
    /// State of work on the thread that calls.
    on_caller: Option<Mutex<OnCaller>>,
}

impl Watch {
    fn new() -> Self {
        let (done, is_ended) = (AtomicUsize::new(0), AtomicBool::new(false));
        Watch { phase: Mutex::new(("steps", None)), done, is_ended, on_caller: None }
    }

    /// Begins to count steps by their name and number.
    pub fn begin(&self, steps: &'static str, number: Option<usize>) {
        *held(&self.phase) = (steps, number);
        self.done.store(0, Ordering::Relaxed);
    }

    /// Looks now and then, if the work is on the thread that calls.
    fn look_at_times(&self) {
        let Some(mut kept) = self.on_caller.as_ref().map(held) else { return };
        let (last, observer, ended) = &mut *kept;
        if last.elapsed() >= PATIENCE && ended.is_ok() {
            *ended = Python::attach(|py| self.look(py, observer.as_ref().map(|observer| observer.bind(py))));
            self.is_ended.store(ended.is_err(), Ordering::Relaxed);
            *last = Instant::now();
        }
    }

    /// Looks for Ctrl-C, and calls the observer.
    fn look(&self, py: Python<'_>, observer: Option<&Observer<'_>>) -> PyResult<()> {
        py.check_signals()?;
        let Some(observer) = observer else { return Ok(()) };
        let (steps, number) = *held(&self.phase);
        observer.call1((steps, self.done.load(Ordering::Relaxed), number)).map(drop)
    }
}

impl Progress for &Watch {
    fn advance(&self, steps: usize) {
        self.done.fetch_add(steps, Ordering::Relaxed);
        self.look_at_times();
    }

    fn is_cancelled(&self) -> bool {
        self.look_at_times();
        self.is_ended.load(Ordering::Relaxed)
    }
}

impl questions::Watch for &Watch {
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_> {
        Watch::begin(self, phase.steps(), (steps > 0).then_some(steps));
        Box::new(*self)
    }
}

/// Runs `work`, keeps looking for Ctrl-C, and calls the observer now and then and at the end. Work of one thread is done on this
/// one, any other on threads beside it.
///
/// # Errors
/// KeyboardInterrupt, or what the observer raises; the work has ended by then.
pub fn carry_out<T: Send>(
    py: Python<'_>,
    observer: Option<&Observer<'_>>,
    work: impl FnOnce(&&Watch) -> T + Send,
) -> PyResult<T> {
    if threads() == 1 {
        let kept = Mutex::new((Instant::now(), observer.map(|observer| observer.clone().unbind()), Ok(())));
        let watch = Watch { on_caller: Some(kept), ..Watch::new() };
        let made = light(py, || work(&&watch));
        let Watch { on_caller: kept, .. } = &watch;
        let ended = kept.as_ref().map_or(Ok(()), |kept| std::mem::replace(&mut held(kept).2, Ok(())));
        return ended.and_then(|()| watch.look(py, observer)).map(|()| made);
    }
    let watch = &Watch::new();
    let (begun, finish) = channel::<()>();
    let finish = Mutex::new(finish);
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            // Dropped however the work goes, which ends the wait.
            let _begun = begun;
            with_threads(|| work(&watch))
        });
        let mut ended = Ok(());
        while py.detach(|| held(&finish).recv_timeout(PATIENCE)) == Err(RecvTimeoutError::Timeout) {
            if ended.is_ok() {
                ended = watch.look(py, observer);
                watch.is_ended.store(ended.is_err(), Ordering::Relaxed);
            }
        }
        let made = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        ended.and_then(|()| watch.look(py, observer)).map(|()| made)
    })
}

/// Runs `work` on this thread: for work that is done before another thread has begun.
pub fn light<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    py.detach(|| numerics::parallel::on_this_thread(work))
}

/// Locks a mutex, also after a panic of another holder.
pub fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
