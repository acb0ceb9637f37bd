//! Numbers as finite element codes read them: at most twenty characters, with a point.

/// Number of characters that Abaqus and CalculiX read of a number; both ignore the rest.
pub(crate) const WIDTH: usize = 20;

/// Formats with the fewest digits that read back to the same double, or thirteen if those are too many.
pub(crate) fn field(value: f64) -> String {
    let whole = with_point(&format!("{value:E}"));
    if whole.len() <= WIDTH { whole } else { format!("{value:.12E}") }
}

/// Adds a decimal point, without which the number may be read as an integer.
fn with_point(text: &str) -> String {
    match text.split_once('E') {
        Some((mantissa, "0")) if mantissa.contains('.') => mantissa.to_owned(),
        Some((mantissa, "0")) => format!("{mantissa}."),
        Some((mantissa, exponent)) if !mantissa.contains('.') => format!("{mantissa}.E{exponent}"),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn numbers_have_a_point_and_as_few_digits_as_they_need() {
        for (value, text) in [
            (0.0, "0."),
            (1.0, "1."),
            (2.5, "2.5"),
            (1e-10, "1.E-10"),
            (1.25e6, "1.25E6"),
            (-1.234_567_890_123_456_7e-100, "-1.234567890123E-100"),
        ] {
            assert_eq!(field(value), text);
        }
    }

    proptest! {
        #[test]
        fn numbers_read_back_to_twelve_digits_from_twenty_characters(exponent in -290.0..290.0f64, negative: bool) {
            let value = 10f64.powf(exponent) * if negative { -1.0 } else { 1.0 };
            let text = field(value);
            prop_assert!(text.len() <= WIDTH && text.contains('.'), "{text}");
            prop_assert!((text.parse::<f64>().unwrap() / value - 1.0).abs() <= 1e-12, "{text}");
        }
    }
}
