//! Date and command of a run.

/// Date and command of a run; only a front end has them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RunStamp {
    /// The date in print.
    pub date: Option<String>,
    /// The command as typed, or a text in its place.
    pub command: Option<String>,
}
