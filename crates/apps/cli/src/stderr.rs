//! Messages beside the result, to a reader who may have left.

use std::io::Write;

use units::printable::message;

/// Says a line on stderr; a missing listener is not a failure.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", message(line));
}
