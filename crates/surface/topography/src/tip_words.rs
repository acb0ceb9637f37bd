//! Tip radii in the free text of a scan.

use std::sync::LazyLock;

use regex_lite::{Captures, Regex};
use units::LengthUnit;

/// Range of plausible tip radii \[m\].
const SHORTEST_M: f64 = 1e-10;
const LONGEST_M: f64 = 1e-2;
/// Number of letters of context on either side of a radius.
const AROUND: usize = 20;

/// A tip radius found in text.
#[derive(Clone, Debug, PartialEq)]
pub struct TipWords {
    /// Radius \[m\].
    pub radius_m: f64,
    /// The text around it.
    pub text: String,
}

/// Finds every tip radius in a text, in order: `Tip radius - ~5 µm`, `radius of tip 8 nm`, `tip_radius=2 um`,
/// `Tip radius (nm): 10`, `R < 10 nm`. For a range, the larger end counts.
#[must_use]
pub fn tip_words(text: &str) -> Vec<TipWords> {
    let mut found: Vec<(usize, TipWords)> = Vec::new();
    for pattern in PATTERNS.iter() {
        for captures in pattern.captures_iter(text) {
            let start = captures.get(0).map_or(0, |whole| whole.start());
            if let Some(radius_m) = radius_m(&captures).filter(|_| found.iter().all(|&(at, _)| at != start)) {
                found.push((start, TipWords { radius_m, text: around(text, &captures) }));
            }
        }
    }
    found.sort_by_key(|&(at, _)| at);
    found.into_iter().map(|(_, words)| words).collect()
}

/// Finds the largest tip radius in a text: tips wear, and a blunter one leaves less of the scan reliable.
#[must_use]
pub fn proposed_tip(text: &str) -> Option<TipWords> {
    tip_words(text)
        .into_iter()
        .reduce(|largest, other| if other.radius_m > largest.radius_m { other } else { largest })
}

static PATTERNS: LazyLock<Vec<Regex>> = LazyLock::new(|| {
    let number = r"([0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?)";
    let unit = r"([A-Za-zµμÅÅ~]+)";
    // Between name and number: signs, and words that make it approximate.
    let between = "(?:[-\u{2013}\u{2014}:=~\u{2248}<>\u{2264}\u{2265} \t]|\\b(?:is|was|of|about|approx\\.?|approximately|ca\\.?|circa|around|below|less than|nominally|nominal|up to)\\b)*";
    let range = format!(r"{number}(?: ?(?:-|\u{{2013}}|to) ?{number})? ?{unit}");
    let tip = r"(?:tip|stylus|probe|cantilever)s?(?:'s)?";
    let named = format!(
        r"(?:{tip}[ _-]*(?:apex|end|curvature|nominal)?[ _-]*(?:radius|radii|rad)(?: of curvature)?|(?:radius|radii)(?: of curvature)? of (?:the |an? )?{tip})"
    );
    let before = format!(r"(?i)\b{named} ?[(\[]{unit}[)\]]{between}{number}");
    let after = format!(r"(?i)\b{named}{between}{range}");
    // The letter R alone means a tip radius where makers state an upper bound.
    let letter = format!(r"\bR ?(?:<|<=|\u{{2264}}) ?{range}");
    let pattern = |text: String| Regex::new(&text).ok();
    [before, after, letter].into_iter().filter_map(pattern).collect()
});

/// Parses number and unit from the groups that hold them; the larger of two numbers counts.
fn radius_m(captures: &Captures) -> Option<f64> {
    let groups = || captures.iter().skip(1).flatten().map(|group| group.as_str());
    let unit = groups().find_map(LengthUnit::parse_instrument)?;
    let numbers = groups().filter_map(|text| text.replace(',', ".").parse::<f64>().ok());
    let radius_m = unit.to_m(numbers.reduce(f64::max)?);
    (SHORTEST_M..=LONGEST_M).contains(&radius_m).then_some(radius_m)
}

fn around(text: &str, captures: &Captures) -> String {
    let Some(found) = captures.get(0) else { return String::new() };
    // Context ends with the line or sentence.
    let is_end = |letter: char| matches!(letter, '\n' | '\r' | ';');
    let before = text[..found.start()].rsplit(is_end).next().unwrap_or_default();
    let after = text[found.end()..].split(is_end).next().unwrap_or_default();
    let start = before.char_indices().rev().take(AROUND).last().map_or(before.len(), |(at, _)| at);
    let end = after.char_indices().nth(AROUND).map_or(after.len(), |(at, _)| at);
    let words = [&before[start..], found.as_str(), &after[..end]].concat();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn radii_nm(text: &str) -> Vec<f64> {
        tip_words(text).iter().map(|words| (words.radius_m * 1e12).round() / 1e3).collect()
    }

    #[test]
    fn radii_are_found_as_people_write_them() {
        for (text, expected) in [
            ("Tip\n radius", vec![]),
            ("Scan sizes \u{2013} 300 \u{b5}m.\nTip radius - ~5\u{b5}m.", vec![5000.0]),
            (
                "Initial tip radii - 17 nm. \nFinal tip radii - 26 nm (assuming, no TEM image).",
                vec![17.0, 26.0],
            ),
            ("tip radius: 10 nm", vec![10.0]),
            ("tip_radius=2 um", vec![2000.0]),
            ("the radius of the tip is about 8 nm", vec![8.0]),
            ("radius of tip 8 nm", vec![8.0]),
            ("R < 10 nm", vec![10.0]),
            ("TipRadius = 12.5nm; StylusRadius \u{2248} 2 \u{3bc}m", vec![12.5, 2000.0]),
            ("Stylus radius of curvature: 2,5 microns", vec![2500.0]),
            ("tip radius (nm): 30", vec![30.0]),
            ("tip radius 7-12 nm", vec![12.0]),
            ("nominal probe radius 2e-3 mm", vec![2000.0]),
            ("Tip Radius: 0.999", vec![]),
            ("Tip radius 10 V, radius of curvature 5 nm, Ra = 4 nm, R = 12 mm, bar < 3 nm", vec![]),
            ("tip radius 0 nm, tip radius 5 km", vec![]),
        ] {
            assert_eq!(radii_nm(text), expected, "{text}");
        }
        assert_eq!(PATTERNS.len(), 3);
    }

    #[test]
    fn the_bluntest_is_proposed_with_its_words() {
        let text = "Q Factor \u{2013} 527.\nInitial tip radii - 17 nm. \nFinal tip radii - 26 nm (assuming, no TEM image).\nx";
        let words = proposed_tip(text).unwrap();
        assert_eq!(words.text, "Final tip radii - 26 nm (assuming, no TEM i");
        assert!((words.radius_m - 26e-9).abs() < 1e-18);
        assert_eq!(proposed_tip("no such thing"), None);
    }
}
