//! Number of threads that the work takes.

use std::num::NonZeroUsize;
use std::sync::{Mutex, PoisonError};

use pyo3::prelude::*;

use crate::arguments::{Given, whole};

/// The number that was set, if any.
static COUNT: Mutex<Option<NonZeroUsize>> = Mutex::new(None);

/// Lets work take so many threads from now on, of more than eight times the cores that many.
#[pyfunction]
pub fn set_threads(count: Given<'_>) -> PyResult<()> {
    let count = whole("count", &count, &(1..=u64::from(u32::MAX)))?;
    *COUNT.lock().unwrap_or_else(PoisonError::into_inner) = NonZeroUsize::new(count as usize);
    Ok(())
}

/// Number of threads that the work takes.
#[pyfunction]
pub fn threads() -> usize {
    limits::limited(*COUNT.lock().unwrap_or_else(PoisonError::into_inner))
}

#[cfg(not(feature = "threads"))]
mod limits {
    /// One thread, whatever was set.
    pub fn limited(_: Option<std::num::NonZeroUsize>) -> usize {
        1
    }
}

#[cfg(feature = "threads")]
mod limits {
    use std::num::NonZeroUsize;
    use std::thread::available_parallelism;

    /// Most threads per core: more only take room.
    const THREADS_PER_CORE: usize = 8;

    /// The number that was set, or that `RAYON_NUM_THREADS` says, or that of the cores.
    pub fn limited(count: Option<NonZeroUsize>) -> usize {
        let cores = available_parallelism().map_or(1, NonZeroUsize::get);
        let of_environment = || std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok();
        count.or_else(of_environment).map_or(cores, NonZeroUsize::get).min(THREADS_PER_CORE * cores)
    }
}

#[cfg(feature = "threads")]
pub use pool::with_threads;

#[cfg(feature = "threads")]
mod pool {
    use std::sync::{Arc, Mutex, PoisonError};

    use rayon::{ThreadPool, ThreadPoolBuilder};

    /// The process and the pool that it made, for so many threads: threads do not survive a fork.
    static POOL: Mutex<Option<(u32, usize, Arc<ThreadPool>)>> = Mutex::new(None);

    /// Carries work out on the threads that were asked for.
    pub fn with_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
        match pool(super::threads()) {
            Some(pool) => pool.install(work),
            None => parallel::on_this_thread(work),
        }
    }

    /// The pool of this process; none where one thread is to do all, or no more can be had.
    fn pool(count: usize) -> Option<Arc<ThreadPool>> {
        if count == 1 {
            return None;
        }
        let process = std::process::id();
        let mut kept = POOL.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((made_by, of_count, pool)) = &*kept
            && (*made_by, *of_count) == (process, count)
        {
            return Some(pool.clone());
        }
        let pool = Arc::new(ThreadPoolBuilder::new().num_threads(count).build().ok()?);
        // A pool of another process is forgotten rather than dropped: its threads are not here to be joined.
        if let Some((made_by, _, other)) = kept.replace((process, count, pool.clone()))
            && made_by != process
        {
            std::mem::forget(other);
        }
        Some(pool)
    }
}
