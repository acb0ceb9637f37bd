//! A progress bar for people who wait: on a terminal, once the work has taken more than a second.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::interruption::{self, EarlyEnd};

const PATIENCE: Duration = Duration::from_secs(1);

/// Shows what is done, from any thread.
pub struct Progress {
    bar: ProgressBar,
    begun: Instant,
    done: AtomicU64,
}

impl Progress {
    /// Progress towards so many of something, e.g. `states`.
    pub fn towards(total: usize, things: &str) -> Self {
        Self::new(Some(total as u64), "{wide_bar} {pos}/{len} {msg}, {eta} left", things)
    }

    /// Progress of work that shows only in the end how much there was to do.
    pub fn counting(things: &str) -> Self {
        Self::new(None, "{spinner} {pos} {msg}", things)
    }

    fn new(total: Option<u64>, template: &str, things: &str) -> Self {
        let target = if std::io::stderr().is_terminal() {
            ProgressDrawTarget::stderr()
        } else {
            ProgressDrawTarget::hidden()
        };
        let bar = ProgressBar::with_draw_target(total, target);
        bar.set_style(ProgressStyle::with_template(template).expect("a template"));
        bar.set_message(things.to_owned());
        Progress { bar, begun: Instant::now(), done: AtomicU64::new(0) }
    }

    /// Says something meanwhile, with the bar out of the way.
    pub fn aside(&self, say: impl FnOnce()) {
        self.bar.suspend(say);
    }
}

impl study::Progress for Progress {
    fn advance(&self, steps: usize) {
        let done = self.done.fetch_add(steps as u64, Ordering::Relaxed) + steps as u64;
        if self.begun.elapsed() > PATIENCE {
            self.bar.set_position(done);
        }
    }

    fn is_cancelled(&self) -> bool {
        interruption::is_asked_for()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Progress of work that may be ended early.
pub struct UntilEnded {
    /// The progress bar.
    pub progress: Progress,
    /// The request that may end the work.
    pub early_end: EarlyEnd,
}

impl study::Progress for UntilEnded {
    fn advance(&self, steps: usize) {
        self.progress.advance(steps);
    }

    fn is_cancelled(&self) -> bool {
        self.early_end.is_asked_for() || self.progress.is_cancelled()
    }
}

/// Work whose length is not known beforehand is not shown, and may be ended as any other.
pub struct Unseen;

impl study::Progress for Unseen {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        interruption::is_asked_for()
    }
}
