//! Number of threads that the work takes.

use std::num::NonZeroUsize;
use std::sync::Mutex;
use std::thread::available_parallelism;

use pyo3::prelude::*;

use crate::arguments::{Given, whole};
use crate::work::held;

/// Most threads per core: more only take room.
const THREADS_PER_CORE: usize = 8;

/// The number that was set, if any.
static COUNT: Mutex<Option<NonZeroUsize>> = Mutex::new(None);

/// Lets work take so many threads from now on, of more than eight times the cores that many.
#[pyfunction]
pub fn set_threads(count: Given<'_>) -> PyResult<()> {
    let count = whole("count", &count, &(1..=u64::from(u32::MAX)))?;
    *held(&COUNT) = NonZeroUsize::new(count as usize);
    Ok(())
}

/// Number of threads that the work takes: the number that was set, or that `RAYON_NUM_THREADS` says, or that of the cores.
#[pyfunction]
pub fn threads() -> usize {
    if cfg!(not(feature = "threads")) {
        return 1;
    }
    let cores = available_parallelism().map_or(1, NonZeroUsize::get);
    let of_environment = || std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok();
    let count = held(&COUNT).or_else(of_environment);
    count.map_or(cores, NonZeroUsize::get).min(THREADS_PER_CORE * cores)
}

/// Carries work out on the threads that were asked for.
pub fn with_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "threads")]
    if let Some(pool) = pool(threads()) {
        return pool.install(work);
    }
    numerics::parallel::on_this_thread(work)
}

/// The pool of this process; none where one thread is to do all, or no more can be had.
#[cfg(feature = "threads")]
fn pool(count: usize) -> Option<std::sync::Arc<rayon::ThreadPool>> {
    type Pool = std::sync::Arc<rayon::ThreadPool>;
    /// The process and the pool that it made, for so many threads: threads do not survive a fork.
    static POOL: Mutex<Option<(u32, usize, Pool)>> = Mutex::new(None);

    if count == 1 {
        return None;
    }
    let process = std::process::id();
    let mut kept = held(&POOL);
    if let Some((made_by, of_count, pool)) = &*kept
        && (*made_by, *of_count) == (process, count)
    {
        return Some(pool.clone());
    }
    let pool = Pool::new(rayon::ThreadPoolBuilder::new().num_threads(count).build().ok()?);
    // A pool of another process is forgotten rather than dropped: its threads are not here to be joined.
    if let Some((made_by, _, other)) = kept.replace((process, count, pool.clone()))
        && made_by != process
    {
        std::mem::forget(other);
    }
    Some(pool)
}
