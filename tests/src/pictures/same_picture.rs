//! Two SVG documents held against each other by their numbers, since the last digit of a coordinate may depend on a
//! platform's `exp`.

/// Tolerance of two numbers relative to the larger; one in the last digit that both are printed with is allowed as well.
const TOLERANCE: f64 = 1e-6;

/// True if two documents have the same text and the same numbers to within the tolerance.
#[must_use]
pub fn is_same_picture(a: &str, b: &str) -> bool {
    let (a, b) = (parts(a), parts(b));
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a == b || agree(a, b))
}

/// The numbers of a document, and what stands between them; a colour such as `#0072b2` holds no number.
fn parts(document: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let (mut begin, mut in_number, mut in_colour) = (0, false, false);
    for (at, letter) in document.char_indices() {
        in_colour = letter == '#' || (in_colour && letter.is_ascii_hexdigit());
        let belongs = !in_colour
            && (letter.is_ascii_digit() || letter == '.' || (letter == '-' && (!in_number || begin == at)));
        let starts_another = in_number && letter == '-';
        if belongs != in_number || starts_another {
            parts.push(&document[begin..at]);
            begin = at;
        }
        in_number = belongs || (starts_another && !in_colour);
    }
    parts.push(&document[begin..]);
    parts
}

fn agree(a: &str, b: &str) -> bool {
    let (Ok(x), Ok(y)) = (a.parse::<f64>(), b.parse::<f64>()) else { return false };
    let decimals = |text: &str| text.split_once('.').map_or(0, |(_, digits)| digits.len() as i32);
    let (fewest, apart) = (decimals(a).max(decimals(b)), (x - y).abs());
    let last_digit = if fewest == 0 { 0.0 } else { 1.01 * 10f64.powi(-fewest) };
    apart <= (TOLERANCE * x.abs().max(y.abs())).max(last_digit)
}

#[cfg(test)]
mod tests {
    use super::is_same_picture;

    const PICTURE: &str = "<path d=\"M10.25,-3.5 L20.125-4e\" stroke=\"#0072b2\" /><text>10⁻³ H</text>";

    #[test]
    fn the_last_digit_of_a_coordinate_may_differ_and_nothing_else() {
        assert!(is_same_picture(PICTURE, PICTURE));
        assert!(is_same_picture(PICTURE, &PICTURE.replace("20.125", "20.126")));
        for (from, to) in [
            ("20.125", "20.135"),
            ("10.25", "10.35"),
            ("-3.5", "3.5"),
            ("0072b2", "0072b3"),
            ("path", "line"),
            (" H<", " MPa<"),
        ] {
            assert!(!is_same_picture(PICTURE, &PICTURE.replace(from, to)), "{from} is not {to}");
        }
    }
}
