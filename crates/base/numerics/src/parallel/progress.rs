//! Progress and cancellation of long work.

/// Observer of long work; called from any thread, and able to cancel it.
pub trait Progress: Sync {
    /// Reports `steps` more finished steps. The function that starts the work defines a step.
    fn advance(&self, steps: usize);

    /// Returns true if the work should stop as soon as it can; partial results are discarded.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// A [`Progress`] that ignores every report and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unobserved;

impl Progress for Unobserved {
    fn advance(&self, _: usize) {}
}

/// A [`Progress`] for work inside one step of other work: it reports no steps and is cancelled with the outer work.
#[derive(Clone, Copy)]
pub struct NestedProgress<'p>(pub &'p dyn Progress);

impl Progress for NestedProgress<'_> {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}
