//! Number of threads that the work takes.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::errors::input;

/// The threads, made when they are first needed.
struct Threads {
    count: Option<NonZeroUsize>,
    /// The process and the pool that it made: threads do not survive a fork.
    pool: Option<(u32, Arc<ThreadPool>)>,
}

static THREADS: Mutex<Threads> = Mutex::new(Threads { count: None, pool: None });

impl Threads {
    fn count(&self) -> usize {
        self.count.or(available_parallelism().ok()).map_or(1, NonZeroUsize::get)
    }

    /// The pool of this process; none where one thread is to do all, or no more can be had.
    fn pool(&mut self) -> Option<Arc<ThreadPool>> {
        let (count, process) = (self.count(), std::process::id());
        if count == 1 {
            return None;
        }
        if let Some((made_by, pool)) = &self.pool
            && *made_by == process
        {
            return Some(pool.clone());
        }
        let pool = Arc::new(ThreadPoolBuilder::new().num_threads(count).build().ok()?);
        // A pool of another process is forgotten rather than dropped: its threads are not here to be joined.
        if let Some((_, other)) = self.pool.replace((process, pool.clone())) {
            std::mem::forget(other);
        }
        Some(pool)
    }
}

/// Carries work out on the threads that were asked for.
pub fn with_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let pool = THREADS.lock().unwrap_or_else(PoisonError::into_inner).pool();
    match pool {
        Some(pool) => pool.install(work),
        None => parallel::on_this_thread(work),
    }
}

/// Lets work take so many threads from now on.
#[pyfunction]
pub fn set_threads(count: i64) -> PyResult<()> {
    let given = usize::try_from(count).ok().and_then(NonZeroUsize::new);
    let count = given.ok_or_else(|| input(format!("count is {count}; it must be at least 1")))?;
    let mut threads = THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    if threads.count.replace(count) != Some(count) {
        threads.pool = None;
    }
    Ok(())
}

/// Number of threads that the work takes.
#[pyfunction]
pub fn threads() -> usize {
    THREADS.lock().unwrap_or_else(PoisonError::into_inner).count()
}
