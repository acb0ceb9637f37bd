//! Messages beside the result, to a reader who may have left.

use std::io::Write;

/// Says a line on stderr; nobody listening is no failure. Control characters, which names and files may hold, are replaced.
pub fn say(line: &str) {
    let is_obeyed = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    let _ = writeln!(std::io::stderr(), "{}", line.replace(is_obeyed, "\u{fffd}"));
}
