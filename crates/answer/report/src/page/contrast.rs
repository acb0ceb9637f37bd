//! Contrast of the colours of the page, by WCAG 2.2, in light and dark.

const STYLE: &str = include_str!("style.css");

/// Text and the ground behind it, as variables of the style sheet.
const TEXTS: [[&str; 2]; 13] = [
    ["ink", "paper"],
    ["quiet", "paper"],
    ["link", "paper"],
    ["ink", "tint"],
    ["quiet", "none-fill"],
    ["good", "paper"],
    ["good", "good-fill"],
    ["over", "paper"],
    ["over", "over-fill"],
    ["under", "paper"],
    ["under", "under-fill"],
    ["none", "paper"],
    ["none", "none-fill"],
];

/// The colour of a variable among the declarations, the last one counting.
fn colour(declarations: &str, name: &str) -> [f64; 3] {
    let start = format!("--{name}: #");
    let (_, digits) = declarations.rsplit_once(&start).unwrap_or_else(|| panic!("{name} has no colour"));
    let digits = digits.split(';').next().unwrap();
    let width = digits.len() / 3;
    [0, 1, 2].map(|at| {
        let level = u8::from_str_radix(&digits[at * width..][..width], 16).unwrap();
        f64::from(level) / if width == 1 { 15.0 } else { 255.0 }
    })
}

/// Relative luminance.
fn luminance(colour: [f64; 3]) -> f64 {
    let linear =
        |level: f64| if level <= 0.04045 { level / 12.92 } else { ((level + 0.055) / 1.055).powf(2.4) };
    let [red, green, blue] = colour.map(linear);
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

fn contrast(one: [f64; 3], other: [f64; 3]) -> f64 {
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

#[test]
fn black_on_white_has_the_largest_contrast() {
    assert!((contrast([0.0; 3], [1.0; 3]) - 21.0).abs() < 1e-12);
}

#[test]
fn texts_have_the_contrast_of_level_aa_in_light_and_dark() {
    let (light, dark) = STYLE.split_once("(prefers-color-scheme: dark)").unwrap();
    for (scheme, declarations) in [("light", light), ("dark", dark)] {
        for [text, ground] in TEXTS {
            let ratio = contrast(colour(declarations, text), colour(declarations, ground));
            assert!(ratio >= 4.5, "{text} on {ground} in {scheme}: {ratio:.2}");
        }
    }
}
