//! Finished drawings: side by side, as documents of their own, or as elements of a page.

use std::fmt::Write;

use units::printable::printable;

use super::canvas::escaped;

const FONTS: &str = "Helvetica, Arial, Liberation Sans, sans-serif";

/// SVG elements within a rectangle that begins at the origin.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel {
    /// Width and height in px.
    pub size: [f64; 2],
    /// The elements.
    pub elements: String,
}

impl Panel {
    /// Puts another panel below this one.
    pub fn above(self, other: &Panel) -> Self {
        let [width, height] = self.size;
        self.with([0.0, height], other, [width.max(other.size[0]), height + other.size[1]])
    }

    /// Puts another panel to the right of this one.
    pub fn beside(self, other: &Panel) -> Self {
        let [width, height] = self.size;
        self.with([width, 0.0], other, [width + other.size[0], height.max(other.size[1])])
    }

    fn with(mut self, [x, y]: [f64; 2], other: &Panel, size: [f64; 2]) -> Self {
        let _ = writeln!(self.elements, "<g transform=\"translate({x:.2} {y:.2})\">\n{}</g>", other.elements);
        Panel { size, ..self }
    }

    /// Returns the panel as a document of its own, with lines in a comment. With pixels per millimetre it has its size in
    /// print.
    pub fn document(&self, comment: &[String], px_of_mm: Option<f64>) -> String {
        let [width, height] = self.size.map(|px| match px_of_mm {
            Some(px_of_mm) => format!("{:.2}mm", px / px_of_mm),
            None => format!("{}", in_hundredths(px)),
        });
        let view_box = self.view_box();
        let comment =
            if comment.is_empty() { String::new() } else { format!("<!--\n{}\n-->\n", harmless(comment)) };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"{view_box}\" \
             font-family=\"{FONTS}\" font-size=\"13\">\n{comment}<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{}</svg>\n",
            self.elements
        )
    }

    /// Returns the panel as an element of a page that scales with its surroundings; `words` are for readers who cannot
    /// see it.
    pub fn element(&self, words: &str) -> String {
        format!(
            "<svg viewBox=\"{}\" font-family=\"{FONTS}\" font-size=\"13\" role=\"img\" aria-label=\"{}\">\n{}</svg>",
            self.view_box(),
            escaped(words),
            self.elements
        )
    }

    fn view_box(&self) -> String {
        let [width, height] = self.size.map(in_hundredths);
        format!("0 0 {width} {height}")
    }
}

fn in_hundredths(px: f64) -> f64 {
    (100.0 * px).round() / 100.0
}

/// Lines as the text of a comment, without double hyphens, which would end it.
fn harmless(lines: &[String]) -> String {
    let mut comment = printable(&lines.join("\n")).into_owned();
    while comment.contains("--") {
        comment = comment.replace("--", "- -");
    }
    comment
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_never_ends_early() {
        let comment = harmless(&["# -----".to_owned(), "--model".to_owned()]);
        assert!(!comment.contains("--") && comment.contains("model"), "{comment}");
    }
}
