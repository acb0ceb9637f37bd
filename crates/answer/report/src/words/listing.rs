//! Loads, names, ranges and small numbers as people list them.

use std::fmt::Write;

use findings::features::DecadeShare;
use scene::Scene;
use spectrum::ProfilePsd;
use units::display::{length, percent, three_digits};

/// `at every load`, `at 5 MPa`, `at 1e-3 H and 1e-2 H`.
pub(crate) fn at_loads(scene: &Scene, loads: &[usize]) -> String {
    let labels: Vec<&str> = loads.iter().map(|&load| scene.needs.loads[load].label.as_str()).collect();
    match labels[..] {
        [one] => format!("at {one}"),
        _ if labels.len() == scene.needs.loads.len() => "at every load".to_owned(),
        _ => format!("at {}", listed(&labels)),
    }
}

/// `a`, `a and b`, `a, b and c`; semicolons part names that hold commas.
pub(crate) fn listed(names: &[&str]) -> String {
    let comma = if names.iter().any(|name| name.contains(',')) { "; " } else { ", " };
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(comma)),
    }
}

/// `least to most`, or one text if both read the same.
pub(crate) fn range(values: impl Iterator<Item = f64>, display: impl Fn(f64) -> String) -> String {
    let (least, most) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    let (least, most) = (display(least), display(most));
    if least == most { least } else { format!("{least} to {most}") }
}

pub(crate) use units::display::{number_word, share};

/// Ranges that end below are in ppm.
const PPM_BELOW: f64 = 1e-4;

/// `0.12 to 0.18 %`, a range of shares; in ppm below 0.01 %.
pub(crate) fn share_range(low: f64, high: f64) -> String {
    let (factor, unit) = if high < PPM_BELOW { (1e6, "ppm") } else { (100.0, "%") };
    format!("{} {unit}", range([low, high].into_iter(), |share| three_digits(factor * share)))
}

/// A share in the unit of the range that stands beside it.
pub(crate) fn share_beside(share: f64, high: f64) -> String {
    if high < PPM_BELOW { format!("{} ppm", three_digits(1e6 * share)) } else { percent(share) }
}

/// The text with a capital at its beginning.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}", first.to_uppercase(), letters.as_str()))
}

/// `10 µm to 1 µm`: the part of a decade that the spectrum covers, with a remark if it was not measured.
pub(crate) fn decade_name(decade: &DecadeShare, psd: &ProfilePsd) -> String {
    let begins_m = decade.longest_m.min(psd.longest_wavelength_m());
    let ends_m = decade.shortest_m.max(psd.shortest_wavelength_m());
    let measured = if decade.measured { "" } else { ", not measured" };
    format!("{} to {}{measured}", unbroken(begins_m), unbroken(ends_m))
}

/// A length without a line break.
fn unbroken(length_m: f64) -> String {
    length(length_m).replace(' ', "\u{a0}")
}

/// Rows as indented columns of equal width.
pub(crate) fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(|c| c.chars().count()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, " {cell:<width$} ");
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_listed_and_equal_ends_of_a_range_are_one() {
        assert_eq!(listed(&["a", "b", "c"]), "a, b and c");
        assert_eq!(listed(&["a", "b"]), "a and b");
        assert_eq!(listed(&["a, b", "c", "d"]), "a, b; c and d");
        assert_eq!(range([2.0, 1.0, 3.0].into_iter(), three_digits), "1 to 3");
        assert_eq!(range([2.0, 2.0001].into_iter(), three_digits), "2");
    }

    #[test]
    fn a_decade_is_named_as_far_as_the_spectrum_goes() {
        let psd = ProfilePsd::new(vec![4e-5, 1.26e-6], vec![1e-20, 1e-24]).unwrap();
        let named = |longest_m, measured| {
            decade_name(&DecadeShare { longest_m, shortest_m: longest_m / 10.0, share: 0.5, measured }, &psd)
        };
        assert_eq!(named(1e-4, true), "40\u{a0}µm to 10\u{a0}µm");
        assert_eq!(named(1e-5, false), "10\u{a0}µm to 1.26\u{a0}µm, not measured");
    }

    #[test]
    fn small_shares_are_told_in_ppm() {
        assert_eq!([share(0.0018), share(4e-5)], ["0.18 %", "40 ppm"]);
        assert_eq!(share_range(0.0012, 0.0018), "0.12 to 0.18 %");
        assert_eq!(share_range(2.98e-6, 4.68e-6), "2.98 to 4.68 ppm");
    }
}
