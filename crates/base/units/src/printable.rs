//! Text from files made safe to print: without characters that terminals obey or markup forbids, and of bounded length.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

/// Most letters of a line of a message.
const MOST_LETTERS_OF_LINE: usize = 2000;

/// Most lines of a message.
const MOST_LINES: usize = 10_000;

/// Most letters of a list of names in one message.
const MOST_LETTERS_OF_LIST: usize = 400;

/// Most letters of one name in a list.
const MOST_LETTERS_OF_NAME: usize = 80;

/// Replaces control characters (C0, DEL and C1), characters that reorder text, and those that XML forbids; line ends and
/// tabs stay.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    replaced(text, |c| is_obeyed(c) && !matches!(c, '\n' | '\t'))
}

/// Replaces what [`printable`] replaces, line ends and tabs as well.
#[must_use]
pub fn printable_line(text: &str) -> Cow<'_, str> {
    replaced(text, is_obeyed)
}

fn replaced(text: &str, is_refused: impl Fn(char) -> bool) -> Cow<'_, str> {
    match text.contains(&is_refused) {
        true => Cow::Owned(text.replace(&is_refused, char::REPLACEMENT_CHARACTER.encode_utf8(&mut [0; 4]))),
        false => Cow::Borrowed(text),
    }
}

/// Returns true for characters that terminals obey, that reorder the text around them, or that XML forbids.
fn is_obeyed(c: char) -> bool {
    let reorders =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || reorders || matches!(c, '\u{2028}' | '\u{2029}' | '\u{fffe}' | '\u{ffff}')
}

/// Returns the name that provenance quotes for a path: its last part, since the others tell of folders on the machine.
#[must_use]
pub fn shown_path(path: &str) -> &str {
    match path.trim_end_matches(['/', '\\']).rsplit(['/', '\\']).next() {
        Some(name) if !name.is_empty() => name,
        _ => path,
    }
}

/// Returns the shortest end of each path that tells it apart from the others: the file name alone, but where two files of
/// different folders share one.
#[must_use]
pub fn short_paths<'p>(paths: impl IntoIterator<Item = &'p str>) -> HashMap<String, String> {
    let mut left: Vec<&str> = paths.into_iter().collect::<BTreeSet<_>>().into_iter().collect();
    let mut short = HashMap::new();
    for parts in 0.. {
        let end = |path: &'p str| {
            let start = path.rmatch_indices(['/', '\\']).nth(parts);
            start.map_or(path, |(at, _)| &path[at + 1..])
        };
        let mut counts: HashMap<&str, usize> = HashMap::new();
        left.iter().for_each(|path| *counts.entry(end(path)).or_default() += 1);
        let (done, longer) = left.into_iter().partition(|path| counts[end(path)] == 1 || end(path) == *path);
        left = longer;
        short.extend(Vec::into_iter(done).map(|path: &str| (path.to_owned(), end(path).to_owned())));
        if left.is_empty() {
            break;
        }
    }
    short
}

/// Writes bytes in hexadecimal digits.
#[must_use]
pub fn hexadecimal(bytes: impl AsRef<[u8]>) -> String {
    bytes.as_ref().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Shortens a text to at most `most` letters; the end of a shortened text is `...`.
#[must_use]
pub fn shortened(text: &str, most: usize) -> Cow<'_, str> {
    match text.char_indices().nth(most) {
        None => Cow::Borrowed(text),
        Some(_) => {
            let end = text.char_indices().nth(most.saturating_sub(3)).map_or(text.len(), |(at, _)| at);
            Cow::Owned(format!("{}...", &text[..end]))
        }
    }
}

/// Returns a message as people read it: printable, and of bounded length, as what files and arguments hold may be long.
#[must_use]
pub fn message(text: &str) -> String {
    let bounded = text.split('\n').map(|line| shortened(line, MOST_LETTERS_OF_LINE));
    printable(&bounded.take(MOST_LINES).collect::<Vec<_>>().join("\n")).into_owned()
}

/// Lists names for a message, such as `'a', 'b' and 3 more` with `quote` of `'`: as many as fit on a few lines of text,
/// and at least one.
#[must_use]
pub fn listed(names: impl IntoIterator<Item = impl AsRef<str>>, quote: &str) -> String {
    let (mut list, mut letters, mut more) = (String::new(), 0, 0usize);
    for name in names {
        let name = shortened(name.as_ref(), MOST_LETTERS_OF_NAME);
        letters += name.chars().count() + 2 * quote.len() + 2;
        if more > 0 || (!list.is_empty() && letters > MOST_LETTERS_OF_LIST) {
            more += 1;
            continue;
        }
        let comma = if list.is_empty() { "" } else { ", " };
        list += &format!("{comma}{quote}{name}{quote}");
    }
    if more > 0 {
        list += &format!(" and {more} more");
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_that_terminals_obey_or_that_reorder_text_are_replaced() {
        let hostile = "a\u{1b}]0;b\u{7}\u{7f}\u{9b}\u{202e}\u{2066}\u{2069}\u{ffff}\rz";
        let harmless = printable(hostile);
        assert_eq!(harmless.chars().filter(|c| *c == char::REPLACEMENT_CHARACTER).count(), 9);
        assert!(harmless.starts_with('a') && harmless.ends_with('z'));
        let kept = "µm\t\"<script>\"\nÅ \u{200b}";
        assert!(matches!(printable(kept), Cow::Borrowed(_)));
        assert_eq!(printable_line("a\tb\nc"), "a\u{fffd}b\u{fffd}c");
    }

    #[test]
    fn paths_are_shown_as_file_names() {
        for (path, shown) in [
            ("/home/someone/a.txt", "a.txt"),
            ("C:\\lab\\a.txt", "a.txt"),
            ("\\\\server\\a.txt", "a.txt"),
            ("/data/", "data/"),
            ("/", "/"),
            ("scans/a.txt", "a.txt"),
            ("../a.txt", "a.txt"),
            ("builtin:uncd-measured", "builtin:uncd-measured"),
        ] {
            assert_eq!(shown_path(path).trim_end_matches('/'), shown.trim_end_matches('/'));
        }
    }

    #[test]
    fn lists_are_whole_if_short_and_bounded_if_long() {
        assert_eq!(listed(["a", "b"], "'"), "'a', 'b'");
        assert_eq!(listed(Vec::<String>::new(), "'"), "");
        let long = listed((0..1_000_000).map(|at| format!("c{at}")), "");
        assert!(long.len() < 2 * MOST_LETTERS_OF_LIST && long.ends_with(" more"), "{long}");
        assert_eq!(listed(["é".repeat(1000)], ""), format!("{}...", "é".repeat(MOST_LETTERS_OF_NAME - 3)));
        assert_eq!(shortened("abcd", 4), "abcd");
    }
}
