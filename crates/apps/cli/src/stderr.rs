//! Messages beside the result, to a reader who may have left.

use std::io::Write;

use units::printable::{printable, shortened};

/// Most letters of a line of a message; what files hold may be of any length.
const MOST_LETTERS_OF_LINE: usize = 4000;

/// Most lines of a message.
const MOST_LINES: usize = 10_000;

/// Says a line on stderr; a missing listener is not a failure. Control characters, which names and files may hold, are replaced.
pub fn say(line: &str) {
    let bounded = line.split('\n').map(|line| shortened(line, MOST_LETTERS_OF_LINE));
    let bounded: Vec<_> = bounded.take(MOST_LINES).collect();
    let _ = writeln!(std::io::stderr(), "{}", printable(&bounded.join("\n")));
}
