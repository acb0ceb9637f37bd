//! Loads, names and ranges as people list them.

use scene::Scene;

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

/// `least to most` as people read it, or the one text of both.
pub(crate) fn range(values: impl Iterator<Item = f64>, display: impl Fn(f64) -> String) -> String {
    let (least, most) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    let (least, most) = (display(least), display(most));
    if least == most { least } else { format!("{least} to {most}") }
}

/// The same text with a capital at its beginning.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}", first.to_uppercase(), letters.as_str()))
}

#[cfg(test)]
mod tests {
    use units::display::three_digits;

    use super::*;

    #[test]
    fn names_are_listed_and_ranges_told_once() {
        assert_eq!(listed(&["a", "b", "c"]), "a, b and c");
        assert_eq!(listed(&["a", "b"]), "a and b");
        assert_eq!(listed(&["a, b", "c", "d"]), "a, b; c and d");
        assert_eq!(range([2.0, 1.0, 3.0].into_iter(), three_digits), "1 to 3");
        assert_eq!(range([2.0, 2.0001].into_iter(), three_digits), "2");
    }
}
