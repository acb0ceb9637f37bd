//! XML within files of instruments, parsed within bounds.

use roxmltree::{Document, ParsingOptions};

/// Attributes of one element; files of instruments have a few. The parser compares each with all before it.
const MOST_ATTRIBUTES: usize = 256;

/// Parses a document of at most `nodes` nodes.
///
/// # Errors
/// The problem in words.
pub(super) fn parse(text: &str, nodes: u32) -> Result<Document<'_>, String> {
    let attributes = |tag: &str| tag.matches("=\"").count() + tag.matches("='").count();
    if text.split('<').any(|tag| attributes(tag) > MOST_ATTRIBUTES) {
        return Err(format!("an element has more than {MOST_ATTRIBUTES} attributes"));
    }
    let options = ParsingOptions { nodes_limit: nodes, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| error.to_string())
}
