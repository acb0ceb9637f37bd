//! Messages beside the result, to a reader who may have left.

use std::io::Write;

/// Says a line on stderr; nobody listening is no failure.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}
