//! How and when a report came to be made.

/// How and when a front end came to carry a scene out, which nothing below it knows.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Occasion {
    /// The date, as it is to be printed.
    pub date: Option<String>,
    /// What was asked, e.g. the command as typed.
    pub asked: Option<String>,
}
