//! How somebody watches long work, and ends it.

/// Watches work from any thread, and may end it.
pub trait Progress: Sync {
    /// So many more steps are done; what a step is, is told where the work is begun.
    fn advance(&self, steps: usize);

    /// Whether the work should end as soon as it can, with what is known by then thrown away.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Nobody watches, and the work runs to its end.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unobserved;

impl Progress for Unobserved {
    fn advance(&self, _: usize) {}
}

/// Work within a step of other work: its own steps are not told, and it ends with the other.
#[derive(Clone, Copy)]
pub struct WithinAStep<'p>(pub &'p dyn Progress);

impl Progress for WithinAStep<'_> {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}
