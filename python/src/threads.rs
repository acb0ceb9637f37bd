//! Number of threads that the work takes.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::arguments::{Given, whole};

/// Most threads per core: more only take room.
const THREADS_PER_CORE: usize = 8;

/// The threads, made when they are first needed.
struct Threads {
    count: Option<NonZeroUsize>,
    /// The process and the pool that it made: threads do not survive a fork.
    pool: Option<(u32, Arc<ThreadPool>)>,
}

static THREADS: Mutex<Threads> = Mutex::new(Threads { count: None, pool: None });

impl Threads {
    /// The number that was set, or that `RAYON_NUM_THREADS` says, or that of the cores.
    fn count(&self) -> usize {
        let cores = available_parallelism().map_or(1, NonZeroUsize::get);
        let of_environment = || std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok();
        self.count.or_else(of_environment).map_or(cores, NonZeroUsize::get).min(THREADS_PER_CORE * cores)
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

/// Lets work take so many threads from now on, of more than eight times the cores that many.
#[pyfunction]
pub fn set_threads(count: Given<'_>) -> PyResult<()> {
    let count = whole("count", &count, &(1..=u64::from(u32::MAX)))?;
    let count = NonZeroUsize::new(count as usize);
    let mut threads = THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    if std::mem::replace(&mut threads.count, count) != count {
        threads.pool = None;
    }
    Ok(())
}

/// Number of threads that the work takes.
#[pyfunction]
pub fn threads() -> usize {
    THREADS.lock().unwrap_or_else(PoisonError::into_inner).count()
}
