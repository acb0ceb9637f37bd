//! Date and command of a run.

/// Date and command of a run, which only a front end knows.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RunStamp {
    /// The date in print.
    pub date: Option<String>,
    /// The command as typed, or what stands for it.
    pub command: Option<String>,
}
